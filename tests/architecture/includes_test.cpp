// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Guards the arrows between the rooms: meshes is the ground floor; fast and reference stand on it side by side, and the
// only header of the engine that the oracle may see is the one of plain inputs; nothing includes compare.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Include {
  fs::path file;  // relative to the root
  std::string header;
};

std::vector<fs::path> sources_of(const std::string& room) {
  std::vector<fs::path> sources;
  for (const auto& entry : fs::recursive_directory_iterator{fs::path{PCM_SOURCE_DIR} / room}) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".h" || extension == ".cpp") sources.push_back(entry.path());
  }
  return sources;
}

std::vector<Include> includes_of(const std::string& room) {
  static const std::regex pattern{R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re"};
  std::vector<Include> includes;
  for (const fs::path& source : sources_of(room)) {
    std::ifstream in{source};
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (std::regex_search(line, match, pattern)) includes.push_back({fs::relative(source, PCM_SOURCE_DIR), match[1]});
    }
  }
  return includes;
}

bool starts_with_any(const std::string& header, const std::vector<std::string>& prefixes) {
  for (const std::string& prefix : prefixes) {
    if (header.starts_with(prefix)) return true;
  }
  return false;
}

void expect_no_include(const std::string& room, const std::vector<std::string>& forbidden,
                       const std::set<std::string>& except = {}) {
  const std::vector<Include> includes = includes_of(room);
  EXPECT_FALSE(includes.empty()) << "nothing was read in " << room;
  for (const Include& include : includes) {
    EXPECT_TRUE(except.contains(include.header) || !starts_with_any(include.header, forbidden))
        << include.file << " includes " << include.header;
  }
}

TEST(Architecture, MeshesIncludesNoOtherRoom) {
  expect_no_include("meshes", {"fast/", "reference/", "compare/", "tests/", "CGAL/", "gmp", "mpf", "boost/"});
}

TEST(Architecture, FastStandsOnMeshesEigenAndTheStandardLibraryOnly) {
  expect_no_include("fast", {"reference/", "compare/", "tests/", "CGAL/", "gmp", "mpf", "boost/", "tbb/", "fmt/"});
}

TEST(Architecture, ReferenceSeesOnlyTheInputsOfTheEngine) {
  expect_no_include("reference", {"fast/", "compare/", "tests/"}, {"fast/inputs.h"});
}

TEST(Architecture, CompareIncludesNoTests) {
  expect_no_include("compare", {"tests/"});
}

TEST(Architecture, TheInputsHoldNoAlgorithm) {
  for (const Include& include : includes_of("fast")) {
    if (include.file == fs::path{"fast/inputs.h"}) {
      EXPECT_TRUE(include.header == "Eigen/Core" || include.header.find('/') == std::string::npos) << include.header;
    }
  }
}

TEST(Architecture, EverySourceNamesItsLicence) {
  for (const std::string room : {"meshes", "fast", "reference", "compare", "tests"}) {
    const std::string licence = room == "meshes" || room == "fast" ? "BSD-3-Clause" : "GPL-3.0-or-later";
    for (const fs::path& source : sources_of(room)) {
      std::ifstream in{source};
      std::string first;
      std::string second;
      std::getline(in, first);
      std::getline(in, second);
      EXPECT_EQ(first, "// SPDX-FileCopyrightText: 2026 The pcm authors") << source;
      EXPECT_EQ(second, "// SPDX-License-Identifier: " + licence) << source;
    }
  }
}

}  // namespace
