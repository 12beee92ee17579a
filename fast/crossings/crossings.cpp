// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/crossings/crossings.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <functional>
#include <span>

#include "fast/base/ascending.h"
#include "fast/base/shares.h"

namespace pcm::fast {

namespace {

CrossingNode crossing_node(const PosedPair& posed, const PairSigns& signs, const EdgePassage& passage, Index face_E,
                           Index face_F) {
  const bool of_E = passage.edge_side == Side::E;
  const PreparedSurface& surface = posed.surface(passage.edge_side);
  const Index edge_face = of_E ? face_E : face_F;
  const Corners above = of_E ? signs.above_of_E : signs.above_of_F;
  const auto corner = static_cast<std::size_t>(passage.corner);
  CrossingNode node;
  node.edge_side = passage.edge_side;
  node.edge = surface.edges_of(edge_face)[corner];
  node.face = of_E ? face_F : face_E;
  node.from_above = is_above(above, corner) == surface.runs_forwards(edge_face, corner);
  return node;
}

CrossingPair crossing_pair(const PosedPair& posed, Index face_E, Index face_F, const PairSigns& signs) {
  const PairCrossing pair = pair_crossing(signs);
  return {face_E, face_F, crossing_node(posed, signs, pair.start, face_E, face_F),
          crossing_node(posed, signs, pair.end, face_E, face_F)};
}

Index enter_crossing(const CrossingNode& node, CrossingIndex& index, std::vector<CrossingNode>& nodes) {
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

void start_crossings(const PosedPair& posed, CrossingScratch& scratch, Crossings& crossings) {
  crossings.candidates.clear();
  crossings.nodes.clear();
  scratch.index.start();
  for (const Side side : {Side::E, Side::F}) {
    crossings.of(side).intersected.clear();
    crossings.of(side).is_intersected.start(posed.surface(side).mesh.faces.size());
  }
}

/// Enters the segment of two faces that cross, with both its ends.
void enter_pair(const CrossingPair& pair, CrossingScratch& scratch, Crossings& crossings) {
  const Index start = enter_crossing(pair.start, scratch.index, crossings.nodes);
  const Index end = enter_crossing(pair.end, scratch.index, crossings.nodes);
  CrossingNode& first = crossings.nodes[static_cast<std::size_t>(start)];
  assert(first.next < 0);
  first.next = end;
  first.segment_face = {pair.face_E, pair.face_F};
  crossings.nodes[static_cast<std::size_t>(end)].has_previous = true;
  mark_intersected(crossings.of(Side::E), pair.face_E);
  mark_intersected(crossings.of(Side::F), pair.face_F);
}

void sort_intersected(CrossingScratch& scratch, Crossings& crossings) {
  for (CrossedSurface& side : crossings.surfaces) sort_ascending(side.intersected, scratch.marks);
}

/// So many pairs of nodes are enough for threads to share; below a few hundred there may be less to do than it takes to
/// wake a thread (docs/performance.md).
constexpr std::size_t kEnoughForThreads = 1024;
/// And so many are taken at once.
constexpr std::size_t kNodePairsAtOnce = 8;

/// Decides pairs that may cross.
class PairTest {
 public:
  PairTest(PosedPair& posed, const CrossingOptions& options)
      : posed_(posed),
        filtered_(options.filtered),
        sure_(options.filtered ? sure_determinant(posed.placement.extent) : kNeverSure) {}

  PairSigns signs(Index face_E, Index face_F, const SureSigns& known) const {
    if (known.of_passing() && filtered_) return {known.above_of_E(), known.above_of_F(), known.passing()};
    ++posed_.work.unsure_pairs;
    return find_signs(posed_[Side::E].face_points(face_E, posed_.work),
                      posed_[Side::F].face_points(face_F, posed_.work), filtered_ ? known : SureSigns(), sure_,
                      posed_.work);
  }

 private:
  PosedPair& posed_;
  bool filtered_;
  double sure_;
};

/// Searches below all open pairs, and leaves none.
void find_pairs_by_threads(const CandidateSearch& search, PosedPair& posed, const CrossingOptions& options,
                           PosedTeam& team, CrossingScratch& scratch, Crossings& crossings) {
  const NodePairs& open = scratch.open;
  Shares shares(open.size(), kNodePairsAtOnce);
  const std::size_t threads = std::min(team.threads(), shares.shares());
  if (scratch.of_threads.size() < threads) scratch.of_threads.resize(threads);
  const std::span<PairsOfThread> of_threads = std::span(scratch.of_threads).first(threads);
  const auto take_part = [&](std::size_t thread, PosedPair& own_posed) {
    PairsOfThread& own = of_threads[thread];
    own.crossing.clear();
    const PairTest test(own_posed, options);
    const auto visit = [&](Index face_E, Index face_F, const SureSigns& known) {
      const PairSigns signs = test.signs(face_E, face_F, known);
      if (signs.passing != 0) own.crossing.push_back(crossing_pair(own_posed, face_E, face_F, signs));
      return true;
    };
    for (Shares::Share share = shares.take(); !share.empty(); share = shares.take()) {
      own.open.assign(open.begin() + static_cast<std::ptrdiff_t>(share.begin),
                      open.begin() + static_cast<std::ptrdiff_t>(share.end));
      search.visit_below(own.open, own_posed.work, visit);
    }
  };
  team.run(threads, posed, std::cref(take_part));
  scratch.open.clear();
  for (const PairsOfThread& found : of_threads) {
    posed.work.crossing_pairs += static_cast<std::int64_t>(found.crossing.size());
    for (const CrossingPair& pair : found.crossing) enter_pair(pair, scratch, crossings);
  }
}

}  // namespace

void CrossingIndex::start() {
  keys_.clear();
  table_.start(places());
}

std::size_t CrossingIndex::find(std::uint64_t key) const {
  std::size_t at = first_place(key, log2_places_);
  while (table_.contains(at) && table_.at(at).key != key) at = (at + 1) & (places() - 1);
  return at;
}

void CrossingIndex::grow() {
  ++log2_places_;
  table_.start(places());
  for (std::size_t i = 0; i < keys_.size(); ++i) table_.set(find(keys_[i]), {keys_[i], static_cast<Index>(i)});
}

Index CrossingIndex::find_or_insert(std::uint64_t key, Index fresh) {
  if (2 * keys_.size() >= places()) grow();
  const std::size_t at = find(key);
  if (table_.contains(at)) return table_.at(at).value;
  assert(fresh == static_cast<Index>(keys_.size()));  // as grow() enters them
  table_.set(at, {key, fresh});
  keys_.push_back(key);
  return fresh;
}

bool find_crossings(PosedPair& posed, const CrossingOptions& options, PosedTeam& team, CrossingScratch& scratch,
                    Crossings& crossings) {
  start_crossings(posed, scratch, crossings);
  NodePairs& open = scratch.open;
  const CandidateSearch search(posed.surface(Side::E), posed.surface(Side::F), posed.placement, 0, open, posed.work);
  if (team.threads() > 1 && !options.stop_at_first && !options.keep_candidates) {
    search.descend(kEnoughForThreads, open, scratch.next, posed.work);
    if (open.size() >= kEnoughForThreads) find_pairs_by_threads(search, posed, options, team, scratch, crossings);
  }
  const PairTest test(posed, options);
  bool any_cross = !crossings.nodes.empty();
  const auto visit = [&](Index face_E, Index face_F, const SureSigns& known) {
    if (options.keep_candidates) crossings.candidates.emplace_back(face_E, face_F);
    const PairSigns signs = test.signs(face_E, face_F, known);
    if (signs.passing == 0) return true;
    any_cross = true;
    ++posed.work.crossing_pairs;
    if (options.stop_at_first) return false;
    enter_pair(crossing_pair(posed, face_E, face_F, signs), scratch, crossings);
    return true;
  };
  search.visit_below(open, posed.work, visit);
  sort_intersected(scratch, crossings);
  return any_cross;
}

void find_crossings_among(const TrackedPairs& pairs, PosedPair& posed, CrossingScratch& scratch, Crossings& crossings) {
  start_crossings(posed, scratch, crossings);
  pairs.for_each_crossing([&](Index face_E, Index face_F, const PairSigns& signs) {
    ++posed.work.crossing_pairs;
    enter_pair(crossing_pair(posed, face_E, face_F, signs), scratch, crossings);
  });
  sort_intersected(scratch, crossings);
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
