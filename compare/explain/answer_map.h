// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// Which poses a map has: (2 steps + 1) squared of them, r moved by whole ulps along two axes of Me.
struct MapGrid {
  std::array<int, 2> axes{0, 1};  ///< to the right and upwards; 0, 1, 2 for x, y, z
  int steps = 16;                 ///< to either side of the middle
  double ulp = 0;                 ///< m

  std::size_t side() const { return 2 * static_cast<std::size_t>(steps) + 1; }
  std::size_t cells() const { return side() * side(); }
};

/// What one of them answers all over the grid, row by row from below: the number of the answer in AnswerMap::answers.
struct MappedAnswers {
  std::string who;
  std::vector<std::size_t> answers;
};

/// The answers of oracle, engine and published algorithms to poses an ulp apart from each other: do the surfaces cross,
/// and which edges pass through which faces, in the rounded problem.
struct AnswerMap {
  MapGrid grid;
  std::vector<std::string> answers;  ///< in words, the oracle's first, the more frequent the earlier
  std::vector<MappedAnswers> rows;   ///< the oracle's first

  /// At how many poses it differs from the oracle.
  std::size_t wrong(const MappedAnswers& row) const;
};

/// The map about a pose. `grid.ulp` of 0: that of the greatest coordinate (DESIGN section 3). Asks the oracle once a
/// pose, in threads. Throws BadInput where a mesh is unfit for contact, or the pose is no rotation or not finite.
AnswerMap answer_map(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Pose& pose, MapGrid grid);

/// As a picture: a square for each of them, a pose a cell, its colour the answer; crossed out where it is wrong.
std::string answer_map_svg(const AnswerMap& map, const std::string& title);

}  // namespace pcm::compare
