// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Guards the arrows between the parts of the project and, inside each, between its rooms: meshes is the ground floor;
// fast and reference stand on it side by side, and the only header of the engine that the oracle may see is the one of
// plain inputs; nothing includes compare.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/rooms.h"

namespace {

namespace fs = std::filesystem;
using pcm::test::Part;
using pcm::test::parts;

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

const Part& part_named(const std::string& name) {
  return *std::find_if(parts().begin(), parts().end(), [&](const Part& part) { return part.name == name; });
}

/// The place of a room in its part's list, -1 where it is none of them.
std::ptrdiff_t rank(const Part& part, const std::string& room) {
  const auto found = std::find(part.rooms.begin(), part.rooms.end(), room);
  return found == part.rooms.end() ? -1 : found - part.rooms.begin();
}

/// The room of a file: its folder's first name below the part.
std::string room_of(const Part& part, const fs::path& file) {
  const fs::path folder = file.parent_path().lexically_relative(part.name);
  if (folder == fs::path{"include/pcm"}) return part.public_headers.at(file.filename().string());
  return folder == fs::path{"."} ? "" : folder.begin()->string();
}

/// The file in the project that an include names; empty where it names none of ours.
fs::path resolved(const std::string& header) {
  for (const std::string root : {"", "meshes/include/", "fast/include/"}) {
    if (fs::exists(fs::path{PCM_SOURCE_DIR} / (root + header))) return root + header;
  }
  return {};
}

TEST(Architecture, RoomsIncludeOnlyThoseAboveThemInTheirList) {
  for (const Part& part : parts()) {
    for (const Include& include : includes_of(part.name)) {
      const std::string room = room_of(part, include.file);
      const std::ptrdiff_t own = rank(part, room);
      EXPECT_GE(own, 0) << include.file << " lies in no room that tests/architecture/rooms.h knows";
      const fs::path header = resolved(include.header);
      if (header.empty() || header.begin()->string() != part.name) continue;
      EXPECT_LE(rank(part, room_of(part, header)), own)
          << include.file << " includes " << include.header << ", of a room above " << room;
    }
  }
}

/// By header, the headers of ours that it includes.
std::map<std::string, std::set<std::string>> headers_included() {
  std::map<std::string, std::set<std::string>> included;
  for (const Part& part : parts()) {
    for (const Include& include : includes_of(part.name)) {
      const fs::path header = resolved(include.header);
      if (header.empty() || header.extension() != ".h" || include.file.extension() != ".h") continue;
      included[include.file.string()].insert(header.string());
    }
  }
  return included;
}

TEST(Architecture, NoHeadersIncludeEachOtherInACircle) {
  std::map<std::string, std::set<std::string>> left = headers_included();
  // Headers that include none of those left are taken away, until there is nothing left but circles.
  for (bool changed = true; changed;) {
    changed = false;
    for (auto it = left.begin(); it != left.end();) {
      const bool is_free = std::none_of(it->second.begin(), it->second.end(),
                                        [&](const std::string& header) { return left.contains(header); });
      it = is_free ? left.erase(it) : std::next(it);
      changed = changed || is_free;
    }
  }
  for (const auto& [header, included] : left)
    ADD_FAILURE() << header << " is part of a circle of includes, or above one";
}

TEST(Architecture, PublicHeadersNeedNoneOfTheRooms) {
  for (const std::string name : {"meshes", "fast"}) {
    for (const Include& include : includes_of(name + "/include")) {
      const bool is_standard = include.header.find('/') == std::string::npos;
      EXPECT_TRUE(is_standard || starts_with_any(include.header, {"pcm/", "Eigen/"}))
          << include.file << " includes " << include.header;
    }
  }
}

TEST(Architecture, MeshesIncludesNoOtherRoom) {
  for (const auto& [header, room] : part_named("fast").public_headers) expect_no_include("meshes", {"pcm/" + header});
  expect_no_include("meshes", {"fast/", "reference/", "compare/", "tests/", "CGAL/", "gmp", "mpf", "boost/"});
}

TEST(Architecture, FastStandsOnMeshesEigenAndTheStandardLibraryOnly) {
  expect_no_include("fast", {"reference/", "compare/", "tests/", "CGAL/", "gmp", "mpf", "boost/", "tbb/", "fmt/"});
}

TEST(Architecture, ReferenceSeesOnlyTheInputsOfTheEngine) {
  expect_no_include("reference", {"fast/", "compare/", "tests/"}, {"fast/include/pcm/inputs.h"});
}

TEST(Architecture, CompareIncludesNoTests) {
  expect_no_include("compare", {"tests/"});
}

TEST(Architecture, TheInputsHoldNoAlgorithm) {
  for (const Include& include : includes_of("fast")) {
    if (include.file == fs::path{"fast/include/pcm/inputs.h"}) {
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
