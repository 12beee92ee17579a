// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Simbody.h>

#include <Eigen/Core>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/scene.h"

namespace pcm::simbody {

inline Eigen::Vector3d to_eigen(const SimTK::Vec3& v) {
  return {v[0], v[1], v[2]};
}

inline SimTK::Vec3 to_simtk(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

/// Surfaces on mobilized bodies: where each one is in Ground, and how it moves. G is Ground, B the body, S the surface.
class PlacedSurfaces {
 public:
  explicit PlacedSurfaces(const SimTK::SimbodyMatterSubsystem& matter) : matter_(matter) {}

  void add(const SimTK::MobilizedBody& body, const SimTK::Transform& X_BS);

  const SimTK::SimbodyMatterSubsystem& matter() const { return matter_; }
  SimTK::MobilizedBodyIndex body_index(Index surface) const { return at(surface).body; }
  const SimTK::MobilizedBody& body(Index surface) const { return matter_.getMobilizedBody(at(surface).body); }
  /// X_GS; Stage::Position is enough, as for the next one.
  SimTK::Transform in_ground(const SimTK::State& state, Index surface) const {
    return body(surface).getBodyTransform(state) * at(surface).X_BS;
  }
  Pose pose(const SimTK::State& state, Index surface) const;
  /// Of all surfaces, for fast::Scene::move; with velocities where `moving`, which takes Stage::Velocity.
  void body_states(const SimTK::State& state, bool moving, std::vector<fast::BodyState>& states) const;

 private:
  struct Placed {
    SimTK::MobilizedBodyIndex body;
    SimTK::Transform X_BS;
  };
  const Placed& at(Index surface) const { return placed_[static_cast<std::size_t>(surface)]; }
  fast::BodyState body_state(const SimTK::State& state, Index surface, bool moving) const;

  const SimTK::SimbodyMatterSubsystem& matter_;
  std::vector<Placed> placed_;
};

}  // namespace pcm::simbody
