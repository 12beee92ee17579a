// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/error_budget_bodies.h"
#include "compare/known_answers.h"

/// Three kinds of error kept apart: rounding (engine against the exact problem), discretisation (barycentric scheme
/// against the clipped integral on the same meshes) and geometry (clipped integral against the smooth bodies).
namespace pcm::compare {

/// The errors at one resolution, over fixed orientations. "Mean force" is that of the clipped scheme along the axis,
/// the direction of the smooth bodies' force or, where that is not known, the clipped force's own.
struct BudgetLevel {
  Index master_faces = 0;
  double edge = 0;                   ///< root mean square edge length of the master, m
  double across = 0;                 ///< width of the contact in edges; 0 where it is not known
  double rounding_barycentric = 0;   ///< mean |F_engine - F_oracle| / sum |F_k|
  double rounding_clipped = 0;       ///< the same in the clipped scheme
  double discretisation = 0;         ///< mean of barycentric - clipped along the axis / mean force
  double discretisation_single = 0;  ///< root mean square of |barycentric - clipped|, all components / mean force
  std::optional<double> geometry;    ///< (mean force - reference) / reference
  std::optional<double> geometry_equal_volume;  ///< the same for meshes that enclose the smooth bodies' volumes
};

struct ErrorBudget {
  BudgetCase pair;
  int orientations = 0;
  std::vector<BudgetLevel> levels;
};

/// log(e1 / e3) / log(h1 / h3) over the last three levels, of any of the errors above; none where the error is absent
/// or changes its sign.
std::optional<double> observed_order(const ErrorBudget& budget,
                                     const std::function<std::optional<double>(const BudgetLevel&)>& error);

/// One level of a case, on the threads of the current arena. The same bits whatever their number.
BudgetLevel error_budget(const BudgetCase& pair, std::size_t level, int orientations);

/// All cases on `jobs` threads; `progress` is told what comes next.
std::vector<ErrorBudget> error_budgets(Extent extent, int jobs,
                                       const std::function<void(const std::string&)>& progress);

/// One table of all cases, levels and orders, in Markdown with its legend, or plain for a screen.
std::string error_budget_markdown(const std::vector<ErrorBudget>& budgets);
std::string error_budget_summary(const std::vector<ErrorBudget>& budgets);

}  // namespace pcm::compare
