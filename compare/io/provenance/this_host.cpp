// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/provenance/this_host.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace pcm::compare {

std::string this_host() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string boot;
  std::getline(file, boot);
  std::error_code none;
  return boot + ' ' + std::filesystem::read_symlink("/proc/self/ns/pid", none).string();
}

}  // namespace pcm::compare
