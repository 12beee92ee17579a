// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

namespace pcm::compare {

/// Do two triangles intersect? The interval test of Möller (1997) in plain floating point: no tolerance, no exactness;
/// coplanar triangles count as apart. For peers that find overlapping boxes only.
bool triangles_overlap(const std::array<Eigen::Vector3d, 3>& first, const std::array<Eigen::Vector3d, 3>& second);

}  // namespace pcm::compare
