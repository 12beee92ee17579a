// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/crossings.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace pcm::fast {

namespace {

using FaceSigns = std::array<int, 3>;

/// The corner that lies on its own side of the other plane, -1 where all three lie on one side.
int lone_corner(const FaceSigns& signs) {
  if (signs[0] == signs[1]) return signs[1] == signs[2] ? -1 : 2;
  return signs[0] == signs[2] ? 1 : 0;
}

FaceSigns signs_against(const std::array<RankedPoint, 3>& points, const std::array<RankedPoint, 3>& plane,
                        WorkCounters& work) {
  return {orientation(plane[0], plane[1], plane[2], points[0], work),
          orientation(plane[0], plane[1], plane[2], points[1], work),
          orientation(plane[0], plane[1], plane[2], points[2], work)};
}

/// Where one crossing of a pair of faces lies, seen from the pair.
struct Passage {
  Side edge_side;
  int corner;  ///< the directed edge of its face that starts at this corner
};

/// How two faces cross: the two crossings that bound their segment.
struct PairCrossing {
  Passage start, end;
  FaceSigns signs_E, signs_F;  ///< vertices of e above f (+1) or below (-1), and of f above or below e
};

/// Decides whether the faces e and f cross. The planes meet in a line; on it lie the two points where edges of e at its
/// lone corner a meet the plane of f, and the two where edges of f at its lone corner p meet the plane of e. The signs
/// s_ij = orientation(a, a_i, p, p_j) order those points along the line, and an edge of e passes through f where its
/// point lies between the two of f: where its two signs differ. Likewise for the edges of f. So two of the four do, or
/// none. At most 10 signs.
bool cross(const std::array<RankedPoint, 3>& e, const std::array<RankedPoint, 3>& f, PairCrossing& result,
           WorkCounters& work) {
  result.signs_E = signs_against(e, f, work);
  const int lone_E = lone_corner(result.signs_E);
  if (lone_E < 0) return false;
  result.signs_F = signs_against(f, e, work);
  const int lone_F = lone_corner(result.signs_F);
  if (lone_F < 0) return false;

  const auto corner = [](int k) { return static_cast<std::size_t>(k % 3); };
  const RankedPoint& a = e[corner(lone_E)];
  const RankedPoint& p = f[corner(lone_F)];
  int s[2][2];
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) s[i][j] = orientation(a, e[corner(lone_E + 1 + i)], p, f[corner(lone_F + 1 + j)], work);
  }
  int found = 0;
  const auto record = [&](Side side, int from, bool from_above) {
    // Circulation: a directed edge of e from above to below f ends the segment, one of f that does so starts it.
    const bool starts = (side == Side::E) != from_above;
    (starts ? result.start : result.end) = {side, from};
    ++found;
  };
  for (int i = 0; i < 2; ++i) {
    // The edges at the lone corner: from it to the next corner, and from the one before to it.
    const int from_E = i == 0 ? lone_E : (lone_E + 2) % 3;
    if (s[i][0] != s[i][1]) record(Side::E, from_E, result.signs_E[corner(from_E)] > 0);
    const int from_F = i == 0 ? lone_F : (lone_F + 2) % 3;
    if (s[0][i] != s[1][i]) record(Side::F, from_F, result.signs_F[corner(from_F)] > 0);
  }
  assert(found == 0 || found == 2);
  return found != 0;
}

Index enter_crossing(Workspace::Data& workspace, const PairCrossing& pair, const Passage& passage, Index face_E,
                     Index face_F) {
  const bool of_E = passage.edge_side == Side::E;
  const Surface::Data& surface = workspace.side(passage.edge_side).surface();
  const Index edge_face = of_E ? face_E : face_F;
  const FaceSigns& signs = of_E ? pair.signs_E : pair.signs_F;
  const auto corner = static_cast<std::size_t>(passage.corner);
  CrossingNode node;
  node.edge_side = passage.edge_side;
  node.edge = surface.edges_of(edge_face)[corner];
  node.face = of_E ? face_F : face_E;
  const bool forwards = surface.edge(node.edge)[0] == surface.face(edge_face)[corner];
  node.from_above = (signs[corner] > 0) == forwards;
  const auto fresh = static_cast<Index>(workspace.crossings.size());
  const Index found = workspace.crossing_index.find_or_insert(node.key(), fresh);
  if (found == fresh) workspace.crossings.push_back(node);
  return found;
}

void mark_intersected(SideState& side, Index face) {
  if (side.is_intersected.contains(face)) return;
  side.is_intersected[face] = true;
  side.intersected.push_back(face);
}

}  // namespace

void CrossingIndex::start() {
  keys_.clear();
  if (capacity_ == 0) capacity_ = 256;
  table_.start(capacity_);
}

void CrossingIndex::grow() {
  capacity_ *= 2;
  table_.start(capacity_);
  const std::vector<std::uint64_t>& keys = keys_;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    std::size_t at = (keys[i] * 0x9E3779B97F4A7C15u >> 20) & (capacity_ - 1);
    while (table_.contains(at)) at = (at + 1) & (capacity_ - 1);
    table_[at] = {keys[i], static_cast<Index>(i)};
  }
}

Index CrossingIndex::find_or_insert(std::uint64_t key, Index fresh) {
  if (2 * keys_.size() >= capacity_) grow();
  std::size_t at = (key * 0x9E3779B97F4A7C15u >> 20) & (capacity_ - 1);
  for (; table_.contains(at); at = (at + 1) & (capacity_ - 1)) {
    if (table_[at].key == key) return table_[at].value;
  }
  table_[at] = {key, fresh};
  keys_.push_back(key);
  return fresh;
}

bool find_crossings(Workspace::Data& workspace, bool stop_at_first, bool keep_candidates) {
  SideState& side_E = workspace.side(Side::E);
  SideState& side_F = workspace.side(Side::F);
  WorkCounters& work = workspace.contact.work;
  workspace.candidates.clear();
  workspace.crossings.clear();
  workspace.crossing_index.start();
  for (SideState& side : workspace.sides) {
    side.intersected.clear();
    side.is_intersected.start(side.surface().mesh.faces.size());
  }
  bool found = false;
  for_each_candidate(
      side_E.surface(), side_F.surface(), workspace.placement, workspace.node_pairs, work,
      [&](Index face_E, Index face_F) {
        if (keep_candidates) workspace.candidates.emplace_back(face_E, face_F);
        PairCrossing pair;
        if (!cross(side_E.posed.face_points(face_E, work), side_F.posed.face_points(face_F, work), pair, work)) {
          return true;
        }
        ++work.crossing_pairs;
        found = true;
        if (stop_at_first) return false;
        const Index start = enter_crossing(workspace, pair, pair.start, face_E, face_F);
        const Index end = enter_crossing(workspace, pair, pair.end, face_E, face_F);
        CrossingNode& first = workspace.crossings[static_cast<std::size_t>(start)];
        assert(first.next < 0);
        first.next = end;
        first.segment_face = {face_E, face_F};
        workspace.crossings[static_cast<std::size_t>(end)].has_previous = true;
        mark_intersected(side_E, face_E);
        mark_intersected(side_F, face_F);
        return true;
      });
  for (SideState& side : workspace.sides) std::sort(side.intersected.begin(), side.intersected.end());
  return found;
}

}  // namespace pcm::fast
