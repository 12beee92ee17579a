// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/judge/publish_judgement.h"

#include <fmt/core.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "compare/io/tables/report_folder.h"
#include "compare/judge/judgement/judged_cases.h"
#include "compare/judge/poses/poses_folder.h"

namespace pcm::compare {
namespace {

/// Some of each stratum, and how many there are.
void print_wrong_answers(const Judging& run, const std::optional<std::filesystem::path>& folder) {
  constexpr int kShown = 4;
  std::map<std::string, int> shown;
  std::int64_t all_shown = 0;
  for (const WrongAnswer& wrong : run.wrong_answers()) {
    const PosedQuestion& question = run.judge().posed().questions[wrong.reply.question];
    if (++shown[question.stratum] > kShown) continue;
    ++all_shown;
    const char* word = wrong.tie ? "tie" : "clear";
    for (const FactVerdict& fact : wrong.facts)
      if (fact.verdict == Verdict::wrong)
        std::cout << fmt::format("{} ({}): {}: {}\n", question.id, word, name(fact.fact), fact.text);
    if (wrong.reply.breakdown)
      std::cout << fmt::format("{} ({}): {}: {}\n", question.id, word,
                               kBreakdownNames[static_cast<std::size_t>(*wrong.reply.breakdown)], wrong.reply.failure);
  }
  if (const std::int64_t more = run.total().wrong - all_shown; more > 0)
    std::cout << fmt::format("... and {} more wrong answers{}\n", more,
                             folder
                                 ? "; " + (*folder / "judgement.json").string() + " has them, the first of each stratum"
                                 : "; --out DIR keeps the first of each stratum");
}

/// What was judged: the answers, and the surfaces of their poses.
Json question_of(const PosedQuestions& posed, const JudgingSetup& setup, bool complete) {
  Json question{{"answers", {{"from", setup.who}}},
                {"poses", {{"folder", setup.poses}, {"sha256", setup.poses_sha256}}},
                {"laws", std::string("of each pose its own, with scheme and mode, in ") + kPosesFile},
                {"complete", complete},
                {"surfaces", Json::array()}};
  if (!setup.answers_sha256.empty()) question["answers"]["sha256"] = setup.answers_sha256;
  for (const PosedSurface& surface : posed.surfaces)
    question["surfaces"].push_back({{"name", surface.name}, {"sha256", surface.sha256}});
  return question;
}

}  // namespace

void publish_judgement(const Judging& run, const JudgingSetup& setup,
                       const std::optional<std::filesystem::path>& folder, const std::string& ended) {
  const Table strata = strata_table(run), facts = facts_table(run), pairs = pairs_table(run);
  const std::string verdict = judging_verdict(run, ended.empty());
  std::cout << judging_legend(setup) << '\n' << on_screen(strata) << '\n' << on_screen(facts) << '\n';
  if (!pairs.rows.empty()) std::cout << on_screen(pairs) << '\n';
  print_wrong_answers(run, folder);
  std::cout << verdict << '\n';
  if (folder) {
    remove_judged_cases(*folder);
    Json whole = judging_json(run, setup, ended);
    whole["cases"] = write_judged_cases(*folder, run);
    ReportFolder tables(*folder, kJudgementReport, question_of(run.judge().posed(), setup, ended.empty()));
    tables.markdown("judgement", "# Answers before the oracle\n\n" + judging_legend(setup) + "\n" + markdown(strata) +
                                     "\n" + markdown(facts) + "\n" + markdown(pairs) + "\n" + verdict + "\n");
    tables.csv("strata", csv(strata), {});
    tables.csv("facts", csv(facts), {});
    tables.csv("pairs", csv(pairs), {});
    tables.json("judgement", whole);
    tables.finish();
  }
}

}  // namespace pcm::compare
