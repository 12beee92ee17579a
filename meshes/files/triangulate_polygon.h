// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// Cuts a polygon of n >= 3 corners into exactly n - 2 triangles of the same orientation and appends them to `faces`.
///
/// The polygon is judged in the coordinate plane that its (Newell) normal is most nearly perpendicular to. A convex one
/// is fanned from its first corner; any other loses its ears one by one, the next one after the last first. A convex
/// one with a corner on a straight line is treated as any other where the fan would contain a triangle of zero area.
/// Every sign is exact, so a simple polygon (in projection) of non-zero area gives triangles that don't overlap and
/// none of zero area. For a polygon that crosses itself or has no area the triangles are arbitrary, but there are
/// still n - 2 of them.
///
/// `corners` are valid indices of finite `vertices`. Cost: O(n) where convex, else O(n^2); O(n^3) at worst where it
/// touches or crosses itself.
void triangulate_polygon(const std::vector<Eigen::Vector3d>& vertices, std::span<const Index> corners,
                         std::vector<Triangle>& faces);

}  // namespace pcm
