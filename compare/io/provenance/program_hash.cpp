// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/provenance/program_hash.h"

#include <optional>
#include <utility>

#include "compare/io/provenance/sha256.h"
#include "pcm/bad_input.h"

namespace pcm::compare {

std::string program_hash_of(const std::filesystem::path& program) {
  if (std::optional<std::string> hash = sha256_of_file(program)) return *std::move(hash);
  throw BadInput(program.string() + " can't be read: which build this is stays unknown");
}

const std::string& program_hash() {
  // The link leads to the file that was started, even where another one has taken its place since.
  static const std::string hash = program_hash_of("/proc/self/exe");
  return hash;
}

}  // namespace pcm::compare
