// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/error_budget/bodies.h"
#include "compare/known_answers/known_answers.h"

/// Three kinds of error of the elastic force kept apart, for pairs of smooth bodies over resolutions: rounding (engine
/// against the oracle's exact problem, same scheme, same meshes), discretisation (barycentric scheme against the
/// clipped integral, same meshes) and geometry (clipped integral against the smooth bodies, as meshed and at equal
/// volume).
namespace pcm::compare {

/// The rows of every case, in this order. All but rounding are relative to the smooth bodies' force and taken along it.
enum class BudgetRow : std::uint8_t {
  rounding_barycentric,   ///< |F - F_oracle| / sum |F_k|
  rounding_clipped,       ///< the same in the clipped scheme
  discretisation,         ///< barycentric - clipped
  one_pose,               ///< the length of that difference, all components
  geometry,               ///< clipped - smooth
  geometry_equal_volume,  ///< the same for meshes that enclose the smooth bodies' volumes
};
inline constexpr std::size_t kBudgetRows = 6;

/// A pair of bodies as a problem with one series for each row.
KnownAnswer budget_problem(const BudgetCase& pair, Extent extent);

/// The result of a row at a level, and what its levels say together.
const SeriesResult& row_of(const KnownAnswerResult& result, BudgetRow row);

/// All cases on `jobs` threads; `progress` is told what comes next. The same bits whatever the number of threads. What
/// is kept is not worked out again.
std::vector<KnownAnswerResult> error_budget(Extent extent, int jobs, KeptValues& kept,
                                            const std::function<void(const std::string&)>& progress);

/// The paper's claim in numbers: error of the barycentric scheme against the clipped integral over master resolution,
/// in Markdown.
std::string barycentric_error_markdown(const std::vector<KnownAnswerResult>& budget);

/// All kinds of error over resolutions, one line a level: in Markdown with its legend, and plain for a screen, every
/// miss below.
std::string error_budget_markdown(const std::vector<KnownAnswerResult>& budget);
std::string error_budget_summary(const std::vector<KnownAnswerResult>& budget);

/// The last line printed.
std::string error_budget_verdict(const std::vector<KnownAnswerResult>& budget);

}  // namespace pcm::compare
