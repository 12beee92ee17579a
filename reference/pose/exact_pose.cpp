// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/pose/exact_pose.h"

namespace pcm::reference {
namespace {

/// fl(fl(fl(fl(a_i1 x) + fl(a_i2 y)) + fl(a_i3 z)) + r_i), to nearest, without fused multiply-add: PCM section 1.
Eigen::Vector3d rounded_point(const Pose& pose, const Eigen::Vector3d& x_F) {
  Eigen::Vector3d x_E;
  for (int i = 0; i < 3; ++i) {
    const double first = pose.A(i, 0) * x_F[0];
    const double second = pose.A(i, 1) * x_F[1];
    const double third = pose.A(i, 2) * x_F[2];
    x_E[i] = ((first + second) + third) + pose.r[i];
  }
  return x_E;
}

}  // namespace

ExactPose::ExactPose(Problem problem, const Surface& surface_E, const Surface& surface_F, const Pose& pose)
    : problem_(problem), surface_E_(surface_E), surface_F_(surface_F), pose_(pose) {
  const std::vector<Eigen::Vector3d>& vertices = surface_F.mesh.vertices;
  rounded_F_.reserve(vertices.size());
  for (const Eigen::Vector3d& x_F : vertices) rounded_F_.push_back(rounded_point(pose, x_F));

  true_F_.reserve(vertices.size());
  const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
  for (const Eigen::Vector3d& x_F : vertices) {
    Box box;
    for (int i = 0; i < 3; ++i) {
      const Interval x = Interval(pose.A(i, 0)) * Interval(x_F[0]) + Interval(pose.A(i, 1)) * Interval(x_F[1]) +
                         Interval(pose.A(i, 2)) * Interval(x_F[2]) + Interval(pose.r[i]);
      box.lower[i] = x.inf();
      box.upper[i] = x.sup();
    }
    true_F_.push_back(box);
  }
}

Box ExactPose::face_box(Side side, Index f) const {
  const Triangle& t = face(side, f);
  Box box = rounding_box({side, t[0]});
  box.include(rounding_box({side, t[1]}));
  box.include(rounding_box({side, t[2]}));
  return box;
}

std::vector<Box> ExactPose::face_boxes(Side side) const {
  const Index count = static_cast<Index>(surface(side).mesh.faces.size());
  std::vector<Box> boxes;
  boxes.reserve(surface(side).mesh.faces.size());
  for (Index f = 0; f < count; ++f) boxes.push_back(face_box(side, f));
  return boxes;
}

}  // namespace pcm::reference
