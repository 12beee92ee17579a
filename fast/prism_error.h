// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "fast/element_error.h"
#include "fast/footprint.h"
#include "fast/master_prism.h"

namespace pcm::fast {

/// How far the coordinates a MasterPrism gives may be from the exact problem's (PCM section 1), in two steps. M stands
/// for the affine map with the prism's computed gradients, free of roundings, M' for the exact problem's own map.
///
///   1. Vertices: what the prism makes of a computed vertex x is off M(x') by
///   the vertex's rounding and those of two
///      scalar products. This moves the vertices of a face, so the points
///      between them by no more.
///   2. Frame: M(x) and M'(x) differ by an affine map near the identity, the
///   same for all points x. Over the master
///      face, and as deep beneath it as something is seen, that is little
///      however far the vertices of what is seen may be: rounded corners of the
///      master, and the direction of its lines, off by an angle, times the
///      depth.
///
/// The weights that the prism gives a face's own corners are exact in both problems.
class PrismError {
 public:
  /// `rounding_Me`: how far each coordinate of F's vertices may be off; the master may be E's or F's.
  PrismError(const MasterPrism& prism, const FaceError& face, Side master, const Eigen::Vector3d& rounding_Me);

  /// |x - p0| is no greater where no |coordinate| of x is, m.
  double distance(double s, double t, double depth) const { return length_s_ * s + length_t_ * t + depth; }
  /// The first step, for vertices no farther from p0 than `distance`, of the slave or of the master's own faces.
  /// `least_depth`: the least |depth| of any of them.
  PrismShift of_vertices(double distance, double least_depth, bool own) const;
  /// The second, for points over the master face no deeper than `depth`.
  PrismShift of_frame(double depth) const;
  /// The second step's part that turns depth into s and t, for points as far as `depth` from the master's plane,
  /// wherever they are: the rest maps lines in (s, t) to lines, and says nothing new of sides and windings.
  PrismShift of_tilt(double depth) const { return {tilt_s_ * depth, tilt_t_ * depth, 0}; }

 private:
  double length_s_, length_t_;           ///< of p1 - p0 and p2 - p0, m
  double longest_;                       ///< no side is longer, m
  double gradient_s_, gradient_t_;       ///< length of the gradients of s and t, 1 / m
  PrismShift moved_;                     ///< by a vertex of F that is off by its rounding
  bool own_moves_;                       ///< the master is F's
  double depth_noise_;                   ///< roundings of a depth over the distance
  double exact_depth_noise_;             ///< and what is added where
  double exact_depth_;                   ///< |depth| over the distance is less than this
  PrismShift frame_;                     ///< at depth 0
  double tilt_s_, tilt_t_, tilt_depth_;  ///< times the depth
};

}  // namespace pcm::fast
