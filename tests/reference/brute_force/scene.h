// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"
#include "reference/vocabulary/answer.h"
#include "tests/reference/brute_force/rational.h"

namespace pcm::brute_force {

using Edge = std::array<Index, 2>;  ///< smaller vertex index first

inline Edge edge_between(Index a, Index b) {
  return a < b ? Edge{a, b} : Edge{b, a};
}

/// One surface in Me, its coordinates scaled to integers.
struct Body {
  std::vector<Vector> vertices;
  std::vector<Triangle> faces;
  std::vector<Vector> normals;  ///< N = (q - p) x (s - p) of each face, not normalised
  std::map<Edge, std::vector<Index>> faces_of_edge;
  Index first_rank = 0;  ///< rank of vertex 0 in the tie rule: E's vertices first, then F's
  bool closed = true;    ///< no border edge at all

  const Vector& corner(Index face, int i) const { return vertices[faces[face][i]]; }
};

/// Both surfaces in one pose. All coordinates are dyadic, so a power of two makes them integers.
struct Scene {
  Body E;
  Body F;
  Vector r_MeMf;         ///< in units
  Rational unit;         ///< m
  Index rank_count = 0;  ///< vertices of both

  const Body& body(Side side) const { return side == Side::E ? E : F; }
};

inline Side other(Side side) {
  return side == Side::E ? Side::F : Side::E;
}

/// x_E = A x_F + r with each operation rounded, in the order PCM section 1 lays down.
Eigen::Vector3d rounded_point(const Eigen::Vector3d& x, const Pose& pose);

Scene scene_of(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Pose& pose, reference::Problem problem);

/// A point with its place in the order of the tie rule.
struct RankedPoint {
  const Vector* x = nullptr;
  Index rank = 0;
};

/// Sign of ((b - a) x (c - a)) . (d - a), never zero for four different ranks: +1 if d is above the triangle (a, b, c).
int orientation(const RankedPoint& a, const RankedPoint& b, const RankedPoint& c, const RankedPoint& d);

/// How the segment from a to b passes the triangle: +1 from above to below, -1 from below to above, 0 not at all.
int passage(const RankedPoint& a, const RankedPoint& b, const std::array<RankedPoint, 3>& triangle);

RankedPoint ranked(const Body& body, Index vertex);
std::array<RankedPoint, 3> ranked_face(const Body& body, Index face);

}  // namespace pcm::brute_force
