// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formulas of the force law stand in few files: who changes them knows where.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "tests/architecture/source_files.h"

namespace pcm::architecture {
namespace {

/// Files that divide by the transition depth (15), or by the slip velocity (20).
std::set<std::string> files_with_formulas() {
  static const std::regex formula{R"re(/ *(\w+\()?(\w+(\.|->))*(transition_depth|slip_velocity)\b)re"};
  std::set<std::string> found;
  for (const std::string& file : source_files()) {
    if (!file.ends_with(".h") && !file.ends_with(".cpp")) continue;
    if (file.find("known_answers") != std::string::npos) continue;  // forces in numbers
    std::ifstream in{PCM_SOURCE_DIR + file};
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line.substr(0, line.find("//")), formula)) found.insert(file);
  }
  return found;
}

TEST(ForceLaw, HasItsFormulasInFiveFiles) {
  const std::set<std::string> five{"/fast/law/element_force.h", "/fast/bounds/law_error.cpp", "/reference/force/law.h",
                                   "/compare/verify/bounds/element_law.cpp", "/tests/force_law.h"};
  EXPECT_EQ(files_with_formulas(), five);
}

}  // namespace
}  // namespace pcm::architecture
