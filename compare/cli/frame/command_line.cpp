// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/command_line.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <iostream>

#include "meshes/files/parse_number.h"
#include "pcm/bad_input.h"

namespace pcm::compare {

void flush_output() {
  errno = 0;
  std::cout.flush();
  if (std::cout) return;
  const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  std::cout.clear();  // Reported once.
  throw BadInput("cannot write to standard output" + reason);
}

void complain(std::string message) {
  while (!message.empty() && message.back() == '\n') message.pop_back();
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "pcm: " << message << '\n';
}

double finite_number(const std::string& option, const std::string& text) {
  const std::optional<double> number = parse_number(text);
  if (!number) throw BadInput(option + ": '" + text + "' is not a finite number; write it as 0.1 or 0x1.8p-3");
  return *number;
}

double positive_number(const std::string& option, const std::string& text) {
  const double number = finite_number(option, text);
  if (!(number > 0)) throw BadInput(option + ": " + text + " is not positive; give a number above 0");
  return number;
}

double nonnegative_number(const std::string& option, const std::string& text) {
  const double number = finite_number(option, text);
  if (number < 0) throw BadInput(option + ": " + text + " is negative; give 0 or more");
  return number;
}

std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t least,
                           std::uint64_t most) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end || number < least || number > most) {
    throw BadInput(option + ": '" + text + "' is not a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most));
  }
  return number;
}

}  // namespace pcm::compare
