// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>

#include "compare/error_budget.h"

namespace pcm::compare {
namespace {

constexpr std::size_t kColumns = 10;
using Row = std::array<std::string, kColumns>;

std::string percent(const std::optional<double>& x) {
  return x ? fmt::format("{:+.3g} %", 100 * *x) : "-";
}

std::string text(const std::optional<double>& order) {
  return order ? fmt::format("{:.2f}", *order) : "-";
}

Row row(const ErrorBudget& budget, const BudgetLevel& level) {
  return {budget.pair.title,
          fmt::format("{}", level.master_faces),
          fmt::format("{:.4f}", level.edge),
          level.across > 0 ? fmt::format("{:.1f}", level.across) : "-",
          fmt::format("{:.1e}", level.rounding_barycentric),
          fmt::format("{:.1e}", level.rounding_clipped),
          percent(level.discretisation),
          fmt::format("{:.2g} %", 100 * level.discretisation_single),
          percent(level.geometry),
          percent(level.geometry_equal_volume)};
}

Row orders(const ErrorBudget& budget) {
  const auto order = [&](auto error) { return text(observed_order(budget, error)); };
  return {budget.pair.title,
          "order",
          "",
          "",
          "",
          "",
          order([](const BudgetLevel& l) -> std::optional<double> { return l.discretisation; }),
          order([](const BudgetLevel& l) -> std::optional<double> { return l.discretisation_single; }),
          order([](const BudgetLevel& l) { return l.geometry; }),
          order([](const BudgetLevel& l) { return l.geometry_equal_volume; })};
}

/// Rows of the table, from coarse to fine, the orders last.
std::vector<Row> rows(const ErrorBudget& budget) {
  std::vector<Row> table;
  for (const BudgetLevel& level : budget.levels) table.push_back(row(budget, level));
  table.push_back(orders(budget));
  return table;
}

}  // namespace

std::string error_budget_markdown(const std::vector<ErrorBudget>& budgets) {
  std::string page = "# Error budget of the elastic force\n\nThe first body is the master.";
  for (const ErrorBudget& budget : budgets)
    page += fmt::format("\n- {}: {}; {} orientations", budget.pair.title, budget.pair.problem, budget.orientations);
  page +=
      "\n\n`edge`: root mean square edge length of the master, m; `across`: width of the contact in edges. `rounding`: "
      "engine against the exact problem on the same meshes, relative to the sum of the elements' forces, mean. "
      "`discretisation`: barycentric scheme less the clipped integral on the same meshes, along the force, mean; "
      "`one pose`: root mean square of all components of the difference. `geometry`: mean of the clipped integral "
      "against the closed form; `equal volume`: the same, the meshes made larger until they enclose the smooth bodies' "
      "volumes. All relative to the force. `order`: in edge length over the last three levels.\n\n"
      "| bodies | master faces | edge | across | rounding, barycentric | rounding, clipped | discretisation | one pose "
      "| geometry | equal volume |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const ErrorBudget& budget : budgets)
    for (const Row& r : rows(budget)) page += fmt::format("| {} |\n", fmt::join(r, " | "));
  return page;
}

std::string error_budget_summary(const std::vector<ErrorBudget>& budgets) {
  const auto line = [](const Row& r) {
    return fmt::format("{:<17}{:>7}{:>8}{:>8}{:>9}{:>9}{:>12}{:>10}{:>12}{:>14}\n", r[0], r[1], r[2], r[3], r[4], r[5],
                       r[6], r[7], r[8], r[9]);
  };
  std::string screen =
      "Rounding: engine - exact problem (barycentric, clipped); discretisation: barycentric - clipped, mean and rms of "
      "one pose;\ngeometry: clipped - closed form, as meshed and at the smooth bodies' volume; orders in edge length\n";
  screen += line(
      {"bodies", "master", "edge m", "across", "rounding", "", "discretis.", "one pose", "geometry", "equal volume"});
  for (const ErrorBudget& budget : budgets)
    for (const Row& r : rows(budget)) screen += line(r);
  return screen;
}

}  // namespace pcm::compare
