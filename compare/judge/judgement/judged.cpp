// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/judged.h"

#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "compare/judge/lines/answer_lines.h"

namespace pcm::compare {

void JudgedTally::add(const PoseVerdict& verdict) {
  ++poses;
  const bool is_wrong = verdict.has(Verdict::wrong);
  wrong += is_wrong;
  near += !is_wrong && verdict.has(Verdict::near);
  empty += verdict.facts.empty();
  for (const FactVerdict& fact : verdict.facts) {
    FactTally& tally = facts[static_cast<std::size_t>(fact.fact)];
    ++(fact.verdict == Verdict::right ? tally.right : fact.verdict == Verdict::near ? tally.near : tally.wrong);
    if (fact.verdict != Verdict::wrong) continue;
    tally.lost += fact.lost;
    tally.spurious += fact.spurious;
  }
  for (const Fact fact : verdict.no_truth) ++facts[static_cast<std::size_t>(fact)].no_truth;
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
  ties += other.ties;
  empty += other.empty;
  for (std::size_t k = 0; k < kBreakdowns; ++k) breakdowns[k] += other.breakdowns[k];
  for (std::size_t k = 0; k < kFacts; ++k) {
    facts[k].right += other.facts[k].right;
    facts[k].near += other.facts[k].near;
    facts[k].wrong += other.facts[k].wrong;
    facts[k].lost += other.facts[k].lost;
    facts[k].spurious += other.facts[k].spurious;
    facts[k].no_truth += other.facts[k].no_truth;
  }
}

Json JudgedTally::to_json() const {
  Json rows = Json::array();
  for (const FactTally& fact : facts)
    rows.push_back({fact.right, fact.near, fact.wrong, fact.lost, fact.spurious, fact.no_truth});
  return {{"poses", {poses, wrong, ties, near, empty}}, {"breakdowns", breakdowns}, {"facts", std::move(rows)}};
}

JudgedTally JudgedTally::from_json(const Json& json) {
  const auto [poses, wrong, ties, near, empty] = json.at("poses").get<std::array<std::int64_t, 5>>();
  JudgedTally tally{poses, wrong, ties, near, empty, json.at("breakdowns").get<std::array<std::int64_t, kBreakdowns>>(),
                    {}};
  for (std::size_t k = 0; k < kFacts; ++k) {
    const auto row = json.at("facts").at(k).get<std::array<std::int64_t, 6>>();
    tally.facts[k] = {row[0], row[1], row[2], row[3], row[4], row[5]};
  }
  return tally;
}

Json WrongAnswer::to_json(const PosedQuestions& posed) const {
  Json json{{"question", reply.question},
            {"line", reply.line},
            {"answer", answer_json(posed.questions[reply.question].id, reply.answer, Notation::hexadecimal)},
            {"tie", tie},
            {"facts", Json::array()}};
  if (reply.breakdown) json["breakdown"] = {static_cast<int>(*reply.breakdown), reply.failure};
  for (const FactVerdict& fact : facts)
    json["facts"].push_back(
        {static_cast<int>(fact.fact), static_cast<int>(fact.verdict), fact.text, fact.lost, fact.spurious});
  return json;
}

WrongAnswer WrongAnswer::from_json(const Json& json, const PosedQuestions& posed) {
  WrongAnswer wrong;
  wrong.reply.question = json.at("question").get<std::size_t>();
  wrong.reply.line = json.at("line").get<std::int64_t>();
  wrong.reply.answer = answer_from(json.at("answer"), posed, posed.questions.at(wrong.reply.question));
  wrong.tie = json.at("tie").get<bool>();
  if (json.contains("breakdown")) {
    wrong.reply.breakdown = static_cast<Breakdown>(json["breakdown"].at(0).get<int>());
    wrong.reply.failure = json["breakdown"].at(1).get<std::string>();
  }
  for (const Json& fact : json.at("facts"))
    wrong.facts.push_back({static_cast<Fact>(fact.at(0).get<int>()), static_cast<Verdict>(fact.at(1).get<int>()),
                           fact.at(2).get<std::string>(), fact.at(3).get<std::int64_t>(),
                           fact.at(4).get<std::int64_t>()});
  return wrong;
}

void Judged::merge(Judged&& other) {
  for (const auto& [name, tally] : other.strata) strata[name].merge(tally);
  for (const auto& [name, tally] : other.pairs) pairs[name].merge(tally);
  conventions.merge(other.conventions);
  for (auto& [stratum, wrong] : other.wrong_answers) {
    auto& ours = wrong_answers[stratum];
    ours.merge(wrong);
    while (ours.size() > kMostCasesOfAStratum) ours.erase(std::prev(ours.end()));
  }
}

std::int64_t Judged::poses() const {
  std::int64_t poses = 0;
  for (const auto& [name, tally] : strata) poses += tally.poses;
  return poses;
}

}  // namespace pcm::compare
