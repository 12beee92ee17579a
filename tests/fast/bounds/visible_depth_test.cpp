// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/fast/engine_support.h"

/// The bounds of the greatest penetration in the clipped scheme, where the deepest point is known without an oracle.
/// The face that looks is the top of a block, two triangles in z = 0; the body above it is turned.
namespace pcm::fast {
namespace {

using namespace test;
using Eigen::Vector3d;

TriangleMesh block() {
  return translated(generate::box({8, 8, 8}), {0, 0, -4});
}

TriangleMesh body(const Vector3d& size, const Vector3d& centre) {
  return translated(generate::box(size), centre);
}

ForceBound bound_of(const TriangleMesh& F, const Pose& pose) {
  Wanted wanted;
  wanted.bound = true;
  const Contact contact = answer(block(), F, pose, stiffness(1), Mode::E, {}, wanted, Scheme::clipped);
  EXPECT_GT(contact.elements.size(), 0u);
  EXPECT_LE(contact.bound->penetration_at_least, contact.max_penetration);
  return *contact.bound;
}

/// How far the lowest of these vertices lies below z = 0.
double depth_of_lowest(const TriangleMesh& mesh, const Pose& pose) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector3d& x : mesh.vertices) lowest = std::min(lowest, (pose.A * x + pose.r).z());
  return -lowest;
}

void expect_close(const ForceBound& bound, double depth) {
  EXPECT_NEAR(bound.penetration_at_least, depth, 1e-10 * depth);
  EXPECT_NEAR(bound.penetration_at_most, depth, 1e-10 * depth);
  EXPECT_LE(bound.penetration_at_least, depth * (1 + 0x1p-50));
  EXPECT_GE(bound.penetration_at_most, depth * (1 - 0x1p-50));
}

/// Two plates, the upper one dips into the block, the lower one lies within it and beneath all of the upper.
TEST(VisibleDepth, WhatLiesBehindAnotherPlateDoesNotCount) {
  const TriangleMesh upper = body({2, 3, 1.5}, {0, 0, 0.6}), lower = body({1.5, 2.5, 0.25}, {0, 0, -1.5});
  for (int i = 0; i < 20; ++i) {
    const Pose pose = turned(0.05 + 0.02 * i, {0.01 * i, 0.2, 0});
    expect_close(bound_of(degenerate::joined(upper, lower), pose), depth_of_lowest(upper, pose));
  }
}

/// The lower plate, which starts outside of all bodies, is entered first where it looks out: it carries nothing there.
TEST(VisibleDepth, WhatIsEnteredFirstDoesNotCountWhereItLooksOutBesideAnother) {
  const TriangleMesh upper = body({2, 3, 1.5}, {0, 0, 0.6}), lower = body({2.5, 3.5, 0.25}, {0, 0, -1.5});
  for (int i = 0; i < 20; ++i) {
    const Pose pose = turned(0.05 + 0.02 * i, {0.01 * i, 0.2, 0});
    expect_close(bound_of(degenerate::joined(upper, lower), pose), depth_of_lowest(upper, pose));
  }
}

/// A cavity hides the floor of a body that widens upwards, but for a strip along the floor's border.
TEST(VisibleDepth, FloorSeenInANarrowStripCounts) {
  TriangleMesh outer = body({2, 3, 2}, {0, 0, 0});
  for (Vector3d& x : outer.vertices) {
    if (x.z() > 0) x.head<2>() *= 1.5;
  }
  for (const double width : {0.25, 0x1p-10, 0x1p-20, 0x1p-30, 0x1p-40, 0x1p-50}) {
    const TriangleMesh cavity = degenerate::inverted(body({2 - 2 * width, 3 - 2 * width, 0.25}, {0, 0, -0.5}));
    for (int i = 0; i < 5; ++i) {
      Pose pose = turned(0, {0.01 * i, 0.2, 0});
      pose.A = (Eigen::AngleAxisd(width / 8, Vector3d::UnitX()) * Eigen::AngleAxisd(0.3 + i, Vector3d::UnitZ()))
                   .toRotationMatrix();
      const ForceBound bound = bound_of(degenerate::joined(outer, cavity), pose);
      const double depth = depth_of_lowest(outer, pose);
      EXPECT_GE(bound.penetration_at_most, depth * (1 - 0x1p-50)) << width;
      EXPECT_LE(bound.penetration_at_most, depth * (1 + 1e-10)) << width;
      EXPECT_LE(bound.penetration_at_least, depth * (1 + 0x1p-50)) << width;
      if (width > 0x1p-40) {
        EXPECT_NEAR(bound.penetration_at_least, depth, 1e-10 * depth) << width;
      }
    }
  }
}

/// Faces of a sheet that share a side leave no gap there, however the sheet is parted.
TEST(VisibleDepth, SidesWithinASheetHideWhatLiesBehind) {
  const TriangleMesh upper = translated(generate::icosphere(1, 3), {0, 0, 0.8});
  const TriangleMesh lower = translated(scaled(generate::icosphere(1, 2), 0.3), {0.05, 0.02, -1.5});
  for (int i = 0; i < 20; ++i) {
    const Pose pose = turned(0.3 + 0.1 * i, {0.01 * i, 0.2, 0});
    Pose upright = pose;
    upright.A.setIdentity();
    TriangleMesh first = upper, second = lower;
    for (Vector3d& x : first.vertices) x = pose.A * (x - Vector3d(0, 0, 0.8)) + Vector3d(0, 0, 0.8);
    for (Vector3d& x : second.vertices) x = pose.A * (x - Vector3d(0, 0, -1.5)) + Vector3d(0, 0, -1.5);
    expect_close(bound_of(degenerate::joined(first, second), upright), depth_of_lowest(first, upright));
  }
}

/// Over a needle the engine's three weights, each rounded for itself, do not add up to 1 as well as depths are known:
/// it cuts what is seen a little before or beyond the third side.
TEST(VisibleDepth, SeenByANeedleIsNoMoreThanTheEngineSees) {
  TriangleMesh disc = generate::icosphere(0.5, 1);
  for (Vector3d& x : disc.vertices) x.z() *= 0x1p-20;
  const TriangleMesh slab = generate::gridded_box(1, 2);
  Wanted wanted;
  wanted.bound = true;
  int deep = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose pose = turned(0.005 * i, {0.4 - 0.0005 * i, 0.3, 0.2});
    const Contact contact = answer(disc, slab, pose, stiffness(1), Mode::E, {}, wanted, Scheme::clipped);
    EXPECT_LE(contact.bound->penetration_at_least, contact.max_penetration) << i;
    deep += contact.bound->penetration_at_least > 0.01 ? 1 : 0;
  }
  EXPECT_GT(deep, 100);
}

TEST(VisibleDepth, OfTwoBallsIsHeldBothWays) {
  const TriangleMesh E = generate::icosphere(1, 3), F = generate::icosphere(1, 2);
  Wanted wanted;
  wanted.bound = true;
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    for (int i = 0; i < 20; ++i) {
      const Pose pose = turned(0.3 * i, {0.3, 0.4, 1.6});
      const Contact contact = answer(E, F, pose, stiffness(1), mode, {}, wanted, Scheme::clipped);
      EXPECT_NEAR(contact.bound->penetration_at_least, contact.max_penetration, 1e-11 * contact.max_penetration);
      EXPECT_NEAR(contact.bound->penetration_at_most, contact.max_penetration, 1e-11 * contact.max_penetration);
    }
  }
}

}  // namespace
}  // namespace pcm::fast
