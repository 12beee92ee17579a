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
#include <thread>
#include <utility>
#include <vector>

#include "compare/io/provenance/program_hash.h"
#include "compare/io/provenance/sha256.h"
#include "compare/verify/run/run_chunks.h"
#include "compare/verify/tables/verification_table.h"
#include "meshes/files/text_file.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/lattice_tetrahedra.h"
#include "pcm/bad_input.h"
#include "pcm/write_obj.h"
#include "tests/compare/run_pcm.h"
#include "tests/compare/verify/routes/altering_seam.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::kept_run_test {
namespace {

using Json = nlohmann::ordered_json;

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Json kept_identity(const std::filesystem::path& folder) {
  Database database(folder / kCampaignFile);
  Statement job(database, "SELECT identity FROM job");
  return job.step() ? Json::parse(job.text(0)) : Json();
}

/// Changes whose run is kept in the folder, in a campaign that is not damaged.
void alter_identity(const std::filesystem::path& folder, const std::function<void(Json&)>& alter) {
  Json identity = kept_identity(folder);
  alter(identity);
  Database database(folder / kCampaignFile);
  Statement job(database, "SELECT chunks, part, parts, number FROM job");
  ASSERT_TRUE(job.step());
  const std::string text = identity.dump();
  const std::string hash =
      sha256(text + '\n' + job.text(0) + '\n' + job.text(1) + '/' + job.text(2) + '\n' + job.text(3));
  Statement(database, "UPDATE job SET identity = ?, sha256 = ?", text, hash).run();
}

constexpr auto kNever = [] { return false; };
constexpr auto kSilent = [](std::int64_t) {};

/// Every cell's counts, whatever the times.
std::string csv_of(const VerificationPlan& plan, Outcomes outcomes) {
  Verification run(plan);
  run.add(std::move(outcomes));
  return verification_csv(run);
}

class KeptRunTest : public testing::Test {
 protected:
  KeptRunTest() {
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

  /// Runs some chunks and leaves them in the folder, with a table and a case.
  void keep_half_a_run() {
    const Verification run(plan_);
    KeptRun kept(scratch_.path(), run);
    std::int64_t asked = 0;
    run_chunks(
        run, kept, 1, [&] { return ++asked > 1000; }, kSilent);
    for (const char* file : {"overview.md", "verification.md", "verification.csv", "verification.json", "times.md",
                             "verification.provenance.json"})
      scratch_.write(file, "old");
    scratch_.write("case_old.json", R"({"origin": "old"})");
    for (const char* file : {"notes.txt", "notes.json", "case_mine.json"}) scratch_.write(file, "not of the run");
  }

  std::int64_t poses_kept(const VerificationPlan& plan) const {
    const Verification run(plan);
    KeptRun kept(scratch_.path(), run);
    std::int64_t poses = 0;
    for (const auto& [cell, outcome] : kept.outcomes().cells) poses += outcome.tally.poses;
    return poses;
  }

  bool exists(const char* file) const { return std::filesystem::exists(scratch_.path() / file); }

  void expect_started_anew(const VerificationPlan& plan, const std::string& why) {
    SCOPED_TRACE(why);
    const Verification run(plan);
    KeptRun kept(scratch_.path(), run);
    EXPECT_TRUE(kept.outcomes().cells.empty());
    EXPECT_FALSE(kept.part_done());
    EXPECT_NE(kept.notice().find(why), std::string::npos) << kept.notice();
    EXPECT_FALSE(kept.finished());
    for (const char* file :
         {"overview.md", "verification.md", "verification.csv", "verification.json", "times.md", "case_old.json"})
      EXPECT_FALSE(exists(file)) << file;
    for (const char* file : {"notes.txt", "notes.json", "case_mine.json"}) EXPECT_TRUE(exists(file)) << file;
  }

  TemporaryFolder scratch_;
  VerificationPlan plan_;
};

TEST_F(KeptRunTest, OfTheSameProgramIsContinuedAndEndsAsAnUninterruptedOne) {
  keep_half_a_run();
  EXPECT_GT(poses_kept(plan_), 0);
  EXPECT_LT(poses_kept(plan_), 2000);
  const Verification run(plan_);
  KeptRun kept(scratch_.path(), run);
  EXPECT_EQ(kept.notice(), "");
  EXPECT_FALSE(kept.finished());
  EXPECT_TRUE(exists("case_old.json"));
  run_chunks(run, kept, 2, kNever, kSilent);
  EXPECT_TRUE(kept.part_done());
  Verification whole(plan_);
  run_all(whole, 1, kNever, kSilent);
  EXPECT_EQ(csv_of(plan_, kept.outcomes()), verification_csv(whole));
  kept.finish({{"who", "first"}}, "launch");
  EXPECT_EQ(kept.finished()->by["who"], "first");
  EXPECT_EQ(kept.finished()->launch, "launch");
}

TEST_F(KeptRunTest, IsDoneByTwoAtATimeAsByOne) {
  const Verification run(plan_);
  KeptRun first(scratch_.path(), run), second(scratch_.path(), run);
  std::jthread other([&] { run_chunks(run, second, 1, kNever, kSilent); });
  run_chunks(run, first, 1, kNever, kSilent);
  other.join();
  EXPECT_TRUE(first.part_done());
  Verification whole(plan_);
  run_all(whole, 2, kNever, kSilent);
  EXPECT_EQ(csv_of(plan_, first.outcomes()), verification_csv(whole));
}

TEST_F(KeptRunTest, KeepsTheSameFindingsWhoeverHasThem) {
  const AlteringSeam wrong([](fast::Contact& contact) {
    contact.touching = !contact.touching;
    return true;
  });
  Verification whole(plan_, wrong);
  run_all(whole, 1, kNever, kSilent);
  ASSERT_EQ(whole.findings().size(), kMostFindings);
  const Verification run(plan_, wrong);
  KeptRun first(scratch_.path(), run), second(scratch_.path(), run);
  std::int64_t asked = 0;
  run_chunks(
      run, first, 1, [&] { return ++asked > 1200; }, kSilent);
  run_chunks(run, second, 1, kNever, kSilent);
  ASSERT_TRUE(second.part_done());
  const Outcomes all = second.outcomes();
  ASSERT_EQ(all.findings.size(), kMostFindings);
  for (std::size_t k = 0; k < kMostFindings; ++k) {
    EXPECT_EQ(all.findings[k].cell, whole.findings()[k].cell);
    EXPECT_EQ(all.findings[k].pose, whole.findings()[k].pose);
    EXPECT_EQ(all.findings[k].disagreements.front().text, whole.findings()[k].disagreements.front().text);
  }
}

TEST_F(KeptRunTest, OfAnotherBuildIsRemoved) {
  keep_half_a_run();
  VerificationPlan other = plan_;
  other.build = std::string(64, '0');
  expect_started_anew(other, "another build");
}

TEST_F(KeptRunTest, OfABuildThatKeptNoHashIsRemoved) {
  keep_half_a_run();
  alter_identity(scratch_.path(), [](Json& run) {
    run.erase("build");
    run["format"] = "pcm verification 4";
  });
  expect_started_anew(plan_, "another build");
}

TEST_F(KeptRunTest, OnOtherSurfacesIsRemoved) {
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

TEST_F(KeptRunTest, UnderAnotherLawOfThePairIsContinuedForPosesAreAskedUnderLawsOfTheirOwn) {
  keep_half_a_run();
  VerificationPlan other = plan_;
  other.pairs.front().law = ContactLaw{};
  EXPECT_GT(poses_kept(other), 0);
  const Verification run(other);
  KeptRun kept(scratch_.path(), run);
  run_chunks(run, kept, 2, kNever, kSilent);
  Verification whole(plan_);
  run_all(whole, 2, kNever, kSilent);
  EXPECT_EQ(csv_of(other, kept.outcomes()), verification_csv(whole));
}

TEST_F(KeptRunTest, WithoutACampaignIsRemovedForItsCasesAreNobodys) {
  keep_half_a_run();
  std::filesystem::remove(scratch_.path() / kCampaignFile);
  expect_started_anew(plan_, "whose campaign is gone");
  const Verification run(plan_);
  EXPECT_EQ(KeptRun(scratch_.path(), run).notice(), "") << "nothing is left to tell of";
}

TEST_F(KeptRunTest, OfAnotherBuildIsLeftAloneWhileOthersAreAtIt) {
  keep_half_a_run();
  const Verification run(plan_);
  KeptRun kept(scratch_.path(), run);
  VerificationPlan other = plan_;
  other.build = std::string(64, '0');
  const Verification another(other);
  EXPECT_THROW(KeptRun(scratch_.path(), another), BadInput);
  EXPECT_TRUE(exists("case_old.json"));
  run_chunks(run, kept, 1, kNever, kSilent);
  EXPECT_TRUE(kept.all_done());
}

TEST_F(KeptRunTest, OfAnEarlierVersionIsLeftAlone) {
  scratch_.write("state.json", "{}");
  const Verification run(plan_);
  EXPECT_THROW(KeptRun(scratch_.path(), run), BadInput);
  EXPECT_TRUE(exists("state.json"));
  EXPECT_FALSE(exists(kCampaignFile));
  // An empty campaign is what a refusal used to leave.
  for (const char* file : {kCampaignFile, "verification.md"}) scratch_.write(file, "");
  EXPECT_THROW(KeptRun(scratch_.path(), run), BadInput);
  EXPECT_TRUE(exists("verification.md"));
}

TEST_F(KeptRunTest, ThatLacksAnArgumentOrHasOneMoreIsOfOtherArguments) {
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
    alter_identity(scratch_.path(), changes[k]);
    const Verification run(plan_);
    EXPECT_THROW(KeptRun(scratch_.path(), run), BadInput);
    std::filesystem::remove(scratch_.path() / kCampaignFile);
    for (const char* file : {"verification.md", "case_old.json"}) EXPECT_TRUE(exists(file)) << file;
  }
}

TEST_F(KeptRunTest, WithOtherArgumentsOrDamagedIsRefusedAndLeftAlone) {
  keep_half_a_run();
  const std::string kept = bytes_of(scratch_.path() / kCampaignFile);
  VerificationPlan other = plan_;
  other.seed = 2;
  other.build = std::string(64, '0');
  const Verification run(other);
  EXPECT_THROW(KeptRun(scratch_.path(), run), BadInput);
  EXPECT_EQ(bytes_of(scratch_.path() / kCampaignFile), kept);
  const Verification same(plan_);
  scratch_.write(kCampaignFile, kept.substr(0, kept.size() / 2));
  EXPECT_THROW(KeptRun(scratch_.path(), same).outcomes(), BadInput);
  scratch_.write(kCampaignFile, kept);
  {
    Database database(scratch_.path() / kCampaignFile);
    database.run("UPDATE found SET text = replace(text, '1', '2')");
  }
  EXPECT_THROW(KeptRun(scratch_.path(), same).outcomes(), BadInput);
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

TEST_F(KeptRunOfTheProgram, WithoutACampaignLeavesNoCaseBesideTheNewTables) {
  std::filesystem::create_directories(folder_);
  write_text_file(folder_ / "case_box-box_generic_0_both.json",
                  R"({"origin": "seed 1, box-box/generic/0/both, drawn"})");
  const Outcome first = run_pcm(verify_);
  EXPECT_EQ(first.status, 0);
  EXPECT_NE(first.err.find("whose campaign is gone"), std::string::npos) << first.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "case_box-box_generic_0_both.json"));
}

TEST_F(KeptRunOfTheProgram, RefusesAFolderWithFilesOfOthersThatAreCalledAsTablesAre) {
  std::filesystem::create_directories(folder_);
  write_text_file(folder_ / "overview.md", "my thesis");
  const Outcome refused = run_pcm(verify_);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("overview.md is there, which no run has left"), std::string::npos) << refused.err;
  EXPECT_EQ(bytes_of(folder_ / "overview.md"), "my thesis");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(KeptRunOfTheProgram, RefusesSuchAFolderWithAnEmptyCampaignToo) {
  std::filesystem::create_directories(folder_);
  write_text_file(folder_ / "overview.md", "my thesis");
  write_text_file(folder_ / "campaign.sqlite", "");
  const Outcome refused = run_pcm(verify_);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("overview.md is there, which no run has left"), std::string::npos) << refused.err;
  EXPECT_EQ(bytes_of(folder_ / "overview.md"), "my thesis");
}

