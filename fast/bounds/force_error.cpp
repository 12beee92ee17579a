// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/force_error.h"

#include <algorithm>
#include <cmath>

#include "fast/bounds/law_error.h"
#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;

/// The layers' shift (13) carries up to 2 roundings; without layers, or with a rigid body, it is exact.
constexpr double kShiftRoundings = 2;

/// The velocities of an element and their errors.
struct VelocityErrors {
  double v_n = 0;                                     ///< of the approach velocity (16), m/s
  Eigen::Vector3d slip_Me = Eigen::Vector3d::Zero();  ///< of v_k - v_n n_k, component by component, m/s
};

// (17): v_F = v + w x L, v_n = n . v_F, slip = v_F - v_n n; what is rounded and what the errors of L and n bring.
VelocityErrors velocity_errors(const ForceProblem& problem, const Element& element, double normal_error,
                               const Eigen::Vector3d& lever, const Eigen::Vector3d& lever_error) {
  const Eigen::Vector3d n = element.normal_Me.cwiseAbs(), w = problem.velocity.w.cwiseAbs();
  const Eigen::Vector3d turning = cross_of_magnitudes(w, lever.cwiseAbs());
  const Eigen::Vector3d v = problem.velocity.v.cwiseAbs() + turning;
  // A product, the difference of two, the sum with v.
  // Nothing underflows where nothing moves.
  const double underflow = problem.velocity.v.isZero(0) && w.isZero(0) ? 0 : kUnderflow;
  const Eigen::Vector3d v_error =
      cross_of_magnitudes(w, lever_error) + 2 * u * turning + u * v + Eigen::Vector3d::Constant(underflow);
  VelocityErrors errors;
  errors.v_n = n.dot(v_error) + normal_error * (v + v_error).sum() + 3 * u * n.dot(v) + underflow;
  const double v_n = std::abs(element.normal_velocity);
  errors.slip_Me = v_error + errors.v_n * n + Eigen::Vector3d::Constant((v_n + errors.v_n) * normal_error + underflow) +
                   u * (2 * v_n * n + v);
  return errors;
}

}  // namespace

ElementForceError force_error(const ForceProblem& problem, const Element& element, const ElementError& error) {
  const ContactLaw& law = problem.law;
  const Eigen::Vector3d n = element.normal_Me.cwiseAbs();
  const double depth = element.penetration;
  const double depth_error = error.penetration;

  // (13): C_k = foot + (shift u_k) n; lever L = C_k - r.
  const double shift = element.master == Side::E ? problem.stiffness.shift_from_E : problem.stiffness.shift_from_F;
  const double greatest_shift = shift * (depth + depth_error);
  const Eigen::Vector3d lever = element.position_Me - problem.pose.r;
  const Eigen::Vector3d lever_size = lever.cwiseAbs();
  const Eigen::Vector3d lever_error =
      error.foot_Me +
      (shift * depth_error + (kShiftRoundings + 2) * u * greatest_shift + kUnderflow * (depth + depth_error)) * n +
      Eigen::Vector3d::Constant(greatest_shift * error.normal) + u * (element.position_Me.cwiseAbs() + lever_size);

  VelocityErrors velocity;
  if (problem.with_velocities) velocity = velocity_errors(problem, element, error.normal, lever, lever_error);
  const Uncertain F_n = normal_force_error(problem, element, error, velocity.v_n);

  // (21), (22).
  FrictionErrors friction;
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  const Eigen::Vector3d force = element.force_Me.cwiseAbs();
  if (law.friction > 0) {
    friction = friction_error(law, F_n, element.tangential_velocity, velocity.slip_Me.sum());
    along = Eigen::Vector3d::Constant(friction.along);
    if (element.tangential_force > 0) {
      // The direction, from what is left of the force without F_n n, which it is rounded with.
      const double sign = element.master == Side::E ? 1 : -1;
      const Eigen::Vector3d tangential =
          (element.force_Me - (sign * element.normal_force) * element.normal_Me).cwiseAbs() +
          4 * u * (force + F_n.size * n);
      along = along.cwiseMin((friction.along / element.tangential_force) * tangential);
    }
  }
  ElementForceError result;
  result.force_Me = F_n.error * n + along + u * (F_n.size * n + force) +
                    Eigen::Vector3d::Constant(F_n.greatest() * error.normal + friction.beside + 0x1p-1060);
  result.torque_Me = cross_of_magnitudes(lever_size, result.force_Me) +
                     cross_of_magnitudes(lever_error, force + result.force_Me) +
                     2 * u * cross_of_magnitudes(lever_size, force) + Eigen::Vector3d::Constant(0x1p-1060);
  result.force_Me *= kSafetyFactor;
  result.torque_Me *= kSafetyFactor;
  return result;
}

GreatestForce greatest_force(const ForceProblem& problem, double area, double depth, const Eigen::Vector3d& foot_Me,
                             const Eigen::Vector3d& foot_error) {
  const ContactLaw& law = problem.law;
  const double u_k = std::min(depth, law.max_penetration);
  // |C_k - r|: the foot's distance, and no more than the whole penetration beyond.
  const double lever = (foot_Me - problem.pose.r).lpNorm<1>() + foot_error.sum() + u_k;
  const double speed = problem.velocity.v.lpNorm<1>() + problem.velocity.w.lpNorm<1>() * lever + kUnderflow;
  const double F_n = greatest_normal_force(problem, area, u_k, speed);
  const double normal = kSafetyFactor * F_n + 0x1p-1060, friction = kSafetyFactor * law.friction * F_n + 0x1p-1060;
  return {normal, friction, kSafetyFactor * lever * (normal + friction) + 0x1p-1060};
}

}  // namespace pcm::fast
