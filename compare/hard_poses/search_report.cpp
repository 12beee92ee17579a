// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/search_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "compare/io/names.h"

namespace pcm::compare {
namespace {

constexpr std::size_t kMostTold = 20;

std::string legend() {
  std::string text = "Climbs to hard states, and how hard these were where a climb began and where it ended:\n";
  for (const Goal goal : kGoals) text += fmt::format("{}: {}\n", name(goal), measure(goal));
  return text;
}

std::vector<const Climbed*> climbs_to(const SearchReport& report, Goal goal, Scheme scheme) {
  std::vector<const Climbed*> found;
  for (const Climbed& climbed : report.climbs)
    if (climbed.goal == goal && climbed.hardest.scheme == scheme) found.push_back(&climbed);
  std::ranges::stable_sort(found, std::greater(), &Climbed::reached);
  return found;
}

TableCell hardness_cell(double x) {
  if (x < 0) return empty_cell();
  return {fmt::format("{:.3g}", x), x};
}

TableCell median_cell(std::vector<double> numbers) {
  std::ranges::sort(numbers);
  return hardness_cell(numbers[numbers.size() / 2]);
}

std::vector<TableCell> row_of(Goal goal, Scheme scheme, const std::vector<const Climbed*>& found) {
  std::vector<double> begun, reached;
  std::int64_t disagreeing = 0;
  for (const Climbed* climbed : found) {
    begun.push_back(climbed->begun_at);
    reached.push_back(climbed->reached);
    disagreeing += !climbed->hardest.disagreements.empty();
  }
  return {std::string(name(goal)),
          std::string(name(scheme)),
          count_cell(std::ssize(found)),
          median_cell(begun),
          hardness_cell(std::ranges::max(begun)),
          median_cell(reached),
          hardness_cell(std::ranges::max(reached)),
          count_cell(disagreeing)};
}

std::string findings(const SearchReport& report) {
  std::string lines;
  std::size_t told = 0;
  for (const Climbed& climbed : report.climbs)
    for (const auto& [kind, text] : climbed.hardest.disagreements)
      if (told++ < kMostTold) lines += fmt::format("{}: {}: {}\n", climbed.hardest.origin, kind, text);
  return lines;
}

}  // namespace

Table search_table(const SearchReport& report) {
  Table table;
  table.columns = {{"goal", "goal", false},
                   {"scheme", "scheme", false},
                   {"climbs", "climbs"},
                   {"begun at, median", "begun_at_median"},
                   {"greatest", "begun_at_greatest"},
                   {"reached, median", "reached_median"},
                   {"greatest", "reached_greatest"},
                   {"disagreements", "disagreements"}};
  for (const Goal goal : kGoals)
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
      if (const std::vector<const Climbed*> found = climbs_to(report, goal, scheme); !found.empty())
        table.rows.push_back(row_of(goal, scheme, found));
  return table;
}

std::vector<const Climbed*> hardest_climbs(const SearchReport& report, std::size_t most) {
  std::vector<const Climbed*> hardest;
  for (const Goal goal : kGoals)
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      const std::vector<const Climbed*> found = climbs_to(report, goal, scheme);
      for (std::size_t k = 0; k < std::min(most, found.size()); ++k) hardest.push_back(found[k]);
    }
  return hardest;
}

Table hardest_table(const std::vector<const Climbed*>& hardest) {
  Table table;
  table.columns = {{"goal", "goal", false}, {"scheme", "scheme", false}, {"mode", "mode", false},
                   {"from", "from", false}, {"begun at", "begun_at"},    {"reached", "reached"},
                   {"case", "case", false}};
  for (const Climbed* climbed : hardest) {
    const Case& posed = climbed->hardest;
    table.rows.push_back({std::string(name(climbed->goal)), std::string(name(posed.scheme)),
                          std::string(name(posed.mode)), climbed->from, hardness_cell(climbed->begun_at),
                          hardness_cell(climbed->reached), case_file_name(climbed->name)});
  }
  return table;
}

std::string search_summary(const SearchReport& report) {
  return legend() + "\n" + on_screen(search_table(report)) + findings(report);
}

std::string search_markdown(const SearchReport& report, const std::vector<const Climbed*>& hardest) {
  return "# Hard states that were searched for\n\n" + legend() + "\n" + markdown(search_table(report)) +
         "\n## The hardest\n\n" + markdown(hardest_table(hardest)) + "\n" + findings(report) + search_verdict(report) +
         "\n";
}

std::string search_verdict(const SearchReport& report) {
  const std::string what = fmt::format("{} climbs, {} disagreements", report.climbs.size(), report.disagreeing());
  if (report.disagreeing() > 0) return "NOT verified: " + what;
  return report.finished() ? "verified: " + what : fmt::format("unfinished: {} of {}", what, report.planned);
}

}  // namespace pcm::compare
