// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/command_line.h"

#include <cerrno>
#include <cstring>
#include <iostream>

#include "meshes/bad_input.h"

namespace pcm::compare {
void flush_output() {
  errno = 0;
  std::cout.flush();
  if (std::cout) return;
  const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  std::cout.clear();  // Reported once.
  throw BadInput("cannot write to standard output" + reason);
}

}  // namespace pcm::compare
