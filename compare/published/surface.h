// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "compare/published/box_tree.h"
#include "fast/base/fast_clear_array.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare::published {

/// A surface with its tree and who neighbours whom, which is what the paper's doubly connected edge list is used for
/// (figure 7). Immutable. The mesh must be fit for contact.
struct Surface {
  explicit Surface(TriangleMesh surface_mesh);

  TriangleMesh mesh;
  BoxTree tree;                                  ///< of the faces
  std::vector<std::array<Index, 2>> edges;       ///< ends, the smaller index first
  std::vector<std::array<Index, 3>> face_edges;  ///< edge k of a face joins its vertices k and k + 1
  /// Edges and faces at each vertex: those of vertex v are entries offset[v] to offset[v + 1].
  struct AtVertex {
    std::vector<Index> offset, entries;
    std::pair<const Index*, const Index*> operator[](Index vertex) const {
      const auto v = static_cast<std::size_t>(vertex);
      return {entries.data() + offset[v], entries.data() + offset[v + 1]};
    }
  };
  AtVertex vertex_edges, vertex_faces;
  double size = 0;  ///< greatest extent along an axis of its frame, m

  const Triangle& face(Index f) const { return mesh.faces[static_cast<std::size_t>(f)]; }
  const std::array<Index, 2>& edge(Index e) const { return edges[static_cast<std::size_t>(e)]; }
};

/// A face in Me, of the vertices that the rounded problem has.
struct PosedFace {
  std::array<Eigen::Vector3d, 3> points_Me;
  Eigen::Vector3d N_Me;  ///< (p1 - p0) x (p2 - p0), outward, m^2
};

/// The faces of a surface in Me, each formed when first asked for, once a pose.
class PosedFaces {
 public:
  /// `pose` is that of F; nullptr where the surface is E's, which does not move. Both must outlive the use.
  void place(const Surface& surface, const Pose* pose) {
    surface_ = &surface;
    pose_ = pose;
    const std::size_t faces = surface.mesh.faces.size();
    known_.start(faces);
    if (faces_.size() < faces) faces_.resize(faces);
  }

  const Surface& surface() const { return *surface_; }
  const PosedFace& operator[](Index f) {
    PosedFace& face = faces_[static_cast<std::size_t>(f)];
    if (!known_.contains(f)) {
      known_[f] = true;
      form(f, face);
    }
    return face;
  }

 private:
  void form(Index f, PosedFace& face) const;

  const Surface* surface_ = nullptr;
  const Pose* pose_ = nullptr;
  std::vector<PosedFace> faces_;
  fast::FastClearArray<bool> known_;
};

}  // namespace pcm::compare::published
