// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string>

#include "compare/judge/judgement/judgement.h"
#include "compare/judge/lines/given_answer.h"
#include "compare/verify/bounds/question.h"
#include "reference/vocabulary/answer.h"

/// Conventions other than those of docs/judge.md, where they can be told: what is wrong by ours is right by theirs.
namespace pcm::compare {

enum class OtherConvention : std::uint8_t {
  force_sign,          ///< the force on F
  torque_sign,         ///< the torque on F
  torque_point,        ///< the torque about Me's origin
  millimetre_areas,    ///< mm^2
  millimetre_volumes,  ///< mm^3
  millimetre_torques,  ///< N mm
  millimetre_forces,   ///< c_l A_k u_k of an A_k in mm^2 and a u_k in mm
};

inline constexpr std::size_t kOtherConventions = 7;

/// What one answer tells: in which conventions' facts it is wrong, and by which of these it would be right.
struct ConventionsTold {
  std::bitset<kOtherConventions> told;
  std::bitset<kOtherConventions> followed;
};

/// `judged`: the answer's facts as judge_facts has them.
ConventionsTold told_by(const Question& question, const GivenAnswer& given, const reference::Answer& truth,
                        const Tolerances& tolerances, const std::vector<FactJudged>& judged);

/// What the answers so far tell together.
class Conventions {
 public:
  /// Fewer wrong answers tell nothing.
  static constexpr std::int64_t kFewest = 10;

  /// `line`: where the answer stands, 0 for none. In any order.
  void add(const ConventionsTold& of_one, std::int64_t line);
  /// What is surely another convention, and what mends it; empty where none is. Nine in ten of what is wrong must be
  /// right by it.
  struct Found {
    std::string text;
    std::int64_t line = 0;  ///< of the first answer that follows it
  };
  Found found() const;

  void merge(const Conventions& other);
  struct Count {
    std::int64_t told = 0;
    std::int64_t followed = 0;
    std::int64_t line = 0;  ///< of the first answer that follows it, 0 for none
  };
  const std::array<Count, kOtherConventions>& counts() const { return counts_; }
  static Conventions of(const std::array<Count, kOtherConventions>& counts);

 private:
  std::array<Count, kOtherConventions> counts_{};
};

}  // namespace pcm::compare
