// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/prism/projected_face.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::fast {

namespace {

/// Whether one of a's sides has all of b on its far side. A corner that both share lies on its sides exactly.
bool side_separates(const ProjectedFace& a, const ProjectedFace& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const PrismPoint& from = a.corners[k];
    const PrismPoint& to = a.corners[(k + 1) % 3];
    if (cross_st(from, to, b.corners[0]) <= 0 && cross_st(from, to, b.corners[1]) <= 0 &&
        cross_st(from, to, b.corners[2]) <= 0) {
      return true;
    }
  }
  return false;
}

/// Adds the overlaps of two faces of positive area, where they have any: one for each of them that carries.
void add_overlaps(const std::vector<ProjectedFace>& faces, std::size_t i, std::size_t j,
                  std::vector<Overlap>& overlaps) {
  const ProjectedFace& f = faces[i];
  const ProjectedFace& g = faces[j];
  if (!(f.carries || g.carries) || !(f.low_s < g.high_s && g.low_s < f.high_s)) return;
  if (!(f.low_t < g.high_t && g.low_t < f.high_t)) return;
  if (side_separates(f, g) || side_separates(g, f)) return;
  if (f.carries) overlaps.emplace_back(i, j);
  if (g.carries) overlaps.emplace_back(j, i);
}

}  // namespace

bool project_face(const std::array<Index, 3>& vertices, const std::array<PrismPoint, 3>& corners, ProjectedFace& face) {
  for (int weight = 0; weight < 3; ++weight) {
    if (!(std::max({corners[0][weight], corners[1][weight], corners[2][weight]}) > 0)) return false;
  }
  if (!(std::max({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]}) >= 0)) return false;
  const double twice_area = cross_st(corners[0], corners[1], corners[2]);
  if (!(std::abs(twice_area) > 0)) return false;
  face.leaves = twice_area < 0;
  const std::array<std::size_t, 3> order{0, face.leaves ? 2U : 1U, face.leaves ? 1U : 2U};
  ConvexPolygon& seen = face.seen;
  seen.count = 3;
  seen.cuts = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    face.vertices[k] = vertices[order[k]];
    face.corners[k] = seen.points[k] = corners[order[k]];
  }
  for (int coordinate = 0; coordinate <= kDepth; ++coordinate) {
    // A polygon of no corner beyond a side stays beyond none.
    if (std::min({corners[0][coordinate], corners[1][coordinate], corners[2][coordinate]}) >= 0) continue;
    keep_where_not_negative(seen, coordinate);
    if (seen.empty()) return false;
  }
  face.low_s = face.low_t = std::numeric_limits<double>::infinity();
  face.high_s = face.high_t = -face.low_s;
  for (int i = 0; i < seen.count; ++i) {
    if (seen[i][kDepth] < 0) seen[i][kDepth] = 0;
    face.low_s = std::min(face.low_s, seen[i][kS]);
    face.high_s = std::max(face.high_s, seen[i][kS]);
    face.low_t = std::min(face.low_t, seen[i][kT]);
    face.high_t = std::max(face.high_t, seen[i][kT]);
  }
  return true;
}

void find_overlaps(const std::vector<ProjectedFace>& faces, std::vector<std::size_t>& order,
                   std::vector<Overlap>& overlaps) {
  overlaps.clear();
  order.clear();
  for (std::size_t i = 0; i < faces.size(); ++i) order.push_back(i);
  std::sort(order.begin(), order.end(), [&faces](std::size_t a, std::size_t b) {
    return faces[a].low_s < faces[b].low_s || (faces[a].low_s == faces[b].low_s && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const ProjectedFace& f = faces[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (!(faces[order[j]].low_s < f.high_s)) break;
      add_overlaps(faces, order[i], order[j], overlaps);
    }
  }
  std::sort(overlaps.begin(), overlaps.end());
}

}  // namespace pcm::fast
