// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A run kept in a folder is continued by the same program on the same surfaces only, and never passed off as a new one.
#include "compare/verify/run/kept_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "compare/io/program_hash.h"
#include "compare/io/sha256.h"
#include "compare/verify/tables/verification_table.h"
#include "meshes/files/text_file.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/lattice_tetrahedra.h"
#include "pcm/bad_input.h"
#include "pcm/write_obj.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

using Json = nlohmann::ordered_json;

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Changes what is kept in the folder, in a state that is not damaged.
void alter_state(const std::filesystem::path& folder, const std::function<void(Json&)>& alter) {
  Json state = Json::parse(bytes_of(folder / "state.json")).at("state");
  alter(state);
  const std::string text = state.dump();
  write_text_file(folder / "state.json", R"({"sha256":")" + sha256(text) + R"(","state":)" + text + "}\n");
}

class KeptRun : public testing::Test {
 protected:
  KeptRun() {
    SurfacePair pair;
    pair.name = "lattice tetrahedra";
    auto [E, F] = degenerate::lattice_tetrahedra(0);
    pair.E = std::move(E);
    pair.F = std::move(F);
    pair.variants = {degenerate::lattice_tetrahedra(2)};
    pair.law = verification_law(3, pair.E, pair.F);
    pair.for_hard_strata = true;
    plan_.pairs = {pair};
    plan_.poses = 2000;
    plan_.strata = {Stratum::separated};
  }

  /// Runs the first batch of two and leaves it in the folder, with a table and a case.
  void keep_half_a_run() {
    Verification run(plan_);
    ASSERT_EQ(run.batches(), 2);
    run.run_batch(
        2, [] { return false; }, [](std::int64_t) {});
    keep_run(scratch_.path(), run, {});
    for (const char* file : {"verification.md", "verification.csv", "verification.json", "times.md", "case_old.json"})
      scratch_.write(file, "old");
    scratch_.write("notes.txt", "not of the run");
  }

  bool exists(const char* file) const { return std::filesystem::exists(scratch_.path() / file); }

  void expect_started_anew(const VerificationPlan& plan, const std::string& why) {
    SCOPED_TRACE(why);
    Verification run(plan);
    const Resumption kept = resume_run(scratch_.path(), run);
    EXPECT_EQ(run.poses_done(), 0);
    EXPECT_NE(kept.notice.find(why), std::string::npos) << kept.notice;
    EXPECT_FALSE(kept.finished_at);
    for (const char* file :
         {"state.json", "verification.md", "verification.csv", "verification.json", "times.md", "case_old.json"})
      EXPECT_FALSE(exists(file)) << file;
    EXPECT_TRUE(exists("notes.txt"));
  }

  TemporaryFolder scratch_;
  VerificationPlan plan_;
};

TEST_F(KeptRun, OfTheSameProgramIsContinuedAndSaysSo) {
  keep_half_a_run();
  Verification run(plan_);
  const Resumption kept = resume_run(scratch_.path(), run);
  EXPECT_GT(run.poses_done(), 0);
  EXPECT_NE(kept.notice.find("continued after " + std::to_string(run.poses_done()) + " poses"), std::string::npos);
  EXPECT_FALSE(kept.finished_at);
  EXPECT_TRUE(exists("case_old.json"));
}

TEST_F(KeptRun, OfAnotherBuildIsRemoved) {
  keep_half_a_run();
  VerificationPlan other = plan_;
  other.build = std::string(64, '0');
  expect_started_anew(other, "another build");
}

TEST_F(KeptRun, OfABuildThatKeptNoHashIsRemoved) {
  keep_half_a_run();
  alter_state(scratch_.path(), [](Json& state) {
    state["run"].erase("build");
    state["run"]["format"] = "pcm verification 4";
  });
  expect_started_anew(plan_, "another build");
}

