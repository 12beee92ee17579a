// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/sweeps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcm::compare::stability {
namespace {

SweptBodies at(Sweep sweep, int step) {
  return bodies_at({sweep, step});
}

/// What is left of a body when its first vertex is moved to the origin; exact where differences of vertices are.
std::vector<Eigen::Vector3d> shape(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& x : mesh.vertices) points.push_back(x - mesh.vertices.front());
  return points;
}

TEST(Sweeps, BodiesAreTheSameBitByBitAtAnyOffset) {
  const SweptBodies near = at(Sweep::offset, 0);
  for (const int step : {20, 44}) {
    const SweptBodies far = at(Sweep::offset, step);
    EXPECT_EQ(shape(far.E), shape(near.E));
    EXPECT_EQ(shape(far.F), shape(near.F));
    EXPECT_GT(far.E.vertices.front().norm(), std::ldexp(1.0, step));
  }
  // One binary order further a coordinate is no multiple of the grid any more.
  EXPECT_NE(shape(at(Sweep::offset, 46).E), shape(near.E));
}

TEST(Sweeps, AspectStretchesOneAxisExactly) {
  const SweptBodies round = at(Sweep::aspect, 0), long_ones = at(Sweep::aspect, 50);
  for (std::size_t v = 0; v < round.E.vertices.size(); ++v) {
    const Eigen::Vector3d stretched(0x1p50 * round.E.vertices[v].x(), round.E.vertices[v].y(), round.E.vertices[v].z());
    EXPECT_EQ(long_ones.E.vertices[v], stretched);
  }
}

TEST(Sweeps, ScaleIsAPowerOfTwoOfTheSameBodies) {
  const SweptBodies bodies = at(Sweep::scale, -240);
  EXPECT_EQ(bodies.scale, 0x1p-240);
  EXPECT_EQ(bodies.E.vertices, at(Sweep::scale, 0).E.vertices);
  EXPECT_EQ(scaled(bodies.E, bodies.scale).vertices[5], 0x1p-240 * bodies.E.vertices[5]);
}

TEST(Sweeps, MeshesHaveTheFacesTheirParameterSays) {
  for (const SweepPoint& point : sweep_points(Sweep::faces, Extent::full))
    EXPECT_EQ(static_cast<double>(bodies_at(point).E.faces.size()), point.parameter());
  EXPECT_EQ(sweep_points(Sweep::faces, Extent::full).back().in_words(), "20480");
}

TEST(Sweeps, DepthsGoDownToTheUlpOfASize) {
  for (const Sweep sweep : {Sweep::depth, Sweep::vertex}) {
    const SweepPoint last = sweep_points(sweep, Extent::full).back();
    EXPECT_LT(last.parameter(), 1e-15);
    EXPECT_EQ(bodies_at(last).depth, 2 * last.parameter());
    EXPECT_EQ(last.in_words(), "2^-50");
  }
}

TEST(Sweeps, QuickPointsAreAmongAllPointsOrCoarser) {
  for (const Sweep sweep : kSweeps)
    EXPECT_LT(sweep_points(sweep, Extent::quick).size(), sweep_points(sweep, Extent::full).size());
}

}  // namespace
}  // namespace pcm::compare::stability
