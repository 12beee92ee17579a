// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "compare/bench/steps.h"

namespace pcm::compare {
namespace {

constexpr const char* kSentences =
    "Force and torque at poses one after the other: asked of a memory that follows the pairing, and of the engine\n"
    "without a past; either goes all ways in turn, pass by pass. Medians over the steps of medians over the passes;\n"
    "`whole`: sums over all steps. Bubbles and spheres of `bench peers` at its poses, on seeded ways from there, and\n"
    "what pairings of `pcm simulate` went through, from one accepted step to the next.\n";

constexpr const char* kWorkLegend =
    "What an evaluation does, means over the steps, following and without a past: pairs of tree nodes, faces of F\n"
    "tested against up to eight of E at once and the pairs of these whose boxes touch, pairs that may cross, those\n"
    "that single precision does not decide, signs asked for, penetration lines, those known to find what they found at "
    "the\n"
    "last pose, and those searched for along the trees because no face is known through which they leave the slave,\n"
    "because they leave it too far off its normal, or because other faces of slave or master may be met before.\n";

TableCell mean_cell(std::int64_t sum, std::int64_t evaluations) {
  const double mean = static_cast<double>(sum) / static_cast<double>(evaluations);
  return {fmt::format("{:.1f}", mean), mean};
}

std::string verdict(const std::vector<StepsResult>& results) {
  std::int64_t evaluations = 0, different = 0;
  for (const StepsResult& result : results) {
    evaluations += result.evaluations;
    different += result.different;
  }
  return fmt::format("{} answers compared bit for bit, {} different.\n", evaluations, different);
}

}  // namespace

Table steps_table(const std::vector<StepsResult>& results) {
  Table table{{{"bodies", "bodies", false},
               {"steps", "steps", false},
               {"scheme", "scheme", false},
               {"evaluations", "evaluations"},
               {"following us", "following_us"},
               {"without a past us", "isolated_us"},
               {"ratio", "ratio"},
               {"whole", "whole_ratio"},
               {"different", "different"}},
              {}};
  for (const StepsResult& r : results)
    table.rows.push_back({r.bodies, r.steps, r.scheme, count_cell(r.evaluations), number_cell(r.following_us, 3),
                          number_cell(r.isolated_us, 3), number_cell(r.following_us / r.isolated_us, 2),
                          number_cell(r.whole_ratio, 2), count_cell(r.different)});
  return table;
}

Table steps_work_table(const std::vector<StepsResult>& results) {
  struct Counted {
    const char *title, *key;
    std::int64_t fast::WorkCounters::*counter;
  };
  static constexpr std::array<Counted, 12> kCounted{
      {{"node pairs", "node_pairs", &fast::WorkCounters::node_pairs},
       {"rows", "face_rows", &fast::WorkCounters::face_rows},
       {"live", "live_lanes", &fast::WorkCounters::live_lanes},
       {"pairs", "candidate_pairs", &fast::WorkCounters::candidate_pairs},
       {"unsure", "unsure_pairs", &fast::WorkCounters::unsure_pairs},
       {"signs", "predicates", &fast::WorkCounters::predicates},
       {"lines", "lines", &fast::WorkCounters::lines},
       {"settled", "lines_settled", &fast::WorkCounters::lines_settled},
       {"unseen", "searches_unseen", &fast::WorkCounters::searches_unseen},
       {"oblique", "searches_oblique", &fast::WorkCounters::searches_oblique},
       {"slave", "searches_slave", &fast::WorkCounters::searches_slave},
       {"master", "searches_master", &fast::WorkCounters::searches_master}}};
  Table table{
      {{"bodies", "bodies", false}, {"steps", "steps", false}, {"scheme", "scheme", false}, {"past", "past", false}},
      {}};
  for (const Counted& counted : kCounted) table.columns.push_back({counted.title, counted.key});
  for (const StepsResult& r : results) {
    for (const bool following : {true, false}) {
      std::vector<TableCell>& row = table.rows.emplace_back();
      row = {r.bodies, r.steps, r.scheme, following ? "following" : "without"};
      for (const Counted& counted : kCounted)
        row.push_back(mean_cell((following ? r.following : r.isolated).*counted.counter, r.evaluations));
    }
  }
  return table;
}

std::string steps_screen(const std::vector<StepsResult>& results, const Machine& machine) {
  return describe(machine) + '\n' + kSentences + '\n' + on_screen(steps_table(results)) + '\n' + verdict(results);
}

std::string steps_markdown(const std::vector<StepsResult>& results, const Machine& machine) {
  return fmt::format("# pcm bench steps\n\n{}\n\n{}\n{}\n{}\n{}\n{}", describe(machine), kSentences,
                     markdown(steps_table(results)), verdict(results), kWorkLegend,
                     markdown(steps_work_table(results)));
}

}  // namespace pcm::compare
