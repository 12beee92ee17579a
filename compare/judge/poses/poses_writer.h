// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "compare/judge/lines/posed_question.h"

namespace pcm::compare {

/// The surfaces of a folder of poses, each once, however many pairs have it.
class PosedSurfaces {
 public:
  /// The surface's number; another one of the same vertices and faces has it too.
  std::size_t number_of(const TriangleMesh& mesh);
  /// Writes the files, whose bytes the hashes are of, under names of their own; then gives them theirs, or removes
  /// them.
  void write_beside(const std::filesystem::path& folder) const;
  void take_their_places(const std::filesystem::path& folder) const;
  void remove_those_beside(const std::filesystem::path& folder) const;
  const std::vector<PosedSurface>& surfaces() const { return surfaces_; }

 private:
  std::string free_name(const std::string& name);

  std::vector<PosedSurface> surfaces_;
  std::map<std::string, std::size_t> by_hash_;
  std::set<std::string> names_;
};

/// A folder of poses being written: poses.jsonl under a name of its own until all is there, so that one of that name is
/// always whole and beside its own surfaces. What an earlier run left in the folder is whole until finish().
class PosesWriter {
 public:
  /// Writes the first line. `surfaces`, all of them, must outlive this. Throws BadInput, and leaves all as it is, where
  /// poses.jsonl or the file of a surface is there which no such writer has left: a user's own.
  PosesWriter(std::filesystem::path folder, const PosedSurfaces& surfaces, std::int64_t poses,
              const std::string& origin);
  PosesWriter(const PosesWriter&) = delete;
  PosesWriter& operator=(const PosesWriter&) = delete;
  /// Nothing is left of what was not finished.
  ~PosesWriter();

  void add(const std::string& line) { out_ << line << '\n'; }
  /// Writes the surfaces too. Throws BadInput where one of them could not be written; what an earlier run left stays.
  void finish();

 private:
  std::filesystem::path folder_, partial_;
  const PosedSurfaces& surfaces_;
  std::ofstream out_;
};

}  // namespace pcm::compare
