// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/active/intersection.h"
#include "fast/base/geometry.h"
#include "fast/bounds/force_error.h"
#include "fast/bounds/undecided_faces.h"
#include "fast/force/element_sum.h"

namespace pcm::fast {

/// Gathers a rigorous bound on the errors of one master's force and torque against the exact problem (PCM section 1):
/// what every element adds to them, in either scheme (fast/bounds/barycentric_bound.h, fast/bounds/clipped_bound.h),
/// and the rounding of the sums.
///
/// All bounds are finite but where the element's own numbers come near the end of the range of doubles.
class MasterBound {
 public:
  /// The candidate pairs must have been kept. `undecided` is filled.
  MasterBound(const Intersection& intersection, Side master, const ForceProblem& problem, UndecidedFaces& undecided);

  Side master() const { return master_; }
  const UndecidedFaces& undecided() const { return undecided_; }
  const Eigen::Vector3d& rounding_Me() const { return rounding_Me_; }  ///< of any vertex of F

  void add(const ElementForceError& error);
  /// An element that the exact problem may not have.
  void add_whole_force(const Element& element);
  /// One that the exact problem may have: of a face with this geometry, its area and depth at most these.
  void add_possible_element(double area, double depth, const FaceGeometry& geometry, const Eigen::Vector3d& foot_error);
  /// What the last addition to a sum rounds off.
  void add_rounding_of(const MasterForce& total);
  /// The exact problem has a point at least as deep as the one, and none of this element or face deeper than the other.
  void note_depth(double at_least, double at_most);
  double depth_at_least() const { return sum_.penetration_at_least; }  ///< of the point noted so, m
  /// A decision may be another one in the exact problem.
  void flip() { sum_.flipped = true; }

  ForceBound result() const;

 private:
  const ForceProblem& problem_;
  Side master_;
  UndecidedFaces& undecided_;
  Eigen::Vector3d rounding_Me_;
  ForceBound sum_;
};

/// The bound of mode `both`: of the mean of what both masters' bounds are for.
ForceBound mean_bound(const ForceBound& E, const ForceBound& F, const MasterForce& mean);

}  // namespace pcm::fast
