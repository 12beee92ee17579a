// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>

#include "pcm/triangle_mesh.h"

/// Handmade surfaces for the tests of check().
namespace pcm {

/// [0, 1]^3; vertex number = x + 2 y + 4 z.
inline TriangleMesh cube() {
  TriangleMesh mesh;
  mesh.name = "cube";
  for (int i = 0; i < 8; ++i) mesh.vertices.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  const std::array<std::array<Index, 4>, 6> quads{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& [a, b, c, d] : quads) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
  }
  return mesh;
}

/// Vertices of equal coordinates become one.
inline TriangleMesh weld(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.name = mesh.name;
  std::map<std::array<double, 3>, Index> index;
  std::vector<Index> renumbered;
  for (const Eigen::Vector3d& p : mesh.vertices) {
    const auto [it, is_new] = index.insert({{p.x(), p.y(), p.z()}, static_cast<Index>(result.vertices.size())});
    if (is_new) result.vertices.push_back(p);
    renumbered.push_back(it->second);
  }
  for (const Triangle& face : mesh.faces)
    result.faces.push_back({renumbered[face[0]], renumbered[face[1]], renumbered[face[2]]});
  return result;
}

/// A strip of five triangles whose ends are joined with a half turn: the smallest triangulation of a Moebius strip.
inline TriangleMesh moebius_strip() {
  TriangleMesh mesh;
  mesh.name = "strip";
  mesh.vertices = {{0, 0, 0}, {5, 1, 0}, {6, 6, 2}, {1, 7, 3}, {2, 3, 9}};
  for (Index i = 0; i < 5; ++i) {
    const Index next = (i + 1) % 5;
    const Index after = (i + 2) % 5;
    mesh.faces.push_back(i % 2 == 0 ? Triangle{i, next, after} : Triangle{next, i, after});
  }
  return mesh;
}

/// The closed slab [0, n] x [0, n] x [0, 1] with top and bottom cut into n^2 squares each: 4 n (n + 2) faces.
inline TriangleMesh slab_on_a_grid(Index n) {
  TriangleMesh mesh;
  const Index layer = (n + 1) * (n + 1);
  const auto at = [&](Index i, Index j, Index k) { return k * layer + i * (n + 1) + j; };
  const auto add_quad = [&](Index a, Index b, Index c, Index d) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
  };
  for (Index k = 0; k < 2; ++k)
    for (Index i = 0; i <= n; ++i)
      for (Index j = 0; j <= n; ++j) mesh.vertices.emplace_back(i, j, k);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      add_quad(at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1));
      add_quad(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0));
    }
    add_quad(at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 0, 1), at(i, 0, 1));
    add_quad(at(i + 1, n, 0), at(i, n, 0), at(i, n, 1), at(i + 1, n, 1));
    add_quad(at(0, i + 1, 0), at(0, i, 0), at(0, i, 1), at(0, i + 1, 1));
    add_quad(at(n, i, 0), at(n, i + 1, 0), at(n, i + 1, 1), at(n, i, 1));
  }
  return mesh;
}

}  // namespace pcm
