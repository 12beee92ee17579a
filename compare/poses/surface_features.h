// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// An edge with its one (border) or two faces.
struct FeatureEdge {
  std::array<Index, 2> ends{};
  std::vector<Index> faces;
};

/// A face in a plane orthogonal to a coordinate axis, all three coordinates bit for bit the same.
struct AxisFace {
  Index face = 0;
  int axis = 0;  ///< 0, 1, 2 for x, y, z
  int sign = 1;  ///< of the outward normal along the axis
};

/// What the strata need to know of a surface, in the frame of its own marker; computed once. Only + - * / sqrt.
/// O(n log n), and O(n) a candidate for the inner ball.
struct SurfaceFeatures {
  explicit SurfaceFeatures(const TriangleMesh& mesh);

  /// Vertex farthest along `direction`, of those that a face uses: the first one of equals. O(n).
  Index support(const Eigen::Vector3d& direction) const;
  /// Sum of the vector areas of the faces at a vertex; its direction is an outward normal there (null at a pinnacle
  /// that folds back on itself).
  Eigen::Vector3d vertex_normal(Index vertex) const { return vertex_normals[static_cast<std::size_t>(vertex)]; }
  /// Twice the vector area of a face; where that rounds to 0, as a needle's may, a vector along it of less than 2^-900
  /// m^2.
  Eigen::Vector3d face_normal(Index face) const;
  /// The faces at an edge of the surface, its smaller vertex first. O(log n).
  const std::vector<Index>& faces_at(const std::array<Index, 2>& ends) const;

  const TriangleMesh& mesh;
  std::vector<Index> used_vertices;  ///< ascending
  std::vector<FeatureEdge> edges;    ///< ordered by their ends
  std::vector<Eigen::Vector3d> vertex_normals;
  std::vector<AxisFace> axis_faces;
  Eigen::Vector3d box_min = Eigen::Vector3d::Zero();
  Eigen::Vector3d box_max = Eigen::Vector3d::Zero();
  double size = 0;      ///< greatest extent of the bounding box, m
  bool closed = false;  ///< no border edge
};

inline const Eigen::Vector3d& vertex(const SurfaceFeatures& surface, Index v) {
  return surface.mesh.vertices[static_cast<std::size_t>(v)];
}

/// A ball inside a closed surface: no surface point is nearer to the centre than the radius.
struct InnerBall {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;  ///< m; 0 where no ball was found
};

/// A large inner ball, the best of a fixed number of candidates (a face's barycentre moved inward by halves of the
/// size): large, not largest. O(n) a candidate.
InnerBall inner_ball(const SurfaceFeatures& features);

/// Radius about the centre of the bounding box that holds all of the surface, m.
double bounding_radius(const SurfaceFeatures& features);

/// Radius about the origin that holds all of the surface, m.
double radius_about_origin(const TriangleMesh& mesh);

}  // namespace pcm::compare
