// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/proofs/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

#include "meshes/base/floating_point_environment.h"
#include "reference/crossings/candidates.h"

namespace pcm::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

struct Face {
  std::array<Index, 3> vertices;
  std::array<Point, 3> points;
  Kernel::Triangle_3 triangle() const { return {points[0], points[1], points[2]}; }
};

/// The corner that `face` has beside those shared with `other` (exactly one of three is not).
const Point& corner_apart(const Face& face, const Face& other) {
  for (int i = 0; i < 3; ++i)
    if (std::find(other.vertices.begin(), other.vertices.end(), face.vertices[i]) == other.vertices.end())
      return face.points[i];
  return face.points[0];
}

/// Faces with a common edge have more in common only where one is folded flat upon the other.
bool folded_flat(const Face& a, const Face& b, const Point& u, const Point& v) {
  const Point &p = corner_apart(a, b), &q = corner_apart(b, a);
  return CGAL::coplanar(u, v, p, q) && CGAL::coplanar_orientation(u, v, p, q) == CGAL::POSITIVE;
}

/// With one common vertex: the edge opposite to it of one face must meet the other.
bool opposite_edge_meets(const Face& a, int shared, const Face& b) {
  const Kernel::Segment_3 edge(a.points[(shared + 1) % 3], a.points[(shared + 2) % 3]);
  return CGAL::do_intersect(edge, b.triangle());
}

bool intersect(const Face& a, const Face& b) {
  std::vector<std::pair<int, int>> shared;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (a.vertices[i] == b.vertices[j]) shared.emplace_back(i, j);
  if (shared.size() == 3) return true;
  if (a.triangle().is_degenerate() || b.triangle().is_degenerate()) return false;  // reported as zero-area elsewhere
  if (shared.size() == 2) return folded_flat(a, b, a.points[shared[0].first], a.points[shared[1].first]);
  if (shared.size() == 1)
    return opposite_edge_meets(a, shared[0].first, b) || opposite_edge_meets(b, shared[0].second, a);
  return CGAL::do_intersect(a.triangle(), b.triangle());
}

}  // namespace

std::vector<std::pair<Index, Index>> self_intersections(const TriangleMesh& mesh) {
  const DefaultFloatingPoint environment;
  std::vector<Face> faces;
  for (const Triangle& t : mesh.faces) {
    Face face{t, {}};
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d& p = mesh.vertices[t[i]];
      face.points[i] = Point(p[0], p[1], p[2]);
    }
    faces.push_back(face);
  }
  std::vector<std::pair<Index, Index>> found;
  const BoxTree tree(boxes_of_faces(mesh));
  for (const auto& [a, b] : meeting_boxes(tree, tree))
    if (a < b && intersect(faces[a], faces[b])) found.emplace_back(a, b);
  return found;
}

}  // namespace pcm::reference
