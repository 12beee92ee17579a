// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/hard_poses/error_over_bound.h"
#include "compare/random/random.h"

/// Poses that are searched for, because they bring the engine's error near to its own bound. The stratum adversarial
/// searches for the least margins of decisions instead.
namespace pcm::compare {

/// A pose and the error over its bound there.
struct HardPose {
  Pose pose;
  double ratio = 0;
};

/// Draws 64 poses as the stratum generic does and climbs from the hardest of them: 384 times a neighbour is drawn,
/// moved along an axis by up to 2^-52 to 2^-4 of the smaller body's size or turned by as much, and taken unless it is
/// easier. So scales from roundings to features are tried alike, and where the ratio does not change the climb walks
/// on.
///
/// Poses whose bound says `flipped` are left alone: their bound is what one element more or less would change, and is
/// used up wherever that comes true. A pure function of the pairing and the random numbers, by correctly rounded
/// operations only. Where nothing that is drawn carries a force, the ratio is 0.
/// Cost: 448 questions to engine and oracle each, 0.03 to 0.3 s for bodies of some dozen faces.
HardPose climb(const HeldPairing& held, PoseRandom random, fast::Workspace& workspace);

}  // namespace pcm::compare
