// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Case files hold a disagreement so that it replays anywhere: what is written is read back bit for bit or refused.
#include "compare/verify/verdict/case_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/poses/extreme_meshes.h"
#include "compare/poses/strata.h"
#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/routes/state_draw.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/write_obj.h"
#include "tests/compare/expect_same_law.h"
#include "tests/compare/small_pair.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

class CaseFiles : public testing::Test {
 protected:
  static Case posed() {
    SurfacePair pair = small_pair();
    const FeaturePair features(pair.E, pair.F);
    const DrawnPose drawn = draw_pose(Stratum::near_degenerate, features, PoseRandom(1, 5, 0, 3));
    Case posed;
    posed.origin = "a test";
    posed.E = pair.E;
    posed.F = pair.F;
    posed.pose = drawn.pose;
    posed.velocity = drawn.velocity;
    // Each number another one, so that none can stand for another.
    posed.law.stiffness = 5.9e5;
    posed.law.layers = LayerStiffness{1.2e6, 3.7e6};
    posed.law.damping = 500;
    posed.law.transition_depth = 0x1p-9;
    posed.law.friction = 0.3;
    posed.law.slip_velocity = 0x1p-7;
    posed.law.max_penetration = 0.1;
    posed.law.damping_mode = DampingMode::full;
    posed.mode = Mode::F;
    posed.scheme = Scheme::clipped;
    return posed;
  }

  // Its own, since ctest runs these tests side by side.
  const TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
};

void expect_same_question(const Case& a, const Case& b) {
  EXPECT_EQ(a.E.vertices, b.E.vertices);
  EXPECT_EQ(a.E.faces, b.E.faces);
  EXPECT_EQ(a.F.vertices, b.F.vertices);
  EXPECT_EQ(a.F.faces, b.F.faces);
  EXPECT_EQ(a.pose.A, b.pose.A);
  EXPECT_EQ(a.pose.r, b.pose.r);
  EXPECT_EQ(a.velocity.v, b.velocity.v);
  EXPECT_EQ(a.velocity.w, b.velocity.w);
  EXPECT_EQ(a.mode, b.mode);
  EXPECT_EQ(a.scheme, b.scheme);
  expect_same_law(a.law, b.law);
}

TEST_F(CaseFiles, ReadBackBitForBitWithMeshesInline) {
  Case written = posed();
  written.disagreements = in_words({{Kind::force, "off"}});
  write_text_file(folder_ / "case.json", format_case(written, {}, {}));
  const Case read = read_case(folder_ / "case.json");
  expect_same_question(read, written);
  EXPECT_EQ(read.disagreements, written.disagreements);
}

// Thresholds are drawn at depths and speeds of the bodies, be they 2^-240 m large.
TEST_F(CaseFiles, OfExtremeQuestionsReadBackBitForBit) {
  const SurfacePair pair = small_pair();
  for (std::uint64_t i = 0; i < 4 * kExtremes; ++i) {
    SCOPED_TRACE(i);
    const auto [E, F] = extreme_meshes(pair.E, pair.F, i % kExtremes);
    const HeldPairing held(E, F, ContactLaw{}, Mode::both);
    const DrawnPose drawn = draw_pose(Stratum::extreme, held.features(), PoseRandom(1, 5, 0, i));
    const HeldPairing::State state =
        draw_state(held, Stratum::extreme, drawn, i % 2 == 0 ? Scheme::barycentric : Scheme::clipped,
                   PoseRandom(1, 5, 0, i, Purpose::law), PoseRandom(1, 5, 0, i, Purpose::velocity));
    Case written;
    written.E = E;
    written.F = F;
    written.pose = state.pose;
    written.velocity = state.velocity;
    written.law = state.law;
    written.scheme = state.scheme;
    write_text_file(folder_ / "case.json", format_case(written, {}, {}));
    expect_same_question(read_case(folder_ / "case.json"), written);
  }
}

TEST_F(CaseFiles, ReadBackBitForBitWithMeshesByPathAndRefuseChangedOnes) {
  Case written = posed();
  written.file_E = folder_ / "E.obj";
  write_obj(written.E, written.file_E);
  write_text_file(folder_ / "case.json", format_case(written, {}, {}));
  expect_same_question(read_case(folder_ / "case.json"), written);
  std::ofstream(written.file_E, std::ios::app) << "# changed\n";
  EXPECT_THROW(read_case(folder_ / "case.json"), BadInput);
}

