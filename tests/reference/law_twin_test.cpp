// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle's force law against the same law written down once more, in numbers of 600 digits, on the twin's elements.
#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>
#include <tuple>
#include <utility>

#include "reference/oracle.h"
#include "tests/force_law.h"
#include "tests/reference/brute_force/brute_force.h"
#include "tests/reference/brute_force/trials.h"

namespace pcm::brute_force {
namespace {

using reference::Problem;
using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<600>, boost::multiprecision::et_off>;
using RealVector = std::array<Real, 3>;

Real real(const Rational& x) {
  Real result;
  mpfr_set_q(result.backend().data(), x.get_mpq_t(), MPFR_RNDN);
  return result;
}
RealVector real(const Vector& x) {
  return {real(x[0]), real(x[1]), real(x[2])};
}
RealVector real(const Eigen::Vector3d& x) {
  return {Real(x[0]), Real(x[1]), Real(x[2])};
}
RealVector operator*(const Real& s, const RealVector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
RealVector plus(const RealVector& a, const RealVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Real inner(const RealVector& a, const RealVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
RealVector outer(const RealVector& a, const RealVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Load {
  Real penetration;
  Real area;
  Real normal_velocity;
  Real tangential_velocity;
  Real normal_force;
  Real tangential_force;
  RealVector normal{};
  RealVector position{};
  RealVector force{};  ///< on body E
  RealVector torque{};
};

/// PCM section 7 for one element, line by line.
Load load_of(const Scene& scene, const Element& element, const ContactLaw& law, const Velocity& velocity) {
  const Body& body = scene.body(element.master);
  const bool master_E = element.master == Side::E;
  const Real unit = real(scene.unit);
  const RealVector N = real(body.normals[element.master_face]);
  const Real length = sqrt(inner(N, N));
  const RealVector n_k = (-1 / length) * N;
  const Real A_k = unit * unit * real(element.alpha) * length;
  const Real u_k = std::min(Real(unit * real(element.q) * length), Real(law.max_penetration));

  const auto [c_l, share] = written_law::layers<Real>(law, element.master);
  const RealVector C_k = plus(unit * real(element.foot), (share * u_k) * n_k);
  const RealVector arm = plus(C_k, (-unit) * real(scene.r_MeMf));
  RealVector v_k = plus(real(velocity.v), outer(real(velocity.w), arm));
  if (!master_E) v_k = Real(-1) * v_k;
  const Real v_n = inner(n_k, v_k);

  const RealVector slip = plus(v_k, (-v_n) * n_k);
  // What these digits leave of a zero is no speed.
  const Real v = sqrt(inner(slip, slip)), v_t = v > 1e-150 ? v : Real(0);
  const auto [F_n, F_t] = written_law::forces<Real>(law, c_l, A_k, u_k, v_n, v_t);
  Load load{u_k, A_k, v_n, v_t, F_n, F_t};
  load.normal = n_k;
  load.position = C_k;
  load.force = F_n * n_k;
  if (F_t > 0) load.force = plus(load.force, (F_t / v_t) * slip);
  if (!master_E) load.force = Real(-1) * load.force;
  load.torque = outer(arm, load.force);
  return load;
}

/// The oracle's double is that nearest to a number known to 150 digits of `scale`; either neighbour where those do not
/// tell (ties are told apart elsewhere), and nothing but zero where they are zeros.
void expect_nearest(const Real& value, const Real& scale, double oracle) {
  const Real error = scale * pow(Real(10), -150);
  const double below = Real(value - error).convert_to<double>(), above = Real(value + error).convert_to<double>();
  if (abs(value) <= error) {
    EXPECT_EQ(oracle, 0);
  } else {
    EXPECT_TRUE(oracle == below || oracle == above) << oracle << " instead of " << below;
  }
}

void expect_nearest(const RealVector& value, const Real& scale, const Eigen::Vector3d& oracle) {
  for (int i = 0; i < 3; ++i) expect_nearest(value[i], scale, oracle[i]);
}

void expect_nearest(const Load& load, const reference::Element& oracle) {
  const Real size = sqrt(inner(load.force, load.force)), speed = 10;
  expect_nearest(load.area, load.area, oracle.area);
  expect_nearest(load.penetration, load.penetration, oracle.penetration);
  expect_nearest(load.normal_velocity, speed, oracle.normal_velocity);
  expect_nearest(load.tangential_velocity, speed, oracle.tangential_velocity);
  expect_nearest(load.normal_force, size, oracle.normal_force);
  expect_nearest(load.tangential_force, size, oracle.tangential_force);
  expect_nearest(load.normal, Real(1), oracle.normal_Me);
  expect_nearest(load.position, Real(10), oracle.position_Me);
  expect_nearest(load.force, size, oracle.force_Me);
}

struct Question {
  ContactLaw law;
  Mode mode;
  Velocity velocity;
};

/// Every feature of the law on or off.
Question draw_question(std::mt19937_64& random) {
  const auto any_of = [&random](std::initializer_list<double> values) {
    return *(values.begin() + random() % values.size());
  };
  const double infinite = std::numeric_limits<double>::infinity();
  Question question;
  ContactLaw& law = question.law;
  law.stiffness = 1e5;
  const double c_E = any_of({1e5, 3e5, infinite}), c_F = any_of({1e5, 7e4});
  if (any_of({0, 1}) == 1) law.layers = any_of({0, 1}) == 1 ? LayerStiffness{c_E, c_F} : LayerStiffness{c_F, c_E};
  law.damping = any_of({0, 100, 30000.5});
  law.transition_depth = any_of({0, 0.125, 0.3});
  law.friction = any_of({0, 0.25, 0.7});
  law.slip_velocity = any_of({0, 0.01, 0.5});
  law.max_penetration = any_of({infinite, infinite, 0.125, 0.2});
  law.damping_mode = std::array{DampingMode::no_tension, DampingMode::full, DampingMode::compression}[random() % 3];
  question.mode = std::array{Mode::E, Mode::F, Mode::both}[random() % 3];
  for (int i = 0; i < 3; ++i) {
    question.velocity.v[i] = any_of({0, 0.25, -0.5, 1, 0.1, -0.3});
    question.velocity.w[i] = any_of({0, 0, 0.5, -0.7});
  }
  return question;
}

/// Clamps to the greatest penetration of one of the elements, or to an ulp beside it, or to half of it.
void clamp_at_an_element(Question& question, const Trial& trial, Problem problem, Scheme scheme,
                         std::mt19937_64& random) {
  const reference::Answer free =
      reference::Oracle(trial.E, trial.F, {}, question.mode, scheme).answer(problem, trial.pose);
  if (free.elements.empty()) return;
  const double deepest = free.elements[random() % free.elements.size()].greatest_penetration;
  const std::array bounds{deepest, std::nextafter(deepest, 0.0), std::nextafter(deepest, 2 * deepest), deepest / 2};
  question.law.max_penetration = bounds[random() % bounds.size()];
}

class LawTwin : public testing::TestWithParam<std::tuple<Kind, int, Scheme>> {};

TEST_P(LawTwin, AgreesWithTheOracle) {
  std::mt19937_64 random(41);
  SCOPED_TRACE("seed 41");
  const auto [kind, trials, scheme] = GetParam();
  int elements = 0, clamped = 0;
  for (int number = 0; number < affordable(trials) && !HasFailure(); ++number) {
    const Trial trial = draw_trial(kind, 31, number);
    SCOPED_TRACE(trial.description);
    Question question = draw_question(random);
    if (scheme == Scheme::clipped && std::max(trial.E.faces.size(), trial.F.faces.size()) > 24) continue;
    const Problem problem = number % 2 == 0 ? Problem::rounded : Problem::exact;
    if (number % 3 == 0) clamp_at_an_element(question, trial, problem, scheme, random);
    const double max_penetration = question.law.max_penetration;
    const Answer twin = answer(trial.E, trial.F, trial.pose, problem, question.mode, scheme, max_penetration);
    const reference::Answer oracle = reference::Oracle(trial.E, trial.F, question.law, question.mode, scheme)
                                         .answer(problem, trial.pose, question.velocity);
    ASSERT_EQ(twin.elements.size(), oracle.elements.size());
    RealVector force{}, torque{};
    Real force_scale = 0, torque_scale = 0;
    for (std::size_t i = 0; i < twin.elements.size(); ++i) {
      const Load load = load_of(twin.scene, twin.elements[i], question.law, question.velocity);
      const Real size = sqrt(inner(load.force, load.force));
      expect_nearest(load, oracle.elements[i]);
      EXPECT_EQ(greatest_penetration(twin.scene, twin.elements[i]), oracle.elements[i].greatest_penetration);
      force = plus(force, load.force);
      torque = plus(torque, load.torque);
      force_scale += size;
      torque_scale += sqrt(inner(load.torque, load.torque)) + size;
    }
    const Real share = question.mode == Mode::both ? 0.5 : 1.0;
    expect_nearest(share * force, force_scale, oracle.force_Me);
    expect_nearest(share * torque, torque_scale, oracle.torque_Me);
    elements += static_cast<int>(twin.elements.size());
    clamped += oracle.penetration_exceeded ? 1 : 0;
  }
  EXPECT_GE(elements, affordable(trials) / 12);
  EXPECT_GE(clamped, affordable(trials) / 20);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, LawTwin,
    testing::Values(std::tuple{Kind::generic, 60, Scheme::barycentric},
                    std::tuple{Kind::lattice, 200, Scheme::barycentric},
                    std::tuple{Kind::near_lattice, 200, Scheme::barycentric},
                    std::tuple{Kind::grids, 20, Scheme::barycentric}, std::tuple{Kind::open, 200, Scheme::barycentric},
                    std::tuple{Kind::generic, 40, Scheme::clipped}, std::tuple{Kind::lattice, 120, Scheme::clipped},
                    std::tuple{Kind::near_lattice, 120, Scheme::clipped}, std::tuple{Kind::open, 120, Scheme::clipped}),
    [](const testing::TestParamInfo<std::tuple<Kind, int, Scheme>>& test) {
      return name_of(std::get<Kind>(test.param)) + (std::get<Scheme>(test.param) == Scheme::clipped ? "Clipped" : "");
    });

}  // namespace
}  // namespace pcm::brute_force
