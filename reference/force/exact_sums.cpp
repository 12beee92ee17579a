// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/force/exact_sums.h"

namespace pcm::reference {
namespace {

/// Of the first enclosures of the scales.
constexpr mpfr_prec_t kScalePrecision = 256;

double rounded(const Quadratic& x) {
  RadicalSum sum;
  sum.add(x);
  return sum.rounded();
}

Ball force_size(const ElementLoad<Quadratic>& load, const Field<Ball>& field) {
  const Ball v_t = sqrt(enclosed(load.speed_squared, field));
  Ball squares = field(0.0);
  for (int i = 0; i < 3; ++i) {
    const Ball component = enclosed(load.force[i], field) + v_t * enclosed(load.drag[i], field);
    squares = squares + component * component;
  }
  return sqrt(squares);
}

Ball arm_length(const ElementLoad<Quadratic>& load, const Field<Ball>& field) {
  Ball squares = field(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const Ball component = enclosed(load.arm[axis], field);
    squares = squares + component * component;
  }
  return sqrt(squares);
}

/// One component of arm x force.
Quadratic moment(const Vec3<Quadratic>& arm, const Vec3<Quadratic>& force, int axis) {
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  return arm[next] * force[last] - arm[last] * force[next];
}

/// Products of enclosures as narrow as the precision is high, without a quotient: they close in.
template <class Enclosures>
double scale(const Enclosures& enclosures) {
  return rounded_number(kScalePrecision, kTiePrecision, enclosures);
}

}  // namespace

const ExactSums::Known& ExactSums::at(std::size_t i) {
  std::optional<Known>& known = known_[i];
  if (!known) {
    const ElementGeometry<Quadratic> g = question_.elements.geometry(i, pose_);
    const Field<Quadratic> field;
    known = Known{g, load_of(g, question_.elements.pair(i).master, question_.law,
                             state_of(question_.pose.pose(), question_.velocity, field), field)};
  }
  return *known;
}

double ExactSums::area(std::size_t i) {
  return rounded(at(i).load.area);
}

double ExactSums::penetration(std::size_t i) {
  return rounded(at(i).load.penetration);
}

double ExactSums::greatest_penetration(std::size_t i) {
  return rounded(at(i).load.greatest_penetration);
}

double ExactSums::perimeter(std::size_t i) {
  return question_.elements.perimeter(i, pose_).rounded();
}

double ExactSums::cosine(std::size_t i) {
  const ElementGeometry<Quadratic>& g = at(i).geometry;
  const Rational squares = (dot(g.N, g.N) * dot(g.slave_N, g.slave_N)).a();
  RadicalSum quotient;
  quotient.add(Rational(dot(g.N, g.slave_N).a() / squares), squares);
  return quotient.rounded();
}

double ExactSums::normal_velocity(std::size_t i) {
  return rounded(at(i).load.normal_velocity);
}

double ExactSums::tangential_velocity(std::size_t i) {
  RadicalSum root;
  root.add(Quadratic(Rational(1)), at(i).load.speed_squared);
  return root.rounded();
}

double ExactSums::normal_force(std::size_t i) {
  return rounded(at(i).load.normal_force);
}

double ExactSums::tangential_force(std::size_t i) {
  const ElementLoad<Quadratic>& load = at(i).load;
  RadicalSum sum;
  sum.add(load.friction.constant, load.speed_squared);
  sum.add(load.friction.linear * load.speed_squared);
  return sum.rounded();
}

double ExactSums::normal(std::size_t i, int axis) {
  return rounded(at(i).load.normal[axis]);
}

double ExactSums::position(std::size_t i, int axis) {
  return rounded(at(i).load.position[axis]);
}

double ExactSums::force(std::size_t i, int axis) {
  const ElementLoad<Quadratic>& load = at(i).load;
  RadicalSum sum;
  sum.add(load.force[axis]);
  sum.add(load.drag[axis], load.speed_squared);
  return sum.rounded();
}

double ExactTotals::force(int axis) {
  const Quadratic share{Rational(share_)};
  RadicalSum sum;
  for (ExactSums* master : masters_)
    for (std::size_t i = 0; i < master->size(); ++i) {
      const ElementLoad<Quadratic>& load = master->load(i);
      sum.add(share * load.force[axis]);  // (23)
      sum.add(share * load.drag[axis], load.speed_squared);
    }
  return sum.rounded();
}

double ExactTotals::torque(int axis) {
  const Quadratic share{Rational(share_)};
  RadicalSum sum;
  for (ExactSums* master : masters_)
    for (std::size_t i = 0; i < master->size(); ++i) {
      const ElementLoad<Quadratic>& load = master->load(i);
      sum.add(share * moment(load.arm, load.force, axis));  // (22), (24)
      sum.add(share * moment(load.arm, load.drag, axis), load.speed_squared);
    }
  return sum.rounded();
}

std::optional<Quadratic> ExactTotals::greatest() {
  std::optional<Quadratic> greatest;
  Rational greatest_squared;
  for (ExactSums* master : masters_)
    for (std::size_t i = 0; i < master->size(); ++i) {
      const ElementGeometry<Quadratic>& g = master->geometry(i);
      const Rational squared = (g.q_greatest * g.q_greatest * dot(g.N, g.N)).a();
      if (greatest && squared <= greatest_squared) continue;
      greatest_squared = squared;
      greatest = master->load(i).greatest_penetration;
    }
  return greatest;
}

double ExactTotals::greatest_penetration() {
  const std::optional<Quadratic> deepest = greatest();
  return deepest ? rounded(*deepest) : 0;
}

bool ExactTotals::greatest_exceeds(double bound) {
  const std::optional<Quadratic> deepest = greatest();
  return deepest && (*deepest - Quadratic(Rational(bound))).sign() > 0;
}

double ExactTotals::force_scale() {
  return scale([this](mpfr_prec_t precision) {
    const Field<Ball> field{precision};
    Ball sum = field(0.0);
    for (ExactSums* master : masters_)
      for (std::size_t i = 0; i < master->size(); ++i) sum = sum + force_size(master->load(i), field);
    return field(share_) * sum;
  });
}

double ExactTotals::torque_scale() {
  return scale([this](mpfr_prec_t precision) {
    const Field<Ball> field{precision};
    Ball sum = field(0.0);
    for (ExactSums* master : masters_)
      for (std::size_t i = 0; i < master->size(); ++i) {
        const ElementLoad<Quadratic>& load = master->load(i);
        sum = sum + arm_length(load, field) * force_size(load, field);
      }
    return field(share_) * sum;
  });
}

}  // namespace pcm::reference
