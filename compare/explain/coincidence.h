// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>
#include <optional>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

/// What coincides in a pose, or nearly does, as the rounded problem has it (PCM section 1). Numbers of vertices and
/// faces count from 0.
namespace pcm::compare {

enum class FeatureKind : std::uint8_t {
  vertex,
  edge,
  face,
  line,        ///< the penetration line of a master face (PCM section 6)
  barycentre,  ///< of a master face
};

/// A vertex, an edge without its ends, a face without its border; or what belongs to a master face.
struct Feature {
  FeatureKind kind = FeatureKind::vertex;
  Side side = Side::E;
  std::array<Index, 2> index{-1, -1};  ///< of an edge its ends, the smaller one first; otherwise {number, -1}
  auto operator<=>(const Feature&) const = default;
};

inline Feature vertex_feature(Side side, Index v) {
  return {FeatureKind::vertex, side, {v, -1}};
}
inline Feature edge_feature(Side side, const std::array<Index, 2>& ends) {
  return {FeatureKind::edge, side, ends};
}
inline Feature face_feature(Side side, Index f) {
  return {FeatureKind::face, side, {f, -1}};
}

/// In the order in which they are told where margins are equal: what says most comes first.
enum class CoincidenceKind : std::uint8_t {
  coplanar_faces,       ///< a face of each in one plane, with a common part of positive area
  edge_in_face,         ///< an edge of one in the plane of a face of the other, with a common part of positive length
  edge_along_edge,      ///< an edge of each on one line, with a common part of positive length
  vertex_on_vertex,     ///< a vertex of each in one point
  vertex_on_edge,       ///< a vertex of one on an edge of the other
  edge_across_edge,     ///< an edge of each meet in a point
  vertex_on_face,       ///< a vertex of one in a face of the other
  line_in_face,         ///< a penetration line in the plane of a slave face that it passes over
  line_through_vertex,  ///< a penetration line passes through a vertex of the slave
  line_through_edge,    ///< a penetration line passes through an edge of the slave
  barycentre_on_face,   ///< the barycentre of a master face in a face of the slave
};
inline constexpr std::size_t kCoincidenceKinds = 11;

struct Coincidence {
  CoincidenceKind kind = CoincidenceKind::coplanar_faces;
  std::array<Feature, 2> features;  ///< of E and of F; of the master and of the slave
  /// How far apart the nearest points of the features are, those being inside both; correctly rounded, m; 0 only where
  /// they coincide exactly. Of coplanar faces, edges in a face or along an edge and lines in a face: of the places
  /// where they are nearest to each other, the last one that it takes to make such a pair.
  double margin = 0;
  Eigen::Vector3d position_Me = Eigen::Vector3d::Zero();  ///< where, m, rounded
  /// Unit vector from the first feature to the second, where they coincide the one along which they part soonest; zero
  /// where that is no single one.
  Eigen::Vector3d apart_Me = Eigen::Vector3d::Zero();
  std::optional<bool> equal_normals;  ///< coplanar faces: otherwise opposite

  bool exact() const { return margin == 0; }
};

/// Whether two of what nearly coincides, within `width`, m, are two places and not one that is told twice. Exact ones
/// always are: of these each place is told once.
bool are_different_places(const Coincidence& a, const Coincidence& b, double width);

/// Nearest ones first, then by kind and features.
void sort_by_margin(std::vector<Coincidence>& coincidences);

/// Nearly coincident features are told once, by the smallest ones: a vertex that is near to another is near to all
/// edges and faces there as well. Takes away what is told by parts of its features; what coincides exactly stays.
void leave_out_told_by_parts(std::vector<Coincidence>& coincidences, const TriangleMesh& mesh_E,
                             const TriangleMesh& mesh_F);

}  // namespace pcm::compare
