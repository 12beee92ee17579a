// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Forces and torques that no enclosure can round: zeros, doubles and ties that hold only by cancelling radicals.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/round.h"
#include "reference/oracle.h"
#include "tests/reference/brute_force/brute_force.h"
#include "tests/reference/problems.h"

namespace pcm::brute_force {
namespace {

using reference::kProblems;
using reference::Oracle;
using reference::Problem;

/// A convex cross-section in x and z, counterclockwise seen from -y, extruded from y0 to y0 + 1.
TriangleMesh prism(const std::vector<std::array<double, 2>>& section, double y0) {
  TriangleMesh mesh;
  const auto n = static_cast<Index>(section.size());
  for (const double y : {y0, y0 + 1})
    for (const auto& [x, z] : section) mesh.vertices.emplace_back(x, y, z);
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    mesh.faces.push_back({i, n + i, n + j});
    mesh.faces.push_back({i, n + j, j});
    if (i == 0 || j == 0) continue;
    mesh.faces.push_back({0, i, j});
    mesh.faces.push_back({n, n + j, n + i});
  }
  return mesh;
}

/// The two triangles of a prism's side made four about a point of it.
void fan(TriangleMesh& mesh, Index side, Index sides, const Eigen::Vector3d& x) {
  const Index i = side, j = (side + 1) % sides, top = static_cast<Index>(mesh.vertices.size());
  const std::array<Index, 4> around{i, sides + i, sides + j, j};
  std::erase_if(mesh.faces, [&](const Triangle& t) {
    return t == Triangle{i, sides + i, sides + j} || t == Triangle{i, sides + j, j};
  });
  mesh.vertices.push_back(x);
  for (int k = 0; k < 4; ++k) mesh.faces.push_back({around[k], around[(k + 1) % 4], top});
}

/// A keel of 45 degrees: |N| is a multiple of sqrt 2 on both slopes, which are divided differently. In the plate to the
/// upper edges of its slopes, u is linear over each of them, so that the sum of A_k u_k does not depend on the division
/// and both slopes' shares of F_x cancel.
TriangleMesh keel() {
  TriangleMesh mesh = prism({{0, 0}, {1, 1}, {1, 2}, {-1, 2}, {-1, 1}}, 0);
  fan(mesh, 0, 5, {0.25, 0.5, 0.25});
  return mesh;
}

/// The same with the other slope in four, too, about another point: both symmetric about y = 1/2.
TriangleMesh keel_of_two_fans() {
  TriangleMesh mesh = keel();
  fan(mesh, 4, 5, {-0.625, 0.5, 0.625});
  return mesh;
}

/// Beside the keel, a ramp whose sides are as 3 : 4 : 5. Two triangles of A = 5/8 at the depths 3/4 and 1/2, u = 5/4
/// depth, n_x = -3/5: F_x = -75/128 c_l.
TriangleMesh keel_and_ramp() {
  return degenerate::joined(keel(), prism({{-2, 0}, {0, 0}, {1, 0.75}, {1, 2}, {-2, 2}}, 2));
}

/// Its top at z = 1.
const TriangleMesh& plate() {
  static const TriangleMesh mesh = generate::box({-8, -8, -3}, {8, 8, 1});
  return mesh;
}

ContactLaw stiffness(double c_l) {
  ContactLaw law;
  law.stiffness = c_l;
  return law;
}

/// The answer, equal to the twin's.
reference::Answer held_by_twin(const TriangleMesh& E, const ContactLaw& law, Problem problem) {
  const reference::Answer oracle = Oracle(E, plate(), law).answer(problem, {});
  const ForceAndTorque twin = elastic_force(answer(E, plate(), {}, problem), Rational(law.stiffness), Mode::E);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(oracle.force_Me[i], twin.force[i]);
    EXPECT_EQ(oracle.torque_Me[i], twin.torque[i]);
  }
  return oracle;
}

TEST(ForceRounding, TorqueIsExactlyZeroThoughNoTwoTermsCancel) {
  for (const Problem problem : kProblems) {
    // About z, the slopes' shares are -+ 1/2 F_x each: both symmetric about y = 1/2.
    const reference::Answer a = held_by_twin(keel_of_two_fans(), stiffness(0.7), problem);
    EXPECT_EQ(a.torque_Me.z(), 0);
    EXPECT_FALSE(std::signbit(a.torque_Me.z()));
    EXPECT_EQ(a.force_Me.x(), 0);
    ASSERT_EQ(a.elements.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto torque = [&a](std::size_t k) {
          const reference::Element& e = a.elements[k];
          return e.position_Me.x() * e.force_Me.y() - e.position_Me.y() * e.force_Me.x();
        };
        EXPECT_NE(torque(i), -torque(j));
      }
  }
}

TEST(ForceRounding, ForceIsADoubleWhereSixRadicalTermsCancel) {
  for (const Problem problem : kProblems) {
    const reference::Answer a = held_by_twin(keel_and_ramp(), stiffness(64), problem);
    EXPECT_EQ(a.force_Me.x(), -37.5);
    EXPECT_NE(a.elements[0].force_Me.x(), std::round(a.elements[0].force_Me.x()));
  }
}

