// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/force/tangent_sum.h"

#include "fast/simd/element_sets.h"

namespace pcm::fast {

namespace {

Eigen::Matrix3d sum_of_lanes(const MatrixLanes& lanes) {
  Eigen::Matrix3d sum;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j) {
      const std::array<double, kElementLanes>& x = lanes[static_cast<std::size_t>(3 * i + j)].value;
      sum(i, j) = (x[0] + x[1]) + (x[2] + x[3]);
    }
  return sum;
}

/// The matrix of (a x).
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return matrix;
}

}  // namespace

void TangentSum::add(const ElementLanes& lanes, const ForceLimits& limits, LaneBits which) {
  if (are_parts_) {
    fastest_wide_elements().tangent_of_parts(lanes, motions_, limits, which, lanes_);
  } else {
    fastest_wide_elements().tangent(lanes, limits, which, lanes_);
  }
}

void TangentSum::set_motion(std::size_t lane, const ElementMotion& motion) {
  are_parts_ = true;
  const auto set = [lane](const MotionSlope& slope, ElementMotionLanes::Slope& lanes) {
    lanes.by_position.set(lane, slope.by_position);
    lanes.by_rotation.set(lane, slope.by_rotation);
  };
  set(motion.area, motions_.area);
  set(motion.depth, motions_.depth);
  set(motion.s, motions_.s);
  set(motion.t, motions_.t);
  motions_.edge_s_Me.set(lane, motion.edge_s_Me);
  motions_.edge_t_Me.set(lane, motion.edge_t_Me);
}

Tangent TangentSum::total(const ForceLimits& limits, const Eigen::Vector3d& force_Me,
                          const Eigen::Vector3d& torque_Me) const {
  const Eigen::Matrix3d force_by_velocity = sum_of_lanes(lanes_.force_by_velocity),
                        force_by_spin = -sum_of_lanes(lanes_.force_by_lever),
                        torque_by_velocity = sum_of_lanes(lanes_.torque_by_velocity),
                        torque_by_spin = -sum_of_lanes(lanes_.torque_by_lever);
  Eigen::Matrix3d force_by_position = sum_of_lanes(lanes_.force_by_position),
                  force_by_rotation = sum_of_lanes(lanes_.force_by_rotation),
                  torque_by_position = sum_of_lanes(lanes_.torque_by_position),
                  torque_by_rotation = sum_of_lanes(lanes_.torque_by_rotation);
  const auto matrix = [](const std::array<double, 3>& a) { return cross_matrix({a[0], a[1], a[2]}); };
  const Eigen::Matrix3d v_x = matrix(limits.v_Me), w_x = matrix(limits.w_Me);
  if (limits.master_E) {
    force_by_position -= force_by_velocity * w_x;
    torque_by_position -= torque_by_velocity * w_x;
    torque_by_position += cross_matrix(force_Me);
  } else {
    force_by_rotation += force_by_velocity * v_x + force_by_spin * w_x - cross_matrix(force_Me);
    torque_by_rotation += torque_by_velocity * v_x + torque_by_spin * w_x - cross_matrix(torque_Me);
  }
  Tangent tangent;
  tangent << force_by_position, force_by_rotation, force_by_velocity, force_by_spin,  //
      torque_by_position, torque_by_rotation, torque_by_velocity, torque_by_spin;
  return tangent.array() + 0.0;  // no -0
}

}  // namespace pcm::fast