TEST_F(KeptRun, OnOtherSurfacesIsRemoved) {
  const auto up = [](double& x) { x = std::nextafter(x, std::numeric_limits<double>::infinity()); };
  const std::vector<std::function<void(SurfacePair&)>> changes = {
      [&](SurfacePair& pair) { up(pair.E.vertices[1].x()); },
      [&](SurfacePair& pair) { up(pair.F.vertices[3].z()); },
      [](SurfacePair& pair) { std::swap(pair.F.faces[0], pair.F.faces[1]); },
      [&](SurfacePair& pair) { up(pair.variants[0][1].vertices[0].y()); },
      [](SurfacePair& pair) { pair.variants.clear(); },
      [](SurfacePair& pair) { pair.name = "others"; },
  };
  for (std::size_t k = 0; k < changes.size(); ++k) {
    SCOPED_TRACE(k);
    keep_half_a_run();
    VerificationPlan other = plan_;
    changes[k](other.pairs.front());
    expect_started_anew(other, "other surfaces");
  }
}

TEST_F(KeptRun, UnderAnotherLawOfThePairIsContinuedForPosesAreAskedUnderLawsOfTheirOwn) {
  keep_half_a_run();
  VerificationPlan other = plan_;
  other.pairs.front().law = ContactLaw{};
  Verification run(other), whole(plan_);
  EXPECT_NE(resume_run(scratch_.path(), run).notice.find("continued"), std::string::npos);
  for (Verification* one : {&run, &whole})
    while (!one->finished())
      one->run_batch(
          2, [] { return false; }, [](std::int64_t) {});
  EXPECT_EQ(verification_csv(run), verification_csv(whole));
}

TEST_F(KeptRun, WithoutAStateIsRemovedForItsCasesAreNobodys) {
  keep_half_a_run();
  std::filesystem::remove(scratch_.path() / "state.json");
  expect_started_anew(plan_, "whose state is gone");
  Verification run(plan_);
  EXPECT_EQ(resume_run(scratch_.path(), run).notice, "") << "nothing is left to tell of";
}

TEST_F(KeptRun, ThatLacksAnArgumentOrHasOneMoreIsOfOtherArguments) {
  const std::vector<std::function<void(Json&)>> changes = {
      [](Json& run) { run = Json::object(); },
      [](Json& run) {
        run = Json::array({1, 2});
      },
      [](Json& run) { run.erase("poses"); },
      [](Json& run) { run.erase("seed"); },
      [](Json& run) { run.erase("modes"); },
      [](Json& run) { run.erase("schemes"); },
      [](Json& run) { run.erase("strata"); },
      [](Json& run) { run["friction"] = 1; },
      [](Json& run) {  // as "pcm verification 4" wrote it
        run.erase("schemes");
        run["scheme"] = 1;
        run["format"] = "pcm verification 4";
      },
  };
  for (std::size_t k = 0; k < changes.size(); ++k) {
    SCOPED_TRACE(k);
    keep_half_a_run();
    alter_state(scratch_.path(), [&](Json& state) { changes[k](state["run"]); });
    Verification run(plan_);
    EXPECT_THROW(resume_run(scratch_.path(), run), BadInput);
    for (const char* file : {"state.json", "verification.md", "case_old.json"}) EXPECT_TRUE(exists(file)) << file;
  }
}

TEST_F(KeptRun, WithOtherArgumentsOrDamagedIsRefusedAndLeftAlone) {
  keep_half_a_run();
  const std::string kept = bytes_of(scratch_.path() / "state.json");
  VerificationPlan other = plan_;
  other.seed = 2;
  other.build = std::string(64, '0');
  Verification run(other);
  EXPECT_THROW(resume_run(scratch_.path(), run), BadInput);
  EXPECT_EQ(bytes_of(scratch_.path() / "state.json"), kept);
  scratch_.write("state.json", kept.substr(0, kept.size() / 2));
  Verification same(plan_);
  EXPECT_THROW(resume_run(scratch_.path(), same), BadInput);
  EXPECT_TRUE(exists("case_old.json"));
}

/// What the program itself does with a kept run.
class KeptRunOfTheProgram : public testing::Test {
 protected:
  KeptRunOfTheProgram() {
    write_obj(generate::box({1, 1, 1}), scratch_.path("box.obj"));
    const std::string box = scratch_.path("box.obj");
    verify_ = {"verify", "--poses", "6", "--pair", box, box, "--jobs", "1", "--out", folder_.string()};
  }

  TemporaryFolder scratch_;
  std::filesystem::path folder_ = scratch_.path("run");
  std::vector<std::string> verify_;
};

