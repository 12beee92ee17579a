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
  RealVector position;
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
  const Real A_k = unit * unit * length / 2;
  const Real u_k = std::min(Real(unit * real(element.q) * length), Real(law.max_penetration));

  Real c_l = law.stiffness, share = 0.5;
  if (law.layers) {
    const double c_master = master_E ? law.layers->c_E : law.layers->c_F;
    const double c_slave = master_E ? law.layers->c_F : law.layers->c_E;
    if (std::isinf(c_master)) {
      c_l = c_slave;
      share = 0;
    } else if (std::isinf(c_slave)) {
      c_l = c_master;
      share = 1;
    } else {
      c_l = Real(c_master) * c_slave / (Real(c_master) + c_slave);
      share = Real(c_slave) / (Real(c_master) + c_slave);
    }
  }
  const Vector corners =
      body.corner(element.master_face, 0) + body.corner(element.master_face, 1) + body.corner(element.master_face, 2);
  const RealVector C_k = plus((unit / 3) * real(corners), (share * u_k) * n_k);
  const RealVector arm = plus(C_k, (-unit) * real(scene.r_MeMf));
  RealVector v_k = plus(real(velocity.v), outer(real(velocity.w), arm));
  if (!master_E) v_k = Real(-1) * v_k;
  const Real v_n = inner(n_k, v_k);

  Real F_d = law.damping * A_k * v_n;
  if (u_k < law.transition_depth) F_d *= u_k / law.transition_depth;
  if (law.damping_mode == DampingMode::compression && v_n < 0) F_d = 0;
  Real F_n = c_l * A_k * u_k + F_d;
  if (law.damping_mode == DampingMode::no_tension && F_n < 0) F_n = 0;

  const RealVector slip = plus(v_k, (-v_n) * n_k);
  const Real v_t = sqrt(inner(slip, slip)), v_eps = law.slip_velocity;
  RealVector force = F_n * n_k;
  // What 600 digits leave of a zero is no speed.
  if (F_n > 0 && v_t > 1e-250) {
    const Real F_t = law.friction * F_n * (v_t >= v_eps ? Real(1) : Real((v_t / v_eps) * (2 - v_t / v_eps)));
    force = plus(force, (F_t / v_t) * slip);
  }
  if (!master_E) force = Real(-1) * force;
  return {u_k, C_k, force, outer(arm, force)};
}

/// The oracle's double is that nearest to a number known to 500 digits of `scale`; either neighbour where those do not
/// tell (ties are told apart elsewhere), and nothing but zero where they are zeros.
void expect_nearest(const Real& value, const Real& scale, double oracle) {
  const Real room = scale * pow(Real(10), -500);
  const double below = Real(value - room).convert_to<double>(), above = Real(value + room).convert_to<double>();
  if (abs(value) <= room) {
    EXPECT_EQ(oracle, 0);
  } else {
    EXPECT_TRUE(oracle == below || oracle == above) << oracle << " instead of " << below;
  }
}

void expect_nearest(const RealVector& value, const Real& scale, const Eigen::Vector3d& oracle) {
  for (int i = 0; i < 3; ++i) expect_nearest(value[i], scale, oracle[i]);
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

class LawTwin : public testing::TestWithParam<std::tuple<Kind, int>> {};

TEST_P(LawTwin, AgreesWithTheOracle) {
  std::mt19937_64 random(41);
  const auto [kind, trials] = GetParam();
  int elements = 0;
  for (int number = 0; number < affordable(trials) && !HasFailure(); ++number) {
    const Trial trial = draw_trial(kind, 31, number);
    SCOPED_TRACE(trial.description);
    const Question question = draw_question(random);
    const Problem problem = number % 2 == 0 ? Problem::rounded : Problem::exact;
    const Answer twin = answer(trial.E, trial.F, trial.pose, problem, question.mode);
    const reference::Answer oracle =
        reference::Oracle(trial.E, trial.F, question.law, question.mode).answer(problem, trial.pose, question.velocity);
    ASSERT_EQ(twin.elements.size(), oracle.elements.size());
    RealVector force{}, torque{};
    Real force_scale = 0, torque_scale = 0;
    for (std::size_t i = 0; i < twin.elements.size(); ++i) {
      const Load load = load_of(twin.scene, twin.elements[i], question.law, question.velocity);
      const Real size = sqrt(inner(load.force, load.force));
      expect_nearest(load.penetration, load.penetration, oracle.elements[i].penetration);
      expect_nearest(load.position, Real(10), oracle.elements[i].position_Me);
      expect_nearest(load.force, size, oracle.elements[i].force_Me);
      force = plus(force, load.force);
      torque = plus(torque, load.torque);
      force_scale += size;
      torque_scale += sqrt(inner(load.torque, load.torque)) + size;
    }
    const Real share = question.mode == Mode::both ? 0.5 : 1.0;
    expect_nearest(share * force, force_scale, oracle.force_Me);
    expect_nearest(share * torque, torque_scale, oracle.torque_Me);
    elements += static_cast<int>(twin.elements.size());
  }
  EXPECT_GE(elements, affordable(trials) / 12);
}

INSTANTIATE_TEST_SUITE_P(Kinds, LawTwin,
                         testing::Values(std::tuple{Kind::generic, 60}, std::tuple{Kind::lattice, 200},
                                         std::tuple{Kind::near_lattice, 200}, std::tuple{Kind::grids, 20},
                                         std::tuple{Kind::open, 200}),
                         [](const testing::TestParamInfo<std::tuple<Kind, int>>& test) {
                           return name_of(std::get<0>(test.param));
                         });

}  // namespace
}  // namespace pcm::brute_force
