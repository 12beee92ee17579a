// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "fast/base/box_tree.h"
#include "fast/base/on_demand.h"
#include "fast/surface/wide_tree.h"
#include "pcm/triangle_mesh.h"

namespace pcm::fast {

/// For each of some items the entries that belong to it: those of item i are entries[begin[i] .. begin[i + 1]).
struct Incidence {
  struct Span {
    const Index* first;
    const Index* last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };
  std::vector<Index> offset;
  std::vector<Index> entries;

  std::size_t items() const { return offset.size() - 1; }
  Span operator[](Index item) const {
    const auto i = static_cast<std::size_t>(item);
    return {entries.data() + offset[i], entries.data() + offset[i + 1]};
  }
};

/// Which corner of a face a vertex is, or -1.
inline int corner_at(const Triangle& face, Index vertex) {
  for (int k = 0; k < 3; ++k) {
    if (face[static_cast<std::size_t>(k)] == vertex) return k;
  }
  return -1;
}

/// What surely is free of other faces of the same surface on either side of a face (fast/surface/clearance.h): a line
/// that passes through the face's interior, within one of two cones about its normal, meets no other face at a lesser
/// depth than that.
struct Clearance {
  std::array<float, 2> beneath{};  ///< against the normal, in units of the greatest coordinate; 0: nothing is known
  std::array<bool, 2> above{};     ///< whether nothing is met on the side of the normal, however far
};

/// Lower bounds of the distance from any point of a face along its inward normal to the next face of the same surface
/// (fast/surface/thickness.h), m; infinite where nothing lies beneath.
struct ThicknessEverywhere {
  /// Faces that share no vertex with it are no nearer, also beneath lines that are a little off; of the others
  /// `clear_of_neighbours` tells. At most `exact`.
  double tolerant = 0;
  /// No other face has a point strictly within the prism beneath the face, and nearer, exactly in the surface's own
  /// frame: what stands upright on the prism's border does not count. 0 where a neighbour folds back beneath the face
  /// by however little.
  double exact = 0;
  /// The same for the surface as a pose rounds its vertices (F's). Faces that touch the master's plane from above count
  /// as beneath it, for rounding may fold them under; what stands upright on the prism's sides does not count, though
  /// it may reach in by a rounding. At most `exact`.
  double rounded = 0;
  /// No face that shares a vertex with it reaches beneath it, by more than the tolerance: at each of its corners either
  /// all faces look its way, or each lies beside one of its sides. False where it stands upright.
  bool clear_of_neighbours = false;
};

/// What is derived from a mesh once, in the surface's own frame; read by every step of the evaluation. What costs most,
/// what each face has of its own surface near it, waits until a contact asks for that face.
struct PreparedSurface {
  TriangleMesh mesh;
  /// Edges as pairs (smaller, greater vertex), in lexicographic order: comparing edge indices compares the pairs.
  std::vector<std::array<Index, 2>> edges;
  std::vector<bool> border_edges;                     ///< by edge: it belongs to one face only
  std::vector<std::array<Index, 3>> face_edges;       ///< edge k of a face joins its vertices k and k + 1
  std::vector<std::array<Index, 3>> face_neighbours;  ///< beyond edge k; the face itself where that is a border
  Incidence vertex_edges;                             ///< ascending
  Incidence vertex_faces;                             ///< ascending
  std::vector<Index> face_component;                  ///< component (connected by edges) of each face
  Incidence component_faces;                          ///< ascending
  std::vector<Box> component_boxes;
  bool closed = true;  ///< no border edge at all (rule: a surface is open as a whole)
  BoxTree tree;
  WideTree wide_tree;                                         ///< the same boxes, eight at once
  Eigen::Vector3d max_coordinates = Eigen::Vector3d::Zero();  ///< greatest |coordinate| along each axis, m
  double usual_edge = 0;                                      ///< median length of an edge, m
  Index fewest_vertices = 0;                                  ///< of a component
  // By face, on demand: thickness, thickness_everywhere, exit_depth and clearance of fast/surface read them.
  OnDemand<double> known_thickness;
  OnDemand<ThicknessEverywhere> known_thickness_everywhere;
  OnDemand<double> known_exit_depth;
  OnDemand<Clearance> known_clearance;

  const Triangle& face(Index f) const { return mesh.faces[static_cast<std::size_t>(f)]; }
  const Eigen::Vector3d& vertex(Index v) const { return mesh.vertices[static_cast<std::size_t>(v)]; }
  std::array<Eigen::Vector3d, 3> points_of(Index f) const {
    return {vertex(face(f)[0]), vertex(face(f)[1]), vertex(face(f)[2])};
  }
  const std::array<Index, 2>& edge(Index e) const { return edges[static_cast<std::size_t>(e)]; }
  const std::array<Index, 3>& edges_of(Index f) const { return face_edges[static_cast<std::size_t>(f)]; }
  const std::array<Index, 3>& neighbours_of(Index f) const { return face_neighbours[static_cast<std::size_t>(f)]; }
  /// Whether edge k of a face, from its vertex k on, runs the way that edge runs in `edges`.
  bool runs_forwards(Index f, std::size_t k) const { return face(f)[k] < face(f)[k == 2 ? 0 : k + 1]; }
  Index other_end(Index e, Index v) const { return edge(e)[0] == v ? edge(e)[1] : edge(e)[0]; }
  bool border(Index e) const { return border_edges[static_cast<std::size_t>(e)]; }
};

}  // namespace pcm::fast
