// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/judge/judgement/judge.h"
#include "compare/verify/verdict/case_file.h"

namespace pcm::compare {

/// How often a fact was judged, and how.
struct FactTally {
  std::int64_t right = 0;
  std::int64_t near = 0;
  std::int64_t wrong = 0;
  /// In all wrong answers together: members of sets that they lack, and that they alone have.
  std::int64_t lost = 0, spurious = 0;

  std::int64_t judged() const { return right + near + wrong; }
};

/// The answers to the poses of a stratum.
struct JudgedTally {
  std::int64_t poses = 0;  ///< asked, or answered in a file
  std::int64_t wrong = 0;  ///< poses wrong in anything, breakdowns included
  std::int64_t near = 0;   ///< the others that are near another answer in anything
  std::array<std::int64_t, kBreakdowns> breakdowns{};
  std::array<FactTally, kFacts> facts{};

  const FactTally& of(Fact fact) const { return facts[static_cast<std::size_t>(fact)]; }
  void add(const PoseVerdict& verdict);
  void add(Breakdown breakdown);
  void merge(const JudgedTally& other);
};

/// Of so many wrong answers of a stratum case files are kept, so that no stratum has them all.
inline constexpr std::int64_t kMostCasesOfAStratum = 100;

/// A wrong answer, kept for its case file.
struct WrongAnswer {
  Reply reply;
  std::vector<FactVerdict> facts;  ///< empty where the engine broke down
};

/// Answers before the judge, batch by batch. No count depends on their order.
class Judging {
 public:
  /// The judge must outlive this.
  explicit Judging(const Judge& judge);

  /// Judges on `jobs` threads. Once `stop` says yes those at hand are finished and the others left out; `progress` gets
  /// the number of answers judged so far.
  void add(std::vector<Reply> replies, int jobs, const std::function<bool()>& stop,
           const std::function<void(std::int64_t)>& progress);

  const Judge& judge() const { return judge_; }
  /// In the order in which the poses have them.
  const std::vector<std::pair<std::string, JudgedTally>>& strata() const { return strata_; }
  JudgedTally total() const;
  /// By pair of surfaces, in the order in which the poses have them.
  const std::vector<std::pair<std::string, JudgedTally>>& pairs() const { return pairs_; }
  /// Of each stratum the first kMostCasesOfAStratum.
  const std::vector<WrongAnswer>& wrong_answers() const { return wrong_answers_; }
  const Conventions& conventions() const { return conventions_; }
  /// With what each side says.
  std::string case_text(const WrongAnswer& wrong) const;

 private:
  void keep(Reply reply, const PoseVerdict& verdict);

  const Judge& judge_;
  std::vector<std::pair<std::string, JudgedTally>> strata_;
  std::vector<std::pair<std::string, JudgedTally>> pairs_;
  std::vector<std::size_t> stratum_of_, pair_of_;  ///< by question
  std::vector<WrongAnswer> wrong_answers_;
  Conventions conventions_;
  std::int64_t judged_ = 0;
};

}  // namespace pcm::compare
