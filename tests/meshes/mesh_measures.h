// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

#include "pcm/triangle_mesh.h"

/// Plain measures of a mesh for the tests of the generators, written without the code they test.
namespace pcm::test {

/// Signed volume by the divergence theorem, m^3; positive where closed and outward.
inline double signed_volume(const TriangleMesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    six_volumes += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
  }
  return six_volumes / 6;
}

inline double area(const TriangleMesh& mesh) {
  double double_area = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    double_area += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return double_area / 2;
}

/// Number of border edges, or -1 where an edge's direction is used twice (non-manifold or inconsistently oriented).
inline int border_edges(const TriangleMesh& mesh) {
  std::set<std::array<Index, 2>> directed;
  for (const Triangle& face : mesh.faces) {
    for (int i = 0; i < 3; ++i) {
      if (!directed.insert({face[i], face[(i + 1) % 3]}).second) return -1;
    }
  }
  return static_cast<int>(std::count_if(directed.begin(), directed.end(), [&](const auto& e) {
    return !directed.count({e[1], e[0]});
  }));
}

/// Vertices - edges + faces of a closed mesh: 2 - 2 genus for one component.
inline int euler_characteristic(const TriangleMesh& mesh) {
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.faces.size() * 3 / 2) +
         static_cast<int>(mesh.faces.size());
}

/// Empty where the mesh has no duplicate and no unused vertex, every index in range, no face without an area and every
/// coordinate finite; else what is wrong.
inline std::string flaw(const TriangleMesh& mesh) {
  std::set<std::array<double, 3>> positions;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    if (!vertex.allFinite()) return "vertex not finite";
    if (!positions.insert({vertex.x(), vertex.y(), vertex.z()}).second) return "duplicate vertex";
  }
  std::set<Index> used;
  for (const Triangle& face : mesh.faces) {
    for (const Index i : face) {
      if (i < 0 || i >= static_cast<Index>(mesh.vertices.size())) return "index out of range";
      used.insert(i);
    }
    const auto& [a, b, c] = face;
    const Eigen::Vector3d normal = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    if (!(normal.norm() > 0)) return "face without an area";
  }
  if (used.size() != mesh.vertices.size()) return "unused vertex";
  return "";
}

}  // namespace pcm::test
