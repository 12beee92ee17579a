// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <tuple>

namespace pcm::compare::published {
namespace {

/// Sorts (vertex, entry) pairs into lists by vertex, in the order given.
Surface::AtVertex at_vertices(std::size_t vertices, const std::vector<std::array<Index, 2>>& pairs) {
  Surface::AtVertex lists;
  lists.offset.assign(vertices + 1, 0);
  for (const auto& [vertex, entry] : pairs) ++lists.offset[static_cast<std::size_t>(vertex) + 1];
  std::partial_sum(lists.offset.begin(), lists.offset.end(), lists.offset.begin());
  lists.entries.resize(pairs.size());
  std::vector<Index> next(lists.offset.begin(), lists.offset.end() - 1);
  for (const auto& [vertex, entry] : pairs)
    lists.entries[static_cast<std::size_t>(next[static_cast<std::size_t>(vertex)]++)] = entry;
  return lists;
}

}  // namespace

Surface::Surface(TriangleMesh surface_mesh) : mesh(std::move(surface_mesh)), face_edges(mesh.faces.size()) {
  struct HalfEdge {
    Index from, to, face;
    std::size_t side;
  };
  std::vector<HalfEdge> half_edges;
  std::vector<Box> boxes;
  std::vector<std::array<Index, 2>> faces_at;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Triangle& face = mesh.faces[f];
    std::array<Eigen::Vector3d, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = mesh.vertices[static_cast<std::size_t>(face[k])];
      const auto [from, to] = std::minmax(face[k], face[(k + 1) % 3]);
      half_edges.push_back({from, to, static_cast<Index>(f), k});
      faces_at.push_back({face[k], static_cast<Index>(f)});
    }
    boxes.push_back(box_about(points.data(), points.data() + points.size()));
  }
  std::sort(half_edges.begin(), half_edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.from, a.to, a.face) < std::tie(b.from, b.to, b.face);
  });
  std::vector<std::array<Index, 2>> edges_at;
  for (const HalfEdge& half : half_edges) {
    if (edges.empty() || edges.back() != std::array{half.from, half.to}) {
      edges.push_back({half.from, half.to});
      for (const Index end : edges.back()) edges_at.push_back({end, static_cast<Index>(edges.size() - 1)});
    }
    face_edges[static_cast<std::size_t>(half.face)][half.side] = static_cast<Index>(edges.size() - 1);
  }
  tree = BoxTree(boxes);
  vertex_edges = at_vertices(mesh.vertices.size(), edges_at);
  vertex_faces = at_vertices(mesh.vertices.size(), faces_at);
  const std::array<double, 3>& half = tree[0].box.half;
  size = 2 * *std::max_element(half.begin(), half.end());
}

void PosedFaces::form(Index f, PosedFace& face) const {
  const Triangle& corners = surface_->face(f);
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& x = surface_->mesh.vertices[static_cast<std::size_t>(corners[k])];
    if (pose_ == nullptr) {
      face.points_Me[k] = x;
      continue;
    }
    for (int i = 0; i < 3; ++i)
      face.points_Me[k][i] = ((pose_->A(i, 0) * x[0] + pose_->A(i, 1) * x[1]) + pose_->A(i, 2) * x[2]) + pose_->r[i];
  }
  face.N_Me = (face.points_Me[1] - face.points_Me[0]).cross(face.points_Me[2] - face.points_Me[0]);
}

}  // namespace pcm::compare::published
