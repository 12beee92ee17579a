// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/programs.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "pcm/bad_input.h"

namespace pcm::compare {

void become(const std::string& program, char** argv) {
  const std::filesystem::path file = std::filesystem::read_symlink("/proc/self/exe").parent_path() / program;
  execv(file.c_str(), argv);
  if (errno == ENOENT) throw BadInput(file.string() + " is not there yet; './run build' builds it");
  throw BadInput(file.string() + " can't be started: " + std::strerror(errno));
}

}  // namespace pcm::compare
