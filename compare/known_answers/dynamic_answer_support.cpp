// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/dynamic_answer_support.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>

namespace pcm::compare {

double dynamic_bound(double tolerance, double steps, double condition, double size_over_depth) {
  return condition * (2 * std::sqrt(6.0) * tolerance * steps + 0x1p-52 * (steps + 1000) * size_over_depth);
}

void set_tolerance(DynamicAnswer& answer, double tolerance) {
  answer.tolerance = answer.resolution = tolerance;
  answer.level = fmt::format("rtol {:.0e}", tolerance);
}

void append(DynamicAnswer answer, double computed, double expected, double bound, const IntegrationWork& work,
            std::vector<DynamicAnswer>& answers) {
  answer.computed = computed;
  answer.expected = expected;
  answer.bound = bound;
  answer.steps = work.steps;
  answer.derivatives = work.derivatives;
  answers.push_back(std::move(answer));
}

std::string number(double x) {
  return fmt::format("{}", x);
}

}  // namespace pcm::compare