TEST(ForceRounding, TiesGoToTheEvenNeighbour) {
  // F_x = -n / 128 with odd n between 2^53 and 2^54, where doubles are even: n = 1 modulo 4 is nearer to the multiple
  // of 4 below, n = 3 to that above.
  for (const Problem problem : kProblems) {
    EXPECT_EQ(held_by_twin(keel_and_ramp(), stiffness(120095990063215), problem).force_Me.x(), -(0x1p53 + 132) / 128);
    EXPECT_EQ(held_by_twin(keel_and_ramp(), stiffness(120095990063217), problem).force_Me.x(), -(0x1p53 + 284) / 128);
  }
}

TEST(ForceRounding, TheLeastIrrationalShareDecidesATie) {
  // Damping adds 2^-1000 times an irrational number of the sign of -v_x.
  for (const Problem problem : kProblems)
    for (const double c_l : {120095990063215.0, 120095990063217.0})
      for (const double v_x : {-1.0, 1.0}) {
        ContactLaw law = stiffness(c_l);
        law.damping = 0x1p-1000;
        law.damping_mode = DampingMode::full;
        Velocity velocity;
        velocity.v.x() = v_x;
        // n = 2^53 + 133 and 2^53 + 283.
        const double below = c_l == 120095990063215.0 ? 132 : 282;
        const double less = -(0x1p53 + below + 2) / 128, more = -(0x1p53 + below) / 128;
        EXPECT_EQ(Oracle(keel_and_ramp(), plate(), law).answer(problem, {}, velocity).force_Me.x(),
                  v_x > 0 ? more : less);
      }
}