TEST_F(KeptRunOfTheProgram, FinishedByAnEarlierCallIsSaidToBeSoBeforeTheVerdictAndInIt) {
  const Outcome first = run_pcm(verify_);
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(first.out.find("earlier"), std::string::npos) << first.out;
  const Outcome second = run_pcm(verify_);
  EXPECT_EQ(second.status, 0);
  const std::string verdict = lines_of(second.out).back();
  EXPECT_TRUE(verdict.starts_with(lines_of(first.out).back())) << verdict;
  EXPECT_NE(verdict.find("earlier run's, finished 2"), std::string::npos) << verdict;
  EXPECT_NE(verdict.find("nothing evaluated now"), std::string::npos) << verdict;
  const std::string before = second.out.substr(0, second.out.rfind("verified:"));
  EXPECT_NE(before.find("those of an earlier run"), std::string::npos) << before;
  EXPECT_NE(before.find("Nothing was evaluated now"), std::string::npos) << before;
}

TEST_F(KeptRunOfTheProgram, FinishedByAnEarlierCallHasTablesThatSayWhichCallItWas) {
  ASSERT_EQ(run_pcm(verify_).status, 0);
  const std::string provenance = bytes_of(folder_ / "verification.provenance.json");
  std::vector<std::string> later = verify_;
  later.insert(later.end(), {"--mode", "both"});
  ASSERT_EQ(run_pcm(later).status, 0);
  EXPECT_EQ(bytes_of(folder_ / "verification.provenance.json"), provenance);
}

TEST_F(KeptRunOfTheProgram, FinishedWithoutItsLastTableGetsIt) {
  ASSERT_EQ(run_pcm(verify_).status, 0);
  const std::string table = bytes_of(folder_ / "verification.md");
  std::filesystem::remove(folder_ / "verification.md");
  ASSERT_EQ(run_pcm(verify_).status, 0);
  EXPECT_EQ(bytes_of(folder_ / "verification.md"), table);
}

TEST_F(KeptRunOfTheProgram, FinishedWithATableDamagedOrGoneGetsAllOfThem) {
  ASSERT_EQ(run_pcm(verify_).status, 0);
  std::map<std::string, std::string> tables;
  for (const char* file : {"widths.csv", "verification.csv", "verification.json", "times.md", "verification.md"})
    tables[file] = bytes_of(folder_ / file);
  write_text_file(folder_ / "verification.csv", "garbage");
  write_text_file(folder_ / "times.md", "");
  for (const char* file : {"widths.csv", "verification.json"}) std::filesystem::remove(folder_ / file);
  const Outcome again = run_pcm(verify_);
  EXPECT_EQ(again.status, 0);
  EXPECT_NE(again.out.find("earlier run"), std::string::npos);
  for (const auto& [file, text] : tables) EXPECT_EQ(bytes_of(folder_ / file), text) << file;
}

TEST_F(KeptRunOfTheProgram, WithoutAStateLeavesNoCaseBesideTheNewTables) {
  std::filesystem::create_directories(folder_);
  write_text_file(folder_ / "case_box-box_generic_0_both.json", "stale");
  const Outcome first = run_pcm(verify_);
  EXPECT_EQ(first.status, 0);
  EXPECT_NE(first.err.find("whose state is gone"), std::string::npos) << first.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "case_box-box_generic_0_both.json"));
}

TEST_F(KeptRunOfTheProgram, HoldsTheHashOfTheProgramAndAnotherOnesIsReplaced) {
  ASSERT_EQ(run_pcm(verify_).status, 0);
  const std::string hash = sha256(bytes_of(PCM_PROGRAM));
  const auto kept_hash = [&] { return Json::parse(bytes_of(folder_ / "state.json"))["state"]["run"]["build"]; };
  EXPECT_EQ(kept_hash(), hash);
  EXPECT_NE(program_hash(), hash) << "the tests are a program of their own";

  alter_state(folder_, [](Json& state) { state["run"]["build"] = std::string(64, '0'); });
  write_text_file(folder_ / "case_box-box_generic_0_both.json", "stale");
  const Outcome anew = run_pcm(verify_);
  EXPECT_EQ(anew.status, 0);
  EXPECT_NE(anew.err.find("another build"), std::string::npos) << anew.err;
  EXPECT_EQ(anew.out.find("earlier run"), std::string::npos) << anew.out;
  EXPECT_EQ(kept_hash(), hash);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "case_box-box_generic_0_both.json"));
}

}  // namespace
}  // namespace pcm::compare
