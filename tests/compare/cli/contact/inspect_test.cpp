// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `pcm inspect` as a program: what it prints, and what it refuses.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "compare/io/json/exact_json.h"
#include "meshes/files/text_file.h"
#include "tests/compare/io/well_formed_xml.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

using Words = std::vector<std::string>;

/// A gridded plate E of cells of 1/8 m and a box F, 0.3 m wide, that slides 1/16 m deep in it.
class Inspect : public testing::Test {
 protected:
  const TemporaryFolder scratch_;
  const std::string plate_ = scratch_.path("plate.obj"), box_ = scratch_.path("box.obj");
  const std::string slide_ = scratch_.write("slide.txt",
                                            "# there\n1 0 0 0 1 0 0 0 1  0 0 0.09375\n"
                                            "1 0 0 0 1 0 0 0 1  0.125 0 0.09375  9 9 9 9 9 9\n"
                                            "# and back\n1 0 0 0 1 0 0 0 1  0 0 0.09375\n");

  void SetUp() override {
    ASSERT_EQ(run_pcm({"mesh", "make", "plate", "-o", plate_}).status, 0);
    ASSERT_EQ(
        run_pcm({"mesh", "make", "box", "--extent_x=0.3125", "--extent_y=0.3125", "--extent_z=0.3125", "-o", box_})
            .status,
        0);
  }

