// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace pcm::simulate {

/// The triangles of an arrow's shaft and head, in the frame of its ends, m. Shaft and head are `width` and 2.2 times
/// that from the middle, the head is 6 times as long; a short arrow is slimmer, with a head of 0.6 of its length.
std::vector<std::array<Eigen::Vector3d, 3>> arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width);

}  // namespace pcm::simulate
