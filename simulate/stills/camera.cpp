// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace pcm::simulate {
namespace {

constexpr double kHalfHeightAngle = 15 * std::numbers::pi / 180;  // rad
constexpr double kFilled = 0.88;                                  // of the picture, by the box
constexpr int kRounds = 8;

/// Where the eye is seen from the box's centre, along C's axes, m.
Eigen::Vector3d fitted_eye(const std::array<Eigen::Vector3d, 8>& corners, double tangent, double aspect) {
  // What is near looks greater, so that the middle of the box is not the middle of its picture.
  Eigen::Vector2d shift(0, 0);
  double distance = 0;
  for (int round = 0; round < kRounds; ++round) {
    distance = 0;
    for (const Eigen::Vector3d& x : corners)
      distance =
          std::max(distance, x.z() + std::max(std::abs(x.x() - shift.x()) / aspect, std::abs(x.y() - shift.y())) /
                                         (kFilled * tangent));
    if (distance == 0) distance = 1;
    for (const int axis : {0, 1}) {
      double least = std::numeric_limits<double>::infinity(), greatest = -least;
      for (const Eigen::Vector3d& x : corners) {
        const double seen = (x[axis] - shift[axis]) / (distance - x.z());
        least = std::min(least, seen);
        greatest = std::max(greatest, seen);
      }
      shift[axis] += distance * (least + greatest) / 2;
    }
  }
  return {shift.x(), shift.y(), distance};
}

}  // namespace

Camera camera_on(const Eigen::AlignedBox3d& box_W, double aspect) {
  Camera camera;
  camera.tan_half_height = std::tan(kHalfHeightAngle);
  const Eigen::Vector3d z = Eigen::Vector3d(0.55, -1, 0.5).normalized();
  const Eigen::Vector3d x = Eigen::Vector3d::UnitZ().cross(z).normalized();
  camera.A_CW << x.transpose(), z.cross(x).transpose(), z.transpose();
  const Eigen::Vector3d centre_W = box_W.center();
  std::array<Eigen::Vector3d, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = camera.A_CW * (box_W.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - centre_W);
  const Eigen::Vector3d eye = fitted_eye(corners, camera.tan_half_height, aspect);
  camera.eye_W = centre_W + camera.A_CW.transpose() * eye;
  camera.distance = eye.z();
  return camera;
}

}  // namespace pcm::simulate
