// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/intersection_polygons.h"

#include <algorithm>
#include <utility>

namespace pcm::compare::published {
namespace {

bool snap(const Crossing& a, const Crossing& b) {
  return (a.position_Me - b.position_Me).squaredNorm() < kSnapDistance * kSnapDistance;
}

void turn(Segment& segment) {
  std::swap(segment.ends[0], segment.ends[1]);
  segment.turned = !segment.turned;
}

/// Appends remaining lines, those from `end` on, to the polygon from `first` to `end` for as long as one is near its
/// last point. Returns the new end.
std::size_t extend(std::vector<Segment>& segments, std::size_t end) {
  for (std::size_t next = end; next < segments.size();) {
    const Crossing& free_end = segments[end - 1].ends[1];
    Segment& candidate = segments[next];
    const bool forward = snap(candidate.ends[0], free_end);
    if (!forward && !snap(candidate.ends[1], free_end)) {
      ++next;
      continue;
    }
    if (!forward) turn(candidate);
    if (next != end) std::swap(candidate, segments[end]);
    next = ++end;
  }
  return end;
}

/// Walks the polygon the other way round.
void turn(std::vector<Segment>& segments, std::size_t first, std::size_t end) {
  const auto at = [&](std::size_t k) { return segments.begin() + static_cast<std::ptrdiff_t>(k); };
  std::reverse(at(first), at(end));
  std::for_each(at(first), at(end), [](Segment& segment) { turn(segment); });
}

/// Whether the polygon runs against the circulation (5), by its longest line: short ones have the least certain
/// directions.
bool runs_backwards(const Segment* first, const Segment* last) {
  const auto squared_length = [](const Segment& segment) {
    return (segment.ends[1].position_Me - segment.ends[0].position_Me).squaredNorm();
  };
  return std::max_element(first, last,
                          [&](const Segment& a, const Segment& b) { return squared_length(a) < squared_length(b); })
      ->turned;
}

}  // namespace

void chain_segments(std::vector<Segment>& segments, std::vector<SegmentChain>& chains) {
  chains.clear();
  for (std::size_t first = 0; first < segments.size();) {
    std::size_t end = extend(segments, first + 1);
    const auto closed = [&] { return end - first > 1 && snap(segments[end - 1].ends[1], segments[first].ends[0]); };
    if (!closed()) {
      turn(segments, first, end);
      end = extend(segments, end);
    }
    if (runs_backwards(&segments[first], segments.data() + end)) turn(segments, first, end);
    chains.push_back({closed(), first, end - first});
    first = end;
  }
}

}  // namespace pcm::compare::published
