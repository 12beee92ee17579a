// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/degenerate/bodies.h"

#include <utility>

namespace pcm::degenerate {

TriangleMesh tetrahedron(const std::array<Eigen::Vector3d, 4>& corners) {
  const Eigen::Vector3d a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[3] - corners[0];
  const double six_volumes = a.x() * (b.y() * c.z() - b.z() * c.y()) + a.y() * (b.z() * c.x() - b.x() * c.z()) +
                             a.z() * (b.x() * c.y() - b.y() * c.x());
  TriangleMesh mesh;
  mesh.vertices.assign(corners.begin(), corners.end());
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  mesh.name = "tetrahedron";
  return six_volumes > 0 ? mesh : inverted(std::move(mesh));
}

TriangleMesh spike() {
  return tetrahedron({{{0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}}});
}

TriangleMesh keel() {
  return tetrahedron({{{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}});
}

TriangleMesh ridge() {
  return tetrahedron({{{0, -1, 0}, {0, 1, 0}, {-1, 0, -1}, {1, 0, -1}}});
}

TriangleMesh joined(TriangleMesh first, const TriangleMesh& second) {
  const Index offset = static_cast<Index>(first.vertices.size());
  first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const auto& [a, b, c] : second.faces) first.faces.push_back({a + offset, b + offset, c + offset});
  return first;
}

TriangleMesh inverted(TriangleMesh mesh) {
  for (Triangle& face : mesh.faces) std::swap(face[1], face[2]);
  return mesh;
}

}  // namespace pcm::degenerate
