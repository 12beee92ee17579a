// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/opposed_rotation.h"

namespace pcm::compare {
namespace {

/// A right-handed orthonormal frame, by columns, whose third axis is `third` and whose first is drawn about it.
Eigen::Matrix3d frame_about(const Eigen::Vector3d& third, PoseRandom& random) {
  for (;;) {
    const Eigen::Vector3d drawn = random.direction();
    const Eigen::Vector3d second = ordered_cross(third, drawn);
    if (ordered_dot(second, second) < 1e-4) continue;
    Eigen::Matrix3d frame;
    frame.col(2) = third;
    frame.col(1) = ordered_normalized(second);
    frame.col(0) = ordered_cross(frame.col(1), third);
    return frame;
  }
}

/// B T C^T, one rounded operation at a time.
Eigen::Matrix3d ordered_product_transposed(const Eigen::Matrix3d& B, const Eigen::Matrix3d& T,
                                           const Eigen::Matrix3d& C) {
  Eigen::Matrix3d product;
  for (int j = 0; j < 3; ++j) product.col(j) = ordered_product(B, ordered_product(T, C.row(j).transpose()));
  return product;
}

}  // namespace

Eigen::Matrix3d draw_opposed_rotation(const Eigen::Vector3d& normal_E, const Eigen::Vector3d& normal_F,
                                      double half_tilt, PoseRandom& random) {
  const double t = half_tilt;
  Eigen::Matrix3d tilt = Eigen::Matrix3d::Identity();
  tilt(1, 1) = tilt(2, 2) = (1 - t * t) / (1 + t * t);
  tilt(2, 1) = 2 * t / (1 + t * t);
  tilt(1, 2) = -tilt(2, 1);
  const Eigen::Matrix3d frame_E = frame_about(normal_E, random);
  const Eigen::Matrix3d frame_F = frame_about(-normal_F, random);
  return ordered_product_transposed(frame_E, tilt, frame_F);
}

}  // namespace pcm::compare
