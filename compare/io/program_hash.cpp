// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/program_hash.h"

#include <fstream>
#include <iterator>

#include "compare/io/sha256.h"
#include "pcm/bad_input.h"

namespace pcm::compare {

std::string program_hash_of(const std::filesystem::path& program) {
  std::ifstream file(program, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file || bytes.empty()) throw BadInput(program.string() + " can't be read: which build this is stays unknown");
  return sha256(bytes);
}

const std::string& program_hash() {
  // The link leads to the file that was started, even where another one has taken its place since.
  static const std::string hash = program_hash_of("/proc/self/exe");
  return hash;
}

}  // namespace pcm::compare
