// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"

/// What the engine promises about its bounds that needs no oracle; tests/compare/verify/bounds/force_bound_test.cpp
/// holds them to the truth.
namespace pcm::fast {
namespace {

using namespace test;

Wanted with_bound() {
  Wanted wanted;
  wanted.bound = true;
  return wanted;
}

ContactLaw dry_friction() {
  ContactLaw law = stiffness(1000);
  law.friction = 0.5;
  return law;
}

void expect_no_bit_changed(Scheme scheme) {
  const Surface bubble(generate::bubble());
  ContactLaw law = dry_friction();
  law.damping = 100;
  const Velocity velocity{{0.1, 0.2, -0.3}, {0.4, -0.5, 0.6}};
  Workspace plain, bounded;
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    for (const double max_penetration : {std::numeric_limits<double>::infinity(), 0.02}) {
      law.max_penetration = max_penetration;
      const Pairing pairing(bubble, bubble, law, mode, scheme);
      for (int i = 0; i < 20; ++i) {
        const Pose pose = turned(0.3 * i, {0.05, 0.1, 0.12});
        const Contact& a = evaluate(pairing, pose, velocity, {}, plain);
        Contact b = evaluate(pairing, pose, velocity, with_bound(), bounded);
        EXPECT_GT(a.elements.size(), 0u);
        EXPECT_EQ(a.penetration_exceeded, std::isfinite(max_penetration));
        ASSERT_TRUE(b.bound.has_value());
        EXPECT_FALSE(b.bound->flipped);
        b.bound.reset();
        test::expect_same_answer(a, b);
      }
    }
  }
}

TEST(ForceBound, ChangesNoBitOfTheAnswer) {
  expect_no_bit_changed(Scheme::barycentric);
}

TEST(ForceBound, ChangesNoBitOfTheAnswerInTheClippedScheme) {
  expect_no_bit_changed(Scheme::clipped);
}

TEST(ForceBound, OfTheClippedSchemeIsFiniteAndFlippedOnlyWhereFacesLieFlush) {
  const TriangleMesh box = generate::box({2, 2, 2}), ball = generate::icosphere(1, 2);
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    const Contact apart_from_flush =
        answer(box, ball, turned(0.4, {0, 0, 1.8}), stiffness(1), mode, {}, with_bound(), Scheme::clipped);
    EXPECT_FALSE(apart_from_flush.bound->flipped);
    EXPECT_LT(apart_from_flush.bound->force_Me.norm(), 1e-9 * apart_from_flush.force_Me.norm());
    // The same normal in one plane: the force jumps when the pose passes through.
    const Contact flush =
        answer(box, box, shifted(0.5, 0.25, 0), stiffness(1), mode, {}, with_bound(), Scheme::clipped);
    EXPECT_TRUE(flush.bound->flipped);
    EXPECT_TRUE(flush.bound->force_Me.allFinite());
    EXPECT_TRUE(flush.bound->torque_Me.allFinite());
  }
}

TEST(ForceBound, OfTheClippedSchemeIsNarrowWhereTheMastersOtherFacesLieBeneathAllThatAFaceSees) {
  // As deep as they are: the engine leaves those faces out, and the planes of some of them cut what is seen.
  const Surface bubble(generate::bubble());
  const Pairing pairing(bubble, bubble, stiffness(1000), Mode::both, Scheme::clipped);
  Workspace workspace;
  int touching = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose pose = turned(0.7 * i, {0.2 * std::sin(2.0 * i), 0.2 * std::sin(3.0 * i), 0.2 * std::sin(5.0 * i)});
    const Contact& contact = evaluate(pairing, pose, {}, with_bound(), workspace);
    if (!contact.touching || contact.bound->flipped) continue;
    ++touching;
    EXPECT_LT(contact.bound->force_Me.norm(), 1e-9 * 1000 * contact.volume) << i;
  }
  EXPECT_GE(touching, 150);
}

TEST(ForceBound, OfTheClippedSchemeIsZeroWhereLinesLeaveAThinGuestBeforeLargeFacesWhoseBoxesTheyMeet) {
  TriangleMesh guest = generate::box({1, 1, 0x1p-9});
  const Eigen::Matrix3d Q = Eigen::AngleAxisd(1.1, Eigen::Vector3d(2, -1, 0.5).normalized()).toRotationMatrix();
  for (Eigen::Vector3d& x : guest.vertices) x = Q * x;
  Wanted wanted;
  wanted.bound = true;
  const Contact contact = answer(guest, generate::box({8, 8, 8}), turned(0.7, {0.1, 0.2, -0.1}), stiffness(1000),
                                 Mode::E, {}, wanted, Scheme::clipped);
  EXPECT_TRUE(contact.nested);
  EXPECT_EQ(contact.bound->force_Me, Eigen::Vector3d::Zero());
}

