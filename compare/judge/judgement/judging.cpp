// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/judging.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/judge/lines/answer_lines.h"

namespace pcm::compare {

void JudgedTally::add(const PoseVerdict& verdict) {
  ++poses;
  const bool is_wrong = verdict.has(Verdict::wrong);
  wrong += is_wrong;
  near += !is_wrong && verdict.has(Verdict::near);
  for (const FactVerdict& fact : verdict.facts) {
    FactTally& tally = facts[static_cast<std::size_t>(fact.fact)];
    ++(fact.verdict == Verdict::right ? tally.right : fact.verdict == Verdict::near ? tally.near : tally.wrong);
    if (fact.verdict != Verdict::wrong) continue;
    tally.lost += fact.lost;
    tally.spurious += fact.spurious;
  }
}

void JudgedTally::add(Breakdown breakdown) {
  ++poses;
  ++wrong;
  ++breakdowns[static_cast<std::size_t>(breakdown)];
}

void JudgedTally::merge(const JudgedTally& other) {
  poses += other.poses;
  wrong += other.wrong;
  near += other.near;
  for (std::size_t k = 0; k < kBreakdowns; ++k) breakdowns[k] += other.breakdowns[k];
  for (std::size_t k = 0; k < kFacts; ++k) {
    facts[k].right += other.facts[k].right;
    facts[k].near += other.facts[k].near;
    facts[k].wrong += other.facts[k].wrong;
    facts[k].lost += other.facts[k].lost;
    facts[k].spurious += other.facts[k].spurious;
  }
}

namespace {

/// The place of the tally of that name, which is entered where there is none.
std::size_t place_of(const std::string& name, std::vector<std::pair<std::string, JudgedTally>>& tallies) {
  const auto known =
      std::find_if(tallies.begin(), tallies.end(), [&](const auto& entry) { return entry.first == name; });
  const auto place = static_cast<std::size_t>(known - tallies.begin());
  if (known == tallies.end()) tallies.emplace_back(name, JudgedTally{});
  return place;
}

}  // namespace

Judging::Judging(const Judge& judge) : judge_(judge) {
  for (const PosedQuestion& question : judge.posed().questions) {
    stratum_of_.push_back(place_of(question.stratum, strata_));
    pair_of_.push_back(place_of(question.pair, pairs_));
  }
}

void Judging::add(std::vector<Reply> replies, int jobs, const std::function<bool()>& stop,
                  const std::function<void(std::int64_t)>& progress) {
  std::vector<std::optional<PoseVerdict>> verdicts(replies.size());
  std::atomic<std::int64_t> done = 0;
  std::mutex reporting;
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::size_t>(0, replies.size(), 1),
        [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
          for (std::size_t k = range.begin(); k < range.end(); ++k) {
            if (stop()) return;
            const Reply& reply = replies[k];
            verdicts[k] =
                reply.breakdown ? PoseVerdict() : judge_.judge(judge_.posed().questions[reply.question], reply.answer);
            const std::int64_t now = judged_ + ++done;
            if (const std::unique_lock lock(reporting, std::try_to_lock); lock) progress(now);
          }
        },
        oneapi::tbb::simple_partitioner());
  });
  judged_ += done;
  for (std::size_t k = 0; k < replies.size(); ++k)
    if (verdicts[k]) keep(std::move(replies[k]), *verdicts[k]);
}

void Judging::keep(Reply reply, const PoseVerdict& verdict) {
  JudgedTally& stratum = strata_[stratum_of_[reply.question]].second;
  for (JudgedTally* const tally : {&stratum, &pairs_[pair_of_[reply.question]].second}) {
    if (reply.breakdown)
      tally->add(*reply.breakdown);
    else
      tally->add(verdict);
  }
  conventions_.add(verdict.conventions, reply.line);
  const bool is_wrong = reply.breakdown || verdict.has(Verdict::wrong);
  if (is_wrong && stratum.wrong <= kMostCasesOfAStratum) wrong_answers_.push_back({std::move(reply), verdict.facts});
}

JudgedTally Judging::total() const {
  JudgedTally total;
  for (const auto& [stratum, tally] : strata_) total.merge(tally);
  return total;
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
  std::vector<std::array<std::string, 2>> texts;
  for (const FactVerdict& fact : wrong.facts)
    if (fact.verdict != Verdict::right)
      texts.push_back(
          {std::string(name(fact.fact)) + (fact.verdict == Verdict::near ? " (near another answer)" : ""), fact.text});
  if (wrong.reply.breakdown)
    texts.push_back(
        {std::string(kBreakdownNames[static_cast<std::size_t>(*wrong.reply.breakdown)]), wrong.reply.failure});
  return format_foreign_case(posed, texts, answer_json(question.id, wrong.reply.answer, Notation::hexadecimal),
                             decided(judge_.truth(question)));
}

}  // namespace pcm::compare
