// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/cut_stretches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fast/clipped/seen_edge.h"

namespace pcm::fast {

namespace {

/// A stretch that another one on its line, to within roundings, runs against: shares of the first.
struct Meeting {
  double begin, end;  ///< of the other one, which may begin or end beyond: begin > end, for it runs back
  Places common;

  Meeting(const CutStretch& x, const CutStretch& y) {
    const PrismPoint way = x.b - x.a;
    const int wider = std::abs(way[kS]) >= std::abs(way[kT]) ? kS : kT;
    begin = (y.a[wider] - x.a[wider]) / way[wider];
    end = (y.b[wider] - x.a[wider]) / way[wider];
    common = {std::max(end, 0.0), std::min(begin, 1.0)};
  }
  bool is_one(const CutStretch& x, const CutStretch& y, const Uncertainty& uncertainty) const {
    const PrismPoint way = x.b - x.a;
    return common.first < common.last && lie_on_line(y.a, y.b, x.a, x.b, uncertainty) &&
           are_apart(x.a + common.first * way, x.a + common.last * way, uncertainty);
  }
};

/// Takes out of both what they have in common: what is left of the other one lies beyond the first one's ends.
void part_with(const Meeting& meeting, CutStretch& x, CutStretch& y, std::vector<CutStretch>& rest) {
  const CutStretch one = x, other = y;
  const PrismPoint way = one.b - one.a;
  x.b = one.a + meeting.common.first * way;
  if (meeting.common.last < 1) rest.push_back({one.line, one.a + meeting.common.last * way, one.b});
  y.b = meeting.begin > 1 ? one.b : other.a;
  if (meeting.end < 0) rest.push_back({other.line, one.a, other.b});
}

}  // namespace

void CutStretches::find_with_one_piece(const Uncertainty& uncertainty, std::vector<CutStretch>& found) {
  found.clear();
  std::sort(ends_.begin(), ends_.end());
  int balance = 0;
  for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
    const End &here = ends_[i], &next = ends_[i + 1];
    if (i > 0 && !here.is_on_edge_of(ends_[i - 1])) balance = 0;
    balance += here.turn;
    if (!here.is_on_edge_of(next)) continue;
    if (balance > 0) found.push_back({here.line, here.point, next.point});
    if (balance < 0) found.push_back({here.line, next.point, here.point});
  }
  // A limit, whatever roundings make of their ends: what is left then moves as its cut.
  std::size_t partings = found.size() * found.size();
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = i + 1; j < found.size() && partings > 0; ++j) {
      if (!are_apart(found[i].a, found[i].b, uncertainty)) break;
      const Meeting meeting(found[i], found[j]);
      if (!meeting.is_one(found[i], found[j], uncertainty)) continue;
      CutStretch x = found[i], y = found[j];
      part_with(meeting, x, y, found);
      found[i] = x;
      found[j] = y;
      --partings;
    }
}

bool are_apart(const PrismPoint& a, const PrismPoint& b, const Uncertainty& uncertainty) {
  return std::abs(b[kS] - a[kS]) > uncertainty.s || std::abs(b[kT] - a[kT]) > uncertainty.t;
}

bool lie_on_line(const PrismPoint& a, const PrismPoint& b, const PrismPoint& from, const PrismPoint& to,
                 const Uncertainty& uncertainty) {
  const double width_s = std::abs(to[kS] - from[kS]), width_t = std::abs(to[kT] - from[kT]);
  const auto is_off = [&](const PrismPoint& x) {
    return certain(0.5 * std::abs(cross_st(from, to, x)), width_s, width_t, uncertainty);
  };
  return !is_off(a) && !is_off(b);
}

}  // namespace pcm::fast