TEST(ForceRounding, DampingThatExactlyBalancesTheSpringLeavesNothing) {
  // On a slope at depth d: F_c = c_l A sqrt2 d, F_d = d_l A v_z / sqrt2, none of them a double. The barycentres of
  // either slope are at the depths 2 and 1.
  const TriangleMesh E = prism({{0, 0}, {3, 3}, {3, 6}, {-3, 6}, {-3, 3}}, 0);
  const TriangleMesh deep_plate = generate::box({-16, -16, -3}, {16, 16, 3});
  ContactLaw law = stiffness(0.7);
  law.damping = 0.7;
  law.friction = 0.5;
  Velocity velocity;
  for (const Problem problem : kProblems) {
    velocity.v.z() = -4;
    const reference::Answer balanced = Oracle(E, deep_plate, law).answer(problem, {}, velocity);
    EXPECT_EQ(balanced.elements.size(), 4u);
    EXPECT_EQ(balanced.force_Me, Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(balanced.torque_Me, Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(balanced.force_scale, 0);
    velocity.v.z() = std::nextafter(-4, 0.0);
    EXPECT_GT(Oracle(E, deep_plate, law).answer(problem, {}, velocity).force_Me.z(), 0);
  }
}

/// The bottom of a box 3 m x 1 m, in F by 1/2; |N| = 3, so that v_n N / |N| is no sum of doubles where v_z is not a
/// multiple of 3.
reference::Element pressed_bottom(const ContactLaw& law, const Velocity& velocity, Problem problem) {
  const TriangleMesh E = generate::box({0, 0, 0.5}, {3, 1, 4});
  for (const reference::Element& element : Oracle(E, plate(), law).answer(problem, {}, velocity).elements)
    if (element.normal_Me == Eigen::Vector3d(0, 0, 1)) return element;
  ADD_FAILURE() << "the bottom has no element";
  return {};
}

TEST(ForceRounding, SlipVelocityHalfwayBetweenTwoDoublesGoesToTheEvenOne) {
  // (3 m, 4 m): 5 m = 10^16 + 5, where doubles are even, and 10^16 + 4 is twice an even number.
  const double m = 2e15 + 1;
  Velocity velocity;
  velocity.v = {3 * m, 4 * m, 1};
  for (const Problem problem : kProblems) {
    const reference::Element element = pressed_bottom(stiffness(1), velocity, problem);
    EXPECT_EQ(element.tangential_velocity, 1e16 + 4);
    EXPECT_EQ(element.normal_velocity, 1);
    EXPECT_EQ(element.tangential_force, 0);
  }
}

TEST(ForceRounding, FrictionHalfwayBetweenTwoDoublesGoesToTheEvenOne) {
  // F_n = c_l 3/2 1/2 = (3 2^52 + 3) / 4, and mu = 1. In units of 1/4, 3 2^52 + 2 is twice an odd number.
  ContactLaw law = stiffness(0x1p52 + 1);
  law.friction = 1;
  Velocity velocity;
  velocity.v = {0.1, 0.3, 1};
  for (const double v_eps : {0.0, 0.125})
    for (const Problem problem : kProblems) {
      law.slip_velocity = v_eps;
      const reference::Element element = pressed_bottom(law, velocity, problem);
      EXPECT_EQ(element.normal_force, (0x1.8p53 + 4) / 4);
      EXPECT_EQ(element.tangential_force, (0x1.8p53 + 4) / 4);
    }
}

TEST(ForceRounding, SumOfSizesHalfwayBetweenTwoDoublesGoesToTheEvenOne) {
  // Of both halves of the bottom F_n = c_l 3/2 in all, and mu = 3/4: |F| = 5/4 F_n, 15 (2^52 + 4) / 8 in all. In units
  // of 1, doubles are even and 15 2^49 + 8 is.
  ContactLaw law = stiffness(0x1p52 + 4);
  law.friction = 0.75;
  Velocity velocity;
  velocity.v = {0.1, 0.3, 1};
  const TriangleMesh E = generate::box({0, 0, 0.5}, {3, 1, 4});
  for (const Problem problem : kProblems) {
    const reference::Answer answer = Oracle(E, plate(), law).answer(problem, {}, velocity);
    ASSERT_EQ(answer.elements.size(), 2u);
    EXPECT_EQ(answer.force_scale, 15 * 0x1p49 + 8);
  }
}

TEST(ForceRounding, VelocityAlongANormalDoesNotSlip) {
  // The slant face's N = (9, 9, 9), and no element of this is a sum of doubles: v - (v . N / N^2) N.
  const TriangleMesh E = degenerate::tetrahedron({{{-3, 0, 0}, {0, -3, 0}, {0, 0, -3}, {0, 0, 0}}});
  const TriangleMesh F = generate::box({-8, -8, -8}, {-0.75, -0.5, -0.25});
  ContactLaw law = stiffness(1);
  law.friction = 0.5;
  Velocity velocity;
  velocity.v = {0.1, 0.1, 0.1};
  for (const Problem problem : kProblems) {
    const reference::Answer answer = Oracle(E, F, law).answer(problem, {}, velocity);
    ASSERT_EQ(answer.elements.size(), 1u);
    EXPECT_EQ(answer.elements[0].tangential_velocity, 0);
    EXPECT_EQ(answer.elements[0].tangential_force, 0);
    EXPECT_EQ(answer.elements[0].force_Me.x(), answer.elements[0].force_Me.z());
    EXPECT_GT(answer.elements[0].normal_velocity, 0);
  }
}

TEST(ForceRounding, NormalThatExactArithmeticAloneKnowsToBeInAPlane) {
  // The second and third rows of A begin alike, so what is flat in F's frame has n_x = 0 in Me: a difference of two
  // equal products of more than 240 bits.
  Pose pose;
  const double half = std::sqrt(0.5), c = 0.8 * half, s = 0.6 * half;
  pose.A << 0.8, -0.6, 0, s, c, -half, s, c, half;
  pose.r = {0.1, 0.2 * half, 3.3};
  const TriangleMesh E = generate::box({-8, -8, -3}, {8, 8, 1});
  const TriangleMesh F =
      degenerate::tetrahedron({{{0, 0, -5.7}, {1.7, 3e-21, -5.7}, {5e-21, 1.9, -5.7}, {0.3, 0.3, 0.3}}});
  int flat = 0;
  for (const reference::Element& element : Oracle(E, F, stiffness(1), Mode::F).answer(Problem::exact, pose).elements) {
    const Eigen::Vector3d& n = element.normal_Me;
    if (!(n.y() < 0 && n.z() > 0)) continue;
    EXPECT_EQ(n.x(), 0);
    ++flat;
  }
  EXPECT_GT(flat, 0);
}

TEST(ForceRounding, DepthEqualToTheBoundIsNotExceeded) {
  for (const Problem problem : kProblems) {
    // u = 5/4 depth on the ramp: 15/16 at the deeper barycentre. On its bottom u = 1.
    ContactLaw law = stiffness(1);
    law.max_penetration = 1;
    const TriangleMesh ramp = prism({{-2, 0}, {0, 0}, {1, 0.75}, {1, 2}, {-2, 2}}, 2);
    EXPECT_FALSE(Oracle(ramp, plate(), law).answer(problem, {}).penetration_exceeded);
    law.max_penetration = std::nextafter(1.0, 0.0);
    EXPECT_TRUE(Oracle(ramp, plate(), law).answer(problem, {}).penetration_exceeded);
  }
}

TEST(ForceRounding, RoundBodiesFacingEachOtherPressAlongTheirAxis) {
  const TriangleMesh sphere = generate::icosphere(1, 2);
  ContactLaw law = stiffness(1e5);
  law.damping = 10;
  law.friction = 0.25;
  law.slip_velocity = 0.1;
  Velocity spin;
  spin.w = {0, 0, 1};
  for (const Problem problem : kProblems) {
    const reference::Answer a =
        Oracle(sphere, sphere, law, Mode::both).answer(problem, {Eigen::Matrix3d::Identity(), {0, 0, 1.75}}, spin);
    EXPECT_GT(a.elements.size(), 20u);
    EXPECT_EQ(a.force_Me.head<2>(), Eigen::Vector2d(0, 0));
    EXPECT_EQ(a.torque_Me.head<2>(), Eigen::Vector2d(0, 0));
    EXPECT_LT(a.force_Me.z(), 0);
    EXPECT_GT(a.torque_Me.z(), 0);
  }
}

}  // namespace
}  // namespace pcm::brute_force
