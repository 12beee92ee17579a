// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the oracle certifies of barycentric elements against an open slave, and by case 2 of barycentric_elements.h.
#include "reference/elements/barycentric_elements.h"

#include <gtest/gtest.h>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "reference/oracle.h"
#include "tests/reference/bow_tie.h"
#include "tests/reference/problems.h"

namespace pcm::reference::barycentric_elements_test {
namespace {

/// Its top is z = x / 2: boxes about its faces hold what is near them.
TriangleMesh slanting_plate() {
  TriangleMesh mesh = generate::box({-2, -2, -1}, {2, 2, 0});
  for (Eigen::Vector3d& x : mesh.vertices) x.z() += 0.5 * x.x();
  return mesh;
}

/// Stands above that, its first corner at the height given.
TriangleMesh triangle_on_its_corner(double height) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0.125, height}, {1, 0.25, height + 2}, {0.5, 1, height + 1}};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

TEST(BarycentricElements, OpenSlaveThatTouchesWithACornerIsCertifiedOffTheFaceAndThroughItOnly) {
  for (const Problem problem : kProblems) {
    const auto is_certified = [&](double height) {
      return Oracle(slanting_plate(), triangle_on_its_corner(height), {}, Mode::E).answer(problem, {}).certified;
    };
    EXPECT_FALSE(is_certified(0));
    EXPECT_TRUE(is_certified(0x1p-40));
    EXPECT_TRUE(is_certified(-0x1p-40));
  }
}

/// The left side of E lies before that side of the bow tie where its winding number is -1; a spike that crosses one of
/// its two faces makes that one active. Nothing but the crossing tells of that.
TEST(BarycentricElements, FaceOutsideTheSlaveIsCertifiedWhereItIsCertainlyCrossed) {
  const TriangleMesh E = generate::box({0, -1, -1}, {1.25, 1, 1});
  const auto spike_that_begins_at = [](double x) {
    return degenerate::joined(
        bow_tie(3),
        degenerate::tetrahedron({{{x, -0.75, 0.5}, {0.5, -0.875, 0.5}, {0.5, -0.625, 0.5}, {0.5, -0.75, 0.75}}}));
  };
  for (const Problem problem : kProblems) {
    const Answer crossed = Oracle(E, spike_that_begins_at(-0.5), {}, Mode::E).answer(problem, {});
    EXPECT_EQ(crossed.elements.size(), 1u);
    EXPECT_TRUE(crossed.certified);
    const Answer touched = Oracle(E, spike_that_begins_at(0), {}, Mode::E).answer(problem, {});
    EXPECT_FALSE(touched.certified);
  }
}

}  // namespace
}  // namespace pcm::reference::barycentric_elements_test
