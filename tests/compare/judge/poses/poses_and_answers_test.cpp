// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Poses and answers as files: what is written reads back bit for bit, and what is no pose or answer is refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/io/provenance/sha256.h"
#include "compare/judge/lines/answer_lines.h"
#include "compare/judge/lines/answers_file.h"
#include "compare/judge/lines/json_lines.h"
#include "fast/base/same_bits.h"
#include "pcm/bad_input.h"
#include "tests/compare/expect_same_law.h"
#include "tests/compare/judge/poses/posed_folder.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/expect_bad_input.h"

namespace pcm::compare {
namespace {

/// The plan of PosedFolder once more.
PlannedPoses planned(std::int64_t poses, const std::vector<Scheme>& schemes) {
  VerificationPlan plan;
  plan.poses = poses;
  plan.strata.assign(kUsualStrata.begin(), kUsualStrata.end());
  plan.schemes = schemes;
  plan.pairs = {small_pair()};
  return PlannedPoses(std::move(plan));
}

TEST(PosesFolder, HoldsWhatAVerificationAsksBitForBit) {
  for (const Notation notation : {Notation::decimal, Notation::hexadecimal}) {
    const PosedFolder folder(36, {Scheme::barycentric, Scheme::clipped}, notation);
    const PlannedPoses poses = planned(36, {Scheme::barycentric, Scheme::clipped});
    std::size_t k = 0;
    for (const PlannedCell& cell : poses.cells())
      for (std::int64_t pose = cell.first; pose < cell.first + cell.poses; ++pose, ++k) {
        const PosedQuestion& read = folder.posed.questions.at(k);
        const HeldPairing::State asked = poses.asked(cell, pose);
        const FeaturePair& surfaces = poses.held_pairing(cell, pose).features();
        EXPECT_EQ(read.id, poses.pose_name(cell, pose));
        EXPECT_EQ(folder.posed.surfaces[read.E].mesh.vertices, surfaces.E.mesh.vertices);
        EXPECT_EQ(folder.posed.surfaces[read.F].mesh.vertices, surfaces.F.mesh.vertices);
        EXPECT_EQ(folder.posed.surfaces[read.F].mesh.faces, surfaces.F.mesh.faces);
        EXPECT_TRUE(fast::same_bits(read.pose, asked.pose));
        EXPECT_TRUE(fast::same_bits(read.velocity, asked.velocity));
        expect_same_law(read.law, asked.law);
        EXPECT_EQ(read.scheme, asked.scheme);
        EXPECT_EQ(read.mode, cell.mode);
      }
    EXPECT_EQ(k, folder.posed.questions.size());
    EXPECT_GE(folder.posed.surfaces.size(), 3U) << "a nested guest is scaled";
  }
}

TEST(PosesFolder, AsksTheSamePosesUnderOtherLaws) {
  const PlannedPoses poses = planned(12, {Scheme::barycentric});
  const PosedFolder drawn(12);
  for (const PosedLaw law : {PosedLaw::of_pair, PosedLaw::elastic}) {
    const TemporaryFolder scratch;
    write_poses(
        scratch.path("poses"), poses, law, Notation::decimal, 2, [] { return false; }, [](std::int64_t) {});
    const PosedQuestions read = read_poses_folder(scratch.path("poses"));
    ASSERT_EQ(read.questions.size(), drawn.posed.questions.size());
    std::size_t k = 0;
    for (const PlannedCell& cell : poses.cells())
      for (std::int64_t pose = cell.first; pose < cell.first + cell.poses; ++pose, ++k) {
        const PosedQuestion& question = read.questions[k];
        EXPECT_EQ(question.id, drawn.posed.questions[k].id);
        EXPECT_TRUE(fast::same_bits(question.pose, drawn.posed.questions[k].pose));
        const bool elastic = law == PosedLaw::elastic;
        EXPECT_TRUE(fast::same_bits(question.velocity, elastic ? Velocity{} : poses.draw(cell, pose).velocity));
        expect_same_law(question.law, elastic ? ContactLaw{} : small_pair().law);
      }
  }
}

/// All files under a folder, by their paths.
std::map<std::string, std::string> contents_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) contents[entry.path().string()] = content_of(entry.path().string());
  return contents;
}

