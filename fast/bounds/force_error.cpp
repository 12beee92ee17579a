// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/force_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;

/// A computed number, as its absolute value, and how far it may be from the true one.
struct Uncertain {
  double size = 0;
  double error = 0;
  double greatest() const { return size + error; }
};

/// Both components of a x b whose products are taken absolutely.
Eigen::Vector3d absolute_cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a[1] * b[2] + a[2] * b[1], a[2] * b[0] + a[0] * b[2], a[0] * b[1] + a[1] * b[0]};
}

/// The layers' stiffness and shift (12), (13) carry up to 3 and 2 roundings; given c_l or a rigid body they are exact.
constexpr double kStiffnessRoundings = 3;
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
  const Eigen::Vector3d turning = absolute_cross(w, lever.cwiseAbs());
  const Eigen::Vector3d v = problem.velocity.v.cwiseAbs() + turning;
  // A product, the difference of two, the sum with v.
  const Eigen::Vector3d v_error = absolute_cross(w, lever_error) + 2 * u * turning + u * v;
  VelocityErrors errors;
  errors.v_n = n.dot(v_error) + normal_error * (v + v_error).sum() + 3 * u * n.dot(v);
  const double v_n = std::abs(element.normal_velocity);
  errors.slip_Me =
      v_error + errors.v_n * n + Eigen::Vector3d::Constant((v_n + errors.v_n) * normal_error) + u * (2 * v_n * n + v);
  return errors;
}

/// F_n (14), (15), (18) with its error. With V = A u: faded, A is min(A, V / u_d), which is off by no more than the
/// greater of both errors.
Uncertain normal_force(const ForceProblem& problem, const Element& element, const ElementError& error,
                       double v_n_error) {
  const ContactLaw& law = problem.law;
  const Uncertain area{element.area, error.area}, depth{element.penetration, error.penetration};
  const double c_l = problem.stiffness.c_l;
  const double volume_error = error.volume;
  const double elastic = c_l * area.size * depth.size;
  const double greatest_volume =
      std::min(area.greatest() * depth.greatest(), area.size * depth.size * kSafetyFactor + volume_error);
  const double elastic_error = c_l * std::min(volume_error, area.size * depth.error + area.error * depth.greatest()) +
                               (kStiffnessRoundings + 2) * u * c_l * greatest_volume;
  double damping = 0, damping_error = 0;
  if (law.damping > 0) {
    // Damping stays as it is where it cannot be felt: (18) and the mode `compression` are maxima, which never widen an
    // error.
    const Uncertain v_n{std::abs(element.normal_velocity), v_n_error};
    Uncertain faded = area;
    if (law.transition_depth > 0 && depth.size - 2 * depth.error < law.transition_depth) {
      const Uncertain fade{std::min(1.0, depth.size / law.transition_depth),
                           std::min(1.0, depth.error / law.transition_depth)};
      faded.size = area.size * fade.size;
      faded.error = std::min(area.error * std::min(1.0, fade.greatest()) + area.size * fade.error,
                             std::max(area.error, volume_error / law.transition_depth));
    }
    damping = law.damping * faded.size * v_n.size;
    damping_error = law.damping * (faded.error * v_n.greatest() + faded.size * v_n.error) +
                    5 * u * law.damping * faded.greatest() * v_n.greatest();
  }
  return {std::abs(element.normal_force), elastic_error + damping_error + u * (elastic + damping)};
}

// Friction (20), (21) as one vector: T = mu P h(s), P = max(F_n, 0), h(s) = phi(|s|) s / |s|, |h| <= 1, phi(v) = 1 from
// v_eps on and (v / v_eps)(2 - v / v_eps) below. The direction s / |s| alone has no bound near s = 0, but h has: its
// derivative is phi' along s and phi / v across, phi' <= phi / v, and phi / v falls with v. On the way from the
// computed s to the true one no |s| is less than v_low = |s| - |ds|, so |dh| <= min(2, |ds| phi(v_low) / v_low). At
// v_eps = 0 that is 1 / v_low, and 2 where s may vanish: the force jumps there. Roundings: |s| has 4 u, v / v_eps, its
// complement to 2 and their products 5, the direction and its product with F_t 3, mu P 2; doubled by s / v_eps entering
// twice: 24 u of |T| covers them.
struct FrictionErrors {
  double along = 0;   ///< by F_n's error, in the direction of friction, N
  double beside = 0;  ///< in any direction, N
};

FrictionErrors friction_error(const ContactLaw& law, const Uncertain& F_n, double v_t, double slip_error) {
  const double slip = law.slip_velocity;
  const double phi = v_t >= slip ? 1 : std::min(1.0, (v_t / slip) * (2 - v_t / slip) * kSafetyFactor);
  double turn = 0;
  if (slip_error > 0) {
    const double v_low = std::max(v_t - 2 * slip_error, 0.0);
    const double steepness = v_low < slip ? (2 - v_low / slip) / slip : 1 / v_low;
    turn = std::min(2.0, slip_error * steepness);
  }
  return {law.friction * F_n.error * phi, law.friction * F_n.greatest() * (turn + 24 * u * phi)};
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
      error.foot_Me + (shift * depth_error + (kShiftRoundings + 2) * u * greatest_shift) * n +
      Eigen::Vector3d::Constant(greatest_shift * error.normal) + u * (element.position_Me.cwiseAbs() + lever_size);

  VelocityErrors velocity;
  if (problem.with_velocities) velocity = velocity_errors(problem, element, error.normal, lever, lever_error);
  const Uncertain F_n = normal_force(problem, element, error, velocity.v_n);

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
  result.torque_Me = absolute_cross(lever_size, result.force_Me) +
                     absolute_cross(lever_error, force + result.force_Me) + 2 * u * absolute_cross(lever_size, force) +
                     Eigen::Vector3d::Constant(0x1p-1060);
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
  double F_n = problem.stiffness.c_l * area * u_k;
  if (law.damping > 0) {
    const double speed = problem.velocity.v.lpNorm<1>() + problem.velocity.w.lpNorm<1>() * lever;
    const double fade = u_k < law.transition_depth ? u_k / law.transition_depth : 1;
    F_n += law.damping * area * speed * fade;
  }
  const double normal = kSafetyFactor * F_n + 0x1p-1060, friction = kSafetyFactor * law.friction * F_n + 0x1p-1060;
  return {normal, friction, kSafetyFactor * lever * (normal + friction) + 0x1p-1060};
}

}  // namespace pcm::fast
