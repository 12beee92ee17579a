// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace pcm::compare {

/// What a search for hard states climbs to.
enum class Goal : std::uint8_t {
  margins,           ///< orientations near a tie, and none of them one
  exact_decisions,   ///< as many decisions as can be that floating point leaves open
  error_over_bound,  ///< the engine's error of force or torque as near to its own bound as can be
  bound_over_error,  ///< the bound on the force as far above its error as can be
  work,              ///< as many steps as can be
};

inline constexpr std::array kGoals = {Goal::margins, Goal::exact_decisions, Goal::error_over_bound,
                                      Goal::bound_over_error, Goal::work};

/// A word for tables and names of files, e.g. "error-over-bound".
std::string_view name(Goal goal);

/// What the measure of a goal is, in words (hardness.h).
std::string_view measure(Goal goal);

/// Whether law and velocity have a part in the measure.
bool depends_on_law(Goal goal);

}  // namespace pcm::compare
