// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "reference/contact_force.h"
#include "reference/element_load.h"
#include "reference/radical_sum.h"

namespace pcm::reference {

/// Loads and totals with every decision of the law and every sum exact, correctly rounded (radical_sum.h). An element
/// is computed when something of it is asked for. A root of a root arises where, with friction and w != 0, an element's
/// u_k is clamped to max_penetration: its force has one, and every total it enters.
class ExactLoads {
 public:
  /// All that the question refers to must outlive this.
  explicit ExactLoads(const ForceQuestion& question)
      : question_(question), pose_(question.pose), known_(question.elements.size()) {}

  double area(std::size_t i);
  double penetration(std::size_t i);
  double cosine(std::size_t i);
  double position(std::size_t i, int axis);
  double force(std::size_t i, int axis);  ///< on body E

  double total_force(int axis);
  double total_torque(int axis);
  double greatest_penetration();
  bool greatest_exceeds(double bound);
  /// Force and torque scale, not claimed to be correctly rounded: the middle of an enclosure.
  double force_scale();
  double torque_scale();

 private:
  struct Known {
    ElementGeometry<Rational> geometry;
    ElementLoad<Quadratic> load;
  };
  const Known& at(std::size_t i);
  /// The one of the greatest penetration before clamping; none without elements.
  const Known* deepest();

  const ForceQuestion& question_;
  LiftedPose<Rational> pose_;
  std::vector<std::optional<Known>> known_;
};

}  // namespace pcm::reference
