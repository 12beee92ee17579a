// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/goal.h"

#include <algorithm>

namespace pcm::compare {
namespace {

struct Words {
  Goal goal;
  std::string_view name, measure;
};

constexpr std::array kWords = {
    Words{Goal::margins, "margins", "1 over the least margin of a face and a vertex, or of two edges"},
    Words{Goal::exact_decisions, "exact-decisions", "decisions that floating point leaves open"},
    Words{Goal::error_over_bound, "error-over-bound", "error over bound, of a component of force or torque"},
    Words{Goal::bound_over_error, "bound-over-error", "bound over error, of the force"},
    Words{Goal::work, "work", "steps: pairs of nodes, rows of faces, decisions, elements, lines"},
};

const Words& words(Goal goal) {
  return *std::ranges::find(kWords, goal, &Words::goal);
}

}  // namespace

std::string_view name(Goal goal) {
  return words(goal).name;
}

std::string_view measure(Goal goal) {
  return words(goal).measure;
}

bool depends_on_law(Goal goal) {
  return goal == Goal::error_over_bound || goal == Goal::bound_over_error;
}

}  // namespace pcm::compare
