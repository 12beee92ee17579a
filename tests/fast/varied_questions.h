// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/poses/pairs.h"
#include "pcm/inputs.h"

/// What programs ask about that print or write many answers, to be compared with other ones.
namespace pcm::fast::test {

/// Every subset of what may be wanted, but for tangents, by number, which is that of the C interface's flags.
inline constexpr int kAllWanted = 64;
inline Wanted wanted_by_number(std::uint64_t number) {
  const auto bit = [number](int i) { return (number >> i & 1) != 0; };
  return {
      .polygons = bit(0), .areas = bit(1), .force = bit(2), .elements = bit(3), .bound = bit(4), .statistics = bit(5)};
}

/// Of the pairs that `pcm verify` has, with their laws: smooth ones and ones on a grid, of genus 1, open, with a
/// cavity, and wound about twice.
inline std::vector<compare::SurfacePair> varied_pairs() {
  std::vector<std::string> missing;
  std::vector<compare::SurfacePair> pairs;
  constexpr std::array<std::string_view, 7> kWanted{"bubble-bubble", "gridded cubes", "small icospheres",
                                                    "small tori",    "cube-tray",     "hollow cube-cube",
                                                    "pentagram-cube"};
  for (compare::SurfacePair& pair : compare::built_in_pairs({}, missing))
    if (std::find(kWanted.begin(), kWanted.end(), pair.name) != kWanted.end()) pairs.push_back(std::move(pair));
  return pairs;
}

}  // namespace pcm::fast::test
