// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The clipped scheme and its bound on tetrahedra of any shape, where faces are needles, vast or upright to the lines.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "compare/random/random.h"
#include "compare/verify/routes/held_pairing.h"
#include "pcm/bad_input.h"
#include "tests/compare/tetrahedron.h"

namespace pcm::compare {
namespace {

ContactLaw elastic() {
  ContactLaw law;
  law.stiffness = 1;
  return law;
}

ContactLaw with_friction() {
  ContactLaw law = elastic();
  law.damping = 1;
  law.friction = 0.3;
  law.slip_velocity = 1e-2;
  law.transition_depth = 1e-3;
  return law;
}

/// Engine against oracle, bounds included, with either body as master.
void hold(const TriangleMesh& E, const TriangleMesh& F, const ContactLaw& law, const Pose& pose,
          const Velocity& velocity) {
  const HeldPairing held(E, F, law, HeldPairing::Modes{Mode::E, Mode::F}, Scheme::clipped);
  fast::Workspace workspace;
  for (const auto& outcome : held.hold(pose, velocity, workspace)) {
    for (const Disagreement& disagreement : outcome.disagreements) ADD_FAILURE() << disagreement.text;
    EXPECT_FALSE(outcome.unbounded);
  }
}

TEST(ClippedBoundOfTetrahedra, HoldsWhereAHiderSeenNearlyEdgewiseIsCutAtDepthZero) {
  // The hider's line of depth 0 is reckoned from depths far from it: 2.7e-11 m off.
  const TriangleMesh E =
      tetrahedron({Eigen::Vector3d{-0x1.40f49fc9d7afap-1, -0x1.bad76ed7f2f8ap-1, -0x1.e9ab32b89474p-1},
                   {-0x1.e643046dc95c7p-1, 0x1.edd27efa7c896p-1, -0x1.b52c50c783fep-3},
                   {-0x1.a021ec7ad391dp-1, 0x1.81cf84fd173c5p-3, -0x1.0ea9cfe01a1a4p-1},
                   {-0x1.ba704853d0e23p-1, 0x1.5b40988ea51b6p-2, -0x1.9a05173f43c8p-7}});
  const TriangleMesh F =
      tetrahedron({Eigen::Vector3d{0.25, -0.5, 0}, {0, 1, -0.25}, {0.25, 0.25, 0.25}, {0.25, -0.5, -0.75}});
  Pose pose;
  pose.r = {-0x1.1010f63d69c9bp+0, 0x1.6073e13f45d07p-1, -0x1.0ea48faccc06fp-1};
  hold(E, F, elastic(), pose, {});
}

/// A point of a tetrahedron, in it or on its border, as often as not near a corner.
Eigen::Vector3d point_of(const Corners& corners, PoseRandom& random) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0;
  const double power = random.coin() ? 8 : 1;
  for (const Eigen::Vector3d& corner : corners) {
    const double weight = random.coin() ? 0 : std::pow(random.uniform(), power);
    sum += weight * corner;
    weights += weight;
  }
  return weights > 0 ? Eigen::Vector3d(sum / weights) : corners[0];
}

Corners corners_of_any_shape(PoseRandom& random) {
  const auto point = [&random] {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    return Eigen::Vector3d(x, y, z);
  };
  Corners x{point(), point(), point(), point()};
  const double little = std::ldexp(1, -3 - static_cast<int>(random.below(20)));
  const double share = random.uniform();
  switch (random.below(6)) {
    case 1:  // Vast.
      for (Eigen::Vector3d& corner : x) corner /= little;
      break;
    case 2:  // A needle.
      x[1] = x[0] + little * point();
      break;
    case 3:  // Flat.
      x[3] = (x[0] + x[1] + x[2]) / 3 + little * point();
      break;
    case 4:  // A narrow face, the fourth corner over it.
      x[2] = x[0] + share * (x[1] - x[0]) + little * point();
      x[3] = x[0] + share * (x[1] - x[0]) + point();
      break;
    case 5:  // On a lattice.
      for (Eigen::Vector3d& corner : x) corner = (4 * corner).array().round() / 4;
      break;
    default:
      break;
  }
  return x;
}

TEST(ClippedBoundOfTetrahedra, HoldsForAllShapes) {
  constexpr std::uint64_t kSeed = 73;
  std::printf("  seed %d\n", static_cast<int>(kSeed));
  int held = 0;
  for (std::uint64_t trial = 0; trial < 6000; ++trial) {
    SCOPED_TRACE(trial);
    PoseRandom random(kSeed, 0, 0, trial);
    const Corners e = corners_of_any_shape(random), f = corners_of_any_shape(random);
    const TriangleMesh E = tetrahedron(e), F = tetrahedron(f);
    Pose pose;
    if (random.coin()) pose.A = random.rotation();
    const Eigen::Vector3d x_Me = point_of(e, random), x_Mf = point_of(f, random);
    pose.r = x_Me - pose.A * x_Mf;
    if (random.coin()) pose.r += random.log_uniform(0x1p-50, 1) * random.direction();
    const Velocity velocity{random.direction(), random.direction()};
    try {
      hold(E, F, trial % 3 == 0 ? with_friction() : elastic(), pose, velocity);
    } catch (const BadInput&) {
      continue;  // A face without area.
    }
    if (HasFailure()) return;
    ++held;
  }
  EXPECT_GE(held, 5500);
}

}  // namespace
}  // namespace pcm::compare
