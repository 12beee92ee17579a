// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simbody/placed_surfaces.h"

namespace pcm::simbody {

void PlacedSurfaces::add(const SimTK::MobilizedBody& body, const SimTK::Transform& X_BS) {
  placed_.push_back({body.getMobilizedBodyIndex(), X_BS});
}

Pose PlacedSurfaces::pose(const SimTK::State& state, Index surface) const {
  const SimTK::Transform X = in_ground(state, surface);
  Pose pose;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) pose.A(row, column) = X.R().asMat33()(row, column);
  pose.r = to_eigen(X.p());
  return pose;
}

fast::BodyState PlacedSurfaces::body_state(const SimTK::State& state, Index surface, bool moving) const {
  const SimTK::MobilizedBody& carrying = body(surface);
  fast::BodyState result;
  result.pose = pose(state, surface);
  if (moving) {
    result.velocity.v = to_eigen(carrying.findStationVelocityInGround(state, at(surface).X_BS.p()));
    result.velocity.w = to_eigen(carrying.getBodyAngularVelocity(state));
  }
  return result;
}

void PlacedSurfaces::body_states(const SimTK::State& state, bool moving, std::vector<fast::BodyState>& states) const {
  states.clear();
  for (Index surface = 0; surface < static_cast<Index>(placed_.size()); ++surface)
    states.push_back(body_state(state, surface, moving));
}

}  // namespace pcm::simbody
