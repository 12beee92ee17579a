// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/climb.h"

namespace pcm::compare {
namespace {

constexpr int kStarts = 64, kNeighbours = 384;

/// Moved along one axis by up to `share` of the size, or turned by an angle of up to twice that: what is gained in the
/// roundings of the one is kept while the other changes.
Pose neighbour(const Pose& pose, double share, double size, PoseRandom& random) {
  Pose near = pose;
  if (random.coin()) {
    near.r[static_cast<Eigen::Index>(random.below(3))] += share * size * random.uniform(-1, 1);
    return near;
  }
  const Eigen::Vector3d turn = random.direction() * (share * random.uniform());
  const Eigen::Matrix3d R = ordered_rotation(1, turn.x(), turn.y(), turn.z());
  for (int j = 0; j < 3; ++j) near.A.col(j) = ordered_product(R, pose.A.col(j));
  return near;
}

}  // namespace

HardPose climb(const HeldPairing& held, PoseRandom random, fast::Workspace& workspace) {
  HardPose hardest;
  const auto take_unless_easier = [&](const Pose& pose) {
    const ErrorOverBound there = error_over_bound(held, pose, workspace);
    if (!there.flipped && there.ratio >= hardest.ratio) hardest = {pose, there.ratio};
  };
  const double size = held.features().size();
  for (int i = 0; i < kStarts; ++i)
    take_unless_easier(detail::draw_overlapping(held.features(), 1e-6, 0.5, random).pose);
  for (int i = 0; i < kNeighbours; ++i)
    take_unless_easier(neighbour(hardest.pose, random.log_uniform(0x1p-52, 0x1p-4), size, random));
  return hardest;
}

}  // namespace pcm::compare
