// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/degenerate/bodies.h"

#include <cstddef>
#include <map>
#include <set>
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

TriangleMesh union_of_cubes(const std::vector<std::array<int, 3>>& corners) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, Index> numbers;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = numbers.emplace(at, static_cast<Index>(mesh.vertices.size()));
    if (is_new) mesh.vertices.emplace_back(at[0], at[1], at[2]);
    return found->second;
  };
  const std::set<std::array<int, 3>> cubes(corners.begin(), corners.end());
  for (const std::array<int, 3>& cube : cubes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        std::array<int, 3> neighbour = cube;
        neighbour[axis] += 2 * side - 1;
        if (cubes.count(neighbour) > 0) continue;
        const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
        // Counterclockwise about the axis, seen from its end.
        std::array<Index, 4> square{};
        for (std::size_t k = 0; k < 4; ++k) {
          std::array<int, 3> at = cube;
          at[axis] += side;
          at[next] += k == 1 || k == 2;
          at[last] += k >= 2;
          square[k] = vertex(at);
        }
        if (side == 0) std::swap(square[1], square[3]);
        mesh.faces.push_back({square[0], square[1], square[2]});
        mesh.faces.push_back({square[0], square[2], square[3]});
      }
  mesh.name = "cubes";
  return mesh;
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
