// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "compare/published/surface.h"

namespace pcm::compare::published {

/// Where an edge of one surface passes through a face of the other: an end point of an intersection line.
struct Crossing {
  Eigen::Vector3d position_Me = Eigen::Vector3d::Zero();  ///< m
  double along = 0;                                       ///< from the edge's first end (0) to its second (1)
  Index edge = 0;                                         ///< of the surface `edge_side`
  Index face = 0;                                         ///< of the other one
  Side edge_side = Side::E;
  bool first_end_below = false;  ///< the edge comes from the inner side of the face
};

/// The intersection line of two faces, directed as (5) asks, (n_e x n_f) . (ends[1] - ends[0]) >= 0, unless turned.
struct Segment {
  std::array<Crossing, 2> ends;
  Index face_E = 0;
  Index face_F = 0;
  bool turned = false;
};

/// The test of two triangles that also gives their intersection line, in plain floating point after Moeller (1997), the
/// usual one at the time: neither triangle lies on one side of the other's plane, and the intervals they cut out of the
/// line of both planes overlap. A vertex in the plane counts as above it; there is no tolerance. An end point is
/// computed from its edge's ends in one order whatever face asks, so that neighbouring faces find the same bits.
std::optional<Segment> intersect(const Surface& surface_E, Index e, const PosedFace& face_E, const Surface& surface_F,
                                 Index f, const PosedFace& face_F);

}  // namespace pcm::compare::published
