// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/crossings/crossings.h"

#include <array>
#include <bit>
#include <cassert>

#include "fast/base/ascending.h"
#include "fast/simd/overlap_sets.h"

namespace pcm::fast {

namespace {

/// Which corners of a face lie above a plane, bit by bit; a corner not above is below.
using Corners = unsigned;

/// The corner that lies on its own side of the other plane, -1 where all three lie on one side.
int lone_corner(Corners above) {
  constexpr std::array<std::int8_t, 8> kLone{-1, 0, 1, 2, 2, 1, 0, -1};
  return kLone[above];
}

bool has(Corners corners, std::size_t corner) {
  return (corners >> corner & 1U) != 0;
}

Corners above(const std::array<RankedPoint, 3>& plane, const std::array<RankedPoint, 3>& points, double sure,
              WorkCounters& work) {
  const OrientedPlane oriented(plane[0], plane[1], plane[2], sure);
  Corners corners = 0;
  for (std::size_t k = 0; k < 3; ++k) corners |= static_cast<Corners>(oriented.above(points[k], work)) << k;
  return corners;
}

/// Where one crossing of a pair of faces lies, seen from the pair.
struct Passage {
  Side edge_side;
  int corner;  ///< the directed edge of its face that starts at this corner
};

/// How two faces cross: the two crossings that bound their segment.
struct PairCrossing {
  Passage start, end;
  Corners above_F, above_E;  ///< corners of e above f, and of f above e
};

std::size_t corner(int k) {
  return static_cast<std::size_t>(k < 3 ? k : k - 3);
}

/// What is known of a pair of faces that may cross.
struct PairSigns {
  Corners above_F = 0, above_E = 0;  ///< corners of e above f, and of f above e
  unsigned passing = 0;              ///< as in SureSigns
};

/// Finds which edges of e and f pass through the other face: none where the faces do not cross. The planes meet in a
/// line; on it lie the two points where edges of e at its lone corner a meet the plane of f, and the two where edges of
/// f at its lone corner p meet the plane of e. The signs s_ij = orientation(a, a_i, p, p_j) order those points along
/// the line, and an edge of e passes through f where its point lies between the two of f: where its two signs differ.
/// Likewise for the edges of f. So two of the four do, or none. At most 10 signs, of which `known` may spare 6.
PairSigns find_signs(const std::array<RankedPoint, 3>& e, const std::array<RankedPoint, 3>& f, const SureSigns& known,
                     double sure, WorkCounters& work) {
  PairSigns result;
  result.above_F = known.of_E() ? known.above_of_E() : above(f, e, sure, work);
  const int lone_E = lone_corner(result.above_F);
  if (lone_E < 0) return result;
  result.above_E = known.of_F() ? known.above_of_F() : above(e, f, sure, work);
  const int lone_F = lone_corner(result.above_E);
  if (lone_F < 0) return result;

  const RankedPoint& a = e[corner(lone_E)];
  const RankedPoint& p = f[corner(lone_F)];
  unsigned s[2][2];
  for (int i = 0; i < 2; ++i) {
    const OrientedPlane through_p(a, e[corner(lone_E + 1 + i)], p, sure);
    for (int j = 0; j < 2; ++j) s[i][j] = through_p.above(f[corner(lone_F + 1 + j)], work) ? 1 : 0;
  }
  result.passing = (s[0][0] ^ s[0][1]) | (s[1][0] ^ s[1][1]) << 1 | (s[0][0] ^ s[1][0]) << 2 | (s[0][1] ^ s[1][1]) << 3;
  return result;
}

/// How two faces cross, some of whose edges pass through the other. Circulation: a directed edge of e from above to
/// below f ends the segment, one of f that does so starts it.
PairCrossing pair_crossing(const PairSigns& signs) {
  const int lone_E = lone_corner(signs.above_F), lone_F = lone_corner(signs.above_E);
  const unsigned starting = (has(signs.above_F, corner(lone_E)) ? 0b0010U : 0b0001U) |
                            (has(signs.above_E, corner(lone_F)) ? 0b0100U : 0b1000U);
  assert(std::popcount(signs.passing & starting) == 1 && std::popcount(signs.passing & ~starting) == 1);
  const auto passage = [&](unsigned edge) -> Passage {
    const int number = std::countr_zero(edge);
    const int lone = number < 2 ? lone_E : lone_F;
    return {number < 2 ? Side::E : Side::F, number % 2 == 0 ? lone : static_cast<int>(corner(lone + 2))};
  };
  return {passage(signs.passing & starting), passage(signs.passing & ~starting), signs.above_F, signs.above_E};
}

Index enter_crossing(const PosedPair& posed, const PairCrossing& pair, const Passage& passage, Index face_E,
                     Index face_F, CrossingIndex& index, std::vector<CrossingNode>& nodes) {
  const bool of_E = passage.edge_side == Side::E;
  const PreparedSurface& surface = posed.surface(passage.edge_side);
  const Index edge_face = of_E ? face_E : face_F;
  const Corners above = of_E ? pair.above_F : pair.above_E;
  const auto corner = static_cast<std::size_t>(passage.corner);
  CrossingNode node;
  node.edge_side = passage.edge_side;
  node.edge = surface.edges_of(edge_face)[corner];
  node.face = of_E ? face_F : face_E;
  node.from_above = has(above, corner) == surface.runs_forwards(edge_face, corner);
  const auto fresh = static_cast<Index>(nodes.size());
  const Index found = index.find_or_insert(node.key(), fresh);
  if (found == fresh) nodes.push_back(node);
  return found;
}

void mark_intersected(CrossedSurface& side, Index face) {
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
  assert(fresh == static_cast<Index>(keys_.size()));  // as grow() enters them
  table_[at] = {key, fresh};
  keys_.push_back(key);
  return fresh;
}

bool find_crossings(PosedPair& posed, const CrossingOptions& options, CrossingScratch& scratch, Crossings& crossings) {
  const PreparedSurface& surface_E = posed.surface(Side::E);
  const PreparedSurface& surface_F = posed.surface(Side::F);
  crossings.candidates.clear();
  crossings.nodes.clear();
  scratch.index.start();
  for (const Side side : {Side::E, Side::F}) {
    crossings.of(side).intersected.clear();
    crossings.of(side).is_intersected.start(posed.surface(side).mesh.faces.size());
  }
  const double sure = options.filtered ? sure_determinant(posed.placement.extent) : kNeverSure;
  bool found = false;
  const auto visit = [&](Index face_E, Index face_F, const SureSigns& known) {
    if (options.keep_candidates) crossings.candidates.emplace_back(face_E, face_F);
    PairSigns signs{known.above_of_E(), known.above_of_F(), known.passing()};
    if (!known.of_passing() || !options.filtered) {
      signs = find_signs(posed[Side::E].face_points(face_E, posed.work), posed[Side::F].face_points(face_F, posed.work),
                         options.filtered ? known : SureSigns(), sure, posed.work);
    }
    if (signs.passing == 0) return true;
    ++posed.work.crossing_pairs;
    found = true;
    if (options.stop_at_first) return false;
    const PairCrossing pair = pair_crossing(signs);
    const Index start = enter_crossing(posed, pair, pair.start, face_E, face_F, scratch.index, crossings.nodes);
    const Index end = enter_crossing(posed, pair, pair.end, face_E, face_F, scratch.index, crossings.nodes);
    CrossingNode& first = crossings.nodes[static_cast<std::size_t>(start)];
    assert(first.next < 0);
    first.next = end;
    first.segment_face = {face_E, face_F};
    crossings.nodes[static_cast<std::size_t>(end)].has_previous = true;
    mark_intersected(crossings.of(Side::E), face_E);
    mark_intersected(crossings.of(Side::F), face_F);
    return true;
  };
  for_each_candidate(surface_E, surface_F, posed.placement, fastest_wide_tests(), scratch.open, posed.work, visit);
  for (CrossedSurface& side : crossings.surfaces) sort_ascending(side.intersected, scratch.marks);
  return found;
}

void list_crossings_by_edge(const PosedPair& posed, const std::vector<Index>& order, Crossings& crossings) {
  for (const Side side : {Side::E, Side::F}) crossings.of(side).edges.start(posed.surface(side).edges.size());
  // Each list grows at its head: the last crossing comes first.
  for (std::size_t i = crossings.nodes.size(); i-- > 0;) {
    const Index c = order.empty() ? static_cast<Index>(i) : order[i];
    CrossingNode& crossing = crossings.nodes[static_cast<std::size_t>(c)];
    EdgeCrossings& list = crossings.of(crossing.edge_side).edges[crossing.edge];
    crossing.next_on_edge = list.first;
    list.first = c;
    ++list.count;
    list.winding_change += crossing.winding_change();
  }
}

}  // namespace pcm::fast
