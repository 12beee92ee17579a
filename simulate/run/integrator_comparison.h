// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "simulate/run/simulation.h"

namespace pcm::simulate {

/// One scene to its end by one integrator.
struct IntegratorTrial {
  std::string integrator;
  JacobianOf jacobian = JacobianOf::differences;  ///< where it takes any
  double tolerance = 0;                           ///< relative and, in m, rad, m/s, rad/s, absolute
  double slip_velocity = 0;                       ///< of the laws with friction, m/s
  Work work = {};
  /// The greatest difference of a component of the state at the end, in m, rad, m/s or rad/s, from the reference.
  double error = 0;
  bool gave_up = false;  ///< before the end: no error then

  std::string name() const { return integrator + (jacobian == JacobianOf::tangents ? ", tangents" : ""); }
  std::int64_t evaluations() const { return work.derivatives + work.derivatives_for_jacobians; }
};

/// How all integrators do in one scene.
struct IntegratorComparison {
  double slip_velocity = 0;  ///< of the scene itself, m/s
  double reference_tolerance = 0;
  double reference_error = 0;                     ///< the difference between BDF's and ESDIRK's state at that tolerance
  std::vector<IntegratorTrial> by_tolerance;      ///< at the scene's slip velocity
  std::vector<IntegratorTrial> by_slip_velocity;  ///< at a tolerance of a tenth of it, where that is below 1; no errors
};

/// Relative and absolute, of the run that the others' errors are measured against.
inline constexpr double kReferenceTolerance = 1e-8;

/// Gives every law with friction this slip velocity, m/s.
void set_slip_velocity(Scene& scene, double slip_velocity);

/// Those that take Jacobians with these made of differences, then of tangents. Tolerances from 1e-3 to 1e-6, and slip
/// velocities from a hundred times the scene's down to a tenth of it, by powers of ten. `begin` is told what is begun.
/// Throws BadInput, before any work, where the scene has no friction, or laws with friction have no slip velocity or
/// not the same one; and IntegrationFailure where the reference can't be had.
IntegratorComparison compare_integrators(const Scene& scene,
                                         const std::vector<std::pair<std::string, Method>>& integrators,
                                         const std::function<void(const std::string&)>& begin);

}  // namespace pcm::simulate