TEST(CaseFileNames, AreWordsWithoutFolders) {
  EXPECT_EQ(case_file_name("gridded cube-plate/generic/7/E"), "case_gridded_cube-plate_generic_7_E.json");
}

TEST_F(CaseFiles, OfARunAreRemovedAndThoseOfOthersAreNot) {
  Case written = posed();
  written.origin = "seed 1, cube-plate/generic/7/E, rotated";
  const std::string text = format_case(written, {}, {});
  write_text_file(folder_ / case_file_name("cube-plate/generic/7/E"), text);
  const std::vector<std::string> own{"case_mine.json", "case_cube.json", "case_7.json", "case_generic.json",
                                     "case_1.json",    "case_E.json",    "case_.json"};
  for (const std::string& name : own) write_text_file(folder_ / name, text);
  write_text_file(folder_ / "case_notes.json", "no JSON");
  EXPECT_TRUE(remove_case_files(folder_));
  EXPECT_FALSE(std::filesystem::exists(folder_ / case_file_name("cube-plate/generic/7/E")));
  for (const std::string& name : own) EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "case_notes.json"));
  EXPECT_FALSE(remove_case_files(folder_));
}

TEST_F(CaseFiles, OfAFolderInPlaceOfAMeshAreRefusedByName) {
  auto json = nlohmann::ordered_json::parse(format_case(posed(), {}, {}));
  json["E"] = {{"path", "."}, {"sha256", ""}};
  write_text_file(folder_ / "case.json", json.dump());
  expect_bad_input([&] { read_case(folder_ / "case.json"); }, "cannot read the mesh");
}

TEST_F(CaseFiles, BadOnesAreRefused) {
  EXPECT_THROW(read_case(folder_ / "missing.json"), BadInput);
  EXPECT_THROW(read_case(folder_), BadInput);
  const std::string whole = format_case(posed(), {}, {});
  for (const std::string& text : {std::string("{"), std::string("[1]"), std::string("{\"format\": \"pcm case 1\"}"),
                                  std::string(whole).replace(whole.find("clipped"), 7, "cut"),
                                  std::string(whole).replace(whole.find("0x"), 2, "zz")}) {
    write_text_file(folder_ / "case.json", text);
    EXPECT_THROW(read_case(folder_ / "case.json"), BadInput) << text.substr(0, 40);
  }
  EXPECT_THROW(write_text_file(folder_ / "no" / "such" / "folder.json", ""), BadInput);
}

