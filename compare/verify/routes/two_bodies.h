// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "pcm/engine.h"
#include "pcm/scene.h"
#include "pcm/triangle_mesh.h"

/// Two bodies of a scene that are to each other as a pairing's question says.
namespace pcm::compare {

/// The pairing's two bodies, E before F.
fast::Scene scene_of(const fast::Pairing& pairing, const Wanted& wanted, const fast::Savings& savings);

/// Both bodies where they are to each other at the given state, each moving by half of it: E turned by turns of the
/// axes Q, at -Q r / 2 with velocity -Q v / 2, F at Q r / 2 with Q v / 2. Differences of these are exact. Where E
/// spins, too, by -Q w / 2, F's velocity is that at its marker besides.
struct TwoBodies {
  fast::BodyState E, F;
  Eigen::Vector3d carried_W = Eigen::Vector3d::Zero();  ///< velocity at F's marker by E's spin, m/s

  /// Turn and spin drawn from the state's bits.
  TwoBodies(const Pose& pose, const Velocity& velocity);
  /// `turn`: which of the 24 that turn axes onto axes.
  TwoBodies(const Pose& pose, const Velocity& velocity, std::uint64_t turn, bool spins);
};

/// F a step away. Either it is turned about its marker and moved by `step`: where it lies far off the marker, the turn
/// moves it by more. Or it is turned about the middle of its box, which stays: then nothing but the turn has moved it.
fast::BodyState stepped(const fast::BodyState& F, const TriangleMesh& mesh, double step, std::uint64_t which);

}  // namespace pcm::compare
