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

void check_tangent(const Question& question, const fast::Contact& subj, const std::vector<fast::Element>& found,
                   const reference::Answer& true_rounded, const reference::Tangent& truth, Checks& checks) {
  if (!subj.tangent) {
    checks.add(Kind::tangent, "no tangent");
    return;
  }
  fast::Tangent bounds = truth.error;
  if (has_all(true_rounded.elements, found)) {
    bounds += tangent_bounds(question, true_rounded, truth.elements);
  } else {
    bounds.setConstant(std::numeric_limits<double>::infinity());
  }
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 12; ++column) {
      const double ours = (*subj.tangent)(row, column), theirs = truth.slope(row, column), bound = bounds(row, column);
      if (std::abs(ours - theirs) <= bound) continue;
      checks.add(Kind::tangent, "{} {} by {} {}: engine {}, oracle {}, bound {:.2g}",
                 kRows[static_cast<std::size_t>(row / 3)], row % 3, kColumns[static_cast<std::size_t>(column / 3)],
                 column % 3, ours, theirs, bound);
    }
  for (int row = 0; row < 6; row += 3)
    for (int column = 0; column < 12; column += 3)
      checks.checked(Kind::tangent, bounds.block<3, 3>(row, column).maxCoeff(),
                     truth.slope.block<3, 3>(row, column).lpNorm<Eigen::Infinity>());
}

}  // namespace pcm::compare
