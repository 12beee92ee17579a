// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The program's tables do not depend on how many processes share in a run, on machines that hold parts of it, or on who
// of them is killed.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "compare/campaign/database.h"
#include "meshes/files/text_file.h"
#include "meshes/generate/boxes.h"
#include "pcm/write_obj.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::shared_run_test {
namespace {

using Words = std::vector<std::string>;

class SharedRun : public testing::Test {
 protected:
  void SetUp() override {
    write_obj(generate::box({1, 1, 1}), scratch_.path("box.obj"));
    const Outcome alone = run_pcm(verify("alone"));
    ASSERT_EQ(alone.status, 0) << alone.out << alone.err;
    verdict_ = lines_of(alone.out).back();
  }

  Words verify(const std::string& folder, const Words& more = {}) const {
    const std::string box = scratch_.path("box.obj");
    Words words{"verify", "--poses", "300", "--pair", box, box, "--jobs", "1", "--out", scratch_.path(folder)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  pid_t start(const Words& words) const {
    const pid_t child = fork();
    if (child != 0) return child;
    std::vector<char*> arguments{const_cast<char*>(PCM_PROGRAM)};  // NOLINT: execv wants it so
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT
    arguments.push_back(nullptr);
    const std::string null = "/dev/null";
    if (freopen(null.c_str(), "w", stdout) == nullptr || freopen(null.c_str(), "w", stderr) == nullptr) _exit(126);
    execv(PCM_PROGRAM, arguments.data());
    _exit(127);
  }

  /// But for the campaign, provenance and times.
  void expect_same_tables(const std::string& folder) const {
    for (const char* table : {"/verification.csv", "/widths.csv"})
      EXPECT_EQ(read_text_file(scratch_.path(folder) + table), read_text_file(scratch_.path("alone") + table))
          << folder << table;
  }

  TemporaryFolder scratch_;
  std::string verdict_;
};

/// How many workers have found something in a folder's run.
std::int64_t workers_in(const std::string& file) {
  Database database(file);
  Statement begun(database, "SELECT count(*) FROM sqlite_master WHERE name = 'found'");
  begun.step();
  if (begun.integer(0) == 0) return 0;  // the file is there, and nothing in it yet
  Statement workers(database, "SELECT count(DISTINCT worker) FROM found");
  workers.step();
  return workers.integer(0);
}

/// Two seconds at most.
void wait_for_workers(std::int64_t workers, const std::string& file) {
  for (int k = 0; k < 200 && (!std::filesystem::exists(file) || workers_in(file) < workers); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

TEST_F(SharedRun, OfFourProcessesOneOfWhichIsKilledHasTheTablesOfOne) {
  std::vector<pid_t> processes;
  for (int k = 0; k < 4; ++k) processes.push_back(start(verify("shared")));
  const std::string file = scratch_.path("shared/campaign.sqlite");
  wait_for_workers(2, file);
  kill(processes[1], SIGKILL);
  int killed = 0;
  waitpid(processes[1], &killed, 0);
  EXPECT_TRUE(WIFSIGNALED(killed)) << "it had ended by itself";
  for (const std::size_t k : {0, 2, 3}) {
    int status = 0;
    waitpid(processes[k], &status, 0);
    EXPECT_EQ(status, 0) << k;
  }
  EXPECT_GE(workers_in(file), 2) << "they shared";
  expect_same_tables("shared");
}

TEST_F(SharedRun, KilledAltogetherGoesOnAndEndsWithTheTablesOfAnUninterruptedOne) {
  const std::string file = scratch_.path("killed/campaign.sqlite");
  const pid_t process = start(verify("killed"));
  wait_for_workers(1, file);
  kill(process, SIGKILL);
  int killed = 0;
  waitpid(process, &killed, 0);
  EXPECT_TRUE(WIFSIGNALED(killed)) << "it had ended by itself";
  const Outcome last = run_pcm(verify("killed"));
  EXPECT_EQ(last.status, 0) << last.err;
  EXPECT_NE(last.err.find("continued, "), std::string::npos) << last.err;
  EXPECT_EQ(lines_of(last.out).back(), verdict_) << last.out;
  expect_same_tables("killed");
}

TEST_F(SharedRun, InterruptedGoesOnAndIsNotFinishedBeforeItsTablesAreWritten) {
  const pid_t process = start(verify("interrupted"));
  const std::string file = scratch_.path("interrupted/campaign.sqlite");
  wait_for_workers(1, file);
  kill(process, SIGINT);
  int status = 0;
  waitpid(process, &status, 0);
  ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << status;
  EXPECT_NE(read_text_file(scratch_.path("interrupted/verification.md")).find("(interrupted, 300 poses wanted)"),
            std::string::npos);

  std::filesystem::remove(scratch_.path("interrupted/widths.csv"));
  std::filesystem::create_directories(scratch_.path("interrupted/widths.csv/in the way"));
  const Outcome failed = run_pcm(verify("interrupted"));
  EXPECT_EQ(failed.status, 2);
  EXPECT_EQ(lines_of(failed.out).back(), verdict_) << "the verdict is not lost";
  std::filesystem::remove_all(scratch_.path("interrupted/widths.csv"));
  const Outcome again = run_pcm(verify("interrupted"));
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(lines_of(again.out).back(), verdict_) << "it is no earlier run's";
  expect_same_tables("interrupted");
}

TEST_F(SharedRun, WithoutAllThatWasFoundIsDamagedAndNotVerified) {
  {
    Database database(scratch_.path("alone/campaign.sqlite"));
    database.run("DELETE FROM found WHERE key = '0'");
  }
  const Outcome outcome = run_pcm(verify("alone"));
  EXPECT_EQ(outcome.status, 2) << outcome.out;
  EXPECT_NE(outcome.err.find("it is damaged"), std::string::npos) << outcome.err;
}

TEST_F(SharedRun, FinishedIsSaidByWhoeverWasStartedApart) {
  for (int k = 0; k < 5; ++k) {
    const pid_t other = start(verify("alone"));
    const Outcome outcome = run_pcm(verify("alone"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(lines_of(outcome.out).back().starts_with(verdict_)) << outcome.out;
    int status = 0;
    waitpid(other, &status, 0);
    EXPECT_EQ(status, 0);
  }
}

TEST_F(SharedRun, PartsOfSeveralMachinesArePutTogether) {
  Words folders{"--merge"};
  for (const std::string k : {"1", "2", "3"}) {
    const Outcome part = run_pcm(verify("part " + k, {"--part", k + "/3"}));
    EXPECT_EQ(part.status, 0) << part.err;
    EXPECT_TRUE(lines_of(part.out).back().starts_with("part " + k + " of 3: ")) << part.out;
    for (const std::string& line : lines_of(read_text_file(scratch_.path("part " + k) + "/times.md")))
      EXPECT_EQ(line.find("| both | 0.00 / 0.00 |"), std::string::npos) << "of no pose: " << line;
    folders.push_back(scratch_.path("part " + k));
  }
  // Refused, this leaves nothing that would keep others out of the folder.
  const Outcome other = run_pcm({"verify", "--poses", "6", "--out", scratch_.path("whole"), folders[0], folders[1]});
  EXPECT_EQ(other.status, 2);
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("whole")));
  const Outcome two = run_pcm(verify("whole", {folders[0], folders[1], folders[3]}));
  EXPECT_EQ(two.status, 1);
  EXPECT_TRUE(lines_of(two.out).back().starts_with("unfinished: ")) << two.out;
  EXPECT_NE(two.out.find("(parts are missing, 300 poses wanted)"), std::string::npos) << two.out;
  const Outcome whole = run_pcm(verify("whole", folders));
  EXPECT_EQ(whole.status, 0) << whole.err;
  EXPECT_EQ(lines_of(whole.out).back(), verdict_);
  expect_same_tables("whole");
}

TEST_F(SharedRun, OfMpirunHasTheTablesOfOneProcessAndOneVerdict) {
  if (!has_mpirun()) GTEST_SKIP() << "mpirun (Debian: openmpi-bin) is not installed";
  for (const int ranks : {2, 4}) {
    const std::string folder = "ranks " + std::to_string(ranks);
    const Outcome outcome = run_by_mpirun(ranks, verify(folder));
    const std::string& printed = outcome.out;
    EXPECT_EQ(outcome.status, 0) << printed << outcome.err;
    const std::size_t at = printed.find("\nverified: ");
    EXPECT_NE(at, std::string::npos) << printed;
    EXPECT_EQ(printed.find("\nverified: ", at + 1), std::string::npos) << "said twice";
    EXPECT_NE(printed.find(verdict_), std::string::npos) << printed;
    expect_same_tables(folder);
  }
}

TEST_F(SharedRun, OfMpirunWithoutAFolderIsRefused) {
  setenv("OMPI_COMM_WORLD_RANK", "0", 1);
  setenv("OMPI_COMM_WORLD_SIZE", "2", 1);
  const Outcome outcome = run_pcm({"verify", "--poses", "6", "--jobs", "1"});
  unsetenv("OMPI_COMM_WORLD_RANK");
  unsetenv("OMPI_COMM_WORLD_SIZE");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--out DIR"), std::string::npos) << outcome.err;
}

TEST_F(SharedRun, PartsThatAreNoneAreRefused) {
  for (const std::string part : {"0/3", "4/3", "1", "x/3", "1/x", "1/0", "1/3/5", ""}) {
    const Outcome outcome = run_pcm(verify("odd", {"--part", part}));
    EXPECT_EQ(outcome.status, 2) << part;
    EXPECT_NE(outcome.err.find("--part"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run_pcm({"verify", "--poses", "6", "--part", "1/2"}).status, 2);
  EXPECT_EQ(run_pcm(verify("alone", {"--part", "1/2"})).status, 2) << "it holds the whole run";
}

}  // namespace
}  // namespace pcm::compare::shared_run_test
