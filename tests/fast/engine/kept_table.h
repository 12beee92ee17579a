// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace pcm::fast::test {

/// Holds rows, the columns' names first, against the table of that name in this folder. Where they differ, what was
/// found is written to a file of that name where the test runs.
inline void expect_kept(const std::vector<std::string>& rows, const std::string& name) {
  std::ifstream file(std::filesystem::path(PCM_SOURCE_DIR) / "tests" / "fast" / "engine" / name);
  std::vector<std::string> kept;
  for (std::string row; std::getline(file, row);) kept.push_back(row);
  if (rows == kept) return;
  std::ofstream now(name);
  for (const std::string& row : rows) now << row << '\n';
  ADD_FAILURE() << "what was found is in " << std::filesystem::absolute(name);
  for (std::size_t i = 0; i < std::min(rows.size(), kept.size()); ++i) EXPECT_EQ(rows[i], kept[i]) << rows.front();
}

}  // namespace pcm::fast::test
