// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Guards the arrows between the parts of the project and, inside each, between its rooms: meshes is the ground floor;
// fast and reference stand on it side by side, and the only header of the engine that the oracle may see is the one of
// plain inputs; only simulate, and tests, include anything of compare.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
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

/// What begins a comment in sources of each kind, by their extension.
const std::map<std::string, std::string>& comment_marks() {
  static const std::map<std::string, std::string> marks{
      {".h", "//"}, {".cpp", "//"}, {".c", "//"}, {".f90", "!"}, {".py", "#"}};
  return marks;
}

std::vector<fs::path> sources_of(const std::string& room) {
  std::vector<fs::path> sources;
  for (const auto& entry : fs::recursive_directory_iterator{fs::path{PCM_SOURCE_DIR} / room}) {
    if (comment_marks().contains(entry.path().extension().string())) sources.push_back(entry.path());
  }
  return sources;
}

bool may_include(const fs::path& source) {
  const std::string extension = source.extension().string();
  return extension == ".h" || extension == ".cpp" || extension == ".c";
}

std::vector<Include> includes_of(const std::string& room) {
  static const std::regex pattern{R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re"};
  std::vector<Include> includes;
  for (const fs::path& source : sources_of(room)) {
    if (!may_include(source)) continue;
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

void expect_no_include(const std::string& room, const std::vector<std::string>& forbidden) {
  const std::vector<Include> includes = includes_of(room);
  EXPECT_FALSE(includes.empty()) << "nothing was read in " << room;
  for (const Include& include : includes) {
    EXPECT_FALSE(starts_with_any(include.header, forbidden)) << include.file << " includes " << include.header;
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

/// The room of a file: the nearest folder around it, below the part, that is one; else its folder.
std::string room_of(const Part& part, const fs::path& file) {
  const fs::path folder = file.parent_path().lexically_relative(part.name);
  if (folder == fs::path{"include/pcm"}) return part.public_headers.at(file.filename().string());
  if (folder == fs::path{"."}) return "";
  for (fs::path around = folder; !around.empty(); around = around.parent_path()) {
    if (rank(part, around.string()) >= 0) return around.string();
  }
  return folder.string();
}

/// The file in the project that an include names; empty where it names none of ours.
fs::path resolved(const std::string& header) {
  for (const std::string root : {"", "meshes/include/", "fast/include/", "bindings/c/include/"}) {
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

/// What is included, by what includes it.
using Graph = std::map<std::string, std::set<std::string>>;

/// What is part of a circle, or above one.
std::vector<std::string> above_circles(Graph graph) {
  // What includes none of those left is taken away, until there is nothing left but circles and what is above them.
  for (bool changed = true; changed;) {
    changed = false;
    for (auto it = graph.begin(); it != graph.end();) {
      const bool is_free = std::none_of(it->second.begin(), it->second.end(),
                                        [&](const std::string& included) { return graph.contains(included); });
      it = is_free ? graph.erase(it) : std::next(it);
      changed = changed || is_free;
    }
  }
  std::vector<std::string> left;
  for (const auto& [name, included] : graph) left.push_back(name);
  return left;
}

TEST(Architecture, NoHeadersIncludeEachOtherInACircle) {
  Graph headers;
  for (const Part& part : parts()) {
    for (const Include& include : includes_of(part.name)) {
      const fs::path header = resolved(include.header);
      if (header.extension() == ".h" && include.file.extension() == ".h")
        headers[include.file.string()].insert(header.string());
    }
  }
  for (const std::string& header : above_circles(headers)) ADD_FAILURE() << header;
}

/// A module is the header and the source of one name in one folder; a public header is that of the room it lies in.
std::string module_of(const Part& part, const fs::path& file) {
  const bool is_public = file.parent_path() == fs::path{part.name} / "include/pcm";
  const fs::path folder = is_public ? fs::path{part.name} / room_of(part, file) : file.parent_path();
  return (folder / file.stem()).string();
}

TEST(Architecture, NoModulesIncludeEachOtherInACircle) {
  for (const std::string name : {"meshes", "fast", "reference", "compare", "simulate"}) {
    const Part& part = part_named(name);
    Graph modules;
    for (const Include& include : includes_of(name)) {
      const fs::path header = resolved(include.header);
      if (header.empty() || header.begin()->string() != name) continue;
      const std::string own = module_of(part, include.file), other = module_of(part, header);
      if (own != other) modules[own].insert(other);
    }
    EXPECT_GT(modules.size(), 10U);
    for (const std::string& module : above_circles(modules)) ADD_FAILURE() << module;
  }
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
  expect_no_include("reference", {"fast/", "compare/", "tests/"});
  for (const auto& [header, room] : part_named("fast").public_headers) {
    if (header != "inputs.h") expect_no_include("reference", {"pcm/" + header});
  }
}

TEST(Architecture, CompareIncludesNoTests) {
  expect_no_include("compare", {"tests/"});
}

TEST(Architecture, SimulateIncludesNoTestsAndNotTheOracle) {
  expect_no_include("simulate", {"tests/", "reference/"});
}

TEST(Architecture, OnlyTestsIncludeSimulate) {
  for (const std::string part : {"meshes", "fast", "reference", "compare", "simbody"})
    expect_no_include(part, {"simulate/"});
}

TEST(Architecture, BindingsStandOnThePublicHeadersOfTheEngine) {
  expect_no_include("bindings", {"meshes/", "fast/", "reference/", "compare/", "simbody/", "simulate/", "tests/"});
}

TEST(Architecture, OnlyTestsIncludeBindings) {
  for (const std::string part : {"meshes", "fast", "reference", "compare", "simbody", "simulate"})
    expect_no_include(part, {"bindings/", "pcm/pcm.h"});
}

TEST(Architecture, TheInputsHoldNoAlgorithm) {
  for (const Include& include : includes_of("fast")) {
    if (include.file == fs::path{"fast/include/pcm/inputs.h"}) {
      EXPECT_TRUE(include.header == "Eigen/Core" || include.header.find('/') == std::string::npos) << include.header;
    }
  }
}

TEST(Architecture, EverySourceNamesItsLicence) {
  for (const std::string room :
       {"meshes", "fast", "simbody", "bindings", "reference", "compare", "simulate", "tests"}) {
    const bool is_permissive = room == "meshes" || room == "fast" || room == "simbody" || room == "bindings";
    const std::string licence = is_permissive ? "BSD-3-Clause" : "GPL-3.0-or-later";
    for (const fs::path& source : sources_of(room)) {
      const std::string mark = comment_marks().at(source.extension().string());
      std::ifstream in{source};
      std::string first;
      std::string second;
      std::getline(in, first);
      std::getline(in, second);
      EXPECT_EQ(first, mark + " SPDX-FileCopyrightText: 2026 The pcm authors") << source;
      EXPECT_EQ(second, mark + " SPDX-License-Identifier: " + licence) << source;
    }
  }
}

}  // namespace