TEST(PosesFolder, InterruptedRunLeavesPosesOfAnEarlierOneWhole) {
  const PosedFolder folder(12);
  // Surfaces of the same names and other bytes.
  const std::string surface = folder.path() + "/" + folder.posed.surfaces[0].file;
  std::string poses = content_of(folder.path() + "/poses.jsonl");
  std::ofstream(surface, std::ios::app) << "# other bytes\n";
  const std::string hash = folder.posed.surfaces[0].sha256;
  poses.replace(poses.find(hash), hash.size(), sha256(content_of(surface)));
  std::ofstream(folder.path() + "/poses.jsonl", std::ios::binary) << poses;
  const std::map<std::string, std::string> before = contents_of(folder.path());
  int asked = 0;
  const auto stop = [&asked] { return ++asked > 3; };
  EXPECT_FALSE(write_poses(folder.path(), planned(24, {Scheme::barycentric}), PosedLaw::drawn, Notation::decimal, 1,
                           stop, [](std::int64_t) {}));
  EXPECT_EQ(contents_of(folder.path()), before);
  EXPECT_EQ(read_poses_folder(folder.path()).questions.size(), 12U);
  EXPECT_TRUE(write_poses(
      folder.path(), planned(24, {Scheme::barycentric}), PosedLaw::drawn, Notation::decimal, 1, [] { return false; },
      [](std::int64_t) {}));
  EXPECT_EQ(read_poses_folder(folder.path()).questions.size(), 24U);
}

TEST(PosesFolder, WhoseSurfacesCannotBeWrittenKeepsEarlierPoses) {
  const PosedFolder folder(12);
  const std::string poses = content_of(folder.path() + "/poses.jsonl");
  std::filesystem::remove_all(folder.path() + "/surfaces");
  std::ofstream(folder.path() + "/surfaces") << "no folder, so that surfaces can't be written\n";
  EXPECT_THROW(write_poses(
                   folder.path(), planned(12, {Scheme::barycentric}), PosedLaw::drawn, Notation::decimal, 1,
                   [] { return false; }, [](std::int64_t) {}),
               BadInput);
  EXPECT_EQ(content_of(folder.path() + "/poses.jsonl"), poses);
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/poses.jsonl.part"));
}

TEST(PosesFolder, FilesOfOthersUnderItsNamesAreLeftAlone) {
  const PosedFolder folder(12);
  const auto expect_refused = [&](const std::string& file) {
    const std::map<std::string, std::string> before = contents_of(folder.path());
    try {
      write_poses(
          folder.path(), planned(24, {Scheme::barycentric}), PosedLaw::drawn, Notation::decimal, 1,
          [] { return false; }, [](std::int64_t) {});
      ADD_FAILURE() << file << " is written over";
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(file + " is there"), std::string::npos) << error.what();
    }
    EXPECT_EQ(contents_of(folder.path()), before);
  };
  const std::string surface = folder.path() + "/" + folder.posed.surfaces[1].file, own = content_of(surface);
  std::ofstream(surface, std::ios::binary) << "# mine\n" << own;
  expect_refused(folder.posed.surfaces[1].file);
  std::ofstream(surface, std::ios::binary) << own;
  std::ofstream(folder.path() + "/poses.jsonl", std::ios::binary) << "my own\n";
  expect_refused("poses.jsonl");
}

class Folder : public testing::Test {
 protected:
  const PosedFolder folder_{12};

  void expect_refused(const std::string& text, const std::string& named) const {
    const TemporaryFolder scratch;
    AnswersFile file(scratch.write("answers.jsonl", text), folder_.posed);
    try {
      while (file.next()) {
      }
      ADD_FAILURE() << "read: " << text;
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos)
          << "expected '" << named << "' in: " << error.what();
    }
  }
  std::string id(std::size_t k = 0) const { return folder_.posed.questions[k].id; }
  std::string with(const std::string& facts) const { return "\n{\"id\":\"" + id() + "\"," + facts + "}\n"; }
};

