// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "fast/bounds/element_error.h"
#include "fast/prism/master_prism.h"
#include "fast/prism/prism_position_error.h"
#include "pcm/inputs.h"

namespace pcm::fast {

/// A linear function of what a master face sees: per_s s + per_t t + per_depth depth.
struct PrismFunction {
  double per_s = 0, per_t = 0, per_depth = 0;
};

/// How far the coordinates a MasterPrism gives may be from the exact problem's (PCM section 1), in two steps. M stands
/// for the affine map with the prism's computed gradients, free of roundings, M' for the exact problem's own map.
///
///   1. Vertices: what the prism makes of a computed vertex x is off M(x') by the vertex's rounding and those of two
///      scalar products. This moves the vertices of a face, so the points between them by no more.
///   2. Frame: M(x) and M'(x) differ by an affine map near the identity, the same for all points x. Over the master
///      face, and as deep beneath it as something is seen, that is little however far the vertices of what is seen may
///      be: rounded corners of the master, and the direction of its lines, off by an angle, times the depth.
///
/// Rounded vertices are displaced in space, so a linear function of the three coordinates is off by the displacement's
/// scalar product with that function's gradient: less than the coordinates' own errors say together, where the master
/// is narrow or what it sees is steep. The weights that the prism gives a face's own corners are exact in both
/// problems.
class PrismError {
 public:
  /// The prism has to outlive this. `own_rounding_Me`: how far each coordinate of the master face's vertices may be
  /// off, 0 for E's; `rounding_Me`: of any vertex of F.
  PrismError(const MasterPrism& prism, const FaceError& face, Side master, const Eigen::Vector3d& own_rounding_Me,
             const Eigen::Vector3d& rounding_Me);

  /// How far p0 + (s (p1 - p0) + t (p2 - p0)), as it is computed for a point (s, t) of the master face, may be from the
  /// exact problem's point with the same (s, t), component by component, m. That is a mean of the vertices, so off by
  /// no more than these are; then edges, products and their sum round by u each, 4 u times both edges, the quotients
  /// that gave s and t by 1 u more, and the last sum by u times itself.
  Eigen::Vector3d of_point_in_master() const;
  double twice_area() const { return 2 * prism_.face().area; }  ///< of the master face, m^2
  /// |x - p0| is no greater where no |coordinate| of x is, m.
  double distance(double s, double t, double depth) const { return length_s_ * s + length_t_ * t + depth; }
  /// Roundings of what the prism makes of vertices at `points_Me`, which it sees at these corners. Those that are
  /// `shared` are the master's own, seen exactly: they are off only by what M is off there.
  PrismRounding rounding(const std::array<Eigen::Vector3d, 3>& points_Me, const std::array<PrismPoint, 3>& corners,
                         const std::array<bool, 3>& shared) const;
  /// And of what it makes of any as near to p0 as that.
  PrismPositionError greatest_rounding(double distance) const;
  /// The first step, for vertices with these roundings, that are themselves off by up to `rounding_Me`.
  PrismPositionError of_vertices(const PrismRounding& rounding, const Eigen::Vector3d& rounding_Me) const;
  /// The same for any vertices of the slave, or of the master.
  PrismPositionError of_any_vertices(const PrismPositionError& rounding, bool of_master) const;
  /// The second, for points over the master face no deeper than `depth`.
  PrismPositionError of_frame(double depth) const;
  /// Both steps for a function of points over the master face no deeper than `depth`, on a face whose vertices are seen
  /// with these roundings and are off by up to `rounding_Me`.
  double of_function(const PrismFunction& f, double depth, const PrismRounding& rounding,
                     const Eigen::Vector3d& rounding_Me) const;
  /// The second step's part that turns depth into s and t, for points as far as `depth` from the master's plane,
  /// wherever they are: the rest maps lines in (s, t) to lines, and says nothing new of sides and windings.
  PrismPositionError of_tilt(double depth) const { return {tilt_.s * depth, tilt_.t * depth, 0}; }
  /// How far 1 - s - t may be from the weight of p0 as it is computed, over the master face no deeper than `depth`.
  double of_third_weight(double depth, const PrismRounding& rounding) const;

 private:
  double tilt_of(const PrismFunction& f) const;
  PrismPositionError displacement(const Eigen::Vector3d& rounding_Me) const;

  const MasterPrism& prism_;
  const Eigen::Vector3d& g_s_Me_;  ///< gradients of s and t, the prism's
  const Eigen::Vector3d& g_t_Me_;
  const Eigen::Vector3d& n_Me_;
  Eigen::Vector3d own_rounding_Me_;
  double ss_, st_, tt_;                  ///< scalar products of the gradients, 1 / m^2
  double length_s_, length_t_;           ///< of p1 - p0 and p2 - p0, m
  double gradient_s_, gradient_t_;       ///< length of the gradients of s and t, 1 / m
  PrismPositionError any_displacement_;  ///< by any vertex of F that is off by its rounding
  bool own_moves_;                       ///< the master is F's
  double height_;                        ///< how far such a vertex may be off along n, m
  double exact_depth_rounding_;          ///< what is added to a depth's roundings where
  double exact_depth_;                   ///< |depth| over the distance is less than this
  PrismPositionError frame_rounding_;    ///< roundings of the frame, at depth 0
  PrismPositionError tilt_rounding_;     ///< and times the depth
  PrismPositionError frame_;             ///< at depth 0
  PrismPositionError tilt_;              ///< times the depth
  double third_weight_;                  ///< of the sum of the weights at depth 0
  double third_weight_tilt_;             ///< and times the depth
};

}  // namespace pcm::fast