TEST(ForceBound, ImpliesTheForce) {
  Wanted only_bound{false, false, false, false, true};
  const TriangleMesh box = generate::box({2, 2, 2}), ball = generate::icosphere(1, 2);
  const Contact contact = answer(box, ball, turned(0.4, {0, 0, 1.8}), stiffness(1), Mode::E, {}, only_bound);
  const Contact usual = answer(box, ball, turned(0.4, {0, 0, 1.8}), stiffness(1));
  EXPECT_EQ(contact.force_Me, usual.force_Me);
  EXPECT_TRUE(contact.bound.has_value());
}

TEST(ForceBound, HoldsTheGreatestPenetrationBetweenTwoNumbers) {
  const TriangleMesh E = generate::icosphere(1, 2), F = generate::icosphere(1, 2);
  const Pose pose = turned(0.4, {0.3, 0.4, 1.7});
  for (const Mode mode : {Mode::E, Mode::both}) {
    const Contact once = answer(E, F, pose, stiffness(1), mode, {}, with_bound());
    EXPECT_GT(once.max_penetration, 0.05);
    EXPECT_LE(once.bound->penetration_at_least, once.max_penetration);
    EXPECT_GE(once.bound->penetration_at_most, once.max_penetration);
    EXPECT_NEAR(once.bound->penetration_at_least, once.bound->penetration_at_most, 1e-12);
  }
  // The deepest of all elements, clamped or not.
  ContactLaw law = stiffness(1);
  law.max_penetration = 0.01;
  const Contact clamped = answer(E, F, pose, law, Mode::E, {}, with_bound());
  EXPECT_TRUE(clamped.penetration_exceeded);
  EXPECT_GT(clamped.bound->penetration_at_least, law.max_penetration);
  EXPECT_GE(clamped.bound->penetration_at_most, clamped.max_penetration);
}

TEST(ForceBound, IsZeroWhereTheSurfacesAreApart) {
  const TriangleMesh box = generate::box({2, 2, 2});
  for (const Mode mode : {Mode::E, Mode::both}) {
    const Contact contact = answer(box, box, turned(0.4, {5, 0, 0}), stiffness(1), mode, {}, with_bound());
    EXPECT_EQ(contact.bound->force_Me, Eigen::Vector3d::Zero());
    EXPECT_EQ(contact.bound->torque_Me, Eigen::Vector3d::Zero());
    EXPECT_FALSE(contact.bound->flipped);
    EXPECT_EQ(contact.bound->penetration_at_most, 0);
  }
}

TEST(ForceBound, GrowsWithTheDistanceFromTheOrigin) {
  const TriangleMesh E = generate::icosphere(1, 2), F = generate::icosphere(1, 2);
  double previous = 0;
  for (const double far : {1.0, 1e3, 1e6}) {
    const Eigen::Vector3d at(far, 0, 0);
    const Contact contact = answer(translated(E, at), F, turned(0.4, at + Eigen::Vector3d(0.3, 0.4, 1.7)), stiffness(1),
                                   Mode::E, {}, with_bound());
    EXPECT_FALSE(contact.bound->flipped);
    EXPECT_GT(contact.bound->force_Me.norm(), 10 * previous);
    previous = contact.bound->force_Me.norm();
  }
}

/// So far from the origin, where vertices are rounded to 2^-14 m, the master's thickness is not taken on trust: its
/// lines pass boxes of its own sides, which stand aslant in their tree, and meet none of these.
TEST(ForceBound, IsNarrowWhereLinesPassTheMastersSidesWithoutMeetingThem) {
  const Eigen::Vector3d far(0x1p38, 0, 0);
  const Pose pose = turned(0.7, far + Eigen::Vector3d(0, 0, 2.25));
  const TriangleMesh E = translated(generate::box({4, 4, 4}), far);
  TriangleMesh F = generate::gridded_box({1, 1, 1}, {3, 3, 3});
  for (Eigen::Vector3d& x : F.vertices) x = pose.A.transpose() * x;
  const Contact contact = answer(E, F, pose, stiffness(1), Mode::F, {}, with_bound());
  EXPECT_EQ(contact.element_count, 18);
  EXPECT_LT(contact.bound->force_Me.norm(), 0x1p-11);
}

