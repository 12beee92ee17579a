// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "pcm/triangle_mesh.h"

/// Closed surfaces through cross-sections along a straight axis. The same bits on every machine.
namespace pcm::generate {

/// The axis of a loft and the axes u and v of its cross-sections; u, v and the axis are right-handed.
enum class LoftAxis {
  x,  ///< u along y, v along z
  z   ///< u along x, v along y
};

/// A cross-section at `position` along the axis: the ellipse of half-widths `half_u` and `half_v` about its centre,
/// blended by `squareness` (0 to 1) with the superellipse |u|^8 + |v|^8 = 1 of the same half-widths. Lengths in metres.
struct CrossSection {
  double position = 0;
  double center_u = 0;
  double center_v = 0;
  double half_u = 0;
  double half_v = 0;
  double squareness = 0;
};

/// A ring of vertices: the cross-section at `position`, scaled about its centre.
struct LoftRing {
  double position = 0;
  double scale = 1;
};

/// A rounded end: within `length` of it, m, the cross-sections shrink to a point like those of an ellipsoid. `rings`
/// rings lie on it, equally spaced in angle, the pole and the ring of full size where it begins not counted.
struct RoundedEnd {
  double length = 0;
  Index rings = 0;
};

/// `count` rings from `start` to `end` along the axis, without the poles: those of the two rounded ends and the rest
/// equally spaced between them.
std::vector<LoftRing> rounded_rings(double start, double end, const RoundedEnd& first, const RoundedEnd& last,
                                    Index count);

/// The surface through the rings, `segments` vertices on each, closed by a pole at the first and the last given cross-
/// section's centre. Between the given cross-sections, ascending in position, each of their five numbers follows a
/// monotone cubic (Fritsch and Butland), so none overshoots. 2 segments rings faces, outward.
TriangleMesh loft(std::string_view name, LoftAxis axis, const std::vector<CrossSection>& sections,
                  const std::vector<LoftRing>& rings, Index segments);

}  // namespace pcm::generate
