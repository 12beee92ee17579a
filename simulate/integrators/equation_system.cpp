// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/equation_system.h"

#include <utility>

namespace pcm::simulate {

namespace {

const SimTK::SubsystemIndex kDefaultSubsystem(0);

class EquationGuts final : public SimTK::System::Guts {
 public:
  EquationGuts(int size, EquationSystem::Slope slope) : size_(size), slope_(std::move(slope)) {}

 private:
  EquationGuts* cloneImpl() const override { return new EquationGuts(*this); }

  int realizeTopologyImpl(SimTK::State& state) const override {
    state.allocateZ(kDefaultSubsystem, SimTK::Vector(size_, 0.0));
    return 0;
  }

  /// An integrator realizes the end of a step to stage Velocity before it accepts it, and to Acceleration only when it
  /// takes the next step: asked for here, a slope that can't be had there is met while there still is a smaller step.
  int realizeVelocityImpl(const SimTK::State& state) const override {
    slope_(state.getTime(), state.getZ());
    return 0;
  }

  int realizeAccelerationImpl(const SimTK::State& state) const override {
    state.updZDot(kDefaultSubsystem) = slope_(state.getTime(), state.getZ());
    return 0;
  }

  int size_;
  EquationSystem::Slope slope_;
};

}  // namespace

EquationSystem::EquationSystem(int size, Slope slope) {
  adoptSystemGuts(new EquationGuts(size, std::move(slope)));
  SimTK::DefaultSystemSubsystem subsystem(*this);  // which the System owns; z is its
  realizeTopology();
}

SimTK::State EquationSystem::state_at(double t, const SimTK::Vector& y) const {
  SimTK::State state = getDefaultState();
  realizeModel(state);
  state.setTime(t);
  state.updZ() = y;
  return state;
}

}  // namespace pcm::simulate
