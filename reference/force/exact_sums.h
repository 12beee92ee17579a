// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "reference/force/force_question.h"
#include "reference/force/law.h"
#include "reference/numbers/radical_sum.h"

namespace pcm::reference {

/// An exact load enclosed.
template <class T>
ElementLoad<T> enclosed(const ElementLoad<Quadratic>& load, const Field<T>& field) {
  const auto number = [&](const Quadratic& x) { return enclosed(x, field); };
  const auto vector = [&](const Vec3<Quadratic>& v) { return Vec3<T>{number(v[0]), number(v[1]), number(v[2])}; };
  return {number(load.area),
          number(load.penetration),
          number(load.greatest_penetration),
          vector(load.normal),
          vector(load.position),
          vector(load.arm),
          number(load.normal_velocity),
          number(load.speed_squared),
          number(load.normal_force),
          {number(load.friction.constant), number(load.friction.linear)},
          vector(load.force),
          vector(load.drag)};
}

/// Loads of one master's elements with every decision of the law exact. An element is computed when something of it is
/// asked for; its values are correctly rounded (radical_sum.h).
class ExactSums {
 public:
  /// All that the question refers to must outlive this.
  explicit ExactSums(const ForceQuestion& question)
      : question_(question), pose_(question.pose), known_(question.elements.size()) {}

  std::size_t size() const { return known_.size(); }
  const ElementGeometry<Quadratic>& geometry(std::size_t i) { return at(i).geometry; }
  const ElementLoad<Quadratic>& load(std::size_t i) { return at(i).load; }

  double area(std::size_t i);
  double penetration(std::size_t i);
  double greatest_penetration(std::size_t i);
  double perimeter(std::size_t i);
  double cosine(std::size_t i);
  double normal_velocity(std::size_t i);
  double tangential_velocity(std::size_t i);
  double normal_force(std::size_t i);
  double tangential_force(std::size_t i);
  double normal(std::size_t i, int axis);
  double position(std::size_t i, int axis);
  double force(std::size_t i, int axis);  ///< on body E

 private:
  struct Known {
    ElementGeometry<Quadratic> geometry;
    ElementLoad<Quadratic> load;
  };
  const Known& at(std::size_t i);

  ForceQuestion question_;
  ConvertedPose<Rational> pose_;
  std::vector<std::optional<Known>> known_;
};

/// Totals over masters with every sum exact, correctly rounded. A root of a root arises where, with friction and
/// w != 0, an element is clamped, if only in part: its force has one, and every total it enters.
class ExactTotals {
 public:
  /// The masters must outlive this. Force, torque and scales are multiplied by `share`.
  ExactTotals(std::vector<ExactSums*> masters, double share) : masters_(std::move(masters)), share_(share) {}

  double force(int axis);
  double torque(int axis);
  double greatest_penetration();
  bool greatest_exceeds(double bound);
  /// Force and torque scale. Either neighbour at a tie, or what is that to kTiePrecision bits.
  double force_scale();
  double torque_scale();

 private:
  /// The greatest penetration before clamping; none without elements.
  std::optional<Quadratic> greatest();

  std::vector<ExactSums*> masters_;
  double share_;
};

}  // namespace pcm::reference
