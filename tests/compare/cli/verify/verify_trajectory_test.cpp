// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `pcm verify --trajectory`, as a user calls it.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "meshes/files/text_file.h"
#include "tests/compare/run_pcm.h"
#include "tests/compare/tiny_trajectory.h"

namespace pcm::compare {
namespace {

using Words = std::vector<std::string>;

class VerifyTrajectory : public testing::Test {
 protected:
  Outcome verify(const Words& options = {}) const {
    Words arguments{"verify", "--trajectory", trajectory_.file()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_pcm(arguments);
  }

  void expect_verdict(const Words& options, const std::string& verdict) const {
    SCOPED_TRACE(testing::PrintToString(options));
    const Outcome outcome = verify(options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    ASSERT_FALSE(outcome.out.empty());
    EXPECT_EQ(lines_of(outcome.out).back(), verdict);
  }

  void expect_refused(const std::string& named, const Words& options = {}) const {
    SCOPED_TRACE(testing::PrintToString(options));
    const Outcome outcome = verify(options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << "expected '" << named << "' in: " << outcome.err;
  }

  /// Refuses the index with that change, naming it and where.
  void expect_bad_index(const std::function<void(Json&)>& alter, const std::string& named) const {
    trajectory_.write_index(alter);
    expect_refused(trajectory_.file() + ": " + named);
  }

  const TinyTrajectory trajectory_;
};

TEST_F(VerifyTrajectory, HoldsEveryRecordedPose) {
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(lines_of(outcome.out).back(), "verified: 3 poses, 3 touching, 0 disagreements");
  EXPECT_NE(outcome.out.find("\nblock-brick "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\ntrajectory "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("demands no measure of recorded poses"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("measured"), std::string::npos) << outcome.out;
}

TEST_F(VerifyTrajectory, OptionsChangeWhatIsAsked) {
  expect_verdict({"--poses", "2"}, "verified: 2 poses, 2 touching, 0 disagreements");
  expect_verdict({"--mode", "all"}, "verified: 3 poses in 3 modes, 3 touching, 0 disagreements");
  const std::string out = trajectory_.folder().path("out");
  expect_verdict({"--mode", "E", "--scheme", "clipped", "--out", out},
                 "verified: 3 poses, 3 touching, 0 disagreements");
  const std::string table = read_text_file(out + "/verification.csv");
  EXPECT_NE(table.find("\nblock-brick,trajectory,clipped,E,3,3,0,"), std::string::npos) << table;
}

TEST_F(VerifyTrajectory, KeepsTablesOfThisRecordingAlone) {
  const std::string out = trajectory_.folder().path("out");
  expect_verdict({"--out", out}, "verified: 3 poses, 3 touching, 0 disagreements");
  const std::string table = read_text_file(out + "/verification.csv");
  EXPECT_NE(table.find("\nblock-brick,trajectory,barycentric,F,3,3,0,"), std::string::npos) << table;
  EXPECT_NE(verify({"--out", out}).out.find("nothing evaluated now"), std::string::npos);
  trajectory_.write_index([](Json& json) { json["pairings"][0]["law"]["friction"] = "0x1p-1"; });
  EXPECT_NE(verify({"--out", out}).err.find("it held a run of another recording"), std::string::npos);
}

TEST_F(VerifyTrajectory, RefusesOptionsThatContradict) {
  const std::string surface = trajectory_.folder().path("first.obj");
  for (const Words& options :
       {Words{"--seed", "1"}, Words{"--strata", "generic"}, Words{"--pair", surface, surface},
        Words{"--engine", "fast"}, Words{"--engine", "published-2003"}, Words{"--case", surface},
        Words{"--known-answers"}, Words{"--error-budget"}, Words{"--audits"}, Words{"--stability"}})
    expect_refused(options.front() + " excludes --trajectory", options);
  expect_refused("--quick goes with", {"--quick"});
  expect_refused("--scheme both", {"--scheme", "both"});
  expect_refused("--poses", {"--poses", "0"});
}

TEST_F(VerifyTrajectory, RefusesABadIndexByItsKey) {
  const std::string file = trajectory_.file();
  trajectory_.folder().write("trajectory.json", "no JSON");
  expect_refused(file +
                 ": this is no trajectory of pcm; give trajectory/trajectory.json of a folder of 'pcm simulate'");
  trajectory_.folder().write("trajectory.json", "[1]");
  expect_refused(file + ": this is no trajectory of pcm");
  expect_bad_index([](Json& json) { json["pcm_trajectory"] = 2; }, "\"pcm_trajectory\" is 2, and only 1 is known");
  expect_bad_index([](Json& json) { json.erase("pcm_trajectory"); }, "this is no trajectory of pcm");
  expect_bad_index([](Json& json) { json.erase("surfaces"); }, "\"surfaces\" is missing");
  expect_bad_index([](Json& json) { json["pairings"] = "none"; }, "pairings: ");
  expect_bad_index([](Json& json) { json["pairing"] = 1; }, "the key 'pairing' is none of pcm_trajectory");
  expect_bad_index([](Json& json) { json["pairings"][0]["modes"] = "E"; }, "pairings[0]: the key 'modes' is none of");
  expect_bad_index([](Json& json) { json["surfaces"][0]["unit"] = "m"; }, "surfaces[0]: the key 'unit' is none of");
  expect_bad_index([](Json& json) { json["surfaces"][1].erase("file"); }, "surfaces[1]: \"file\" is missing");
  expect_bad_index([](Json& json) { json["surfaces"][1] = 7; }, "surfaces[1]: ");
  expect_bad_index([](Json& json) { json["surfaces"][0]["name"] = 7; }, "surfaces[0]: \"name\" is no text: 7");
  for (const char* key : {"E", "F", "law", "mode", "scheme", "poses"})
    expect_bad_index([key](Json& json) { json["pairings"][0].erase(key); },
                     "pairings[0]: \"" + std::string(key) + "\" is missing");
  for (const Json& index : {Json(2), Json(-1), Json(0.5), Json("0"), Json(), Json(1e300), Json(18446744073709551615U)})
    expect_bad_index([&index](Json& json) { json["pairings"][0]["F"] = index; },
                     "pairings[0]: F: " + index.dump() + " is no surface's number; there are 2, from 0");
  expect_bad_index([](Json& json) { json["pairings"][0]["mode"] = "all"; }, "pairings[0]: mode: 'all' is none of E, F");
  expect_bad_index([](Json& json) { json["pairings"][0]["scheme"] = 1; }, "pairings[0]: scheme: type must be string");
  expect_bad_index([](Json& json) { json["pairings"][0]["poses"] = 1; }, "pairings[0]: \"poses\" is no text: 1");
}

TEST_F(VerifyTrajectory, RefusesABadLawByItsKey) {
  const auto expect_bad_law = [this](const char* key, const Json& value, const std::string& named) {
    expect_bad_index([&](Json& json) { json["pairings"][0]["law"][key] = value; }, "pairings[0]: law: " + named);
  };
  expect_bad_law("friction", 0.25, "friction: 0.25 is no number in quotes");
  expect_bad_law("friction", "much", "friction: 'much' is no number");
  expect_bad_law("friction", "-1", "contact law: friction mu is -1");
  expect_bad_law("stiffness", "inf", "contact law: stiffness c_l is inf");
  expect_bad_law("damping_mode", "none", "damping_mode: 'none' is none of no-tension, full, compression");
  expect_bad_law("stiffness_E", "1e6", "\"stiffness_F\" is missing");
  expect_bad_law("stiffness_F", "1e6", "\"stiffness_E\" is missing");
  expect_bad_law("stiffness", "1e300", "stiffness: 1e+300 is so large that the verdict's bounds need not hold");
  expect_bad_law("frction", "1", "the key 'frction' is none of stiffness");
  expect_bad_index([](Json& json) { json["pairings"][0]["law"].erase("damping"); },
                   "pairings[0]: law: \"damping\" is missing");
}

TEST_F(VerifyTrajectory, RefusesFilesThatAreMissingOrMalformed) {
  const TemporaryFolder& folder = trajectory_.folder();
  folder.write("0.poses", "1 0 0  0 1 0  0 0 1  0.8 0 0  0 0 0  0 0 0\n1 0 0\n");
  expect_refused(folder.path("0.poses") + ":2: 3 numbers");
  folder.write("0.poses", "1 0 0  0 1 0  0 0 1  0.8 0 0\n1 0 0  0 1 0  0 0 1  1e300 0 0\n");
  expect_refused(folder.path("0.poses") + ":2: pose: greatest |r| is");
  folder.write("0.poses", "1 0 0  0 1 0  0 0 1  0.8 0 0  1e100 0 0  0 0 0\n");
  expect_refused(folder.path("0.poses") + ":1: velocity: a component exceeds 2^300");
  folder.write("0.poses", "");
  expect_refused(trajectory_.file() + ": no pairing has a pose");
  std::filesystem::remove(folder.path("0.poses"));
  expect_refused(folder.path("0.poses") + ": no such file");
  folder.write("second.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  expect_refused(trajectory_.file() + ": surfaces[1]: ");
  std::filesystem::remove(folder.path("second.obj"));
  expect_refused("second.obj: no such file");
  std::filesystem::remove(trajectory_.file());
  expect_refused(trajectory_.file() + ": no such file");
}

TEST_F(VerifyTrajectory, StratumOfThatNameIsDrawnAlongTheBuiltInScenesAndKept) {
  const std::string out = trajectory_.folder().path("out");
  const Words words{"verify", "--strata", "degenerate,trajectory", "--scheme", "both", "--poses", "200", "--out", out};
  const Outcome outcome = run_pcm(words);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(lines_of(outcome.out).back().starts_with("verified: 200 poses, ")) << outcome.out;
  EXPECT_NE(outcome.out.find("\ntrajectory                     100 "), std::string::npos) << outcome.out;
  const std::string table = read_text_file(out + "/verification.csv");
  EXPECT_NE(table.find("\nhead_and_neck-car,trajectory,clipped,both,"), std::string::npos) << table;
  EXPECT_EQ(table.find("\nhead_and_neck-car,degenerate,"), std::string::npos) << table;
  EXPECT_NE(run_pcm(words).out.find("nothing evaluated now"), std::string::npos);
}

TEST_F(VerifyTrajectory, StratumOfThatNameIsNotToBeHadOfOtherSurfaces) {
  const std::string surface = trajectory_.folder().path("first.obj");
  const Outcome outcome = run_pcm({"verify", "--strata", "generic,trajectory", "--pair", surface, surface});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("stratum trajectory gets no pose: it is not to be had with these pairs"),
            std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace pcm::compare
