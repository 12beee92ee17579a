// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::compare {
namespace {

/// `equal`: engine and oracle have the same value, infinity perhaps, from which no distance is a number.
bool holds(double distance, double bound, bool equal) {
  return distance <= bound || (equal && !std::isnan(bound));
}

/// No number where a component is none: stableNorm() passes over that where another component comes first.
double length_of(const Eigen::Vector3d& x) {
  return x.hasNaN() ? std::numeric_limits<double>::quiet_NaN() : x.stableNorm();
}

}  // namespace

void Checks::check_value(Kind kind, std::string_view what, double subj, double truth, double bound, double scale) {
  checked(kind, bound, scale);
  if (!holds(std::abs(subj - truth), bound, subj == truth))
    add(kind, "{}: engine {}, oracle {}, bound {:.2g}", what, subj, truth, bound);
}

void Checks::check_vector(Kind kind, std::string_view what, const Eigen::Vector3d& subj, const Eigen::Vector3d& truth,
                          double bound, double scale) {
  checked(kind, bound, scale);
  const double distance = length_of(subj - truth);
  if (!holds(distance, bound, subj == truth))
    add(kind, "{}: engine ({}, {}, {}), oracle ({}, {}, {}), apart {:.2g}, bound {:.2g}", what, subj.x(), subj.y(),
        subj.z(), truth.x(), truth.y(), truth.z(), distance, bound);
}

void Checks::checked(Kind kind, double bound, double scale) {
  if (bound == 0 && scale == 0) return;
  std::optional<double> relative;
  if (!std::isfinite(bound))
    relative = std::numeric_limits<double>::infinity();
  else if (bound == 0)
    relative = 0;
  else if (scale != 0)
    relative = std::min(bound / std::abs(scale), std::numeric_limits<double>::max());
  widths_.push_back({kind, relative});
}

std::vector<Disagreement> Checks::sorted() const {
  std::vector<Disagreement> list = list_;
  std::stable_sort(list.begin(), list.end(),
                   [](const Disagreement& a, const Disagreement& b) { return a.kind < b.kind; });
  return list;
}

void Checks::merge(Checks other) {
  for (Disagreement& d : other.list_)
    if (!knows(d.kind)) list_.push_back(std::move(d));
  widths_.insert(widths_.end(), other.widths_.begin(), other.widths_.end());
}

bool Checks::knows(Kind kind) const {
  return std::any_of(list_.begin(), list_.end(), [kind](const Disagreement& d) { return d.kind == kind; });
}

}  // namespace pcm::compare
