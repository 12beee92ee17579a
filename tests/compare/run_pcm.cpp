// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/compare/run_pcm.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "tests/meshes/content_of.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

/// The first word is the program; without a slash it is sought where programs are.
Outcome run(std::vector<std::string> words, const std::filesystem::path& output, const std::filesystem::path& input) {
  const TemporaryFolder scratch;
  const std::string out = output.empty() ? scratch.path("out") : output.string();
  const std::string err = scratch.path("err");

  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, input.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, argv.front(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("could not start " + words.front());

  int ended = 0;
  waitpid(process, &ended, 0);
  Outcome outcome;
  outcome.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  if (output.empty()) outcome.out = content_of(out);
  outcome.err = content_of(err);
  return outcome;
}

}  // namespace

Outcome run_pcm(const std::vector<std::string>& arguments, const std::filesystem::path& output,
                const std::filesystem::path& input) {
  std::vector<std::string> words{PCM_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run(std::move(words), output, input);
}

bool has_mpirun() {
  return std::system("mpirun --version > /dev/null 2>&1") == 0;
}

Outcome run_by_mpirun(int processes, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"mpirun", "--allow-run-as-root",     "--oversubscribe",
                                 "-n",     std::to_string(processes), PCM_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run(std::move(words), {}, "/dev/null");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace pcm::compare
