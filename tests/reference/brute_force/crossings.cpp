// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>

#include "tests/reference/brute_force/steps.h"

namespace pcm::brute_force {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::logic_error(what);
}

/// Where the edge meets the plane of the face, which it is not parallel to.
Vector position(const Body& edges, const Body& faces, const Crossing& crossing) {
  const Vector& a = edges.vertices[crossing.edge[0]];
  const Vector& b = edges.vertices[crossing.edge[1]];
  const Vector& normal = faces.normals[crossing.face];
  const Vector& p = faces.corner(crossing.face, 0);
  const Rational above_a = dot(normal, a - p);
  const Rational above_b = dot(normal, b - p);
  require(above_a != above_b, "twin: an edge crosses a face in whose plane it lies");
  return a + Rational(above_a / (above_a - above_b)) * (b - a);
}

/// Whether the face's winding runs along the edge from its first vertex to its second.
bool runs_along(const Triangle& face, const Edge& edge) {
  for (int i = 0; i < 3; ++i)
    if (face[i] == edge[0] && face[(i + 1) % 3] == edge[1]) return true;
  return false;
}

}  // namespace

void find_crossings(Answer& answer, Steps& steps) {
  std::map<std::array<Index, 2>, std::vector<Crossing>> starts;
  std::map<std::array<Index, 2>, std::vector<Crossing>> ends;
  for (const Side side : {Side::E, Side::F}) {
    const Body& edges = answer.scene.body(side);
    const Body& faces = answer.scene.body(other(side));
    for (const auto& [edge, faces_at_edge] : edges.faces_of_edge) {
      for (Index face = 0; face < std::ssize(faces.faces); ++face) {
        const int passes = passage(ranked(edges, edge[0]), ranked(edges, edge[1]), ranked_face(faces, face));
        if (passes == 0) continue;
        const Crossing crossing{side, edge, face};
        steps.passages[crossing] = passes;
        answer.positions[crossing] = position(edges, faces, crossing);
        for (const Index at_edge : faces_at_edge) {
          const std::array<Index, 2> pair = side == Side::E ? std::array{at_edge, face} : std::array{face, at_edge};
          // An edge of E going down through F ends the segment, an edge of F going down through E starts it.
          const bool down = (passes > 0) == runs_along(edges.faces[at_edge], edge);
          (down == (side == Side::E) ? ends : starts)[pair].push_back(crossing);
        }
      }
    }
  }
  for (const Side side : {Side::E, Side::F}) {
    steps.intersected[index_of(side)].assign(answer.scene.body(side).faces.size(), false);
  }
  require(starts.size() == ends.size(), "twin: a crossing pair without start or end");
  for (const auto& [pair, crossings] : starts) {
    require(crossings.size() == 1 && ends[pair].size() == 1, "twin: a crossing pair has not one start and one end");
    steps.segments[pair] = {crossings.front(), ends[pair].front()};
    steps.intersected[0][pair[0]] = true;
    steps.intersected[1][pair[1]] = true;
  }
  answer.touching = !steps.segments.empty();
  for (const Side side : {Side::E, Side::F}) {
    ActiveArea& active = side == Side::E ? answer.E : answer.F;
    for (Index f = 0; f < std::ssize(answer.scene.body(side).faces); ++f)
      if (steps.intersected[index_of(side)][f]) active.intersected.push_back(f);
  }
}

void chain_polygons(Answer& answer, const Steps& steps) {
  std::map<Crossing, Crossing> next;
  std::set<Crossing> reached;
  for (const auto& [pair, segment] : steps.segments) {
    require(next.emplace(segment[0], segment[1]).second, "twin: two segments start at one crossing");
    require(reached.insert(segment[1]).second, "twin: two segments end at one crossing");
  }
  const auto follow = [&](Crossing crossing, bool closed) {
    Polygon polygon;
    polygon.closed = closed;
    polygon.points.push_back(crossing);
    for (auto it = next.find(crossing); it != next.end(); it = next.find(crossing)) {
      crossing = it->second;
      next.erase(it);
      if (closed && crossing == polygon.points.front()) break;
      polygon.points.push_back(crossing);
    }
    answer.polygons.push_back(std::move(polygon));
  };
  std::vector<Crossing> open_starts;
  for (const auto& [start, end] : next)
    if (!reached.contains(start)) open_starts.push_back(start);
  for (const Crossing& start : open_starts) follow(start, false);
  while (!next.empty()) follow(next.begin()->first, true);  // the map is ordered, so this is the smallest crossing
  std::ranges::sort(answer.polygons, {}, [](const Polygon& polygon) { return polygon.points.front(); });
}

int change_along(const Steps& steps, Side side, Index a, Index b) {
  const Edge edge = edge_between(a, b);
  int change = 0;
  for (auto it = steps.passages.lower_bound(Crossing{side, edge, 0});
       it != steps.passages.end() && it->first.edge_side == side && it->first.edge == edge; ++it)
    change += it->second;
  return edge[0] == a ? change : -change;
}

}  // namespace pcm::brute_force
