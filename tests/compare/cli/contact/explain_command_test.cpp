// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `pcm explain` as users meet it: named poses, surfaces, case files, text and JSON, bad input.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/verify/verdict/case_file.h"
#include "meshes/files/text_file.h"
#include "pcm/read_mesh.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

constexpr std::string_view kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
constexpr std::string_view kIdentity = "1 0 0  0 1 0  0 0 1  ";

/// The tetrahedron as a case file has it.
constexpr std::string_view kSurface =
    R"({"name":"t","vertices":[[0.0,0.0,0.0],[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]],)"
    R"("faces":[[0,2,1],[0,1,3],[0,3,2],[1,2,3]]})";

TEST(ExplainCommand, ExplainsANamedPose) {
  const Outcome outcome = run_pcm({"explain", "--pose", "vertex_on_face"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* words :
       {"a vertex of F inside a face of E", "the surfaces touch", "Coincide exactly: 1 vertex on a face.",
        "margin: 0, exactly", "vertex 0 of F", "tie rule: below, by z of vertex",
        "Other crossings or faces inside: within", "  gone: edge "})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << " in\n" << outcome.out;
  EXPECT_EQ(run_pcm({"explain", "--pose", "catalogue/vertex_on_face/both"}).status, 0);
}

TEST(ExplainCommand, LooksForAnotherAnswerNoFartherOutThanPosesMayBe) {
  const TemporaryFolder scratch;
  const std::string surface = scratch.write("t.obj", kTetrahedron);
  const std::string poses = scratch.write("poses.txt", std::string(kIdentity) + "1e90 0 0\n");
  const Outcome outcome = run_pcm({"explain", surface, surface, "--poses", poses});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("found along no direction"), std::string::npos) << outcome.out;
}

TEST(ExplainCommand, DrawsAMapOfOnePoseAndRefusesOneOfMany) {
  const TemporaryFolder scratch;
  const std::string picture = scratch.path("map.svg");
  const Outcome drawn = run_pcm({"explain", "--pose", "vertex_on_face", "--map", picture, "--map-steps", "2"});
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_NE(drawn.out.find("fast             crossings wrong at      0 of 25 poses"), std::string::npos) << drawn.out;
  EXPECT_TRUE(std::filesystem::exists(picture));
  const std::string surface = scratch.write("t.obj", kTetrahedron);
  const std::string poses = scratch.write("poses.txt", std::string(kIdentity) + "0.5 0 0\n");
  EXPECT_EQ(run_pcm({"explain", surface, surface, "--poses", poses, "--map", picture, "--map-steps", "1"}).status, 0);
  const std::string two =
      scratch.write("two.txt", std::string(kIdentity) + "0.5 0 0\n" + std::string(kIdentity) + "1 0 0\n");
  EXPECT_EQ(run_pcm({"explain", surface, surface, "--poses", two, "--map", picture}).status, 2);
  const std::string none = scratch.write("none.txt", "# none\n");
  EXPECT_EQ(run_pcm({"explain", surface, surface, "--poses", none, "--map", picture}).status, 2);
  for (const std::string& input : {surface, poses}) {
    const std::string before = read_text_file(input);
    const Outcome refused = run_pcm({"explain", surface, surface, "--poses", poses, "--map", input});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("is read or written already"), std::string::npos) << refused.err;
    EXPECT_EQ(read_text_file(input), before);
  }
  EXPECT_EQ(run_pcm({"explain", "--pose", "vertex_on_face", "--map", picture, "--map-axes", "xx"}).status, 2);
  EXPECT_EQ(run_pcm({"explain", "--pose", "vertex_on_face", "--map-steps", "2"}).status, 2);
}

TEST(ExplainCommand, MapRefusesOptionsThatSayNothingOfCrossings) {
  const TemporaryFolder scratch;
  const std::string picture = scratch.path("map.svg");
  for (const Words& option : {Words{"--mode", "F"}, Words{"--scheme", "clipped"}, Words{"--ulps", "4"}}) {
    Words words{"explain", "--pose", "vertex_on_face", "--map", picture, "--map-steps", "1"};
    words.insert(words.end(), option.begin(), option.end());
    const Outcome outcome = run_pcm(words);
    EXPECT_EQ(outcome.status, 2) << option[0];
    EXPECT_NE(outcome.err.find(option[0]), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(picture));
  }
}

