// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/posed/placement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fast/posed/transform.h"
#include "fast/surface/prepare_surface.h"
#include "meshes/generate/round.h"

namespace pcm::fast {
namespace {

/// Far from the origin, where rounding moves F's vertices, by up to half a unit in the last place of the offset, and
/// none of E's. What is left of a vertex without the offset is exact.
TEST(Placement, VerticesOfFAreOffByTheVertexErrorAtMostAndThoseOfENotAtAll) {
  const PreparedSurface E = prepare_surface(generate::icosphere(1, 1)),
                        F = prepare_surface(generate::icosphere(0.7, 2));
  for (const double offset : {3.0, 1e3 + 0.1, 1e9 + 0.3, -3e12}) {
    Pose pose;
    pose.r = {offset, -0.5 * offset, 0.25 * offset};
    const Placement placement(E, F, pose);
    EXPECT_EQ(placement.vertex_error(Side::E), 0);
    PosedSurface posed;
    posed.place_F(F, pose, E.mesh.vertices.size(), false);
    WorkCounters work;
    double greatest = 0;
    for (Index v = 0; v < static_cast<Index>(F.mesh.vertices.size()); ++v) {
      const Eigen::Vector3d off = (posed.vertex_Me(v, work) - pose.r) - F.vertex(v);
      greatest = std::max(greatest, off.norm());
    }
    EXPECT_LE(greatest, placement.vertex_error(Side::F)) << offset;
    EXPECT_GE(greatest, placement.vertex_error(Side::F) / 64) << offset;
  }
}

}  // namespace
}  // namespace pcm::fast
