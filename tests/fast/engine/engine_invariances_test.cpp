// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"

namespace pcm::fast {
namespace {

using namespace test;
using Eigen::Vector3d;

/// A pose with everything in play: damping, friction, both masters.
struct Encounter {
  TriangleMesh E = generate::bubble();
  TriangleMesh F = generate::icosphere(0.15, 2);
  Pose pose = turned(0.9, {0.02, 0.11, 0.13});
  Velocity velocity{{0.1, -0.2, -0.7}, {0.3, 0.2, -0.4}};
  ContactLaw law;
  Mode mode = Mode::both;
  Scheme scheme;

  explicit Encounter(Scheme wanted_scheme) : scheme(wanted_scheme) {
    law.stiffness = 5.9e5;
    law.damping = 1000;
    law.transition_depth = 0.01;
    law.friction = 0.25;
    law.slip_velocity = 0.5;
  }
  Contact answer() const { return answer({}); }
  Contact answer(const Wanted& wanted) const { return test::answer(E, F, pose, law, mode, velocity, wanted, scheme); }
};

/// x, y and z called y, z and x: a rotation that takes coordinates to coordinates, without any rounding.
Eigen::Matrix3d axes_renamed() {
  Eigen::Matrix3d P;
  P << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return P;
}

Encounter with_axes_renamed(Encounter scene) {
  const Eigen::Matrix3d P = axes_renamed();
  for (TriangleMesh* mesh : {&scene.E, &scene.F}) {
    for (Vector3d& x : mesh->vertices) x = P * x;
  }
  scene.pose = {P * scene.pose.A * P.transpose(), P * scene.pose.r};
  scene.velocity = {P * scene.velocity.v, P * scene.velocity.w};
  return scene;
}

void expect_bits(const Contact& a, const Contact& b, double length, double area, double force, double torque) {
  EXPECT_EQ(a.touching, b.touching);
  ASSERT_EQ(a.crossings.size(), b.crossings.size());
  for (std::size_t i = 0; i < a.crossings.size(); ++i) {
    EXPECT_EQ(a.crossings[i].position_Me * length, b.crossings[i].position_Me);
  }
  EXPECT_EQ(a.E.area * area, b.E.area);
  EXPECT_EQ(a.F.area * area, b.F.area);
  EXPECT_EQ(a.E.vector_area_Me * area, b.E.vector_area_Me);
  EXPECT_EQ(a.volume * area * length, b.volume);
  EXPECT_EQ(a.force_Me * force, b.force_Me);
  EXPECT_EQ(a.torque_Me * torque, b.torque_Me);
  EXPECT_EQ(a.max_penetration * length, b.max_penetration);
  EXPECT_EQ(a.element_count, b.element_count);
  EXPECT_EQ(a.statistics.max_pressure * length, b.statistics.max_pressure);
}

class EngineInvariance : public testing::TestWithParam<Scheme> {};

Encounter scaled_by(Encounter scene, double s) {
  scene.E = scaled(scene.E, s);
  scene.F = scaled(scene.F, s);
  scene.pose.r *= s;
  scene.velocity.v *= s;
  scene.law.transition_depth *= s;
  scene.law.slip_velocity *= s;
  return scene;
}

TEST_P(EngineInvariance, AllLengthsTimesAPowerOfTwoScaleEveryBit) {
  const Encounter scene(GetParam());
  const Contact plain = scene.answer();
  ASSERT_TRUE(plain.touching);
  ASSERT_GT(plain.element_count, 10);
  for (const int k : {-100, -40, -1, 3, 40, 100}) {
    const double s = std::ldexp(1.0, k);
    expect_bits(plain, scaled_by(scene, s).answer(), s, s * s, s * s * s, s * s * s * s);
  }
}

TEST_P(EngineInvariance, AllLengthsTimesAPowerOfTwoScaleEveryBitOfBoundsAndTangent) {
  Wanted wanted;
  wanted.bound = wanted.tangent = true;
  for (int i = 0; i < 10; ++i) {
    Encounter scene(GetParam());
    scene.pose = turned(0.3 * i, {0.04 * std::sin(2.0 * i), 0.04 * std::sin(3.0 * i), 0.25});
    const Contact plain = scene.answer(wanted);
    ASSERT_GT(plain.element_count, 10) << i;
    for (const int k : {-60, -1, 3, 60}) {
      const double s = std::ldexp(1.0, k), force = s * s * s, torque = force * s;
      const Contact contact = scaled_by(scene, s).answer(wanted);
      EXPECT_EQ(contact.bound->force_Me, plain.bound->force_Me * force) << i << ' ' << k;
      EXPECT_EQ(contact.bound->torque_Me, plain.bound->torque_Me * torque) << i << ' ' << k;
      EXPECT_EQ(contact.bound->flipped, plain.bound->flipped) << i << ' ' << k;
      EXPECT_EQ(contact.bound->penetration_at_least, plain.bound->penetration_at_least * s) << i << ' ' << k;
      EXPECT_EQ(contact.bound->penetration_at_most, plain.bound->penetration_at_most * s) << i << ' ' << k;
      for (Eigen::Index column = 0; column < 12; ++column) {
        const double by = column / 3 % 2 == 0 ? 1 / s : 1;  // r and v are lengths, or lengths over time
        EXPECT_EQ(contact.tangent->topRows<3>().col(column), plain.tangent->topRows<3>().col(column) * (force * by));
        EXPECT_EQ(contact.tangent->bottomRows<3>().col(column),
                  plain.tangent->bottomRows<3>().col(column) * (torque * by));
      }
    }
  }
}

Encounter with_axes_negated(Encounter scene, const Vector3d& signs) {
  for (TriangleMesh* mesh : {&scene.E, &scene.F}) {
    for (Vector3d& x : mesh->vertices) x = x.cwiseProduct(signs);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) scene.pose.A(i, j) *= signs[i] * signs[j];
  }
  scene.pose.r = scene.pose.r.cwiseProduct(signs);
  scene.velocity.v = scene.velocity.v.cwiseProduct(signs);
  scene.velocity.w = scene.velocity.w.cwiseProduct(signs);
  return scene;
}

/// Two axes of both frames, negated: a rotation without any rounding.
std::vector<Vector3d> negations() {
  return {{1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
}

TEST_P(EngineInvariance, TwoAxesNegatedInBothFramesNegateTheResultsBitForBit) {
  const Encounter scene(GetParam());
  const Contact plain = scene.answer();
  for (const Vector3d& signs : negations()) {
    const Contact contact = with_axes_negated(scene, signs).answer();
    EXPECT_EQ(contact.force_Me, plain.force_Me.cwiseProduct(signs));
    EXPECT_EQ(contact.torque_Me, plain.torque_Me.cwiseProduct(signs));
    EXPECT_EQ(contact.volume, plain.volume);
    EXPECT_EQ(contact.E.area, plain.E.area);
    EXPECT_EQ(contact.F.vector_area_Me, plain.F.vector_area_Me.cwiseProduct(signs));
  }
}

TEST_P(EngineInvariance, TwoAxesNegatedInBothFramesLeaveBoundsAndNegateTheTangentBitForBit) {
  Wanted wanted;
  wanted.bound = wanted.tangent = true;
  for (int i = 0; i < 20; ++i) {
    Encounter scene(GetParam());
    scene.pose = turned(0.3 * i, {0.04 * std::sin(2.0 * i), 0.04 * std::sin(3.0 * i), 0.25});
    const Contact plain = scene.answer(wanted);
    ASSERT_GT(plain.element_count, 10) << i;
    for (const Vector3d& signs : negations()) {
      const Contact contact = with_axes_negated(scene, signs).answer(wanted);
      EXPECT_EQ(contact.bound->force_Me, plain.bound->force_Me) << i;
      EXPECT_EQ(contact.bound->torque_Me, plain.bound->torque_Me) << i;
      EXPECT_EQ(contact.bound->flipped, plain.bound->flipped) << i;
      EXPECT_EQ(contact.bound->penetration_at_least, plain.bound->penetration_at_least) << i;
      EXPECT_EQ(contact.bound->penetration_at_most, plain.bound->penetration_at_most) << i;
      for (Eigen::Index row = 0; row < 6; ++row) {
        for (Eigen::Index column = 0; column < 12; ++column) {
          EXPECT_EQ((*contact.tangent)(row, column), signs[row % 3] * signs[column % 3] * (*plain.tangent)(row, column))
              << i << ": " << row << ", " << column;
        }
      }
    }
  }
}

/// All that derives bounds and derivatives goes by single coordinates, and may not prefer any. Bounds depend on what
/// roundings really are, by a few hundredths.
TEST_P(EngineInvariance, RenamedAxesTurnForceBoundAndTangent) {
  Wanted wanted;
  wanted.bound = wanted.tangent = true;
  const Eigen::Matrix3d P = axes_renamed();
  Eigen::Matrix<double, 6, 6> turn_of_pairs = Eigen::Matrix<double, 6, 6>::Zero();
  turn_of_pairs.topLeftCorner<3, 3>() = turn_of_pairs.bottomRightCorner<3, 3>() = P;
  for (int i = 0; i < 20; ++i) {
    Encounter scene(GetParam());
    scene.pose = turned(0.3 * i, {0.04 * std::sin(2.0 * i), 0.04 * std::sin(3.0 * i), 0.25});
    const Contact plain = scene.answer(wanted);
    ASSERT_GT(plain.element_count, 10) << i;
    const Encounter renamed = with_axes_renamed(scene);
    const Contact contact = renamed.answer(wanted);
    EXPECT_EQ(contact.element_count, plain.element_count) << i;
    const double force = plain.force_Me.norm();
    EXPECT_LT((contact.force_Me - P * plain.force_Me).norm(), 1e-12 * force) << i;
    EXPECT_LT((contact.torque_Me - P * plain.torque_Me).norm(), 1e-12 * force) << i;
    const Tangent turned_tangent = [&] {
      Tangent T = turn_of_pairs * *plain.tangent;
      T.leftCols<6>() *= turn_of_pairs.transpose();
      T.rightCols<6>() *= turn_of_pairs.transpose();
      return T;
    }();
    EXPECT_LT((*contact.tangent - turned_tangent).norm(), 1e-10 * turned_tangent.norm()) << i;
    ASSERT_EQ(contact.bound->flipped, plain.bound->flipped);
    for (const auto& [bound, expected] : {std::pair(contact.bound->force_Me, Vector3d(P * plain.bound->force_Me)),
                                          std::pair(contact.bound->torque_Me, Vector3d(P * plain.bound->torque_Me))}) {
      EXPECT_LT((bound - expected).norm(), 0.1 * expected.norm())
          << i << " " << bound.transpose() << ", " << expected.transpose();
    }
  }
}

TEST_P(EngineInvariance, ModeBothIsTheMeanOfBothMasters) {
  Encounter scene(GetParam());
  const Contact both = scene.answer();
  scene.mode = Mode::E;
  const Contact by_E = scene.answer();
  scene.mode = Mode::F;
  const Contact by_F = scene.answer();
  EXPECT_EQ(both.force_Me, 0.5 * (by_E.force_Me + by_F.force_Me));
  EXPECT_EQ(both.torque_Me, 0.5 * (by_E.torque_Me + by_F.torque_Me));
  EXPECT_EQ(both.element_count, by_E.element_count + by_F.element_count);
}

TEST_P(EngineInvariance, ExchangedBodiesGiveTheOppositeForce) {
  Encounter scene(GetParam());
  scene.mode = Mode::E;
  const Contact direct = scene.answer();
  Encounter exchanged = scene;
  std::swap(exchanged.E, exchanged.F);
  exchanged.mode = Mode::F;
  exchanged.pose.A = scene.pose.A.transpose();
  exchanged.pose.r = -scene.pose.A.transpose() * scene.pose.r;
  // Motion of E relative to F at E's marker, resolved in Mf.
  exchanged.velocity.w = -scene.pose.A.transpose() * scene.velocity.w;
  exchanged.velocity.v = -scene.pose.A.transpose() * (scene.velocity.v - scene.velocity.w.cross(scene.pose.r));
  const Contact contact = exchanged.answer();
  const Vector3d force_Me = -(scene.pose.A * contact.force_Me);
  // About Me there, about Mf here.
  const Vector3d torque_Me = -(scene.pose.A * contact.torque_Me) - scene.pose.r.cross(force_Me);
  EXPECT_LT((force_Me - direct.force_Me).norm(), 1e-12 * direct.force_Me.norm());
  EXPECT_LT((torque_Me - direct.torque_Me).norm(), 1e-12 * direct.force_Me.norm());
}

TEST_P(EngineInvariance, PermutedFacesAndVerticesGiveTheSameAnswerToRounding) {
  const unsigned seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const Encounter scene(GetParam());
  const Contact plain = scene.answer();
  Encounter permuted = scene;
  for (TriangleMesh* mesh : {&permuted.E, &permuted.F}) {
    std::vector<Index> place(mesh->vertices.size());
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), random);
    std::vector<Vector3d> vertices(place.size());
    for (std::size_t v = 0; v < place.size(); ++v) vertices[static_cast<std::size_t>(place[v])] = mesh->vertices[v];
    mesh->vertices = vertices;
    for (Triangle& face : mesh->faces) {
      for (Index& v : face) v = place[static_cast<std::size_t>(v)];
      std::rotate(face.begin(), face.begin() + random() % 3, face.end());
    }
    std::shuffle(mesh->faces.begin(), mesh->faces.end(), random);
  }
  const Contact contact = permuted.answer();
  // Slivers of the clipped scheme may come and go.
  if (scene.scheme == Scheme::barycentric) {
    EXPECT_EQ(contact.element_count, plain.element_count);
  }
  EXPECT_EQ(contact.crossings.size(), plain.crossings.size());
  EXPECT_NEAR(contact.volume, plain.volume, 1e-13 * plain.volume);
  EXPECT_LT((contact.force_Me - plain.force_Me).norm(), 1e-12 * plain.force_Me.norm());
}

TEST_P(EngineInvariance, WhatIsNotWantedChangesNoBitOfTheRest) {
  const Encounter scene(GetParam());
  const Contact all = scene.answer();
  const Pairing pairing(Surface(scene.E), Surface(scene.F), scene.law, scene.mode, scene.scheme);
  Workspace workspace;
  for (int bits = 0; bits < 16; ++bits) {
    const Wanted wanted{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
    const Contact& part = evaluate(pairing, scene.pose, scene.velocity, wanted, workspace);
    EXPECT_TRUE(part.touching);
    EXPECT_EQ(part.polygons.size(), wanted.polygons ? all.polygons.size() : 0u);
    if (wanted.polygons) {
      EXPECT_TRUE(test::same(part.crossings, all.crossings));
      EXPECT_TRUE(test::same(part.polygons, all.polygons));
      EXPECT_EQ(part.patches, all.patches);
    }
    EXPECT_EQ(part.volume, wanted.areas ? all.volume : 0);
    if (wanted.areas) {
      EXPECT_TRUE(test::same(part.E, all.E));
      EXPECT_TRUE(test::same(part.F, all.F));
    }
    EXPECT_EQ(part.elements.size(), wanted.elements ? all.elements.size() : 0u);
    if (wanted.elements) {
      EXPECT_TRUE(test::same(part.elements, all.elements)) << bits;
    }
    if (wanted.force) {
      EXPECT_EQ(part.force_Me, all.force_Me);
      EXPECT_EQ(part.torque_Me, all.torque_Me);
    }
  }
}

TEST_P(EngineInvariance, AWorkspaceUsedForOtherPairingsGivesTheSameBits) {
  const Encounter scene(GetParam());
  const Contact fresh = scene.answer();
  Workspace workspace;
  const Pairing other(Surface(generate::icosphere(1, 3)), Surface(generate::pyramid()));
  evaluate(other, turned(0.3, {0.1, 0, -0.7}), {}, {}, workspace);
  const Pairing pairing(Surface(scene.E), Surface(scene.F), scene.law, scene.mode, scene.scheme);
  expect_bits(fresh, evaluate(pairing, scene.pose, scene.velocity, {}, workspace), 1, 1, 1, 1);
}

TEST_P(EngineInvariance, VerticesOfFAreTransformedOnlyWhereTouched) {
  const Pairing pairing(Surface(generate::icosphere(1, 4)), Surface(generate::icosphere(1, 4)), {}, Mode::E,
                        GetParam());
  Workspace workspace;
  const Contact& contact = evaluate(pairing, turned(0.3, {1.2, 1.1, 1.105}), {}, {}, workspace);
  EXPECT_TRUE(contact.touching);
  EXPECT_LT(contact.work.vertices_transformed, 400);
}

INSTANTIATE_TEST_SUITE_P(BothSchemes, EngineInvariance, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& run) { return run.param == Scheme::clipped ? "Clipped" : "Barycentric"; });

}  // namespace
}  // namespace pcm::fast
