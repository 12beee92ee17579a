// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/cut_stretches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fast/clipped/seen_edge.h"

namespace pcm::fast {

namespace {

/// As shares of the first stretch, what it has in common with one that runs against it on its line.
Places common(const CutStretch& x, const CutStretch& y, const Uncertainty& uncertainty) {
  const PrismPoint way = x.b - x.a;
  const int wider = std::abs(way[kS]) >= std::abs(way[kT]) ? kS : kT;
  const auto share = [&](const PrismPoint& at) { return (at[wider] - x.a[wider]) / way[wider]; };
  const Places both{std::max(share(y.b), 0.0), std::min(share(y.a), 1.0)};
  const bool is_one = both.first < both.last && lie_on_line(y.a, y.b, x.a, x.b, uncertainty) &&
                      are_apart(x.a + both.first * way, x.a + both.last * way, uncertainty);
  return is_one ? both : Places{0, 0};
}

/// Takes out of both what they have in common.
void part_with(const Places& shares, CutStretch& x, CutStretch& y, std::vector<CutStretch>& rest) {
  const PrismPoint way = x.b - x.a, first = x.a + shares.first * way, last = x.a + shares.last * way;
  if (shares.last < 1) rest.push_back({x.line, last, x.b});
  rest.push_back({y.line, y.a, last});
  x.b = y.a = first;
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
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = i + 1; j < found.size(); ++j) {
      if (!are_apart(found[i].a, found[i].b, uncertainty)) break;
      const Places shares = common(found[i], found[j], uncertainty);
      if (!(shares.first < shares.last)) continue;
      CutStretch x = found[i], y = found[j];
      part_with(shares, x, y, found);
      found[i] = x;
      found[j] = y;
      j = i;
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
