// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/validate.h"

#include <cmath>
#include <string>

#include "pcm/bad_input.h"
#include "reference/numbers/numbers.h"
#include "reference/numbers/vector3.h"

namespace pcm::reference {
namespace {

void demand(bool holds, const std::string& message) {
  if (!holds) throw BadInput(message);
}

Rational magnitude(const Rational& x) {
  return x < 0 ? Rational(-x) : x;
}

/// max |A^T A - I| <= 1e-9 and det A > 0, decided on the doubles as the reals they are.
bool is_rotation(const Eigen::Matrix3d& A) {
  const auto column = [&A](int j) { return Vec3<Rational>{Rational(A(0, j)), Rational(A(1, j)), Rational(A(2, j))}; };
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      if (magnitude(dot(column(i), column(j)) - Rational(i == j ? 1 : 0)) > Rational(1e-9)) return false;
  return determinant(column(0), column(1), column(2)) > 0;
}

}  // namespace

void require_fit(const Pose& pose, const Velocity& velocity) {
  demand(pose.A.allFinite() && pose.r.allFinite(), "pose: an entry of A or r is not finite; give finite numbers");
  demand(
      is_rotation(pose.A),
      "pose: A is not a rotation (max |A^T A - I| <= 1e-9 and det A > 0); orthonormalise it, or check its order: rows");
  demand(velocity.v.allFinite() && velocity.w.allFinite(),
         "velocity: an entry of v or w is not finite; give finite numbers");
}

void require_fit(const ContactLaw& law) {
  const auto not_negative = [](double x) { return std::isfinite(x) && x >= 0; };
  if (law.layers) {
    const double c_E = law.layers->c_E, c_F = law.layers->c_F;
    demand(c_E > 0 && c_F > 0, "law: layer stiffnesses must be positive (infinite for a rigid body)");
    demand(std::isfinite(c_E) || std::isfinite(c_F), "law: both bodies are rigid; give one of them a finite stiffness");
  } else {
    demand(std::isfinite(law.stiffness) && law.stiffness > 0, "law: stiffness must be positive and finite");
  }
  demand(not_negative(law.damping), "law: damping must be finite and not negative");
  demand(not_negative(law.transition_depth), "law: transition depth must be finite and not negative");
  demand(not_negative(law.friction), "law: friction must be finite and not negative");
  demand(not_negative(law.slip_velocity), "law: slip velocity must be finite and not negative");
  demand(law.max_penetration > 0, "law: greatest penetration must be positive (infinite for no bound)");
}

}  // namespace pcm::reference
