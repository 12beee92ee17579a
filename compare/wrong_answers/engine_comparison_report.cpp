// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/wrong_answers/engine_comparison_report.h"

#include <fmt/core.h>

namespace pcm::compare {
namespace {

/// What the engine's own columns are; of the exact one only the whole.
std::vector<Wrong> shown(Engine engine) {
  if (engine == Engine::fast) return {};
  std::vector<Wrong> kinds;
  for (std::size_t k = 1; k < kWrongs; ++k)
    if (answers(engine, static_cast<Wrong>(k))) kinds.push_back(static_cast<Wrong>(k));
  return kinds;
}

/// Failures have no column of their own: they are in `wrong`.
std::vector<TableCell> row(const std::string& stratum, const ComparisonTally& tally,
                           const std::vector<Engine>& engines) {
  std::vector<TableCell> cells{stratum, count_cell(tally.poses)};
  for (const Engine engine : engines) {
    const ComparisonTally::OfEngine& of_engine = tally.of(engine);
    cells.push_back(count_cell(of_engine.wrong));
    for (const Wrong kind : shown(engine)) cells.push_back(count_cell(of_engine.by[static_cast<std::size_t>(kind)]));
  }
  cells.push_back(count_cell(tally.without_rule));
  for (const Engine engine : engines)
    if (engine != Engine::fast) cells.push_back(count_cell(tally.of(engine).differs_without_rule));
  return cells;
}

std::string key_of(Engine engine, std::string_view what) {
  std::string key = fmt::format("{} {}", name(engine), what);
  for (char& c : key)
    if (c == ' ' || c == '-') c = '_';
  return key;
}

/// "2003" of "published-2003".
std::string short_name(Engine engine) {
  const std::string_view whole = name(engine);
  return std::string(whole.substr(whole.find('-') + 1));
}

}  // namespace

Table engine_comparison_table(const EngineComparison& result) {
  Table table{{{"stratum", "stratum", false}, {"poses", "poses"}}, {}};
  for (const Engine engine : result.engines) {
    table.columns.push_back({short_name(engine) + ": wrong", key_of(engine, "wrong")});
    for (const Wrong kind : shown(engine))
      table.columns.push_back({std::string(name(kind)), key_of(engine, name(kind))});
  }
  table.columns.push_back({"no rule", "without_rule"});
  for (const Engine engine : result.engines)
    if (engine != Engine::fast)
      table.columns.push_back({short_name(engine) + " differs", key_of(engine, "differs_without_rule")});
  for (const auto& [stratum, tally] : result.strata)
    table.rows.push_back(row(std::string(name(stratum)), tally, result.engines));
  table.rows.push_back(row("all", result.all, result.engines));
  return table;
}

std::string engine_comparison_legend() {
  return fmt::format(
      "Poses at which each engine's answer is not the oracle's on the rounded problem: wrong in anything, and in "
      "what.\n"
      "touching: do the surfaces cross; open chains: polygons of closed surfaces that do not close; polygons: their\n"
      "number or their crossings; active faces: intersected or inner ones; elements: which master and slave faces; "
      "force:\n"
      "force or torque beyond {:.0e} of the sum of the elements' (where they are so shallow that doubles can't tell: "
      "beyond\n"
      "the rounding of a right evaluation). no rule: nested, ambiguous or too deep, of which the published algorithms\n"
      "say nothing: there their elements are not held, and `differs` counts other forces.\n",
      kForceTolerance);
}

std::string engine_comparison_on_shallow_poses(const EngineComparison& result) {
  std::string text;
  for (const auto& [stratum, tally] : result.strata) {
    if (stratum != Stratum::generic || tally.shallow == 0) continue;
    const std::int64_t ruled = tally.shallow - tally.shallow_without_rule;
    text +=
        fmt::format("Shallow generic poses, nothing deeper than a tenth of the smaller body: {}, {} of them no rule\n",
                    tally.shallow, tally.shallow_without_rule);
    for (const Engine engine : result.engines) {
      const ComparisonTally::OfEngine& of_engine = tally.of(engine);
      const std::int64_t right = ruled - of_engine.shallow_force_wrong;
      text += fmt::format("  {:<15} right force at {} of {}", name(engine), right, ruled);
      if (ruled > 0) text += fmt::format(" ({:.2f} %)", 100 * static_cast<double>(right) / static_cast<double>(ruled));
      if (engine != Engine::fast)
        text += fmt::format("; without a rule at {} of {}",
                            tally.shallow_without_rule - of_engine.shallow_differs_without_rule,
                            tally.shallow_without_rule);
      text += '\n';
    }
  }
  return text;
}

std::string engine_comparison_verdict(const EngineComparison& result) {
  std::string line = fmt::format("{} poses, wrong answers:", result.all.poses);
  const char* separator = " ";
  for (const Engine engine : result.engines) {
    line += fmt::format("{}{} {}", separator, name(engine), result.all.of(engine).wrong);
    separator = ", ";
  }
  if (!result.finished) line += " (interrupted)";
  return line;
}

}  // namespace pcm::compare
