// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Headers that comments name are there, under the last part of the path that they are given.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "tests/architecture/source_files.h"

namespace pcm::architecture {
namespace {

namespace fs = std::filesystem;

/// The headers that a file's comments name.
std::vector<std::string> headers_named_in(const fs::path& file) {
  static const std::regex header{R"re([A-Za-z0-9_][A-Za-z0-9_/]*\.h\b)re"};
  std::vector<std::string> named;
  std::ifstream in{file};
  for (std::string line; std::getline(in, line);) {
    const std::size_t comment = line.find("//");
    if (comment == std::string::npos) continue;
    const std::string text = line.substr(comment);
    for (std::sregex_iterator match{text.begin(), text.end(), header}; match != std::sregex_iterator{}; ++match)
      named.push_back(match->str());
  }
  return named;
}

TEST(Comments, NameHeadersThatAreThere) {
  std::vector<std::string> files = source_files();
  files.push_back("/pcm/version.h");  // made when configuring
  int named = 0;
  for (const std::string& file : files) {
    if (!file.ends_with(".h") && !file.ends_with(".cpp")) continue;
    if (file == "/pcm/version.h") continue;
    for (const std::string& header : headers_named_in(fs::path{PCM_SOURCE_DIR + file})) {
      ++named;
      EXPECT_TRUE(std::any_of(files.begin(), files.end(),
                              [&](const std::string& there) { return there.ends_with('/' + header); }))
          << file << " names " << header;
    }
  }
  EXPECT_GT(named, 100);
}

}  // namespace
}  // namespace pcm::architecture
