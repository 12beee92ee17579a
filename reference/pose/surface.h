// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "pcm/triangle_mesh.h"
#include "reference/pose/box_tree.h"

namespace pcm::reference {

/// A surface with its adjacency, as every step needs it. Built once; immutable afterwards.
struct Surface {
  TriangleMesh mesh;
  std::vector<std::array<Index, 2>> edges;       ///< end vertices, smaller index first, ascending
  std::vector<std::array<Index, 2>> edge_faces;  ///< the one or two faces of an edge; kNone where a border
  std::vector<std::array<Index, 3>> face_edges;  ///< edge from corner i to corner i + 1
  std::vector<std::vector<Index>> vertex_faces;  ///< faces around a vertex
  std::vector<Index> component;                  ///< of a face: faces joined by shared edges
  Index components = 0;
  bool closed = true;  ///< no border edge at all
  BoxTree tree;        ///< of the faces, in the body's own frame
};

/// O(n log n). The mesh must be fit for contact: at most two faces an edge, indices in range.
Surface make_surface(TriangleMesh mesh);

/// Where `edge` (smaller index first) stands in `surface.edges`.
Index find_edge(const Surface& surface, std::array<Index, 2> edge);

}  // namespace pcm::reference
