// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/judging_report.h"

#include <fmt/core.h>

#include <cmath>

#include "compare/verify/verdict/tally.h"

namespace pcm::compare {
namespace {

/// A rate as people read it.
TableCell rate_cell(double rate) {
  const double percent = 100 * rate;
  return {percent < 10 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent), rate};
}

std::vector<TableCell> fact_row(const std::string& stratum, Fact fact, const JudgedTally& tally) {
  const FactTally& of_fact = tally.of(fact);
  return {stratum,
          std::string(name(fact)),
          count_cell(of_fact.judged()),
          count_cell(of_fact.right),
          count_cell(of_fact.near),
          count_cell(of_fact.wrong),
          rate_cell(rate_upper_bound(of_fact.wrong, of_fact.judged())),
          is_set(fact) ? count_cell(of_fact.lost) : empty_cell(),
          is_set(fact) ? count_cell(of_fact.spurious) : empty_cell(),
          count_cell(tally.poses - of_fact.judged() - of_fact.no_truth),
          count_cell(of_fact.no_truth)};
}

void add_fact_rows(const std::string& stratum, const JudgedTally& tally, Table& table) {
  for (std::size_t k = 0; k < kFacts; ++k) {
    const auto fact = static_cast<Fact>(k);
    if (tally.of(fact).judged() + tally.of(fact).no_truth > 0) table.rows.push_back(fact_row(stratum, fact, tally));
  }
}

/// Of poses by `what`, each right, near another answer or wrong, and what broke down.
Table table_of_poses(const std::string& what) {
  Table table{{{what, what, false},
               {"poses", "poses"},
               {"right", "right"},
               {"near", "near"},
               {"wrong", "wrong"},
               {"of these ties", "wrong_ties"},
               {"rate below", "wrong_rate_upper_bound"},
               {"nothing judged", "nothing_judged"}},
              {}};
  for (const std::string_view word : kBreakdownNames) table.columns.push_back({std::string(word), std::string(word)});
  return table;
}

std::vector<TableCell> row_of_poses(const std::string& name, const JudgedTally& tally) {
  std::vector<TableCell> row{name,
                             count_cell(tally.poses),
                             count_cell(tally.right()),
                             count_cell(tally.near),
                             count_cell(tally.wrong),
                             count_cell(tally.ties),
                             rate_cell(rate_upper_bound(tally.wrong, tally.judged())),
                             count_cell(tally.empty)};
  for (const std::int64_t count : tally.breakdowns) row.push_back(count_cell(count));
  return row;
}

}  // namespace

Table facts_table(const Judging& run) {
  Table table{{{"stratum", "stratum", false},
               {"fact", "fact", false},
               {"judged", "judged"},
               {"right", "right"},
               {"near", "near"},
               {"wrong", "wrong"},
               {"rate below", "wrong_rate_upper_bound"},
               {"lost", "lost"},
               {"spurious", "spurious"},
               {"not given", "not_given"},
               {"no truth", "no_truth"}},
              {}};
  for (const auto& [stratum, tally] : run.strata()) add_fact_rows(stratum, tally, table);
  add_fact_rows("all", run.total(), table);
  return table;
}

Table strata_table(const Judging& run) {
  Table table = table_of_poses("stratum");
  for (const auto& [stratum, tally] : run.strata()) table.rows.push_back(row_of_poses(stratum, tally));
  table.rows.push_back(row_of_poses("all", run.total()));
  return table;
}

Table pairs_table(const Judging& run) {
  Table table = table_of_poses("pair");
  for (const auto& [pair, tally] : run.pairs())
    if (tally.wrong + tally.near > 0) table.rows.push_back(row_of_poses(pair, tally));
  return table;
}

std::string judging_legend(const JudgingSetup& setup) {
  std::string text = fmt::format(
      "Answers of {} to the poses of {}, held against the oracle's answers to the rounded problem.\n"
      "wrong: at least one fact is; rate below: upper end of the 95 % confidence interval of the rate of wrong ones;\n"
      "lost, spurious: members that the sets of all wrong answers together lack, and that they alone have;\n"
      "tie: vertices, edges, faces or penetration lines coincide exactly in the pose; clear: none do;\n"
      "not given: not in the answer, or no answer came; no truth: given, without anything that it could be held "
      "against;\n"
      "crash, hang, garbage: no answer came, and the pose counts as wrong;\n"
      "nothing judged: answers without any fact that could be judged, which count neither as right nor as wrong.\n",
      setup.who, setup.poses);
  text += setup.near_ulps == 0
              ? "No other poses were asked about.\n"
              : fmt::format(
                    "near: wrong, but right by the same measure where r is moved by up to {} ulps of the "
                    "greatest coordinate\n(by 1, 2, 4, ... along axes and diagonals, A unturned) and the "
                    "oracle's discrete answer is another one.\n",
                    setup.near_ulps);
  text += setup.tolerances.empty()
              ? "Values may be off by what a right evaluation in doubles may be off.\n"
              : "Values may be off by what a right evaluation in doubles may be off, or by what was stated: " +
                    setup.tolerances + ".\n";
  return text;
}

nlohmann::ordered_json judging_json(const Judging& run, const JudgingSetup& setup, const std::string& ended) {
  nlohmann::ordered_json whole;
  whole["answers"] = setup.who;
  whole["poses"] = setup.poses;
  whole["tolerances"] = setup.tolerances;
  whole["near_ulps"] = setup.near_ulps;
  whole["complete"] = ended.empty();
  if (!ended.empty()) whole["ended"] = ended;
  whole["strata"] = json(strata_table(run));
  whole["facts"] = json(facts_table(run));
  whole["pairs"] = json(pairs_table(run));
  whole["wrong_answers"] = nlohmann::ordered_json::array();
  for (const WrongAnswer& wrong : run.wrong_answers()) {
    nlohmann::ordered_json entry{{"id", run.judge().posed().questions[wrong.reply.question].id}, {"tie", wrong.tie}};
    for (const FactVerdict& fact : wrong.facts)
      if (fact.verdict == Verdict::wrong) entry["wrong"][std::string(name(fact.fact))] = fact.text;
    if (wrong.reply.breakdown)
      entry["wrong"][std::string(kBreakdownNames[static_cast<std::size_t>(*wrong.reply.breakdown)])] =
          wrong.reply.failure;
    whole["wrong_answers"].push_back(std::move(entry));
  }
  return whole;
}

std::string judging_verdict(const Judging& run, bool finished) {
  const JudgedTally total = run.total();
  const char* word = total.wrong > 0      ? "NOT right"
                     : !finished          ? "unfinished"
                     : total.judged() > 0 ? "right"
                                          : "nothing judged";
  std::string line =
      fmt::format("{}: {} answers, {} wrong, {} near another answer", word, total.poses, total.wrong, total.near);
  std::int64_t broken = 0;
  for (const std::int64_t count : total.breakdowns) broken += count;
  if (broken > 0) line += fmt::format(", {} without an answer", broken);
  if (total.empty > 0) line += fmt::format(", {} with nothing that could be judged", total.empty);
  if (!finished && total.wrong > 0) line += " (unfinished)";
  return line;
}

}  // namespace pcm::compare
