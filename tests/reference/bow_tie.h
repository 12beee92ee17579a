// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A closed surface that lines leave which never entered it.
#pragma once

#include <utility>

#include "pcm/triangle_mesh.h"

namespace pcm::reference {

/// Two prisms along z in one, of which the smaller, on the left, is inside out: the box about a bow tie that crosses
/// itself on the z axis shifted by (x, 0, 0). Its winding number is -1 in the triangle (x - 2, -2), (x, 0), (x - 2, 2),
/// and 1 in (x, 0), (x + 4, -4), (x + 4, 4).
inline TriangleMesh bow_tie(double x) {
  TriangleMesh mesh;
  mesh.name = "bow tie";
  for (const double z : {-4.0, 4.0})
    for (const auto& [dx, y] : {std::pair{4.0, -4.0}, {4.0, 4.0}, {-2.0, -2.0}, {-2.0, 2.0}})
      mesh.vertices.emplace_back(x + dx, y, z);
  for (Index i = 0; i < 4; ++i) {
    const Index j = (i + 1) % 4;
    mesh.faces.push_back({i, j, j + 4});
    mesh.faces.push_back({i, j + 4, i + 4});
  }
  for (const Triangle& t : {Triangle{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}}) mesh.faces.push_back(t);
  return mesh;
}

}  // namespace pcm::reference
