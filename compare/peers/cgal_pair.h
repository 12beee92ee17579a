// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <vector>

#include "compare/poses/rounded_vertices.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// Two surfaces as CGAL has them, which takes surfaces in place: F's vertices are moved, with rounding, before a query.
template <class Kernel>
class CgalPair {
 public:
  using Point = typename Kernel::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;

  CgalPair(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)
      : E(mesh_of(mesh_E)), F(mesh_of(mesh_F)), mesh_F_(mesh_F) {}

  void place(const Pose& pose) {
    const std::vector<Eigen::Vector3d> moved = rounded_vertices(mesh_F_, pose);
    std::size_t v = 0;
    for (const auto vertex : F.vertices()) F.point(vertex) = point(moved[v++]);
  }

  Mesh E, F;

 private:
  static Point point(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

  static Mesh mesh_of(const TriangleMesh& mesh) {
    Mesh made;
    for (const Eigen::Vector3d& x : mesh.vertices) made.add_vertex(point(x));
    const auto vertex = [](Index v) { return typename Mesh::Vertex_index(static_cast<std::uint32_t>(v)); };
    for (const Triangle& f : mesh.faces) made.add_face(vertex(f[0]), vertex(f[1]), vertex(f[2]));
    return made;
  }

  TriangleMesh mesh_F_;
};

}  // namespace pcm::compare
