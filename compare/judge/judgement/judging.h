// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/judge/judgement/judge.h"
#include "compare/judge/judgement/judged.h"
#include "compare/verify/verdict/case_file.h"

namespace pcm::compare {

/// Answers before the judge. No count depends on their order.
class Judging {
 public:
  /// The judge must outlive this.
  explicit Judging(const Judge& judge);

  /// Judges on `jobs` threads. Once `stop` says yes those at hand are finished and the others left out; `progress` gets
  /// the number of answers judged so far.
  void add(std::vector<Reply> replies, int jobs, const std::function<bool()>& stop,
           const std::function<void(std::int64_t)>& progress);
  /// One of them, which is not added. From any thread.
  Judged judge_one(Reply reply) const;
  /// What was judged elsewhere, of answers that are not added otherwise.
  void add(Judged judged) { all_.merge(std::move(judged)); }

  const Judge& judge() const { return judge_; }
  using NamedTallies = std::vector<std::pair<std::string, JudgedTally>>;
  /// In the order in which the poses have them.
  NamedTallies strata() const { return in_order(strata_, all_.strata); }
  JudgedTally total() const;
  /// By pair of surfaces, in the order in which the poses have them.
  NamedTallies pairs() const { return in_order(pairs_, all_.pairs); }
  /// Of each stratum the first ones, in the order of the poses.
  std::vector<WrongAnswer> wrong_answers() const;
  const Conventions& conventions() const { return all_.conventions; }
  /// With what each side says.
  std::string case_text(const WrongAnswer& wrong) const;

 private:
  static NamedTallies in_order(const std::vector<std::string>& names,
                               const std::map<std::string, JudgedTally>& tallies);

  const Judge& judge_;
  std::vector<std::string> strata_, pairs_;  ///< names, each once
  Judged all_;
};

}  // namespace pcm::compare
