// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "fast/prism/master_prism.h"
#include "fast/surface/prepared_surface.h"

namespace pcm::fast {

/// What one master face sees of the other faces of its surface. Most vertices are looked at once: faces that share them
/// ask for them again and again, and those in the master's plane take exact numbers.
class OwnSights {
 public:
  /// `master`: the vertices of the face whose prism it is. Both have to outlive it.
  OwnSights(const MasterPrism& prism, const Triangle& master) : prism_(prism), master_(master) { seen_.fill(-1); }

  /// The corners of another face. `vertex_Me(v)`: where vertex v of the surface is, always the same.
  template <class VertexMe>
  SeenCorners corners(const Triangle& vertices, const VertexMe& vertex_Me, WorkCounters& work) {
    SeenCorners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners.shared[k] = corner_at(master_, vertices[k]);
      corners.points[k] =
          corners.shared[k] >= 0 ? MasterPrism::corner(corners.shared[k]) : see(vertices[k], vertex_Me, work);
    }
    return corners;
  }
  /// The same of a surface that is not moved.
  SeenCorners corners(const PreparedSurface& surface, Index face, WorkCounters& work) {
    const auto vertex_Me = [&](Index v) -> const Eigen::Vector3d& { return surface.vertex(v); };
    return corners(surface.face(face), vertex_Me, work);
  }

 private:
  static constexpr std::size_t kPlaces = 64;  ///< two vertices that would be kept in one place are looked at again

  template <class VertexMe>
  const PrismPoint& see(Index vertex, const VertexMe& vertex_Me, WorkCounters& work) {
    const std::size_t place = static_cast<std::size_t>(vertex) % kPlaces;
    if (seen_[place] != vertex) {
      sights_[place] = prism_.see(vertex_Me(vertex), work);
      seen_[place] = vertex;
    }
    return sights_[place];
  }

  const MasterPrism& prism_;
  const Triangle& master_;
  std::array<PrismPoint, kPlaces> sights_;
  std::array<Index, kPlaces> seen_;  ///< the vertex that is kept there, or -1
};

}  // namespace pcm::fast
