// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/tangent_verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

#include "compare/verify/bounds/tangent_bounds.h"
#include "compare/verify/verdict/element_key.h"

namespace pcm::compare {
namespace {

constexpr std::array<std::string_view, 2> kRows = {"force", "torque"};
constexpr std::array<std::string_view, 4> kColumns = {"position", "rotation", "velocity", "angular velocity"};

/// Whether each of the engine's elements is one of the oracle's; both are in order.
bool has_all(const std::vector<reference::Element>& elements, const std::vector<fast::Element>& found) {
  const auto before = [](const auto& a, const auto& b) { return key(a) < key(b); };
  return std::includes(elements.begin(), elements.end(), found.begin(), found.end(), before);
}

}  // namespace

fast::Tangent allowed_errors(const Question& question, const std::vector<fast::Element>& found,
                             const reference::Answer& true_rounded, const reference::Tangent& truth) {
  if (!has_all(true_rounded.elements, found)) return fast::Tangent::Constant(std::numeric_limits<double>::infinity());
  return truth.error + tangent_bounds(question, true_rounded, truth.elements);
}

bool may_overflow(const reference::Tangent& truth, const fast::Tangent& allowed) {
  return !(kGreatestOnTheWay * (truth.slope.cwiseAbs() + allowed)).allFinite();
}

void check_tangent(const fast::Contact& subj, const reference::Tangent& truth, const fast::Tangent& allowed,
                   Checks& checks) {
  if (!subj.tangent) {
    checks.add(Kind::tangent, "no tangent");
    return;
  }
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 12; ++column) {
      const double ours = (*subj.tangent)(row, column), theirs = truth.slope(row, column), bound = allowed(row, column);
      if (std::abs(ours - theirs) <= bound) continue;
      checks.add(Kind::tangent, "{} {} by {} {}: engine {}, oracle {}, bound {:.2g}",
                 kRows[static_cast<std::size_t>(row / 3)], row % 3, kColumns[static_cast<std::size_t>(column / 3)],
                 column % 3, ours, theirs, bound);
    }
  for (int row = 0; row < 6; row += 3)
    for (int column = 0; column < 12; column += 3)
      checks.checked(Kind::tangent, allowed.block<3, 3>(row, column).maxCoeff(),
                     truth.slope.block<3, 3>(row, column).lpNorm<Eigen::Infinity>());
}

}  // namespace pcm::compare