TEST_F(CaseFiles, BadValuesAreRefusedByFileAndKey) {
  const std::string whole = format_case(posed(), {}, {});
  const std::filesystem::path file = folder_ / "case.json";
  const auto refused_with = [&](const std::string& message,
                                const std::function<void(nlohmann::ordered_json&)>& change) {
    auto json = nlohmann::ordered_json::parse(whole);
    change(json);
    write_text_file(file, json.dump());
    expect_bad_input([&] { read_case(file); }, file.string() + ": " + message);
  };
  refused_with("pose: pose: A is no rotation", [](auto& json) { json["pose"]["A"][0] = "2"; });
  refused_with("pose: A: 1 is no number in quotes", [](auto& json) { json["pose"]["A"][0] = 1; });
  refused_with("pose: pose: A and r must be finite", [](auto& json) { json["pose"]["r"][0] = "inf"; });
  refused_with("pose: v: 'nan' is no number", [](auto& json) { json["pose"]["v"][0] = "nan"; });
  // What the engine or its scenes refuse is no disagreement.
  refused_with("pose: pose: greatest |r| is", [](auto& json) { json["pose"]["r"][0] = "1e308"; });
  refused_with("pose: velocity: greatest |v| or |w| is", [](auto& json) { json["pose"]["w"][0] = "1e308"; });
  refused_with("pose: velocity: a component exceeds 2^300", [](auto& json) { json["pose"]["w"][0] = "1e100"; });
  refused_with("pose: \"w\" is missing", [](auto& json) { json["pose"].erase("w"); });
  refused_with("pose: the key 'q' is none of A, r, v, w", [](auto& json) { json["pose"]["q"] = 1; });
  refused_with("before: a list is wanted", [](auto& json) { json["before"] = 5; });
  refused_with("before[0]: an object is wanted", [](auto& json) { json["before"] = {5}; });
  refused_with("law: contact law: friction mu is -1", [](auto& json) { json["law"]["friction"] = "-1"; });
  refused_with("law: damping: 1e+250 is so large that the verdict's bounds need not hold",
               [](auto& json) { json["law"]["damping"] = "1e250"; });
  refused_with("law: the key 'frction' is none of stiffness", [](auto& json) { json["law"]["frction"] = "1"; });
  for (const char* key : {"stiffness_E", "stiffness_F"})
    refused_with("law: \"" + std::string(key) + "\" is missing", [key](auto& json) { json["law"].erase(key); });
  refused_with("mode: type must be string", [](auto& json) { json["mode"] = 1; });
  refused_with("disagreements[0]: '[\"force\"]' is no pair of words",
               [](auto& json) { json["disagreements"] = nlohmann::ordered_json::parse(R"([["force"]])"); });
  refused_with("disagreements[0]: ", [](auto& json) { json["disagreements"] = {{"force", "off", "by far"}}; });
  refused_with("disagreements[0]: ",
               [](auto& json) { json["disagreements"] = nlohmann::ordered_json::parse(R"([["force", 1]])"); });
  refused_with("disagreements: a list is wanted", [](auto& json) { json["disagreements"] = "force"; });
  refused_with("E: faces[0]: '-1' is no vertex; there are", [](auto& json) { json["E"]["faces"][0][0] = -1; });
  refused_with("E: faces[0]: '0.5' is no vertex", [](auto& json) { json["E"]["faces"][0][0] = 0.5; });
  refused_with("E: faces[0]: '4294967296' is no vertex", [](auto& json) { json["E"]["faces"][0][0] = 4294967296; });
  refused_with("F: faces[1]: '[0,1,2,3]' is no list of three vertices", [](auto& json) {
    json["F"]["faces"][1] = {0, 1, 2, 3};
  });
  refused_with("F: vertices[2]: '[0,1]' is no list of three coordinates", [](auto& json) {
    json["F"]["vertices"][2] = {0, 1};
  });
  refused_with("E: faces: a list is wanted", [](auto& json) { json["E"]["faces"] = 7; });
  refused_with("E: ", [](auto& json) { json["E"]["faces"] = nlohmann::ordered_json::array(); });
  refused_with("the key 'Mode' is none of format, origin", [](auto& json) { json["Mode"] = "E"; });
  write_text_file(file, std::string(whole).replace(whole.find("\"mode\""), 6, "\"mode\": \"E\", \"mode\""));
  expect_bad_input([&] { read_case(file); }, file.string() + ": the key 'mode' is there twice");
  const std::string nested = std::string(200000, '[') + std::string(200000, ']');
  write_text_file(file, R"({"format": "pcm case 1", "disagreements": )" + nested + "}");
  expect_bad_input([&] { read_case(file); }, file.string() + ": lists and objects lie in one another more than 64");
}

TEST(HeldPairings, UnfitAndEmptySurfacesAreRefused) {
  const SurfacePair pair = small_pair();
  EXPECT_THROW(HeldPairing(TriangleMesh{}, pair.F, pair.law, Mode::E), BadInput);
  TriangleMesh torn = pair.E;
  torn.faces[0] = {0, 0, 1};
  EXPECT_THROW(HeldPairing(pair.F, torn, pair.law, Mode::E), BadInput);
}

TEST_F(CaseFiles, ReplayGivesTheSameVerdict) {
  const Case written = posed();
  write_text_file(folder_ / "case.json", format_case(written, {}, {}));
  const Case read = read_case(folder_ / "case.json");
  const HeldPairing held(read.E, read.F, read.law, read.mode, read.scheme);
  fast::Workspace workspace;
  EXPECT_TRUE(held.hold(read.pose, read.velocity, workspace).front().disagreements.empty());
}

}  // namespace
}  // namespace pcm::compare
