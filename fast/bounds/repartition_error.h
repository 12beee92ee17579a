// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/bounds/element_error.h"
#include "fast/bounds/force_error.h"
#include "fast/force/force_problem.h"

namespace pcm::fast {

/// The error of the force from area that the exact problem gives to another element of the same master face (clipped
/// scheme). What one element loses another one gains, so transfers sum to zero, and only the difference of the
/// elements' rates of force counts.
///
/// With fixed velocities the force of an element k may be linear in its integrals, dF = c_k dV + b_k dA
/// (surely_linear_rates, fast/bounds/law_error.h); V is the integral of the clamped depth. What passes sums
/// up to nothing, so the force is off by no more than the sum of |c_k - c| |dV| + |b_k - b| |dA|, c and b those of any
/// one element: as much as the velocities differ from element to element. An element whose force may not be linear
/// counts in full, and what it may pass to the others as well.
class RepartitionError {
 public:
  /// An element and its errors, of which those that pass are not part yet. If its force may not be linear, they become
  /// so.
  void add(const ForceProblem& problem, const Element& element, ElementError& error, ElementForceError& sum);
  /// What may pass to or from where no element was computed, m^2 and m^3.
  void add_elsewhere(double area, double volume);
  /// Once all the face's elements are entered.
  void finish(ElementForceError& sum) const;

  /// By how much the other errors of an element whose force is linear may grow through what passes.
  static constexpr double kGrowth = 1 + 0x1p-10;

 private:
  struct Rates {
    Eigen::Vector3d per_volume_Me = Eigen::Vector3d::Zero();  ///< N / m^3
    Eigen::Vector3d per_area_Me = Eigen::Vector3d::Zero();    ///< N / m^2
    Eigen::Vector3d lever_Me = Eigen::Vector3d::Zero();       ///< m
  };
  Rates first_;
  bool has_first_ = false;
  double elsewhere_area_ = 0, elsewhere_volume_ = 0;
};

}  // namespace pcm::fast
