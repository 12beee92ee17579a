// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compare/io/json/question_json.h"
#include "compare/judge/judgement/judge.h"

/// What came of judging some answers: sums, whatever the order of the answers and whoever judged them.
namespace pcm::compare {

/// How often a fact was judged, and how.
struct FactTally {
  std::int64_t right = 0;
  std::int64_t near = 0;
  std::int64_t wrong = 0;
  /// In all wrong answers together: members of sets that they lack, and that they alone have.
  std::int64_t lost = 0, spurious = 0;
  std::int64_t no_truth = 0;  ///< given, without anything that it could be held against

  std::int64_t judged() const { return right + near + wrong; }
};

/// The answers to the poses of a stratum.
struct JudgedTally {
  std::int64_t poses = 0;  ///< asked, or answered in a file
  std::int64_t wrong = 0;  ///< poses wrong in anything, breakdowns included
  std::int64_t ties = 0;   ///< those of the wrong ones where features coincide exactly
  std::int64_t near = 0;   ///< the others that are near another answer in anything
  std::int64_t empty = 0;  ///< answers in which there was nothing to be judged
  std::array<std::int64_t, kBreakdowns> breakdowns{};
  std::array<FactTally, kFacts> facts{};

  std::int64_t judged() const { return poses - empty; }
  std::int64_t right() const { return judged() - wrong - near; }
  const FactTally& of(Fact fact) const { return facts[static_cast<std::size_t>(fact)]; }
  void add(const PoseVerdict& verdict);
  void add(Breakdown breakdown);
  void merge(const JudgedTally& other);
  Json to_json() const;
  static JudgedTally from_json(const Json& json);
};

/// Of so many wrong answers of a stratum case files are kept, so that no stratum has them all.
inline constexpr std::size_t kMostCasesOfAStratum = 100;

/// A wrong answer, kept for its case file.
struct WrongAnswer {
  Reply reply;
  std::vector<FactVerdict> facts;  ///< empty where the engine broke down
  bool tie = false;                ///< features coincide exactly

  Json to_json(const PosedQuestions& posed) const;
  static WrongAnswer from_json(const Json& json, const PosedQuestions& posed);
};

struct Judged {
  std::map<std::string, JudgedTally> strata, pairs;  ///< by their names
  /// By stratum and number of the question: of each stratum the first kMostCasesOfAStratum.
  std::map<std::string, std::map<std::size_t, WrongAnswer>> wrong_answers;
  Conventions conventions;

  void merge(Judged&& other);
  std::int64_t poses() const;
};

}  // namespace pcm::compare
