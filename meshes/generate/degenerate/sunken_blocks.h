// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "pcm/triangle_mesh.h"

namespace pcm::degenerate {

/// Closed block whose walls lean: its end at z = `height` has the corners `low` and `high`, the one at `far` is
/// `factor` times as wide about the same middle, and along y 7/8 of that, so that no edge of two walls runs along the
/// diagonal of an end. 12 faces.
TriangleMesh leaning_block(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double height, double far,
                           double factor);

/// A plate of 32 m and the body that is let into it: a block with its floor 1 m deep, and four smaller ones through
/// it with floors at other depths, some of them parts of the plate that come out beneath it. All edges of floors lie on
/// the lines of one grid, so that the line of one goes on along others at other depths; no such wall is upright, and
/// the smaller blocks do not touch each other. Plate, then body; a pure function of the number. 72 faces together.
std::array<TriangleMesh, 2> sunken_blocks(std::uint64_t number);

}  // namespace pcm::degenerate
