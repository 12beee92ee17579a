// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pcm::architecture {

inline const std::vector<std::string> kTrees{"meshes",   "fast",    "reference", "compare",
                                             "simulate", "simbody", "bindings",  "tests"};

/// All files below a folder of the project, as "/folder/...".
inline std::vector<std::string> files_below(const std::string& tree) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator{fs::path{PCM_SOURCE_DIR} / tree})
    if (entry.is_regular_file()) files.push_back('/' + fs::relative(entry.path(), PCM_SOURCE_DIR).generic_string());
  return files;
}

/// Those of all trees.
inline std::vector<std::string> source_files() {
  std::vector<std::string> files;
  for (const std::string& tree : kTrees) {
    const std::vector<std::string> more = files_below(tree);
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

}  // namespace pcm::architecture