TEST_F(Folder, AnswersReadBackBitForBit) {
  for (const Notation notation : {Notation::decimal, Notation::hexadecimal})
    for (std::size_t k = 0; k < folder_.answers.size(); ++k) {
      const Json written = answer_json(id(k), folder_.answers[k], notation);
      const GivenAnswer read =
          answer_from(Json::parse(dump_exactly(written)), folder_.posed, folder_.posed.questions[k]);
      EXPECT_EQ(answer_json(id(k), read, notation), written);
    }
}

TEST_F(Folder, WholeNumbersMayHaveADecimalPointAsInJsonSchema) {
  const Json line = Json::parse(R"({"id":")" + id() + R"(","polygons":2.0,"E":{"inner":[3.0]}})");
  const GivenAnswer read = answer_from(line, folder_.posed, folder_.posed.questions[0]);
  EXPECT_EQ(read.polygons, 2);
  ASSERT_TRUE(read.E.inner);
  EXPECT_EQ(*read.E.inner, std::vector<Index>{3});
}

TEST_F(Folder, WhatIsNoAnswerIsRefusedWithFileAndLine) {
  expect_refused("no JSON\n", "answers.jsonl:1: this is no JSON object");
  expect_refused("[1]\n", "answers.jsonl:1: this is JSON, but no object");
  expect_refused("\n{\"id\":\"" + id() + "\",\"for", "answers.jsonl:2: the file ends within this line");
  expect_refused("{\"touching\":true}\n", "answers.jsonl:1: \"id\" is missing");
  expect_refused("{\"id\":7}\n", "answers.jsonl:1: \"id\" is no text");
  expect_refused("{\"id\":\"nobody\"}\n", "answers.jsonl:1: no pose is called 'nobody'");
  expect_refused("{\"id\":\"" + id() + "\"}\n{\"id\":\"" + id() + "\"}\n",
                 "answers.jsonl:2: '" + id() + "' is answered a second time; line 1");
  expect_refused(with("\"touching\":1"), "answers.jsonl:2: \"touching\": 1 is neither true nor false");
  expect_refused(with("\"touching\":true,\"touching\":false"), "the key 'touching' is there twice");
  expect_refused(with("\"E\":{\"area\":1,\"area\":2}"), "the key 'area' is there twice");
  expect_refused(with("\"force\":[1,2,NaN]"), "answers.jsonl:2: NaN and infinity are no answers");
  expect_refused(with("\"force\":[1,2,Infinity]"), "answers.jsonl:2: NaN and infinity are no answers");
  expect_refused(with("\"force\":[1,2,\"nan\"]"), "answers.jsonl:2: \"force\": 'nan' is no number");
  expect_refused(with("\"force\":[1,2,\"inf\"]"), "answers.jsonl:2: \"force\": an infinite component");
  expect_refused(with("\"force\":[1,2]"), "answers.jsonl:2: \"force\": '[1,2]' is no list of three numbers");
  expect_refused(with("\"torque\":1"), "answers.jsonl:2: \"torque\": '1' is no list");
  expect_refused(with("\"volume\":\"big\""), "answers.jsonl:2: \"volume\": 'big' is no number");
  expect_refused(with("\"volume\":1e999"), "answers.jsonl:2: ");
  expect_refused(with("\"polygons\":-1"), "answers.jsonl:2: \"polygons\": '-1' is no number of things");
  expect_refused(with("\"polygons\":9007199254740992"),
                 "answers.jsonl:2: \"polygons\": '9007199254740992' is no number");
  expect_refused(with("\"polygons\":1.5"), "answers.jsonl:2: \"polygons\": '1.5' is no number of things");
  expect_refused(with("\"elements\":-2"), "answers.jsonl:2: \"elements\": '-2' is no number of things");
  expect_refused(with("\"pairs\":[]"), "answers.jsonl:2: the key 'pairs' is none of id, touching, crossing_pairs");
  expect_refused(with("\"crossing_pairs\":[[0,1,2]]"), "answers.jsonl:2: \"crossing_pairs\": '[0,1,2]' is no pair");
  expect_refused(with("\"crossing_pairs\":[[0,1],[0,1]]"),
                 "answers.jsonl:2: \"crossing_pairs\": a pair is listed twice");
  const std::size_t faces = folder_.posed.surfaces[folder_.posed.questions[0].E].mesh.faces.size();
  expect_refused(with("\"E\":{\"inner\":[" + std::to_string(faces) + "]}"),
                 "is no face of E, whose faces are 0 to " + std::to_string(faces - 1));
  expect_refused(with("\"E\":{\"inner\":[3,3]}"), "answers.jsonl:2: \"E\": \"inner\": a face is listed twice");
  expect_refused(with("\"F\":{\"vector_area\":[0,0,0]}"), "answers.jsonl:2: \"F\": the key 'vector_area' is none of");
  expect_refused(with("\"elements\":[{\"master_face\":0,\"slave_face\":0}]"), "\"master\" is missing");
  expect_refused(with("\"elements\":[{\"master\":\"E\",\"master_face\":0}]"),
                 "\"slave_face\" of an element is missing");
}

