// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/line_beside_cut.h"

#include <algorithm>

namespace pcm::fast {

namespace {

/// The longest of some sides that are not the cut's.
class LongestSide {
 public:
  explicit LongestSide(SideLine cut) : cut_(cut), line_(cut) {}

  void look_at(SideLine line, const PrismPoint& from, const PrismPoint& to) {
    const PrismPoint along = to - from;
    const double square = along[kS] * along[kS] + along[kT] * along[kT];
    if (line == cut_ || !(square > longest_square_)) return;
    longest_square_ = square;
    line_ = line;
  }
  void look_at(const ConvexPolygon& polygon) {
    for (int i = 0; i < polygon.count; ++i)
      look_at(polygon.lines[static_cast<std::size_t>(i)], polygon[i], polygon[polygon.next(i)]);
  }
  /// What a cut with these heights takes from a polygon's border.
  void look_at_taken(const ConvexPolygon& polygon, const Heights& heights) {
    const auto at = [&heights](int i) { return heights[static_cast<std::size_t>(i)]; };
    const auto top =
        static_cast<int>(std::max_element(heights.begin(), heights.begin() + polygon.count) - heights.begin());
    const KeptVertices kept(polygon, heights, top);
    const auto end_of_kept = [&](int vertex, int taken) {
      return at(vertex) > 0 ? point_at_zero(polygon[vertex], at(vertex), polygon[taken], at(taken)) : polygon[vertex];
    };
    PrismPoint from = end_of_kept(kept.last, kept.after);
    int next = kept.last;  // which may be the first one, too
    do {
      const SideLine line = polygon.lines[static_cast<std::size_t>(next)];
      next = polygon.next(next);
      const PrismPoint to = next == kept.first ? end_of_kept(kept.first, kept.before) : polygon[next];
      look_at(line, from, to);
      from = to;
    } while (next != kept.first);
  }
  SideLine line() const { return line_; }

 private:
  SideLine cut_, line_;
  double longest_square_ = 0;
};

}  // namespace

SideLine line_beside_cut(const ConvexPolygon& sliver, const ConvexPolygon& polygon, const Heights& heights,
                         SideLine cut) {
  LongestSide longest(cut);
  longest.look_at(sliver);
  longest.look_at_taken(polygon, heights);
  return longest.line();
}

}  // namespace pcm::fast
