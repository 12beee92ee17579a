// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "compare/verify/bounds/element_law.h"
#include "compare/verify/bounds/question.h"
#include "compare/verify/bounds/rounded_faces.h"
#include "reference/vocabulary/answer.h"

/// How far a right engine's doubles may be from the oracle's on the same rounded problem: running error bounds, derived
/// in rounding_bounds.cpp step by step from the formulas of PCM sections 5 to 7. Every discrete decision is exact, so
/// rounding enters through values only. Nothing here is tuned: each term is the unit roundoff u = 2^-53 times the
/// number of roundings of a straightforward evaluation times its condition.
namespace pcm::compare {

/// Bounds for the sums over elements, in the scale of the totals (halved in mode `both`).
struct ForceBounds {
  std::vector<ElementBounds> elements;
  double penetration = 0;  ///< of the greatest penetration, m
  double force = 0;
  double torque = 0;
};

/// Bounds for what depends on the polygons.
struct AreaBounds {
  std::vector<std::vector<double>> positions;  ///< by polygon and point, m
  double area_E = 0;                           ///< m^2
  double area_F = 0;
  double vector_area_E = 0;  ///< m^2, length of the difference
  double vector_area_F = 0;
  double volume = 0;  ///< m^3
};

/// Of the barycentric scheme's elements, and of areas in either scheme. O(n) to build.
class RoundingBounds {
 public:
  RoundingBounds(const Question& question, const reference::Answer& true_rounded);

  /// Greatest |coordinate|, m.
  double max_coordinate() const { return faces_.max_coordinate(); }
  ForceBounds force() const;
  AreaBounds area() const;

 private:
  ElementBounds element(const reference::Element& e) const;
  struct PositionError {
    double along = 0;   ///< the edge, m
    double height = 0;  ///< over the plane of the face, m
    double bound = 0;   ///< along the edge, with terms of higher order, m
  };
  PositionError position_error(const reference::Crossing& crossing) const;
  /// The points that bound the clipped part of a face, or several of these.
  struct Part {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;
    double off = 0;    ///< no point is stored farther off its edge, m
    double terms = 0;  ///< of the sum that is its area

    void add(const Eigen::Vector3d& x_Me, double off_edge, double more_terms) {
      low = low.cwiseMin(x_Me);
      high = high.cwiseMax(x_Me);
      off = std::max(off, off_edge);
      terms += more_terms;
    }
    /// No two true points are farther apart, m; 0 for none.
    double width() const { return (low.array() <= high.array()).all() ? (high - low).stableNorm() + 2 * off : 0; }
  };
  /// Of an edge, as far as the other surface may wind about it: from its first crossing, or a corner about which that
  /// winds, to the last, m; all of it where that surface is open.
  std::map<std::pair<Side, std::array<Index, 2>>, double> lengths_inside() const;
  /// Whether the other surface may wind about the vertex.
  bool may_be_wound(Side side, Index vertex) const;
  /// No two points of it are farther apart, m.
  double width_of(Part part, Side side, Index face) const;

  const Question& question_;
  const reference::Answer& true_;
  RoundedFaces faces_;
};

}  // namespace pcm::compare
