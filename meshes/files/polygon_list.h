// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "meshes/files/text_file.h"
#include "pcm/triangle_mesh.h"

/// What the readers of all mesh formats share.
namespace pcm {

/// As many vertices or faces as an Index can count.
inline constexpr std::int64_t kMostElements = std::numeric_limits<Index>::max();

/// The word as a finite number; throws BadInput for the current line where it is none.
double read_finite(const TextLines& lines, std::string_view word);

/// The faces of a file as polygons, with the lines they come from: they can only be cut into triangles, and their
/// indices only be judged, once all vertices are known.
class PolygonList {
 public:
  /// Begins a polygon that stands in this line.
  void begin(std::int64_t line);
  /// Adds a corner, a vertex index from 0, to the last polygon.
  void add_corner(std::int64_t vertex) { corners_.push_back(vertex); }

  std::size_t size() const { return lines_.size(); }

  /// The polygons as triangles. Throws BadInput where a polygon has fewer than three corners or a corner that is no
  /// vertex; the message counts vertices from `first_number`.
  std::vector<Triangle> triangulate(const std::vector<Eigen::Vector3d>& vertices, const TextLines& lines,
                                    std::int64_t first_number) const;

 private:
  std::vector<std::int64_t> corners_;  // of all polygons, one after the other
  std::vector<std::size_t> starts_;    // the first corner of each
  std::vector<std::int64_t> lines_;
};

}  // namespace pcm