  Outcome inspect(const Words& options) {
    Words arguments{"inspect", plate_, box_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_pcm(arguments);
  }

  void expect_refused(const Words& options, const std::string& named) {
    const Outcome outcome = inspect(options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << "expected '" << named << "' in: " << outcome.err;
  }

  /// The force that `pcm contact` gives at a pose of the JSON output.
  Eigen::Vector3d force_at(const Json& place) {
    std::string line;
    for (const Json& number : place["pose"]) line += dump_exactly(number) + ' ';
    const Outcome outcome =
        run_pcm({"contact", plate_, box_, "--poses", scratch_.write("pose.txt", line), "--stiffness", "800"});
    const Json force = Json::parse(outcome.out)["force"];
    return {force[0].get<double>(), force[1].get<double>(), force[2].get<double>()};
  }
};

TEST_F(Inspect, ReadsQuaternions) {
  const std::string quaternions = scratch_.write("q.txt", "1 0 0 0  0 0 0.09375\n1 0 0 0  0.125 0 0.09375\n");
  const std::string rows =
      scratch_.write("rows.txt", "1 0 0 0 1 0 0 0 1  0 0 0.09375\n1 0 0 0 1 0 0 0 1  0.125 0 0.09375\n");
  const Outcome by_quaternion = inspect({"--path", quaternions, "--quaternions", "wxyz", "--json", "--steps", "2"});
  EXPECT_EQ(by_quaternion.status, 0) << by_quaternion.err;
  EXPECT_EQ(by_quaternion.out, inspect({"--path", rows, "--json", "--steps", "2"}).out);
  expect_refused({"--path", quaternions}, quaternions);
}

TEST_F(Inspect, ScaleMakesMetresOfSurfacesAndPositions) {
  const auto box = [&](const std::string& extent) {
    std::string file = scratch_.path("box_" + extent + ".obj");
    EXPECT_EQ(run_pcm({"mesh", "make", "box", "--extent_x=" + extent, "--extent_y=" + extent, "--extent_z=" + extent,
                       "-o", file})
                  .status,
              0);
    return file;
  };
  const auto path = [&](const Words& files, const std::string& poses, const Words& options) {
    Words arguments{"inspect", files[0],  files[1], "--path", scratch_.write("path.txt", poses),
                    "--json",  "--steps", "2"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  const std::string identity = "1 0 0 0 1 0 0 0 1  ";
  const std::string in_metres =
      path({box("1"), box("0.5")}, identity + "0 0 0.6875\n" + identity + "0.125 0 0.6875\n", {});
  EXPECT_EQ(path({box("8"), box("4")}, identity + "0 0 5.5\n" + identity + "1 0 5.5\n", {"--scale", "0.125"}),
            in_metres);
  expect_refused({"--path", slide_, "--scale", "-1"}, "--scale");
}

TEST_F(Inspect, JumpsAreGivenByPosesThatContactAnswersAlike) {
  const Outcome outcome = inspect({"--path", slide_, "--json", "--stiffness", "800", "--steps", "4"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_GE(lines.size(), 3U);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const Json jump = Json::parse(lines[i]);
    // Barycentres pass a wall in columns: c_l A u for each, or several faces taking turns.
    const double unit = 800 * 0.0078125 * 0.0625;
    EXPECT_NEAR(std::remainder(jump["jump"].get<double>(), unit), 0, 1e-12);
    EXPECT_EQ(jump["cause"], "entry");
    const Json& f = jump["force"];
    const Eigen::Vector3d said(f[0].get<double>(), f[1].get<double>(), f[2].get<double>());
    EXPECT_LE((force_at(jump["after"]) - force_at(jump["before"]) - said).norm(), 1e-12);
    sum += said.z();
  }
  const Json path = Json::parse(lines.back())["path"];
  EXPECT_EQ(path["jumps"], lines.size() - 1);
  EXPECT_EQ(path["closed"], true);
  EXPECT_EQ(path["length"], 0.25);
  EXPECT_EQ(path["work"], 0.0);
  EXPECT_NEAR(sum, 0, 1e-12);  // what came by one way leaves by the other
}

TEST_F(Inspect, TableNamesCausesWorkAndTangentialForce) {
  const std::string file = scratch_.path("jumps.jsonl");
  const Outcome table = inspect({"--path", slide_, "--normal", "0,0,1", "--out", file, "--max-penetration", "0.01"});
  EXPECT_EQ(table.status, 0);
  for (const char* words : {"closed", "barycentre entered or left slave", "clamped", "tangential force: greatest 0 N",
                            "left over after the loop: 0 J", "3 poses, 64 steps"})
    EXPECT_NE(table.out.find(words), std::string::npos) << words << " in\n" << table.out;
  const std::vector<std::string> kept = lines_of(read_text_file(file));
  EXPECT_GE(kept.size(), 2U);
  EXPECT_EQ(Json::parse(kept.back())["path"]["tangential"]["greatest"], 0.0);
}

TEST_F(Inspect, WithoutAnyNormalForceThereIsNoShareOfIt) {
  const Words along_the_plate{"--path", slide_, "--normal", "1,0,0"};
  EXPECT_NE(inspect(along_the_plate).out.find("normal force 0 N there; there is no normal force anywhere"),
            std::string::npos);
  Words as_json = along_the_plate;
  as_json.push_back("--json");
  const Json tangential = Json::parse(lines_of(inspect(as_json).out).back())["path"]["tangential"];
  EXPECT_GT(tangential["greatest"], 0.0);
  EXPECT_TRUE(tangential["share"].is_null());
}

TEST_F(Inspect, ClippedSchemeHasNoJumps) {
  const Outcome table = inspect({"--path", slide_, "--scheme", "clipped", "--mode", "both"});
  EXPECT_EQ(table.status, 0);
  EXPECT_NE(table.out.find("jumps: 0,"), std::string::npos) << table.out;
}

TEST_F(Inspect, PictureIsDrawnOfAPlaceOnThePath) {
  const std::string file = scratch_.path("contact.svg");
  const Outcome outcome =
      inspect({"--path", slide_, "--steps", "1", "--svg", file, "--at", "1.5", "--view=-z", "--scheme", "clipped"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("jumps:"), std::string::npos) << outcome.out;
  const std::string picture = read_text_file(file);
  EXPECT_EQ(fault_in_xml(picture), "");
  for (const char* words : {"plate.obj (E)", "box.obj (F)", "E, seen from -z", "Pose 1.5 of slide.txt", "clipped"})
    EXPECT_NE(picture.find(words), std::string::npos) << words;
}

TEST_F(Inspect, ErrorAfterTheOutputsWereCheckedLeavesEarlierResultsAlone) {
  const std::string jumps = scratch_.write("jumps.jsonl", "earlier"), picture = scratch_.write("a.svg", "earlier");
  const std::string far = scratch_.write("far.txt", "1 0 0 0 1 0 0 0 1 0 0 0\n1 0 0 0 1 0 0 0 1 1e200 0 0\n");
  EXPECT_EQ(inspect({"--path", far, "--out", jumps, "--svg", picture, "--at", "1"}).status, 2);
  EXPECT_EQ(read_text_file(jumps), "earlier");
  EXPECT_EQ(read_text_file(picture), "earlier");
  expect_refused({"--path", slide_, "--out", "/dev/null"}, "/dev/null: this is a folder or a device");
}

TEST_F(Inspect, BadInputIsRefusedByName) {
  const std::string one = scratch_.write("one.txt", "1 0 0 0 1 0 0 0 1 0 0 0\n");
  expect_refused({}, "--path");
  expect_refused({"--path", one}, "one.txt: a path needs at least two poses");
  expect_refused({"--path", scratch_.write("bad.txt", "1 0 0 0 1 0 0 0 1 0 0 0\n1 2 3\n")}, "bad.txt:2");
  expect_refused({"--path", scratch_.path("missing.txt")}, "missing.txt");
  expect_refused({"--path", scratch_.write("far.txt", "1 0 0 0 1 0 0 0 1 0 0 0\n1 0 0 0 1 0 0 0 1 1e200 0 0\n")},
                 "path, at");
  for (const std::string steps : {"0", "-1", "x", "1048577"})
    expect_refused({"--path", slide_, "--steps", steps}, "--steps");
  for (const std::string least : {"-1", "nan", ""}) expect_refused({"--path", slide_, "--least", least}, "--least");
  expect_refused({"--path", slide_, "--normal", "0,0,0"}, "--normal");
  expect_refused({"--path", slide_, "--normal", "1,2"}, "--normal");
  expect_refused({"--path", slide_, "--normal", "1,2,x"}, "--normal");
  expect_refused({"--path", slide_, "--scheme", "sausage"}, "--scheme");
  expect_refused({"--path", slide_, "--stiffness", "0"}, "--stiffness");
  expect_refused({"--path", slide_, "--json", "--out", scratch_.path("a")}, "--out");
  expect_refused({"--path", slide_, "--out", scratch_.path("nowhere/a")}, "nowhere");
  for (const std::string& input : {plate_, box_, slide_}) {
    const std::string before = read_text_file(input);
    expect_refused({"--path", slide_, "--svg", input}, "is read or written already");
    expect_refused({"--path", slide_, "--out", input}, "is read or written already");
    EXPECT_EQ(read_text_file(input), before);
  }
  const std::string svg = scratch_.path("a.svg");
  expect_refused({"--path", slide_, "--svg", scratch_.path("nowhere/a")}, "nowhere");
  for (const std::string at : {"2.5", "-1", "x"}) expect_refused({"--path", slide_, "--svg", svg, "--at", at}, "--at");
  expect_refused({"--path", slide_, "--svg", svg, "--view", "up"}, "--view");
  expect_refused({"--path", slide_, "--at", "1"}, "--svg");
}

}  // namespace
}  // namespace pcm::compare
