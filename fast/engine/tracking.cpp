// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/engine/tracking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcm::fast {

namespace {

/// How long steps may be, relative to an edge: of those that are longer so many pairs would have to be looked at again
/// that to find all anew costs less.
constexpr double kLongestStep = 0x1p-5;
/// Before a step that is longer than this three short ones have to come in a row for pairs to be listed: long ones
/// often are but a few, and lists for them cost more than they save.
constexpr double kLongestAtOnce = 0x1p-7;
/// For how many steps as long as the last one a list of pairs is made, or the list of faces that a line may meet.
/// Longer lists cost more at each step.
constexpr double kPairsAhead = 16, kLinesAhead = 8, kLinesAheadOfF = 2;
/// Pairs after a longer step, of the longest short one that is awaited.
constexpr double kPairsAheadOfLong = 3;
/// But for no farther than this, relative to an edge.
constexpr double kFarthestPairs = 0x1p-3, kFarthestLines = 0x1p-4;
/// Twice as far as a step goes at least: a list serves the next one.
static_assert(kFarthestPairs >= 2 * kLongestStep && kFarthestLines >= 2 * kLongestStep);
/// What is made for no more than this, relative to an edge, costs no less: difference quotients take many such steps.
constexpr double kLeastAhead = 0x1p-14;
/// Lines that are wider, relative to an edge, meet too many faces to be worth remembering.
constexpr double kWidestLines = 0x1p-3;
/// How long steps may be, relative to an edge, for margins of lines to last long enough.
constexpr double kLongestSettled = 0x1p-9;

/// m. `way`: of a step; `farthest`: relative to an edge.
double way_ahead(double steps, double way, double farthest, double edge) {
  return std::max(std::min(steps * way, farthest * edge), kLeastAhead * edge);
}

/// Adds up ways, the sum rounded up: by half a unit in the last place at least, which also pays for the roundings of
/// sums of this and a margin (TrackedPairs, LineMemory).
void add_way(double way, double& travelled) {
  travelled = (1 + 0x1p-52) * (travelled + way);
}

}  // namespace

// A line of F at a distance q from its origin is moved by what F's frame moves there, q over the ball's radius more
// than in the ball, and turned by three times as much again where A is a rotation to 1e-9 only: its direction is that
// of the carried face's normal. q is no more than twice the sum of both radii where surfaces touch. A third more pays
// for roundings of the face's vertices (line_stays).
Tracking::Tracking(const PreparedSurface& E, const PreparedSurface& F)
    : ball_F_(F),
      usual_edge_(std::min(E.usual_edge, F.usual_edge)),
      fewest_vertices_(static_cast<std::size_t>(std::min(E.fewest_vertices, F.fewest_vertices))),
      lines_{LineMemory({1, ball_F_.radius}),
             LineMemory({4.0 / 3 * (1 + 8 * (1 + BoundingBall(E).radius / ball_F_.radius)), ball_F_.radius})} {}

void Tracking::start_lines(double way) {
  for (const Side master : {Side::E, Side::F}) {
    const auto m = static_cast<std::size_t>(master);
    const double way_of_lines = lines_[m].motion().way_over_travel;
    double ahead =
        std::min(way_ahead(master == Side::E ? kLinesAhead : kLinesAheadOfF, way, kFarthestLines, usual_edge_),
                 kWidestLines * usual_edge_ / way_of_lines);
    if (ahead < 2 * way) ahead = 0;  // they would hardly serve another step
    lines_[m].start(travelled_, ahead, way_of_lines * ahead, way_of_lines * way < kLongestSettled * usual_edge_);
  }
}

void Tracking::forget() {
  pairs_.clear();
  for (LineMemory& lines : lines_) lines.clear();
}

void Tracking::list_pairs(PosedPair& posed, double ahead, double way, NodePairs& open) {
  pairs_.list(posed, ahead, open);
  travelled_ = listed_travelled_ = 0;
  start_lines(way);
}

Tracking::Known Tracking::know_at(const Pose& pose, PosedPair& posed, NodePairs& open) {
  const std::optional<Pose> last = std::exchange(last_, pose);
  const bool had_kept = std::exchange(has_kept_, false);
  const double way = last ? greatest_travel(*last, pose, ball_F_) : std::numeric_limits<double>::infinity();
  if (!(way < kLongestStep * usual_edge_)) {
    if (last) short_steps_.note_long();
    forget();
    const double awaited = short_steps_.longest_awaited();
    if (!short_steps_.awaited() || awaited > kLongestAtOnce * usual_edge_) return Known::nothing;
    list_pairs(posed, way_ahead(kPairsAheadOfLong, awaited, kFarthestPairs, usual_edge_), awaited, open);
    return Known::crossing_pairs;
  }
  short_steps_.note_short(way);
  add_way(way, travelled_);
  if (!pairs_.holds(travelled_)) {
    if (!(way < kLongestAtOnce * usual_edge_ ? short_steps_.others_follow() : short_steps_.are_steady())) {
      forget();
      return Known::nothing;
    }
    for (LineMemory& lines : lines_) lines.start_travel_anew(travelled_);
    list_pairs(posed, way_ahead(kPairsAhead, way, kFarthestPairs, usual_edge_), way, open);
    return Known::crossing_pairs;
  }
  start_lines(way);
  add_way(greatest_travel(*last, pose, pairs_.ball_of_listed()), listed_travelled_);
  const bool same = pairs_.update(posed, listed_travelled_, fewest_vertices_) == TrackedPairs::Outcome::same;
  has_kept_ = had_kept && same;
  return has_kept_ ? Known::active_faces : Known::crossing_pairs;
}

void Tracking::keep_active_faces(const Crossings& crossings, const ActiveAreas& areas) {
  for (const Side side : {Side::E, Side::F}) {
    KeptFaces& kept = kept_[static_cast<std::size_t>(side)];
    kept.intersected = crossings.of(side).intersected;
    kept.inner = areas.of(side).inner;
    kept.pockets = areas.of(side).pockets;
  }
  nested_ = areas.nested;
  ambiguous_ = areas.ambiguous;
  has_kept_ = true;
}

void Tracking::restore_active_faces(Crossings& crossings, ActiveAreas& areas) const {
  crossings.nodes.clear();
  crossings.candidates.clear();
  for (const Side side : {Side::E, Side::F}) {
    const KeptFaces& kept = kept_[static_cast<std::size_t>(side)];
    crossings.of(side).intersected = kept.intersected;
    areas.of(side).inner = kept.inner;
    areas.of(side).pockets = kept.pockets;
  }
  areas.nested = nested_;
  areas.ambiguous = ambiguous_;
}

}  // namespace pcm::fast
