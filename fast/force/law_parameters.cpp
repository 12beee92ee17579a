// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/force/law_parameters.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "fast/base/geometry.h"
#include "fast/law/element_force.h"
#include "meshes/base/floating_point_environment.h"
#include "pcm/bad_input.h"
#include "pcm/layer_stiffness.h"

namespace pcm::fast {

namespace {

[[noreturn]] void refuse(const char* what, double value, const char* range) {
  std::ostringstream message;
  message.precision(17);
  message << what << " is " << value << "; it must be " << range;
  throw BadInput(message.str());
}

void require_not_negative(const char* what, double value) {
  if (!(value >= 0 && std::isfinite(value))) refuse(what, value, "finite and not negative");
}

void require_positive(const char* what, double value) {
  if (!(value > 0 && std::isfinite(value))) refuse(what, value, "finite and greater than 0");
}

void require_positive_or_infinite(const char* what, double value) {
  if (!(value > 0)) refuse(what, value, "greater than 0 (infinite is allowed)");
}

/// Of v, m/s, and w, rad/s. Points of surfaces that touch are no farther than 2^303 m from Mf, so that their
/// velocities, and what bounds have of them, stay finite with room for roundings; the relative velocities of a scene's
/// bodies, which are no greater than 2^603, are among these.
constexpr double kGreatestVelocity = 0x1p700;

/// Below the least normal number a sum of two halves has lost digits, or all.
void require_layer_stiffness(const char* what, double value) {
  if (!(value >= std::numeric_limits<double>::min())) refuse(what, value, "at least 2^-1022 (infinite is allowed)");
}

}  // namespace

void require_valid(const ContactLaw& law) {
  if (law.layers) {
    require_layer_stiffness("contact law: layer stiffness c_E", law.layers->c_E);
    require_layer_stiffness("contact law: layer stiffness c_F", law.layers->c_F);
    if (std::isinf(law.layers->c_E) && std::isinf(law.layers->c_F)) {
      throw BadInput("contact law: both bodies are rigid; give at least one a finite layer stiffness");
    }
  } else {
    require_positive("contact law: stiffness c_l", law.stiffness);
  }
  require_not_negative("contact law: damping d_l", law.damping);
  require_not_negative("contact law: transition depth u_d", law.transition_depth);
  require_not_negative("contact law: friction mu", law.friction);
  require_not_negative("contact law: slip velocity v_eps", law.slip_velocity);
  require_positive_or_infinite("contact law: max_penetration", law.max_penetration);
}

void require_valid(const Velocity& velocity) {
  if (!velocity.v.allFinite() || !velocity.w.allFinite()) throw BadInput("velocity: v and w must be finite");
  for (const Eigen::Vector3d& x : {velocity.v, velocity.w}) {
    const double greatest = x.cwiseAbs().maxCoeff();
    if (greatest > kGreatestVelocity)
      refuse("velocity: greatest |v| or |w|", greatest, "at most 2^700; choose other units");
  }
}

double require_valid(const Pose& pose, const Velocity& velocity) {
  const double skew = orthogonality_error(pose.A);
  const bool is_orthogonal = skew <= 1e-9;  // of finite entries alone
  if (!pose.r.allFinite() || !(is_orthogonal || pose.A.allFinite())) throw BadInput("pose: A and r must be finite");
  if (pose.r.cwiseAbs().maxCoeff() > kGreatestCoordinate) {
    refuse("pose: greatest |r|", pose.r.cwiseAbs().maxCoeff(), "at most 2^300 m; choose a larger unit of length");
  }
  require_valid(velocity);
  if (!is_orthogonal) refuse("pose: A is no rotation, max |A^T A - I|", skew, "at most 1e-9");
  if (!(pose.A.determinant() > 0)) throw BadInput("pose: A is a reflection (its determinant is negative), no rotation");
  return skew;
}

namespace {

[[gnu::noinline]] double stiffness_of_layer(double young, double poisson, double thickness) {
  require_positive("elastic layer: Young's modulus", young);
  require_positive("elastic layer: thickness", thickness);
  if (!(poisson > -1 && poisson < 0.45)) {
    refuse("elastic layer: Poisson's ratio", poisson, "greater than -1 and less than 0.45");
  }
  const double stiffness = (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) * young / thickness;
  if (!(stiffness >= std::numeric_limits<double>::min() && stiffness <= std::numeric_limits<double>::max()))
    refuse("elastic layer: stiffness K / b", stiffness, "between 2^-1022 and 2^1024 N/m^3; choose other units");
  return stiffness;
}

}  // namespace

double layer_stiffness(double young, double poisson, double thickness) {
  const DefaultFloatingPoint environment;
  return stiffness_of_layer(young, poisson, thickness);
}

SeriesStiffness::SeriesStiffness(const ContactLaw& law) {
  if (!law.layers) {
    c_l = law.stiffness;
    shift_from_E = shift_from_F = 0.5;
    return;
  }
  const double c_E = law.layers->c_E, c_F = law.layers->c_F;
  if (std::isinf(c_E) || std::isinf(c_F)) {
    // A rigid body doesn't yield: the contact lies on its surface.
    c_l = std::isinf(c_E) ? c_F : c_E;
    shift_from_E = std::isinf(c_E) ? 0 : 1;
    shift_from_F = std::isinf(c_F) ? 0 : 1;
    return;
  }
  // Halved where the sum might overflow: small ones would lose digits by it.
  const double part = std::max(c_E, c_F) > 1 ? 0.5 : 1;
  const double sum = part * c_E + part * c_F;
  shift_from_E = part * c_F / sum;
  shift_from_F = part * c_E / sum;
  // The share of the stiffer layer is no less than a half: the other one may be less than all doubles.
  c_l = c_E < c_F ? c_E * shift_from_E : c_F * shift_from_F;
}

ElementForce element_force(const ContactLaw& law, double c_l, double area, double penetration, double v_n, double v_t) {
  const auto [normal, tangential] = element_forces(law, c_l, area, penetration, v_n, v_t);
  return {normal, tangential};
}

}  // namespace pcm::fast
