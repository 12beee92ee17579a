// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/degenerate/catalogue.h"

namespace pcm::degenerate {
namespace {

/// Two arms along x, one above the other, joined at x = 1.
TriangleMesh clamp() {
  std::vector<std::array<int, 3>> cubes;
  for (const int j : {1, 2}) {
    cubes.push_back({1, j, 1});
    for (int i = 1; i < 6; ++i)
      for (const int k : {0, 2}) cubes.push_back({i, j, k});
  }
  return union_of_cubes(cubes);
}

}  // namespace

std::vector<Case> meeting_features() {
  // The block's top, z = 2, is split along the diagonal from (0, 0) to (4, 4).
  const TriangleMesh block = generate::box({0, 0, 0}, {4, 4, 2});
  // Barycentre of the top at the origin: its penetration line is the negative z axis.
  const TriangleMesh funnel = tetrahedron({{{-3, -3, 0}, {3, -3, 0}, {0, 6, 0}, {0, 0, -9}}});
  return {
      shifted_pair("vertex_on_vertex", "a vertex of F on a vertex of E, nothing else meets", block, spike(), 0,
                   {4, 4, 2}),
      shifted_pair("vertex_on_edge", "a vertex of F on an edge of E", block, spike(), 0, {4, 1, 2}),
      shifted_pair("vertex_on_face", "a vertex of F inside a face of E", block, spike(), 0, {3, 1, 2}),
      shifted_pair("vertex_on_flat_edge", "a vertex of F on an edge between coplanar faces of E", block, spike(), 0,
                   {2, 2, 2}),
      shifted_pair("vertex_under_edge", "a vertex of E on an edge of F",
                   tetrahedron({{{0, 0, 0}, {1, 0, -1}, {-1, 1, -1}, {-1, -1, -1}}}), keel(), 0, {0, 0, 0}),
      shifted_pair("edge_across_edge", "an edge of F meets an edge of E in a point", ridge(), keel(), 0, {0, 0, 0}),
      shifted_pair("edge_in_face", "an edge of F inside a face of E", block, keel(), 0, {2.5, 1, 2}),
      shifted_pair("edge_across_flat_edge", "an edge of F in the plane of two faces of E, across their common edge",
                   block, keel(), 0, {2, 2, 2}),
      shifted_pair("edge_over_edge", "an edge of F in the plane of a face of E, half beyond its border", block, keel(),
                   0, {4, 1, 2}),
      shifted_pair("parallel_coincident_edges", "an edge of F along the middle of an edge of E", block, keel(), 0,
                   {2, 4, 2}),
      shifted_pair("shared_edge", "boxes that have one edge in common", generate::box({0, 0, 0}, {2, 2, 2}),
                   generate::box({0, 0, 0}, {2, 2, 2}), 0, {2, 0, 2}),
      shifted_pair("shared_vertex", "boxes that have one vertex in common", generate::box({0, 0, 0}, {2, 2, 2}),
                   generate::box({0, 0, 0}, {2, 2, 2}), 0, {2, 2, 2}),
      shifted_pair("edge_through_vertex", "an edge of F enters E through a vertex", generate::box({0, 0, 0}, {2, 2, 2}),
                   tetrahedron({{{1, 1, 1}, {3, 3, 3}, {3, 1, 2}, {1, 3, 3}}}), std::nullopt, {0, 0, 0}),
      shifted_pair("line_along_flat_edge", "the intersection line runs along an edge between coplanar faces of E",
                   block, tetrahedron({{{1, 1, 1}, {3, 3, 1}, {2, 2, 5}, {3, 1, 3}}}), std::nullopt, {0, 0, 0}),
      shifted_pair("line_along_edge_of_E", "the intersection line runs along an edge of E, inside a face of F", ridge(),
                   generate::box({0, -2, -2}, {2, 2, 2}), 1.0 / 3, {0, 0, 0}),
      shifted_pair("line_along_edges_of_both", "the intersection line runs along an edge of E and of F", ridge(),
                   generate::box({0, -2, -2}, {2, 2, 0}), 1.0 / 3, {0, 0, 0}),
      shifted_pair("penetration_line_through_vertex", "a barycentre's normal line meets F in a vertex", funnel, spike(),
                   1.0 / 12, {0, 0, -0.5}),
      shifted_pair("penetration_line_through_edge", "a barycentre's normal line meets F in an edge", funnel, keel(),
                   1.0 / 3, {0, 0, -0.5}),
      shifted_pair("penetration_line_through_sheets",
                   "a barycentre's normal line leaves F, enters it again and leaves it",
                   generate::box({0.25, 0.375, -8}, {6.25, 6.375, 2.5}), clamp(), 17, {0, 0, 0}),
      // Barycentres of the top: (4, 2) and (2, 4).
      shifted_pair("penetration_line_in_face", "a barycentre's normal line lies in the plane of a face of F, inside it",
                   generate::box({0, 0, -4}, {6, 6, 0}), generate::box({4, 0.5, -1}, {5.5, 3.5, 1}), 4.5, {0, 0, 0}),
      shifted_pair("penetration_line_along_edge", "a barycentre's normal line runs along an edge of F",
                   generate::box({0, 0, -4}, {6, 6, 0}), generate::box({4, 2, -1}, {5, 3, 1}), 1, {0, 0, 0}),
  };
}

}  // namespace pcm::degenerate
