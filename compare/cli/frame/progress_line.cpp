// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/progress_line.h"

#include <fmt/core.h>
#include <unistd.h>

#include <iostream>

namespace pcm::compare {

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressLine::show(const std::string& what) const {
  if (terminal_) std::cerr << fmt::format("\r{:<60}", what) << std::flush;
}

void ProgressLine::wipe() const {
  if (terminal_) std::cerr << fmt::format("\r{:<60}\r", "");
}

}  // namespace pcm::compare
