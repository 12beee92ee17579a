// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/crossings/crossings.h"

#include <algorithm>
#include <cassert>

namespace pcm::reference {
namespace {

std::array<Vertex, 3> vertices_of(const ExactPose& pose, Side side, Index face) {
  const Triangle& t = pose.face(side, face);
  return {Vertex{side, t[0]}, Vertex{side, t[1]}, Vertex{side, t[2]}};
}

/// Whether the line through both passes all three sides of the face alike. Never in doubt, thanks to the tie rule.
bool line_passes_through(const Orientation& orientation, Vertex a, Vertex b, const std::array<Vertex, 3>& face) {
  const int sign = orientation.orient3d(a, b, face[0], face[1]);
  return orientation.orient3d(a, b, face[1], face[2]) == sign && orientation.orient3d(a, b, face[2], face[0]) == sign;
}

/// Crossings of the edges of `edge_face` with `face`, whose sides of the plane are given.
void add_crossings(const Orientation& orientation, Side edge_side, Index edge_face, Index face,
                   const std::array<int, 3>& sides, std::vector<PairCrossing>& found) {
  const std::array<Vertex, 3> from = vertices_of(orientation.pose(), edge_side, edge_face);
  const std::array<Vertex, 3> through = vertices_of(orientation.pose(), other(edge_side), face);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (sides[i] == sides[j]) continue;
    // Always asked from the smaller vertex, so that both faces at the edge get one answer.
    const bool forward = from[i] < from[j];
    const Vertex a = forward ? from[i] : from[j], b = forward ? from[j] : from[i];
    if (!line_passes_through(orientation, a, b, through)) continue;
    const bool downward = sides[i] > 0;  // the directed edge passes from above to below the face
    PairCrossing crossing;
    crossing.id = {edge_side, {a.index, b.index}, face};
    crossing.delta = downward == forward ? 1 : -1;
    // Circulation (5): e's edge starts the segment going up, f's edge going down.
    crossing.starts = downward == (edge_side == Side::F);
    found.push_back(crossing);
  }
}

}  // namespace

std::vector<PairCrossing> pair_crossings(const Orientation& orientation, Index e, Index f) {
  const ExactPose& pose = orientation.pose();
  const auto sides_of = [&](Side side, Index face, Index plane) {
    const std::array<Vertex, 3> v = vertices_of(pose, side, face);
    return std::array<int, 3>{orientation.side(v[0], other(side), plane), orientation.side(v[1], other(side), plane),
                              orientation.side(v[2], other(side), plane)};
  };
  const auto all_alike = [](const std::array<int, 3>& s) { return s[0] == s[1] && s[1] == s[2]; };
  std::vector<PairCrossing> found;
  const std::array<int, 3> sides_E = sides_of(Side::E, e, f);
  if (all_alike(sides_E)) return found;
  const std::array<int, 3> sides_F = sides_of(Side::F, f, e);
  if (all_alike(sides_F)) return found;
  add_crossings(orientation, Side::E, e, f, sides_E, found);
  add_crossings(orientation, Side::F, f, e, sides_F, found);
  assert(found.empty() || (found.size() == 2 && found[0].starts != found[1].starts));
  return found;
}

Crossings find_crossings(const Orientation& orientation, const std::vector<IndexPair>& candidates) {
  struct Pair {
    Index e, f;
    PairCrossing start, end;
  };
  std::vector<Pair> pairs;
  std::vector<std::pair<CrossingId, int>> found;
  for (const auto& [e, f] : candidates) {
    const std::vector<PairCrossing> both = pair_crossings(orientation, e, f);
    if (both.empty()) continue;
    const bool first_starts = both[0].starts;
    pairs.push_back({e, f, both[first_starts ? 0 : 1], both[first_starts ? 1 : 0]});
    for (const PairCrossing& crossing : both) found.emplace_back(crossing.id, crossing.delta);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());

  Crossings crossings;
  for (const auto& [id, delta] : found) {
    crossings.ids.push_back(id);
    crossings.deltas.push_back(delta);
  }
  const auto place = [&crossings](const CrossingId& id) {
    return static_cast<Index>(std::lower_bound(crossings.ids.begin(), crossings.ids.end(), id) - crossings.ids.begin());
  };
  for (const Pair& pair : pairs)
    crossings.segments.push_back({pair.e, pair.f, place(pair.start.id), place(pair.end.id)});
  return crossings;
}

}  // namespace pcm::reference
