// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "compare/surface_features.h"
#include "fast/inputs.h"
#include "reference/answer.h"

/// How far a right engine's doubles may be from the oracle's on the same rounded problem: running error bounds, derived
/// in rounding_bounds.cpp step by step from the formulas of PCM sections 5 to 7. Every discrete decision is exact, so
/// rounding enters through values only. Nothing here is tuned: each term is the unit roundoff u = 2^-53 times the
/// number of roundings of a straightforward evaluation times its condition.
namespace pcm::compare {

/// A question put to both sides.
struct Question {
  const SurfaceFeatures& E;
  const SurfaceFeatures& F;
  const ContactLaw& law;
  Mode mode = Mode::E;
  Scheme scheme = Scheme::barycentric;
  Pose pose;
  Velocity velocity;
};

/// Bounds for one contact element.
struct ElementBounds {
  double area = 0;         ///< m^2
  double penetration = 0;  ///< m
  double position = 0;     ///< m, length of the difference
  double force = 0;        ///< N, length of the difference
  double torque = 0;       ///< N m, length of the difference
};

/// Bounds for the sums over elements, in the scale of the totals (halved in mode `both`).
struct ForceBounds {
  std::vector<ElementBounds> elements;
  double penetration = 0;  ///< of the greatest penetration, m
  double force = 0;
  double torque = 0;
};

/// Bounds for what hangs on the polygons.
struct AreaBounds {
  std::vector<std::vector<double>> positions;  ///< by polygon and point, m
  double area_E = 0;                           ///< m^2
  double area_F = 0;
  double vector_area_E = 0;  ///< m^2, length of the difference
  double vector_area_F = 0;
  double volume = 0;  ///< m^3
};

/// The rounded problem's geometry as the bounds need it. O(n) to build.
class RoundingBounds {
 public:
  RoundingBounds(const Question& question, const reference::Answer& true_rounded);

  ForceBounds force() const;
  AreaBounds area() const;

 private:
  struct Face {
    Eigen::Vector3d normal_Me = Eigen::Vector3d::Zero();  ///< unit, null where the area is 0
    double area = 0;
    double area_error = 0;    ///< m^2
    double normal_error = 0;  ///< of the unit normal, at most 2
    double longest = 0;       ///< longest side, m
    double farthest = 0;      ///< greatest |coordinate|, m
  };

  const SurfaceFeatures& surface(Side side) const { return side == Side::E ? question_.E : question_.F; }
  const Eigen::Vector3d& vertex(Side side, Index v) const;
  const Eigen::Vector3d& corner(Side side, Index face, std::size_t k) const;
  Face face(Side side, Index face) const;
  ElementBounds element(const reference::Element& e) const;
  double position_error(const reference::Crossing& crossing) const;

  const Question& question_;
  const reference::Answer& true_;
  std::vector<Eigen::Vector3d> vertices_F_Me_;
};

}  // namespace pcm::compare
