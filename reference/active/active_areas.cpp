// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/active/active_areas.h"

#include <algorithm>
#include <iterator>

#include "reference/numbers/disjoint_sets.h"

namespace pcm::reference {
namespace {

enum class FaceState : char { unlabelled, intersected };

std::vector<FaceState> mark_intersected(Side side, const Crossings& crossings, const Surface& surface) {
  std::vector<FaceState> states(surface.mesh.faces.size(), FaceState::unlabelled);
  for (const Segment& segment : crossings.segments)
    states[side == Side::E ? segment.face_E : segment.face_F] = FaceState::intersected;
  return states;
}

void locate_in_closed(const Orientation& orientation, Side side, const std::vector<FaceState>& states,
                      const std::vector<IndexPair>& columns, ActiveFaces& active) {
  const Surface& surface = orientation.pose().surface(side);
  const Index vertices = static_cast<Index>(surface.mesh.vertices.size());
  active.winding.assign(vertices, 0);
  // A vertex with no column lies outside the box of the other surface, or has none of its faces above.
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Index v = columns[i].first;
    if (i == 0 || columns[i - 1].first != v) active.winding[v] = winding_number(orientation, {side, v}, columns);
  }
  active.inside.resize(vertices);
  active.outside.resize(vertices);
  for (Index v = 0; v < vertices; ++v) {
    active.inside[v] = active.winding[v] >= 1;
    active.outside[v] = !active.inside[v];
  }
  std::vector<bool> crossed_component(surface.components, false);
  const Index faces = static_cast<Index>(surface.mesh.faces.size());
  for (Index f = 0; f < faces; ++f)
    if (states[f] == FaceState::intersected) crossed_component[surface.component[f]] = true;
  for (Index f = 0; f < faces; ++f) {
    const Triangle& t = surface.mesh.faces[f];
    if (states[f] == FaceState::intersected) continue;
    if (active.winding[t[0]] < 0) active.pockets.push_back(f);  // uncrossed: one winding number all over
    if (!active.inside[t[0]] || !active.inside[t[1]] || !active.inside[t[2]]) continue;
    active.inner.push_back(f);
    if (!crossed_component[surface.component[f]]) active.nested = true;
  }
}

/// Signed sum of crossings along each edge of `side`, from its smaller to its greater vertex.
std::vector<int> edge_sums(Side side, const Crossings& crossings, const Surface& surface) {
  std::vector<int> sums(surface.edges.size(), 0);
  for (std::size_t i = 0; i < crossings.ids.size(); ++i)
    if (crossings.ids[i].edge_side == side) sums[find_edge(surface, crossings.ids[i].edge)] += crossings.deltas[i];
  return sums;
}

/// Which labels something got.
struct Labels {
  bool inside = false, outside = false;
  void add(const Labels& more) {
    inside = inside || more.inside;
    outside = outside || more.outside;
  }
};

/// Of each vertex, by the edges that end in it.
std::vector<Labels> labels_by_edges(Side side, const Crossings& crossings, const Surface& surface) {
  std::vector<Labels> labels(surface.mesh.vertices.size());
  const std::vector<int> sums = edge_sums(side, crossings, surface);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i] == 0) continue;
    const auto [a, b] = surface.edges[i];
    labels[sums[i] > 0 ? b : a].inside = true;
    labels[sums[i] > 0 ? a : b].outside = true;
  }
  return labels;
}

/// PCM section 5 speaks of sets of uncrossed faces: the classes of the relation "share an edge". A set has the labels
/// of all its vertices.
void locate_in_open(Side side, const Crossings& crossings, const Surface& surface, const std::vector<FaceState>& states,
                    ActiveFaces& active) {
  const auto uncrossed = [&states](Index f) { return f != kNone && states[f] != FaceState::intersected; };
  const Index faces = static_cast<Index>(states.size());
  DisjointSets sets(states.size());
  for (const auto& [f, g] : surface.edge_faces)
    if (uncrossed(f) && uncrossed(g)) sets.join(f, g);

  std::vector<Labels> of_vertex = labels_by_edges(side, crossings, surface);
  std::vector<Labels> of_set(states.size());  // at the root
  for (Index f = 0; f < faces; ++f)
    for (const Index v : surface.mesh.faces[f])
      if (uncrossed(f)) of_set[sets.root(f)].add(of_vertex[v]);

  for (Index f = 0; f < faces; ++f) {
    const Labels& labels = of_set[sets.root(f)];
    if (labels.inside && labels.outside) active.ambiguous = true;
    if (!uncrossed(f) || labels.inside == labels.outside) continue;
    if (labels.inside) active.inner.push_back(f);
    for (const Index v : surface.mesh.faces[f]) of_vertex[v].add(labels);
  }
  for (const Labels& labels : of_vertex) {
    active.inside.push_back(labels.inside);
    active.outside.push_back(labels.outside);
  }
}

}  // namespace

std::vector<Index> ActiveFaces::active() const {
  std::vector<Index> faces;
  faces.reserve(intersected.size() + inner.size());
  std::merge(intersected.begin(), intersected.end(), inner.begin(), inner.end(), std::back_inserter(faces));
  return faces;
}

std::vector<IndexPair> columns_above_vertices(const ExactPose& pose, Side side, const BoxTree& others) {
  const Box& all = others.nodes().front().box;
  std::vector<IndexPair> pairs;
  for (Index v = 0; v < static_cast<Index>(pose.surface(side).mesh.vertices.size()); ++v) {
    Box column = pose.rounding_box({side, v});
    if (!column.meets(all)) continue;  // outside: winding number 0
    column.upper[2] = std::max(column.upper[2], all.upper[2]);
    const auto first = static_cast<std::ptrdiff_t>(pairs.size());
    others.for_each_meeting(column, [&](Index f) { pairs.emplace_back(v, f); });
    std::sort(pairs.begin() + first, pairs.end());
  }
  return pairs;
}

int winding_number(const Orientation& orientation, Vertex v, const std::vector<IndexPair>& columns) {
  const Side faces_side = other(v.side);
  int winding = 0;
  for (auto column = std::lower_bound(columns.begin(), columns.end(), IndexPair{v.index, 0});
       column != columns.end() && column->first == v.index; ++column) {
    const Triangle& t = orientation.pose().face(faces_side, column->second);
    const Vertex p{faces_side, t[0]}, q{faces_side, t[1]}, s{faces_side, t[2]};
    const int turn = orientation.orient_xy(v, p, q);
    if (orientation.orient_xy(v, q, s) != turn || orientation.orient_xy(v, s, p) != turn) continue;
    // The projection holds v, and its turn is the sign of the normal's z. The face lies above v where v is on the side
    // of its plane that points down.
    if (orientation.side(v, faces_side, column->second) != turn) winding += turn;
  }
  return winding;
}

ActiveFaces find_active_faces(const Orientation& orientation, Side side, const Crossings& crossings,
                              const std::vector<IndexPair>& columns) {
  const Surface& surface = orientation.pose().surface(side);
  ActiveFaces active;
  const std::vector<FaceState> states = mark_intersected(side, crossings, surface);
  for (Index f = 0; f < static_cast<Index>(states.size()); ++f)
    if (states[f] == FaceState::intersected) active.intersected.push_back(f);
  if (orientation.pose().surface(other(side)).closed)
    locate_in_closed(orientation, side, states, columns, active);
  else
    locate_in_open(side, crossings, surface, states, active);
  return active;
}

}  // namespace pcm::reference