TEST(ExplainCommand, ExplainsPosesOfTwoSurfacesAsJson) {
  const TemporaryFolder scratch;
  const std::string surface = scratch.write("t.obj", kTetrahedron);
  const std::string poses =
      scratch.write("poses.txt", std::string(kIdentity) + "1 0 0\n" + std::string(kIdentity) + "0.3 0.2 0.17\n");
  const Outcome outcome = run_pcm({"explain", surface, surface, "--poses", poses, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 2U);
  const json tie = json::parse(lines[0]), generic = json::parse(lines[1]);
  EXPECT_EQ(tie["coincident"], true);
  EXPECT_EQ(tie["counts"]["vertex_on_vertex"]["exact"], 1);
  EXPECT_EQ(tie["coincidences"][0]["margin"], 0);
  EXPECT_EQ(tie["free_distance"], 0);
  EXPECT_EQ(generic["coincident"], false);
  EXPECT_EQ(generic["coincidences"], json::array());
  EXPECT_GT(generic["free_distance"], 0);
  EXPECT_FALSE(generic["next_answer"].is_null());
}

TEST(ExplainCommand, ReadsPosesAsContactDoes) {
  const TemporaryFolder scratch;
  const std::string surface = scratch.write("t.obj", kTetrahedron);
  const std::string rows = scratch.write("rows.txt", std::string(kIdentity) + "1 0 0\n");
  const std::string quaternions = scratch.write("q.txt", "0 0 0 1  1 0 0\n");
  const std::string rounded = scratch.write("rounded.txt", "0.960 -0.281 0  0.281 0.960 0  0 0 1  1 0 0\n");
  const auto explain = [&](const Words& options) {
    Words arguments{"explain", surface, surface, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_pcm(arguments);
  };
  const Outcome by_rows = explain({"--poses", rows}),
                by_quaternion = explain({"--poses", quaternions, "--quaternions", "xyzw"});
  ASSERT_EQ(by_quaternion.status, 0) << by_quaternion.err;
  json a = json::parse(by_rows.out), b = json::parse(by_quaternion.out);
  a.erase("origin");
  b.erase("origin");
  EXPECT_EQ(a, b);
  EXPECT_EQ(explain({"--poses", rounded}).status, 2);
  const Outcome mended = explain({"--poses", rounded, "--orthonormalise"});
  EXPECT_EQ(mended.status, 0) << mended.err;
  EXPECT_NE(mended.err.find("replaced by the nearest rotation"), std::string::npos) << mended.err;
  EXPECT_EQ(explain({"--quaternions", "wxyz"}).status, 2);
}

TEST(ExplainCommand, ScaleMakesMetresOfSurfacesAndPositions) {
  const TemporaryFolder scratch;
  const std::string small = scratch.write("t.obj", kTetrahedron);
  std::string text(kTetrahedron);
  for (std::size_t at = text.find("1"); at < text.find('f'); at = text.find("1", at + 1)) text[at] = '4';
  const std::string large = scratch.write("large.obj", text);
  const auto explain = [&](const std::string& surface, const std::string& r, const Words& options) {
    Words arguments{"explain", surface,   surface,
                    "--json",  "--poses", scratch.write("poses.txt", std::string(kIdentity) + r)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    json answer = json::parse(outcome.out);
    for (const char* key : {"origin", "E", "F"}) answer.erase(key);
    return answer;
  };
  EXPECT_EQ(explain(large, "1.5 0.5 0.75\n", {"--scale", "0.25"}), explain(small, "0.375 0.125 0.1875\n", {}));
  EXPECT_EQ(run_pcm({"explain", small, small, "--scale", "0"}).status, 2);
  const Outcome named = run_pcm({"explain", "--pose", "vertex_on_face", "--scale", "2"});
  EXPECT_EQ(named.status, 2);
  EXPECT_NE(named.err.find("--scale goes with two surfaces, not with a case file"), std::string::npos) << named.err;
}

TEST(ExplainCommand, ExplainsACaseFile) {
  const TemporaryFolder scratch;
  const std::string pose = R"({"A":["0x1p+0","0x0p+0","0x0p+0","0x0p+0","0x1p+0","0x0p+0","0x0p+0","0x0p+0","0x1p+0"],)"
                           R"("r":["0x1p+0","0x0p+0","0x0p+0"],"v":["0x0p+0","0x0p+0","0x0p+0"],)"
                           R"("w":["0x0p+0","0x0p+0","0x0p+0"]})";
  const std::string law =
      R"({"stiffness":"0x1p+20","damping":"0x0p+0","transition_depth":"0x0p+0","friction":"0x0p+0",)"
      R"("slip_velocity":"0x0p+0","max_penetration":"inf","damping_mode":"no-tension"})";
  const std::string file = scratch.write(
      "case.json", R"({"format":"pcm case 1","origin":"by hand","pose":)" + pose + R"(,"law":)" + law +
                       R"(,"scheme":"clipped","mode":"both","disagreements":[["force","engine 1, oracle 2"]],"E":)" +
                       std::string(kSurface) + R"(,"F":)" + std::string(kSurface) + "}");
  const Outcome outcome = run_pcm({"explain", file, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json explained = json::parse(outcome.out);
  EXPECT_EQ(explained["origin"], "by hand");
  EXPECT_EQ(explained["scheme"], "clipped");
  EXPECT_EQ(explained["mode"], "both");
  EXPECT_EQ(explained["disagreements"], json::parse(R"([["force","engine 1, oracle 2"]])"));
  EXPECT_EQ(explained["counts"]["vertex_on_vertex"]["exact"], 1);
}

TEST(ExplainCommand, MapIsNoSurfaceThatTheCaseFileRefersTo) {
  const TemporaryFolder scratch;
  const std::string surface = scratch.write("surface.obj", std::string(kTetrahedron));
  Case posed;
  posed.E = posed.F = read_mesh(surface);
  posed.file_E = posed.file_F = surface;
  const std::string file = scratch.write("case.json", format_case(posed, {}, {}));
  const Outcome drawn = run_pcm({"explain", file, "--map", scratch.path("map.svg"), "--map-steps", "1"});
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  const Outcome refused = run_pcm({"explain", file, "--map", surface, "--map-steps", "1"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("surface.obj: is read or written already"), std::string::npos) << refused.err;
  EXPECT_EQ(content_of(surface).front(), 'v');
}

TEST(ExplainCommand, ListsAllOnRequest) {
  const Outcome some = run_pcm({"explain", "--pose", "identical_boxes"});
  const Outcome all = run_pcm({"explain", "--pose", "identical_boxes", "--all"});
  EXPECT_NE(some.out.find("coincidences more (--all)"), std::string::npos) << some.out;
  EXPECT_EQ(all.out.find("(--all)"), std::string::npos);
  EXPECT_GT(all.out.size(), some.out.size());
}

TEST(ExplainCommand, RefusesWhatItCannotDo) {
  const TemporaryFolder scratch;
  const std::string surface = scratch.write("t.obj", kTetrahedron);
  const std::string skew = scratch.write("skew.txt", "1 0 0  0 1 0  0 0 2   0 0 0\n");
  const auto expect = [&](const Words& words, const std::string& named) {
    const Outcome outcome = run_pcm(words);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << "expected '" << named << "' in: " << outcome.err;
  };
  expect({"explain"}, "give a case file, two surfaces, or --pose");
  expect({"explain", surface, "--pose", "vertex_on_face"}, "give a case file, two surfaces, or --pose");
  expect({"explain", surface, surface, surface}, "not more");
  expect({"explain", surface}, "one surface alone; give those of E and F, or a case file");
  expect({"explain", skew}, "this is no case file of pcm");
  expect({"explain", "--pose", "no_such_pose"}, "there is no degenerate case 'no_such_pose'");
  expect({"explain", surface, scratch.path("nowhere.obj")}, "nowhere.obj");
  expect({"explain", surface, surface, "--poses", skew}, "skew.txt:1");
  expect({"explain", "--pose", "vertex_on_face", "--poses", skew}, "--poses goes with two surfaces");
  expect({"explain", surface, surface, "--ulps", "0"}, "--ulps: 0 is not positive");
  expect({"explain", surface, surface, "--ulps", "nan"}, "--ulps");
  expect({"explain", surface, surface, "--mode", "G"}, "--mode");
}

}  // namespace
}  // namespace pcm::compare
