// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/program_hash.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "compare/sha256.h"

namespace pcm::compare {
namespace {

std::string running_program() {
  // The link leads to the file that was started, even where another one has taken its place since.
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file || bytes.empty())
    throw std::runtime_error("/proc/self/exe can't be read: which build this is stays unknown");
  return bytes;
}

}  // namespace

const std::string& program_hash() {
  static const std::string hash = sha256(running_program());
  return hash;
}

}  // namespace pcm::compare
