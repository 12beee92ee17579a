// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/launcher.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

namespace pcm::compare::launcher_test {
namespace {

LaunchedProcess launched_with(const std::map<std::string, std::string>& environment) {
  for (const char* variable : {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE", "PMIX_NAMESPACE",
                               "SLURM_PROCID", "SLURM_STEP_ID"})
    unsetenv(variable);
  for (const auto& [variable, value] : environment) setenv(variable.c_str(), value.c_str(), 1);
  LaunchedProcess process = launched_process();
  for (const auto& [variable, value] : environment) unsetenv(variable.c_str());
  return process;
}

TEST(LaunchedProcess, IsOneOfOneWhereNobodySaysOtherwise) {
  const LaunchedProcess process = launched_with({});
  EXPECT_EQ(process.rank, 0);
  EXPECT_EQ(process.processes, 1);
  EXPECT_EQ(process.launch, "");
}

TEST(LaunchedProcess, KnowsItsRankFromOpenMpiAndSlurm) {
  const LaunchedProcess mpirun = launched_with({{"OMPI_COMM_WORLD_RANK", "2"},
                                                {"OMPI_COMM_WORLD_SIZE", "8"},
                                                {"OMPI_COMM_WORLD_LOCAL_SIZE", "4"},
                                                {"OMPI_MCA_ess_base_jobid", "77"}});
  EXPECT_EQ(mpirun.rank, 2);
  EXPECT_EQ(mpirun.processes, 8);
  EXPECT_EQ(mpirun.on_this_machine, 4);
  EXPECT_NE(mpirun.launch.find("77"), std::string::npos) << mpirun.launch;
  const LaunchedProcess srun = launched_with({{"SLURM_PROCID", "5"},
                                              {"SLURM_STEP_NUM_TASKS", "6"},
                                              {"SLURM_STEP_TASKS_PER_NODE", "3(x2)"},
                                              {"SLURM_JOB_ID", "12"},
                                              {"SLURM_STEP_ID", "3"}});
  EXPECT_EQ(srun.rank, 5);
  EXPECT_EQ(srun.processes, 6);
  EXPECT_EQ(srun.on_this_machine, 3);
  EXPECT_NE(srun.launch.find("12.3"), std::string::npos) << srun.launch;
}

/// Of a process that this one has started, by a launcher that gives no name.
std::string launch_of_child() {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    const std::string launch = launched_with({{"PMI_RANK", "0"}, {"PMI_SIZE", "2"}}).launch;
    _exit(write(ends[1], launch.data(), launch.size()) == static_cast<ssize_t>(launch.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::array<char, 512> text{};
  const ssize_t size = read(ends[0], text.data(), text.size());
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

TEST(LaunchedProcess, OfALauncherThatGivesNoNameIsOfTheLaunchOfWhoStartedIt) {
  const std::string one = launch_of_child(), other = launch_of_child();
  EXPECT_EQ(one, other);
  EXPECT_NE(one.find(' ' + std::to_string(getpid()) + ' '), std::string::npos) << one;
  EXPECT_NE(one.back(), ' ') << "when it was started";
  EXPECT_NE(one, launched_with({{"PMI_RANK", "0"}, {"PMI_SIZE", "2"}}).launch);
}

TEST(LaunchedProcess, IsNoneWhereTheEnvironmentMakesNoSense) {
  for (const char* rank : {"-1", "8", "x", ""})
    EXPECT_EQ(launched_with({{"OMPI_COMM_WORLD_RANK", rank}, {"OMPI_COMM_WORLD_SIZE", "8"}}).processes, 1) << rank;
}

TEST(LaunchedProcess, OneOfALaunchSpeaksForAll) {
  const LaunchedProcess alone, first{0, 2, 2, "this"}, second{1, 2, 2, "this"};
  for (const bool done : {false, true})
    for (const std::optional<std::string>& by : {std::optional<std::string>(), std::optional<std::string>("other")})
      EXPECT_FALSE(is_silent(alone, done, by)) << "it was started apart";
  EXPECT_FALSE(is_silent(first, false, std::nullopt)) << "interrupted";
  EXPECT_TRUE(is_silent(second, false, std::nullopt));
  EXPECT_FALSE(is_silent(second, true, std::nullopt)) << "it finishes the work";
  EXPECT_TRUE(is_silent(first, true, "this"));
  EXPECT_TRUE(is_silent(second, true, "this"));
  EXPECT_FALSE(is_silent(first, true, "other")) << "finished before";
  EXPECT_TRUE(is_silent(second, true, "other"));
}

TEST(LaunchedProcess, HasTheCoresThatItMayRunOn) {
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  CPU_ZERO(&one);
  for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++core)
    if (CPU_ISSET(core, &before)) CPU_SET(core, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(cores_of({}), 1);
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(cores_of({0, 4096, 4096, ""}), 1);
}

}  // namespace
}  // namespace pcm::compare::launcher_test