TEST_F(KeptRunOfTheProgram, ReplacesTablesThatARunWasWritingWhoseCampaignIsGone) {
  std::filesystem::create_directories(folder_);
  write_text_file(folder_ / "overview.md", "half a run's");
  write_text_file(folder_ / "verification.provenance.json.part", R"({"files": {"overview.md": {}}})");
  const Outcome anew = run_pcm(verify_);
  EXPECT_EQ(anew.status, 0) << anew.err;
  EXPECT_NE(anew.err.find("whose campaign is gone"), std::string::npos) << anew.err;
  EXPECT_NE(bytes_of(folder_ / "overview.md"), "half a run's");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "verification.provenance.json.part"));
}

TEST_F(KeptRunOfTheProgram, HoldsTheHashOfTheProgramAndAnotherOnesIsReplaced) {
  ASSERT_EQ(run_pcm(verify_).status, 0);
  const std::string hash = sha256(bytes_of(PCM_PROGRAM));
  const auto kept_hash = [&] { return kept_identity(folder_)["build"]; };
  EXPECT_EQ(kept_hash(), hash);
  EXPECT_NE(program_hash(), hash) << "the tests are a program of their own";

  alter_identity(folder_, [](Json& run) { run["build"] = std::string(64, '0'); });
  write_text_file(folder_ / "case_box-box_generic_0_both.json",
                  R"({"origin": "seed 1, box-box/generic/0/both, drawn"})");
  const Outcome anew = run_pcm(verify_);
  EXPECT_EQ(anew.status, 0);
  EXPECT_NE(anew.err.find("another build"), std::string::npos) << anew.err;
  EXPECT_EQ(anew.out.find("earlier run"), std::string::npos) << anew.out;
  EXPECT_EQ(kept_hash(), hash);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "case_box-box_generic_0_both.json"));
}

}  // namespace
}  // namespace pcm::compare::kept_run_test
