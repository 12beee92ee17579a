// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fast/surface/clearance.h"
#include "fast/surface/exit_depth.h"
#include "fast/surface/thickness.h"
#include "meshes/generate/parts.h"
#include "pcm/engine.h"
#include "tests/meshes/transformed_meshes.h"

/// What is known of a surface beforehand, with all lengths times a power of two, between the ends of what coordinates
/// may be: there squares of lengths, or of products of lengths, leave the range of doubles, or lose digits.
namespace pcm::fast {
namespace {

/// Calls `expect(surface, power, face)` for all faces.
void at_all_scales(const TriangleMesh& mesh,
                   const std::function<void(const PreparedSurface& surface, double power, Index face)>& expect) {
  for (int exponent = -298; exponent <= 298; ++exponent) {
    SCOPED_TRACE(exponent);
    const double power = std::ldexp(1.0, exponent);
    const Surface surface(scaled(mesh, power));
    for (Index face = 0; face < static_cast<Index>(mesh.faces.size()) && !testing::Test::HasFailure(); ++face)
      expect(surface.data(), power, face);
  }
}

/// A bound from below may be lost where products underflow, never be too great.
void expect_at_most(double scaled_bound, double bound, double power) {
  EXPECT_LE(scaled_bound, power * bound);
  if (power > 0x1p-200) {
    EXPECT_EQ(scaled_bound, power * bound);
  }
}

class KnownBounds : public testing::Test {
 protected:
  TriangleMesh mesh = generate::socket(1, 0.5, 8, 2);
  Surface plain{mesh};
};

TEST_F(KnownBounds, ClearanceIsTheSameAtAllScales) {
  at_all_scales(mesh, [&](const PreparedSurface& surface, double, Index face) {
    const Clearance a = clearance(plain.data(), face), b = clearance(surface, face);
    EXPECT_EQ(a.beneath, b.beneath);
    EXPECT_EQ(a.above, b.above);
  });
}

TEST_F(KnownBounds, ThicknessGrowsWithTheScale) {
  at_all_scales(mesh, [&](const PreparedSurface& surface, double power, Index face) {
    expect_at_most(thickness(surface, face), thickness(plain.data(), face), power);
    const ThicknessEverywhere everywhere = thickness_everywhere(plain.data(), face);
    const ThicknessEverywhere there = thickness_everywhere(surface, face);
    expect_at_most(there.tolerant, everywhere.tolerant, power);
    expect_at_most(there.exact, everywhere.exact, power);
    expect_at_most(there.rounded, everywhere.rounded, power);
  });
}

TEST_F(KnownBounds, DepthAtWhichLinesHaveLeftGrowsWithTheScale) {
  at_all_scales(mesh, [&](const PreparedSurface& surface, double power, Index face) {
    // From above: infinite where it is not known.
    const double depth = exit_depth(surface, face), scaled_depth = power * exit_depth(plain.data(), face);
    EXPECT_GE(depth, scaled_depth);
    if (power > 0x1p-200 && power < 0x1p200) {
      EXPECT_EQ(depth, scaled_depth);
    }
  });
}

}  // namespace
}  // namespace pcm::fast
