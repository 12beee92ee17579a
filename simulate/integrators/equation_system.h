// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SimTKmath.h>

#include <functional>

namespace pcm::simulate {

/// dy/dt = f(t, y) as a Simbody System, which is what Simbody's integrators work on: y are its auxiliary variables z,
/// and there is nothing else in it, no bodies and no constraints.
class EquationSystem : public SimTK::System {
 public:
  /// f; where it throws, the integrator tries a smaller step. It is asked for the same state several times in a row.
  using Slope = std::function<const SimTK::Vector&(double t, const SimTK::Vector& y)>;

  EquationSystem(int size, Slope slope);

  SimTK::State state_at(double t, const SimTK::Vector& y) const;
};

}  // namespace pcm::simulate