TEST_F(Folder, AnswersNestedTooDeepAreRefusedWithFileAndLine) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  const std::string too_deep = "answers.jsonl:2: lists and objects lie in one another more than 64 levels deep";
  // The line itself is a level.
  expect_refused(with("\"touching\":" + nested(63)), "is neither true nor false");
  expect_refused(with("\"touching\":" + nested(64)), too_deep);
  expect_refused(with("\"touching\":" + nested(200000)), too_deep);
  expect_refused(with("\"comment\":" + std::string(200000, '[')), too_deep);
  std::string objects;
  for (int k = 0; k < 100000; ++k) objects += "{\"E\":";
  expect_refused(with("\"E\":" + objects + "1" + std::string(100000, '}')), too_deep);
}

TEST_F(Folder, LinesAreReadToTheirEndsAndEndlessOnesAreRefused) {
  const TemporaryFolder scratch;
  // About the length of what is read at once, 4095.
  std::string text;
  for (std::size_t length = 4090; length < 4100; ++length) text += "{\"a\":\"" + std::string(length - 8, 'x') + "\"}\n";
  text.pop_back();
  JsonLines lines(scratch.write("lines.jsonl", text));
  for (std::size_t length = 4090; length < 4100; ++length) {
    const std::optional<Json> object = lines.next();
    ASSERT_TRUE(object) << length;
    EXPECT_EQ((*object)["a"].get<std::string>().size(), length - 8);
    EXPECT_EQ(lines.line(), static_cast<std::int64_t>(length) - 4089);
  }
  EXPECT_FALSE(lines.next());
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "this system has no /dev/zero";
  JsonLines endless("/dev/zero");
  expect_bad_input([&] { endless.next(); }, "/dev/zero:1: this line is longer than 64 MiB");
}

TEST_F(Folder, PosesNestedTooDeepAreRefusedWithFileAndLine) {
  const std::string poses = folder_.path() + "/poses.jsonl";
  std::string whole = content_of(poses);
  whole.replace(whole.find("\"A\":[") + 4, 1, std::string(100000, '['));
  std::ofstream(poses, std::ios::binary) << whole;
  expect_bad_input([&] { read_poses_folder(folder_.path()); }, "poses.jsonl:2: lists and objects lie in one another");
}

TEST_F(Folder, AnswersOfOtherFormatsAndSurfacesAreRefused) {
  expect_refused("{\"format\":\"pcm answers 9\"}\n", "answers.jsonl:1: these are answers of another format");
  const PosedSurface& surface = folder_.posed.surfaces[0];
  const auto header = [&](const std::string& name, const std::string& hash) {
    return "{\"format\":\"pcm answers 1\",\"surfaces\":{\"" + name + "\":\"" + hash + "\"}}\n";
  };
  expect_refused(header(surface.name, std::string(64, '0')),
                 "answers.jsonl:1: the engine has read another surface '" + surface.name + "'");
  expect_refused(header("nothing", surface.sha256), "answers.jsonl:1: no surface is called 'nothing'");
  const TemporaryFolder scratch;
  AnswersFile right(scratch.write("right.jsonl", header(surface.name, surface.sha256)), folder_.posed);
  EXPECT_FALSE(right.next());
  // Blank lines are none.
  expect_refused("\n" + header("nothing", surface.sha256), "answers.jsonl:2: no surface is called 'nothing'");
  EXPECT_NE(right.missing().find("12 of 12 poses have no answer"), std::string::npos) << right.missing();
}

