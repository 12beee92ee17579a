// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/identities.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compare/known_answers/identity_loads.h"
#include "fast/posed/vertex_rounding.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/hard_bodies.h"
#include "meshes/generate/round.h"

namespace pcm::compare {
namespace {

TEST(Identities, HoldOnAnotherSeed) {
  for (const IdentityResult& result : check_identities(2, Extent::quick))
    EXPECT_TRUE(result.passed()) << result.name << ": " << result.first;
}

/// The greatest rounding of a coordinate of F's vertices on its way into Me, m.
double vertex_rounding_of(const Posed& posed) {
  double greatest = 0;
  for (const Eigen::Vector3d& x : posed.F.vertices)
    greatest = std::max(greatest, fast::sharp_vertex_rounding(posed.pose, x).maxCoeff());
  return greatest;
}

TEST(Identities, PosesWithoutRoundingHaveNoneWhicheverBodyIsFirst) {
  int moved = 0;
  for (const Posed& posed : posed_pairs(1, 1)) {
    const Posed direct = without_rounding(posed), exchanged = exchanged_pair(direct), back = exchanged_pair(exchanged);
    // Products that underflow count 2^-1074 each.
    EXPECT_LE(vertex_rounding_of(direct), 0x1p-1070) << posed.where;
    EXPECT_LE(vertex_rounding_of(exchanged), 0x1p-1070) << posed.where;
    EXPECT_EQ(back.pose.r, direct.pose.r) << posed.where;
    EXPECT_EQ(back.velocity.v, direct.velocity.v) << posed.where;
    EXPECT_EQ(back.velocity.w, direct.velocity.w) << posed.where;
    if (direct.pose.r.norm() > 0 && direct.velocity.w.norm() > 0) ++moved;
  }
  EXPECT_GT(moved, 0);
}

TEST(Identities, EmbeddedSurfacesNeitherFoldNorEnd) {
  EXPECT_TRUE(is_closed_and_embedded(generate::box({1, 1, 1})));
  EXPECT_TRUE(is_closed_and_embedded(degenerate::hollow_cube(0.5)));
  EXPECT_FALSE(is_closed_and_embedded(degenerate::pentagram()));
  EXPECT_FALSE(is_closed_and_embedded(degenerate::figure_of_eight()));
  EXPECT_FALSE(is_closed_and_embedded(degenerate::open_box({1, 1, 1})));
}

TEST(Identities, MiddlesOfEdgesAreDoublesOnAGridOnly) {
  EXPECT_TRUE(has_exact_middles(degenerate::figure_of_eight()));
  EXPECT_FALSE(has_exact_middles(generate::wedge(30, 1, 1, 4)));
}

// A cube's face that an open sheet of half its width crosses in its middle: parts beside the sheet's border are not
// crossed, and carry nothing though their lines meet the sheet.
TEST(Identities, SplittingAMasterBeforeAnOpenSlaveChangesFacesWithPartsNoLongerActive) {
  const TriangleMesh cube = generate::box({1, 1, 1}), sheet = generate::rectangle(0.5, 0.5);
  const std::vector<Index> whole_of = quartered(cube).whole;
  fast::ActiveArea whole, parts;
  whole.intersected = {0, 2};
  parts.intersected = {0, 1, 2, 3, 8};
  parts.inner = {9, 10};
  const SplitMasterFaces open(sheet, whole_of, whole, parts), closed(cube, whole_of, whole, parts);
  EXPECT_TRUE(open.carries_the_same(0));
  EXPECT_TRUE(open.carries_the_same(1)) << "nothing of it is active";
  EXPECT_FALSE(open.carries_the_same(2)) << "one of its parts is not active";
  EXPECT_TRUE(closed.carries_the_same(2));
}

}  // namespace
}  // namespace pcm::compare
