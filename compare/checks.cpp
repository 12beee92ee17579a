// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::compare {

void Checks::check_value(Kind kind, std::string_view what, double subj, double truth, double bound, double scale) {
  checked(kind, bound, scale);
  if (!(std::abs(subj - truth) <= bound) && subj != truth)
    add(kind, "{}: engine {}, oracle {}, bound {:.2g}", what, subj, truth, bound);
}

void Checks::check_vector(Kind kind, std::string_view what, const Eigen::Vector3d& subj, const Eigen::Vector3d& truth,
                          double bound, double scale) {
  checked(kind, bound, scale);
  const double distance = (subj - truth).stableNorm();
  if (!(distance <= bound) && subj != truth)
    add(kind, "{}: engine ({}, {}, {}), oracle ({}, {}, {}), apart {:.2g}, bound {:.2g}", what, subj.x(), subj.y(),
        subj.z(), truth.x(), truth.y(), truth.z(), distance, bound);
}

void Checks::checked(Kind kind, double bound, double scale) {
  if (bound == 0 && scale == 0) return;
  const double relative = bound == 0              ? 0
                          : !std::isfinite(bound) ? std::numeric_limits<double>::infinity()
                                                  : bound / std::abs(scale);
  widths_.push_back({kind, std::isfinite(bound) ? std::min(relative, std::numeric_limits<double>::max()) : relative});
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
