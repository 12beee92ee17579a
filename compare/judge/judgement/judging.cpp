// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/judging.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/judge/lines/answer_lines.h"

namespace pcm::compare {

namespace {

void enter(const std::string& name, std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

Judging::Judging(const Judge& judge) : judge_(judge) {
  for (const PosedQuestion& question : judge.posed().questions) {
    enter(question.stratum, strata_);
    enter(question.pair, pairs_);
  }
}

void Judging::add(std::vector<Reply> replies, int jobs, const std::function<bool()>& stop,
                  const std::function<void(std::int64_t)>& progress) {
  std::vector<std::optional<Judged>> judged(replies.size());
  const std::int64_t before = all_.poses();
  std::atomic<std::int64_t> done = 0;
  std::mutex reporting;
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::size_t>(0, replies.size(), 1),
        [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
          for (std::size_t k = range.begin(); k < range.end(); ++k) {
            if (stop()) return;
            judged[k] = judge_one(std::move(replies[k]));
            const std::int64_t now = before + ++done;
            if (const std::unique_lock lock(reporting, std::try_to_lock); lock) progress(now);
          }
        },
        oneapi::tbb::simple_partitioner());
  });
  for (std::optional<Judged>& one : judged)
    if (one) all_.merge(std::move(*one));
}

Judged Judging::judge_one(Reply reply) const {
  const PosedQuestion& question = judge_.posed().questions[reply.question];
  const PoseVerdict verdict = reply.breakdown ? PoseVerdict() : judge_.judge(question, reply.answer);
  JudgedTally tally;
  if (reply.breakdown)
    tally.add(*reply.breakdown);
  else
    tally.add(verdict);
  const bool tie = tally.wrong > 0 && judge_.is_tie(question);
  tally.ties = tie;
  Judged judged;
  judged.strata[question.stratum] = judged.pairs[question.pair] = tally;
  judged.conventions.add(verdict.conventions, reply.line);
  if (tally.wrong > 0) {
    const std::size_t number = reply.question;
    judged.wrong_answers[question.stratum].emplace(number, WrongAnswer{std::move(reply), verdict.facts, tie});
  }
  return judged;
}

JudgedTally Judging::total() const {
  JudgedTally total;
  for (const auto& [stratum, tally] : all_.strata) total.merge(tally);
  return total;
}

std::vector<WrongAnswer> Judging::wrong_answers() const {
  std::map<std::size_t, WrongAnswer> by_question;
  for (const auto& [stratum, wrong] : all_.wrong_answers) by_question.insert(wrong.begin(), wrong.end());
  std::vector<WrongAnswer> all;
  for (auto& [question, wrong] : by_question) all.push_back(std::move(wrong));
  return all;
}

Judging::NamedTallies Judging::in_order(const std::vector<std::string>& names,
                                        const std::map<std::string, JudgedTally>& tallies) {
  NamedTallies ordered;
  for (const std::string& name : names) {
    const auto known = tallies.find(name);
    ordered.emplace_back(name, known == tallies.end() ? JudgedTally{} : known->second);
  }
  return ordered;
}

std::string Judging::case_text(const WrongAnswer& wrong) const {
  const PosedQuestion& question = judge_.posed().questions[wrong.reply.question];
  Case posed;
  posed.origin = question.id;
  posed.E = judge_.posed().surfaces[question.E].mesh;
  posed.F = judge_.posed().surfaces[question.F].mesh;
  posed.pose = question.pose;
  posed.velocity = question.velocity;
  posed.law = question.law;
  posed.mode = question.mode;
  posed.scheme = question.scheme;
  for (const FactVerdict& fact : wrong.facts)
    if (fact.verdict != Verdict::right)
      posed.disagreements.push_back(
          {std::string(name(fact.fact)) + (fact.verdict == Verdict::near ? " (near another answer)" : ""), fact.text});
  if (wrong.reply.breakdown)
    posed.disagreements.push_back(
        {std::string(kBreakdownNames[static_cast<std::size_t>(*wrong.reply.breakdown)]), wrong.reply.failure});
  return format_case(posed, answer_json(question.id, wrong.reply.answer, Notation::hexadecimal),
                     decided(judge_.truth(question)));
}

}  // namespace pcm::compare
