// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/judge/lines/reply.h"

namespace pcm::compare {

/// The words of a command line, separated by blanks. Single and double quotes hold words together, a backslash takes
/// the next character as it is (but for single quotes). Nothing is expanded, and no shell has a part in it. Throws
/// BadInput for an open quote or no word at all.
std::vector<std::string> words_of_command(const std::string& command);

/// An engine that runs as a process of its own: a line down its standard input, a line back from its standard output;
/// its standard error is ours. It is started when it is first asked something, and again after each breakdown. While
/// this lives, writing to a process that has ended is an error, not a signal.
class Conversation {
 public:
  using Seconds = std::chrono::duration<double>;

  /// `greeting`: the line it is told when it starts, which it does not answer. `limit`: for one answer, start included.
  /// `stop`: whether nobody waits for answers any more; asked several times a second while one is waited for.
  Conversation(std::vector<std::string> command, std::string greeting, Seconds limit, std::function<bool()> stop = {});
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;
  /// Ends it: by the end of its input, and by force if it is still there a second later.
  ~Conversation();

  struct Said {
    std::string line;
    std::optional<Breakdown> breakdown;
    std::string failure;
  };
  /// None where it was stopped; the engine has been ended then. Throws BadInput where the command can't be started.
  std::optional<Said> ask(const std::string& line);

  /// Its last line was no answer: it is ended, with whatever else it may have said, and started anew for the next one.
  void give_up();

 private:
  using Clock = std::chrono::steady_clock;

  void start();
  Said crashed();
  bool wait_for_end(Seconds patience);
  void end_by_force();
  void close_pipes();

  std::vector<std::string> command_;
  std::string greeting_;
  Seconds limit_;
  std::function<bool()> stop_;
  struct sigaction former_ {};
  pid_t process_ = 0;  ///< 0 while none runs
  int ended_ = 0;      ///< as waitpid has it
  int to_ = -1, from_ = -1;
  std::string heard_;  ///< bytes that are no whole line yet
};

}  // namespace pcm::compare