TEST_F(Folder, PosesThatWereTamperedWithAreRefused) {
  const std::string poses = folder_.path() + "/poses.jsonl", whole = content_of(poses);
  const auto expect = [&](const std::string& text, const std::string& named) {
    std::ofstream(poses, std::ios::binary) << text;
    try {
      read_poses_folder(folder_.path());
      ADD_FAILURE() << named;
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos)
          << "expected '" << named << "' in: " << error.what();
    }
  };
  const std::size_t second = whole.find('\n') + 1, third = whole.find('\n', second) + 1;
  expect(whole.substr(0, third), "1 poses, where the first line says 12");
  expect(whole + whole.substr(second, third - second), "poses.jsonl:14: a pose '" + id() + "' stands there already");
  expect(whole.substr(0, third + 40), "poses.jsonl:3: the file ends within this line");
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  };
  expect(replaced("pcm poses 1", "pcm poses 2"), "poses.jsonl:1: these are poses of another format");
  expect(replaced("\"A\":[[", "\"A\":[[7.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]],\"former\":[["),
         "poses.jsonl:2: the key 'former' is none of id, pair");
  Json skew = Json::parse(whole.substr(second, third - second));
  skew["A"] = Json{{7.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  expect(whole.substr(0, second) + skew.dump() + "\n" + whole.substr(third), "poses.jsonl:2: pose: A is no rotation");
  expect(replaced("\"r\":[", "\"r\":[0.0,"), "is no list of three numbers");
  expect(replaced("\"A\":[", "\"A\":[[0.0,0.0,0.0],"), "poses.jsonl:2: \"A\" is no list of three rows");
  expect(replaced("\"damping\":", "\"damping_of_old\":0.0,\"damping\":"),
         "poses.jsonl:2: law: the key 'damping_of_old' is none of stiffness");
  expect(replaced("\"poses\":12", "\"poses\":-12"), "poses.jsonl:1: \"poses\": '-12' is no number of poses");
  expect(replaced("\"poses\":12", "\"poses\":12.0"), "poses.jsonl:1: \"poses\": '12.0' is no number of poses");
  expect(replaced("\"poses\":12", "\"poses\":12,\"pose\":1"), "poses.jsonl:1: the key 'pose' is none of format");
  expect(replaced("\"file\":", "\"files\":1,\"file\":"), "poses.jsonl:1: the key 'files' is none of name");
  expect(replaced("\"faces\":", "\"faces\":1"), "poses.jsonl:1: \"faces\": ");
  expect(replaced("\"scheme\":", "\"known_volume\":-5.0,\"scheme\":"), "poses.jsonl:2: \"known_volume\": -5.0");
  expect(replaced(",\"mode\":\"both\"", ""), "poses.jsonl:2: \"mode\" is missing");
  expect(replaced("\"mode\":\"both\"", "\"mode\":5"), "poses.jsonl:2: mode: type must be string");
  Json twice = Json::parse(whole.substr(0, second));
  twice["surfaces"].push_back(twice["surfaces"][0]);
  expect(twice.dump() + "\n" + whole.substr(second),
         "poses.jsonl:1: \"surfaces\": two are called '" + folder_.posed.surfaces[0].name + "'");

  std::ofstream(poses, std::ios::binary) << whole;
  std::ofstream(folder_.path() + "/" + folder_.posed.surfaces[0].file, std::ios::app) << "# other bytes\n";
  expect(whole, "has changed since the poses were written");
}

}  // namespace
}  // namespace pcm::compare
