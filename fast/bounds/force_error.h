// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/bounds/element_error.h"
#include "fast/force/force_problem.h"

namespace pcm::fast {

/// Bounds on |computed - true| of an element's force on E and of its torque about Mf, component by component.
struct ElementForceError {
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< N m
};

/// What the errors of an element's geometry and the roundings of the force law (13)-(22) make of its force, where the
/// exact problem has the same element. `element` as apply_force left it. Never less than the true error; infinite or
/// NaN only where an error of the geometry is, or something overflows.
ElementForceError force_error(const ForceProblem& problem, const Element& element, const ElementError& error);

/// The greatest |force| and |torque| (both components and lengths) of an element of this area, at most this deep, whose
/// foot lies within `foot_error` of `foot_Me`, whatever its normal: what an element that may or may not exist can add.
struct GreatestForce {
  double normal = 0;    ///< along the normal, N
  double friction = 0;  ///< across, N
  double torque = 0;    ///< N m

  double force() const { return normal + friction; }
};
GreatestForce greatest_force(const ForceProblem& problem, double area, double depth, const Eigen::Vector3d& foot_Me,
                             const Eigen::Vector3d& foot_error);

}  // namespace pcm::fast