TEST(ForceBound, OfDryFrictionWithoutSlipIsTheJump) {
  const TriangleMesh box = generate::box({2, 2, 2}), ball = generate::icosphere(1, 2);
  // The slip velocity is 0 in floating point, and in truth anything within its rounding.
  const Velocity normal_to_the_plate{{0, 0, -1}, {0.5, 0.5, 0}};
  Pose pose = turned(0.4, {0, 0, 1.8});
  const Contact contact = answer(box, ball, pose, dry_friction(), Mode::E, normal_to_the_plate, with_bound());
  const Contact at_rest = answer(box, ball, pose, dry_friction(), Mode::E, {}, with_bound());
  const Contact elastic = answer(box, ball, pose, stiffness(1000), Mode::E, {}, with_bound());
  ASSERT_EQ(contact.element_count, 2);
  EXPECT_LE(at_rest.bound->force_Me.maxCoeff(), 2 * elastic.bound->force_Me.maxCoeff());

  Velocity along_normal;
  along_normal.v = {0, 0, -1};
  const Contact stuck = answer(box, ball, pose, dry_friction(), Mode::E, along_normal, with_bound());
  const double limit = 0.5 * stuck.force_Me.norm();
  EXPECT_GE(stuck.bound->force_Me[0], limit);
  EXPECT_LE(stuck.bound->force_Me[0], 2.1 * limit);
  EXPECT_FALSE(stuck.bound->flipped);
  EXPECT_LT(contact.bound->force_Me[0], 1e-9 * limit);
}

TEST(ForceBound, IsFiniteAndFlippedWhereFacesLieInOnePlane) {
  const TriangleMesh box = generate::gridded_box(2, 2);
  for (const Eigen::Vector3d& r : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(0, 0, 1)}) {
    for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
      const Contact contact = answer(box, box, shifted(r[0], r[1], r[2]), stiffness(1), mode, {}, with_bound());
      EXPECT_TRUE(contact.bound->flipped);
      EXPECT_TRUE(contact.bound->force_Me.allFinite());
      EXPECT_TRUE(contact.bound->torque_Me.allFinite());
    }
  }
}

TEST(ForceBound, OfAnUndecidedElementCoversItsWholeForce) {
  // One corner of the box reaches through the plate by less than the rounding of its vertices.
  const TriangleMesh plate = generate::box({4, 4, 1}), box = generate::box({1, 1, 1});
  bool flipped = false;
  for (const double depth : {0.0, 0x1p-53, 0x1p-52, 0x1p-51}) {
    const Contact contact = answer(plate, box, shifted(0, 0, 1 - depth), stiffness(1), Mode::both, {}, with_bound());
    flipped = flipped || contact.bound->flipped;
    if (contact.bound->flipped) {
      EXPECT_GE(contact.bound->force_Me[2], std::abs(contact.force_Me[2]));
    }
    EXPECT_LT(contact.bound->force_Me[2], 1e-13);
  }
  EXPECT_TRUE(flipped);
}

TEST(ForceBound, HoldsForAFaceWhoseAreaUnderflowsUnderAStiffLaw) {
  const TriangleMesh box = generate::box({2.5, 3, 5});
  for (const int exponent : {-530, -536, -539, -545}) {
    const double side = std::ldexp(1.0, exponent);
    TriangleMesh speck;
    speck.vertices = {{0, 0, 0}, {0, side, 0}, {0, 0, side}, {9, 9, 9}, {9, 10, 9}, {9, 9, 10}};
    speck.faces = {{0, 1, 2}, {3, 4, 5}};
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      const Contact contact =
          answer(speck, box, shifted(0.75, 0.5, -0.5), stiffness(0x1p1000), Mode::E, {}, with_bound(), scheme);
      // The face is half a metre deep: c_l side^2 / 2 times that.
      const double truth = -0.25 * std::ldexp(1.0, 1000 + 2 * exponent);
      EXPECT_LE(std::abs(contact.force_Me.x() - truth), contact.bound->force_Me.x()) << exponent;
    }
  }
}

}  // namespace
}  // namespace pcm::fast
