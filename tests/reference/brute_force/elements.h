// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reference/brute_force/answer.h"

namespace pcm::brute_force {

/// u, its greatest value, A, C_k and force of an element, and the elastic force and torque at rest (14), (21)-(24),
/// both layers of equal stiffness.
double penetration(const Scene& scene, const Element& element);
double greatest_penetration(const Scene& scene, const Element& element);
double element_area(const Scene& scene, const Element& element);
std::array<double, 3> element_position(const Scene& scene, const Element& element);
std::array<double, 3> element_force(const Scene& scene, const Element& element, const Rational& stiffness);
struct ForceAndTorque {
  std::array<double, 3> force{};
  std::array<double, 3> torque{};
};
ForceAndTorque elastic_force(const Answer& answer, const Rational& stiffness, Mode mode);

}  // namespace pcm::brute_force
