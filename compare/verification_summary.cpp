// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verification_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace pcm::compare {
namespace {

using NamedTally = std::pair<std::string, Tally>;

/// Merges cells under their names, in order of first appearance.
template <class Name>
std::vector<NamedTally> merged(const Verification& run, const Name& name_of) {
  std::vector<NamedTally> groups;
  for (const Cell& cell : run.cells()) {
    const std::string label = name_of(cell);
    const auto named = [&label](const NamedTally& group) { return group.first == label; };
    if (std::none_of(groups.begin(), groups.end(), named)) groups.emplace_back(label, Tally());
    std::find_if(groups.begin(), groups.end(), named)->second.merge(cell.tally);
  }
  return groups;
}

std::string agreement_row(const std::string& label, const Tally& t) {
  return fmt::format("{:<26}{:>8}{:>10}{:>15}{:>11}{:>9}{:>10}{:>11.0f}{:>11.2f}\n", label, t.poses, t.touching,
                     t.disagreeing, t.ambiguous, t.flipped, t.too_deep, 1e6 * t.engine_seconds.quantile(0.5),
                     1e3 * t.oracle_seconds.quantile(0.5));
}

std::string error_row(const std::string& label, const Tally& t) {
  std::string row = fmt::format("{:<16}", label);
  for (std::size_t k = 0; k < kErrors; ++k) {
    if (t.errors[k].count() == 0) {
      row += fmt::format("{:>16}", "-");
      continue;
    }
    const double p999 = std::min(t.errors[k].quantile(0.999), t.worst[k].value);
    row += fmt::format("{:>16}", fmt::format("{:.0e} {:.0e}", p999, t.worst[k].value));
  }
  return row + "\n";
}

}  // namespace

std::string verification_summary(const Verification& run) {
  const std::vector<NamedTally> by_pair =
      merged(run, [&](const Cell& cell) { return run.plan().pairs[cell.pair].name; });
  const std::vector<NamedTally> by_stratum =
      merged(run, [](const Cell& cell) { return std::string(name(cell.stratum)); });
  const NamedTally all{"all", run.total()};

  std::string text = fmt::format("{:<26}{:>8}{:>10}{:>15}{:>11}{:>9}{:>10}{:>11}{:>11}\n", "pair", "poses", "touching",
                                 "disagreements", "ambiguous", "flipped", "too deep", "engine us", "oracle ms");
  for (const auto& [label, tally] : by_pair) text += agreement_row(label, tally);
  text += "stratum\n";
  for (const auto& [label, tally] : by_stratum) text += agreement_row(label, tally);
  text += agreement_row(all.first, all.second);

  text +=
      "\nRounding error of the engine against the exact problem: 99.9th percentile and maximum, in units of S/p\n"
      "(S: greatest coordinate, p: mean thickness of the intersection; force and torque without flipped poses)\n";
  text += fmt::format("{:<16}", "stratum");
  for (const char* error : kErrorNames) text += fmt::format("{:>16}", error);
  text += "\n";
  for (const auto& [label, tally] : by_stratum) text += error_row(label, tally);
  text += error_row(all.first, all.second);
  for (const std::string& omission : run.omissions()) text += "\n" + omission + "\n";
  return text;
}

}  // namespace pcm::compare
