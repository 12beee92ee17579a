// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// The same faces, and vertices of the same bits; names may differ.
inline bool same_bits(const TriangleMesh& a, const TriangleMesh& b) {
  const auto same_coordinates = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return std::equal(p.begin(), p.end(), q.begin(), [](double x, double y) {
      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
  };
  return a.faces == b.faces &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), same_coordinates);
}

}  // namespace pcm
