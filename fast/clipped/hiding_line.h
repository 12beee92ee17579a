// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fast/clipped/seen_faces.h"

namespace pcm::fast {

/// Part of a straight way, as shares of it, and the line on which it lies: at which a face hides, or passes through,
/// the given one of the slave.
struct PartOnLine {
  SideLine line;
  double from, to;
  const ProjectedFace* hidden;
};

/// The slave's face beyond an edge of f; f itself where its surface ends there.
Index face_beyond(const SeenFaces& seen, std::size_t edge);

/// That face of the slave, where the master sees it and it may carry an element; otherwise nullptr.
const ProjectedFace* carrying_face(const SeenFaces& seen, Index face);

/// The face of the slave with which f's sheet goes on beyond an edge of f, where others may hide some of that; nullptr
/// where the sheet ends there, or nothing does.
const ProjectedFace* hidden_neighbour(const SeenFaces& seen, std::size_t edge);

/// What is seen of a face beyond an edge of f, found where it is asked for: scratch memory, and what was found last.
class SeenBeyond {
 public:
  /// Of another master face, or another f.
  void start() { face_ = nullptr; }
  const std::vector<ConvexPolygon>& pieces(const SeenFaces& beyond);

 private:
  const ProjectedFace* face_ = nullptr;
  std::vector<ConvexPolygon> pieces_, remaining_;
};

/// Of a way from a to b along f, which is seen on the left of it alone: the edge at which f itself ends there, or the
/// line at which a face ends or begins to lie before f, as far as that lies on the way to within roundings. Where f's
/// sheet goes on beyond the edge, and a face that hides it there begins just at it, that face's line in place of the
/// edge, as far as nothing is seen of the sheet between the two: be it narrower than roundings, a strip that the next
/// face does show ends there, and f at the edge. Whether a face passes through f, or through the master, or lies before
/// f, is decided exactly where depths do not tell; beside a corner at which it just does, edge and line lie on one
/// another, and either is taken. Nothing where no line does on a stretch that is longer than roundings. Where there are
/// several, any.
std::optional<PartOnLine> find_hiding_line(const SeenFaces& seen, const PrismPoint& a, const PrismPoint& b,
                                           SeenBeyond& beyond);

}  // namespace pcm::fast
