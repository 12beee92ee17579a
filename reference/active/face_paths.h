// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "reference/lines/face_lines.h"
#include "reference/predicates/orientation.h"

namespace pcm::reference {

/// Straight paths from a face's corners to one point x inside it, everything perturbed as `orientation` has it: x keeps
/// its barycentric coordinates and moves with the corners. x lies on no segment of the lines.
///
/// To be used while the rounding mode is upward.
class FacePaths {
 public:
  /// x: the centre of three of the convex polygon's corners. Orientation and lines must outlive this.
  FacePaths(const Orientation& orientation, Side side, Index face, FaceLines& lines,
            const std::vector<LineMeeting>& polygon);

  /// What the path from the corner to x adds to the winding number at the segment's face: +1 where it passes through
  /// that from above to below, -1 the other way, 0 where it does not.
  int passage(int corner, Index segment);

  /// The winding number at x less that at the corner.
  int change(int corner);

 private:
  Vec3<Interval> centre() const;
  const Vec3<Exact>& exact_centre();
  int height_sign(const Triangle& f, Index segment);
  int line_sign(int corner, Index q, Index r);

  const Orientation& orientation_;
  Side side_;
  Triangle corners_;
  FaceLines& lines_;
  std::array<LineMeeting, 3> around_;
  Vec3<Interval> x_;
  std::optional<Vec3<Exact>> exact_x_;
};

}  // namespace pcm::reference
