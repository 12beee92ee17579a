// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Laws and motions from all over the range of doubles, subnormal ones among them: products underflow and are multiplied
// or divided on. The engine's bounds hold against the exact problem, or the engine refuses the question.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "compare/random/random.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "pcm/bad_input.h"
#include "pcm/engine.h"
#include "reference/oracle.h"

namespace pcm::compare::ends_of_doubles_test {
namespace {

/// 0, or of any exponent, the ends often.
double draw_any(PoseRandom& random) {
  switch (random.below(6)) {
    case 0:
      return 0;
    case 1:
      return std::ldexp(random.uniform(1, 2), -static_cast<int>(1020 + random.below(55)));
    case 2:
      return std::ldexp(random.uniform(1, 2), static_cast<int>(random.below(1020)));
    default:
      return std::ldexp(random.uniform(1, 2), static_cast<int>(random.below(2000)) - 1070);
  }
}

double draw_positive(PoseRandom& random) {
  for (;;) {
    if (const double x = draw_any(random); x > 0) return x;
  }
}

ContactLaw draw_law(PoseRandom& random) {
  ContactLaw law;
  law.stiffness = draw_positive(random);
  if (random.coin()) {
    const double c_E = draw_positive(random);
    law.layers = LayerStiffness{c_E, draw_positive(random)};
  }
  law.damping = draw_any(random);
  law.damping_mode = static_cast<DampingMode>(random.below(3));
  law.friction = random.coin() ? 0.5 : 0;
  law.slip_velocity = draw_any(random);
  law.transition_depth = draw_any(random);
  return law;
}

Velocity draw_velocity(PoseRandom& random) {
  Velocity velocity;
  const double speed = draw_any(random), spin = draw_any(random);
  velocity.v = speed * random.direction();
  velocity.w = spin * random.direction();
  return velocity;
}

struct Tally {
  int answered = 0, refused = 0, touching = 0, finite = 0;
};

void hold(const fast::Pairing& pairing, const reference::Oracle& oracle, const Pose& pose, const Velocity& velocity,
          Tally& tally) {
  const Wanted wanted{.polygons = false, .areas = false, .force = true, .elements = false, .bound = true};
  fast::Workspace workspace;
  const fast::Contact& contact = fast::evaluate(pairing, pose, velocity, wanted, workspace);
  ++tally.answered;
  tally.touching += contact.element_count > 0 ? 1 : 0;
  const reference::Answer truth = oracle.answer(reference::Problem::exact, pose, velocity, {});
  bool finite = true;
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(std::isfinite(contact.force_Me[k]) && std::isfinite(contact.torque_Me[k]));
    // The truth itself is rounded to a double.
    const double force = 0x1p-53 * std::abs(truth.force_Me[k]) + std::numeric_limits<double>::denorm_min();
    const double torque = 0x1p-53 * std::abs(truth.torque_Me[k]) + std::numeric_limits<double>::denorm_min();
    EXPECT_LE(std::abs(contact.force_Me[k] - truth.force_Me[k]), contact.bound->force_Me[k] + force);
    EXPECT_LE(std::abs(contact.torque_Me[k] - truth.torque_Me[k]), contact.bound->torque_Me[k] + torque);
    finite = finite && std::isfinite(contact.bound->force_Me[k]) && std::isfinite(contact.bound->torque_Me[k]);
  }
  tally.finite += finite ? 1 : 0;
}

TEST(EndsOfDoubles, BoundsHoldUnderAnyLawAndMotion) {
  constexpr std::uint64_t kSeed = 20261128;
  const TriangleMesh plate = generate::box({-2, -2, -1}, {2, 2, 0}), box = generate::box({0.5, 0.5, 0.5});
  const TriangleMesh ball = generate::icosphere(0.5, 1);
  Tally tally;
  for (std::uint64_t number = 0; number < 400; ++number) {
    PoseRandom random(kSeed, 0, 0, number);
    const ContactLaw law = draw_law(random);
    const Velocity velocity = draw_velocity(random);
    Pose pose;
    pose.A = random.rotation();
    pose.r = {0.13, 0.21, random.uniform(0.1, 0.45)};
    const TriangleMesh& F = number % 2 == 0 ? box : ball;
    for (const Mode mode : {Mode::E, Mode::F}) {
      for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
        SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", number " << number << ", master "
                                        << (mode == Mode::E ? 'E' : 'F') << ", scheme " << static_cast<int>(scheme));
        try {
          const fast::Pairing pairing(fast::Surface(plate), fast::Surface(F), law, mode, scheme);
          hold(pairing, reference::Oracle(plate, F, law, mode, scheme), pose, velocity, tally);
        } catch (const BadInput&) {
          ++tally.refused;
        }
      }
    }
  }
  std::printf("  %d answered, %d with elements, %d with finite bounds; %d refused\n", tally.answered, tally.touching,
              tally.finite, tally.refused);
  EXPECT_GT(tally.touching, 400);
  EXPECT_GT(tally.finite, tally.answered / 2);
  EXPECT_GT(tally.refused, 10);
}

}  // namespace
}  // namespace pcm::compare::ends_of_doubles_test
