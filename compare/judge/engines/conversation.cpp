// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/engines/conversation.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <system_error>
#include <thread>

#include "compare/judge/lines/json_lines.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr Conversation::Seconds kPatience{1};
/// Thirty years: nobody waits longer.
constexpr Conversation::Seconds kLongestLimit{1e9};
/// Between two looks at whether to stop: signals may come to other threads.
constexpr double kLook = 0.1;

/// Both ends of a pipe, which no other process inherits.
std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  return ends;
}

void close_end(int& end) {
  if (end != -1) close(end);
  end = -1;
}

std::string words_for(int ended) {
  if (WIFSIGNALED(ended)) return fmt::format("signal {} ended it ({})", WTERMSIG(ended), strsignal(WTERMSIG(ended)));
  return fmt::format("it ended with status {}", WEXITSTATUS(ended));
}

}  // namespace

std::vector<std::string> words_of_command(const std::string& command) {
  std::vector<std::string> words;
  char quote = 0;
  bool in_word = false;
  for (std::size_t k = 0; k < command.size(); ++k) {
    const char c = command[k];
    if (quote == 0 && (c == ' ' || c == '\t')) {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (c == '\\' && quote != '\'' && k + 1 < command.size())
      words.back() += command[++k];
    else if (c == quote)
      quote = 0;
    else if (quote == 0 && (c == '\'' || c == '"'))
      quote = c;
    else
      words.back() += c;
  }
  if (quote != 0) throw BadInput(fmt::format("--command: the quote {} in {} has no end", quote, in_quotes(command)));
  if (words.empty()) throw BadInput("--command: there is no word in it");
  return words;
}

Conversation::Conversation(std::vector<std::string> command, std::string greeting, Seconds limit,
                           std::function<bool()> stop)
    : command_(std::move(command)), greeting_(std::move(greeting)), limit_(limit), stop_(std::move(stop)) {
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, &former_);
}

Conversation::~Conversation() {
  close_end(to_);
  if (process_ != 0 && !wait_for_end(kPatience)) end_by_force();
  close_pipes();
  sigaction(SIGPIPE, &former_, nullptr);
}

void Conversation::start() {
  auto [child_in, to] = make_pipe();
  auto [from, child_out] = make_pipe();
  to_ = to;
  from_ = from;
  fcntl(to_, F_SETFL, O_NONBLOCK);
  fcntl(from_, F_SETFL, O_NONBLOCK);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, child_in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, child_out, STDOUT_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  // A process group of its own, so that what it has started ends with it.
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::vector<char*> argv;
  for (std::string& word : command_) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int failed = posix_spawnp(&process_, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(child_in);
  close(child_out);
  if (failed == 0) return;
  process_ = 0;
  close_pipes();
  throw BadInput(fmt::format("--command: {} can't be started: {}", in_quotes(command_[0]), std::strerror(failed)));
}

std::optional<Conversation::Said> Conversation::ask(const std::string& line) {
  std::string tell = line + '\n';
  if (process_ == 0) {
    start();
    tell = greeting_ + '\n' + tell;
  }
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::min(limit_, kLongestLimit));
  std::size_t told = 0;
  while (true) {
    if (const std::size_t at = heard_.find('\n'); at != std::string::npos) {
      Said said{heard_.substr(0, at), std::nullopt, ""};
      heard_.erase(0, at + 1);
      return said;
    }
    if (stop_ && stop_()) {
      give_up();
      return std::nullopt;
    }
    if (heard_.size() > kLongestJsonLine) {
      give_up();
      return Said{"", Breakdown::garbage, "it says more than 64 MiB without ending the line"};
    }
    const double left = Seconds(end - Clock::now()).count();
    if (left <= 0) {
      give_up();
      return Said{"", Breakdown::hang, fmt::format("no answer within {:g} s", limit_.count())};
    }
    std::array<pollfd, 2> ends{{{from_, POLLIN, 0}, {told < tell.size() ? to_ : -1, POLLOUT, 0}}};
    poll(ends.data(), ends.size(), static_cast<int>(std::ceil(1e3 * std::min(left, kLook))));
    if (ends[1].revents != 0) {
      const ssize_t n = write(to_, tell.data() + told, tell.size() - told);
      // Whoever no longer listens may have answered all the same.
      if (n < 0 && errno != EAGAIN && errno != EINTR) told = tell.size();
      if (n > 0) told += static_cast<std::size_t>(n);
    }
    if (ends[0].revents == 0) continue;
    std::array<char, 65536> bytes{};
    const ssize_t n = read(from_, bytes.data(), bytes.size());
    if (n > 0) heard_.append(bytes.data(), static_cast<std::size_t>(n));
    if (n == 0) return crashed();
  }
}

Conversation::Said Conversation::crashed() {
  const bool has_ended = wait_for_end(kPatience);
  const std::string failure = has_ended ? words_for(ended_) : "it closed its output and went on";
  give_up();
  return {"", Breakdown::crash, failure};
}

void Conversation::give_up() {
  if (process_ != 0) end_by_force();
  close_pipes();
}

bool Conversation::wait_for_end(Seconds patience) {
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(patience);
  while (true) {
    if (waitpid(process_, &ended_, WNOHANG) == process_) {
      process_ = 0;
      return true;
    }
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void Conversation::end_by_force() {
  kill(-process_, SIGKILL);  // what it has started
  kill(process_, SIGKILL);   // where it has left its group
  waitpid(process_, &ended_, 0);
  process_ = 0;
}

void Conversation::close_pipes() {
  close_end(to_);
  close_end(from_);
  heard_.clear();
}

}  // namespace pcm::compare
