// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "compare/error_budget/error_budget.h"
#include "compare/io/names.h"

namespace pcm::compare {
namespace {

/// Columns as words.
using Line = std::vector<std::string>;

std::string percent(double x) {
  return fmt::format("{:+.3g} %", 100 * x);
}

std::string size_in_percent(double x) {
  return fmt::format("{:.2g} %", 100 * x);
}

std::string order(const SeriesResult& row) {
  return row.convergence.order ? fmt::format("{:.2f}", *row.convergence.order) : "-";
}

/// What part of the error of geometry is gone at equal volume.
std::string part_removed(double as_meshed, double equal_volume) {
  return fmt::format("{:.0f} %", 100 * (1 - std::abs(equal_volume) / std::abs(as_meshed)));
}

/// Bodies and resolution, the first columns of both tables.
Line resolution(const KnownAnswerResult& result, std::size_t level) {
  const Resolution& r = result.problem.series.front().levels[level];
  return {result.problem.title, fmt::format("{}", r.faces), fmt::format("{:.4f}", r.edge),
          fmt::format("{:.0f}", r.across)};
}

Line with(Line line, const Line& more) {
  line.insert(line.end(), more.begin(), more.end());
  return line;
}

/// Rows of the whole budget: levels from coarse to fine, the orders last.
std::vector<Line> budget_lines(const KnownAnswerResult& result) {
  const auto row = [&](BudgetRow r) -> const SeriesResult& { return row_of(result, r); };
  std::vector<Line> lines;
  for (std::size_t l = 0; l < result.problem.series.front().levels.size(); ++l)
    lines.push_back(with(
        resolution(result, l),
        {fmt::format("{:.0e}", row(BudgetRow::rounding_barycentric).levels[l].value),
         fmt::format("{:.0e}", row(BudgetRow::rounding_clipped).levels[l].value),
         percent(row(BudgetRow::discretisation).levels[l].value),
         size_in_percent(row(BudgetRow::one_pose).levels[l].rms), percent(row(BudgetRow::geometry).levels[l].deviation),
         percent(row(BudgetRow::geometry_equal_volume).levels[l].deviation),
         part_removed(row(BudgetRow::geometry).levels[l].deviation,
                      row(BudgetRow::geometry_equal_volume).levels[l].deviation)}));
  lines.push_back({result.problem.title, "order", "", "", "", "", order(row(BudgetRow::discretisation)),
                   order(row(BudgetRow::one_pose)), order(row(BudgetRow::geometry)),
                   order(row(BudgetRow::geometry_equal_volume)), ""});
  return lines;
}

std::string markdown(const Line& line) {
  return fmt::format("| {} |\n", fmt::join(line, " | "));
}

}  // namespace

std::string barycentric_error_markdown(const std::vector<KnownAnswerResult>& budget) {
  std::string table =
      "| bodies, the master first | edge of the master, m | edges across | mean, % | rms, % | greatest, % | order |\n"
      "|---|---|---|---|---|---|--:|\n";
  for (const KnownAnswerResult& result : budget) {
    const SeriesResult &mean = row_of(result, BudgetRow::discretisation), &size = row_of(result, BudgetRow::one_pose);
    std::array<Line, 5> columns;
    for (std::size_t l = 0; l < mean.levels.size(); ++l) {
      const Resolution& r = result.problem.series.front().levels[l];
      columns[0].push_back(fmt::format("{:.2g}", r.edge));
      columns[1].push_back(fmt::format("{:.0f}", r.across));
      columns[2].push_back(fmt::format("{:+.2g}", 100 * mean.levels[l].value));
      columns[3].push_back(fmt::format("{:.2g}", 100 * size.levels[l].rms));
      columns[4].push_back(fmt::format("{:.2g}", 100 * size.levels[l].greatest));
    }
    Line line{result.problem.title};
    for (const Line& column : columns) line.push_back(fmt::format("{}", fmt::join(column, " / ")));
    line.push_back(order(mean));
    table += markdown(line);
  }
  return table;
}

std::string error_budget_markdown(const std::vector<KnownAnswerResult>& budget) {
  std::string page = "# Error budget of the elastic force\n\n";
  for (const KnownAnswerResult& result : budget)
    page += fmt::format("- {}: {} Reference: {}.\n", result.problem.title, result.problem.problem,
                        result.problem.reference);
  page +=
      "\n`faces`: of both bodies; `edge`: root mean square edge length of the master, m; `across`: width of the "
      "contact in edges. `rounding`: "
      "engine against the exact problem on the same meshes, relative to the sum of the elements' forces, mean. "
      "`discretisation`: barycentric scheme less the clipped integral on the same meshes, along the force, mean; `one "
      "pose`: root mean square over the orientations of the length of that difference. `geometry`: clipped integral "
      "against the smooth bodies, mean; `equal volume`: the same, the meshes made larger until they enclose the smooth "
      "bodies' volumes; `removed`: what part of the error of geometry is gone with it. All but rounding relative to "
      "the smooth bodies' force. `order`: in edge length over the last "
      "three levels.\n\n"
      "| bodies | faces | edge | across | rounding, barycentric | rounding, clipped | discretisation | one pose | "
      "geometry | equal volume | removed |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const KnownAnswerResult& result : budget)
    for (const Line& line : budget_lines(result)) page += markdown(line);
  page += "\n## Error of the barycentric scheme against the clipped integral over master resolution\n\n";
  return page + barycentric_error_markdown(budget);
}

std::string error_budget_summary(const std::vector<KnownAnswerResult>& budget) {
  const auto on_screen = [](const Line& l) {
    std::string text = fmt::format("{:<18}{:>7}{:>8}{:>8}{:>10}{:>7}{:>12}{:>10}{:>11}{:>14}{:>9}", l[0], l[1], l[2],
                                   l[3], l[4], l[5], l[6], l[7], l[8], l[9], l[10]);
    return text.erase(text.find_last_not_of(' ') + 1) + "\n";
  };
  std::string screen =
      "Rounding: engine against oracle (barycentric, clipped); discretisation: barycentric - clipped, mean over the\n"
      "orientations, and rms of one pose; geometry: clipped against smooth bodies, as meshed, with meshes of the "
      "smooth\n"
      "bodies' volume, and what part of it that removes; orders in edge length. The first body is the master.\n";
  screen += on_screen({"bodies", "faces", "edge m", "across", "rounding", "", "discretis.", "one pose", "geometry",
                       "equal volume", "removed"});
  for (const KnownAnswerResult& result : budget)
    for (const Line& line : budget_lines(result)) screen += on_screen(line);
  for (const KnownAnswerResult& result : budget)
    for (std::size_t s = 0; s < result.series.size(); ++s)
      for (const std::string& miss : result.series[s].misses)
        screen += fmt::format("missed: {}, {} ({}): {}\n", result.problem.title, result.problem.series[s].quantity,
                              name(result.problem.series[s].scheme), miss);
  return screen;
}

std::string error_budget_verdict(const std::vector<KnownAnswerResult>& budget) {
  std::size_t rows = 0, missed = 0;
  for (const KnownAnswerResult& result : budget) {
    rows += result.series.size();
    missed += result.missed();
  }
  return fmt::format("error budget {}: {} cases, {} rows, {} missed", missed == 0 ? "met" : "NOT met", budget.size(),
                     rows, missed);
}

}  // namespace pcm::compare
