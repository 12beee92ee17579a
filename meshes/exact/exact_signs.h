// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "pcm/triangle_mesh.h"

/// Signs that reading and checking a surface depend on, exact for every finite input: floating point with an error
/// bound first, exact numbers where that can't tell. The engine and the oracle have predicates of their own.
namespace pcm {

/// The sign of (b - a) x (c - a): +1 where a, b, c turn counterclockwise, 0 where they are collinear.
int turn_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// The sign of the enclosed area of a closed polygon: +1 where it runs counterclockwise.
int area_sign(std::span<const Eigen::Vector2d> polygon);

/// The sign of ((b - a) x (c - a)) . (p - a): +1 where p lies above the face (a, b, c), on the side of its normal.
int side_sign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& p);

/// Whether a, b and c lie on one line, coincidence included: a face of exactly zero area.
bool are_collinear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// The sign of the volume that closed faces enclose: +1 where they are oriented outward, 0 where they enclose nothing.
/// The faces must be closed among themselves (every edge used as often in one direction as in the other).
int volume_sign(const std::vector<Eigen::Vector3d>& vertices, std::span<const Triangle> faces);

/// The coordinates of `p` other than `axis`, in the order that keeps a turn seen against that axis: (y, z) for x,
/// (z, x) for y, (x, y) for z.
inline Eigen::Vector2d without_axis(const Eigen::Vector3d& p, int axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

}  // namespace pcm
