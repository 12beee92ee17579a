// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/kept_judgement.h"

#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/io/json/json_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr const char* kTallies = "tallies";

Json tallies_json(const std::map<std::string, JudgedTally>& tallies) {
  Json json = Json::object();
  for (const auto& [name, tally] : tallies) json[name] = tally.to_json();
  return json;
}

std::map<std::string, JudgedTally> tallies_from(const Json& json) {
  std::map<std::string, JudgedTally> tallies;
  for (const auto& [name, tally] : json.items()) tallies.emplace(name, JudgedTally::from_json(tally));
  return tallies;
}

Json conventions_json(const Conventions& conventions) {
  Json json = Json::array();
  for (const Conventions::Count& count : conventions.counts()) json.push_back({count.told, count.followed, count.line});
  return json;
}

Conventions conventions_from(const Json& json) {
  std::array<Conventions::Count, kOtherConventions> counts;
  for (std::size_t k = 0; k < kOtherConventions; ++k) {
    const auto [told, followed, line] = json.at(k).get<std::array<std::int64_t, 3>>();
    counts[k] = {told, followed, line};
  }
  return Conventions::of(counts);
}

}  // namespace

KeptJudgement::KeptJudgement(const std::filesystem::path& folder, const Json& identity, std::int64_t chunks,
                             const PosedQuestions& posed)
    : SharedChunks(folder), posed_(posed) {
  const Campaign::Job job{json_line(identity), chunks, {}};
  campaign_.begin([&](const std::optional<Campaign::Job>& held, bool) -> std::optional<Campaign::Job> {
    if (!held) return job;
    if (held->identity != job.identity || held->chunks != job.chunks)
      throw BadInput("--out " + folder.string() +
                     ": it holds another judgement (other answers, poses, tolerances or ulps, or by another build); "
                     "choose another folder");
    return std::nullopt;
  });
}

void KeptJudgement::commit(ChunkRange chunks, Judged judged) {
  const std::lock_guard lock(mutex_);
  std::map<std::size_t, std::string> wrong;
  for (const auto& [stratum, answers] : judged.wrong_answers)
    for (const auto& [question, answer] : answers) wrong[question] = json_line(answer.to_json(posed_));
  Judged sum = mine_;
  sum.merge(std::move(judged));
  std::map<std::string, std::string> found;
  found[kTallies] = json_line({{"strata", tallies_json(sum.strata)},
                               {"pairs", tallies_json(sum.pairs)},
                               {"conventions", conventions_json(sum.conventions)}});
  // Those that are among the first of their stratum for this worker.
  for (auto& [question, text] : wrong)
    if (sum.wrong_answers[posed_.questions[question].stratum].contains(question))
      found["wrong " + std::to_string(question)] = std::move(text);
  if (campaign_.commit(chunks, found)) mine_ = std::move(sum);
}

Judged KeptJudgement::judged() {
  Judged all;
  campaign_.for_each_found([&](const std::string& key, const std::string& text) {
    const Json json = Json::parse(text);
    Judged some;
    if (key == kTallies) {
      some.strata = tallies_from(json.at("strata"));
      some.pairs = tallies_from(json.at("pairs"));
      some.conventions = conventions_from(json.at("conventions"));
    } else {
      WrongAnswer wrong = WrongAnswer::from_json(json, posed_);
      const std::size_t question = wrong.reply.question;
      some.wrong_answers[posed_.questions.at(question).stratum].emplace(question, std::move(wrong));
    }
    all.merge(std::move(some));
  });
  return all;
}

}  // namespace pcm::compare
