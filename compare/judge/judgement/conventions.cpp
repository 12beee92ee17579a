// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/conventions.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace pcm::compare {
namespace {

/// A convention: which fact it is about, what it is and what mends it.
struct Convention {
  Fact fact;
  const char* cure;
};

constexpr std::array<Convention, kOtherConventions> kConventions = {{
    {Fact::force, "the force has the opposite sign; \"force\" is the one on E, so negate it"},
    {Fact::torque, "the torque has the opposite sign; \"torque\" is the one on E, so negate it"},
    {Fact::torque, "the torque is about Me's origin; \"torque\" is about Mf's, so take r x force off it"},
    {Fact::area, "areas are a million times too large; they are in m^2, and look like mm^2"},
    {Fact::volume, "volumes are 1e9 times too large; they are in m^3, and look like mm^3"},
    {Fact::torque, "torques are a thousand times too large; they are in N m, and look like N mm"},
    {Fact::force, "forces are 1e9 times too large; stiffness is in N/m^3 and lengths are in m, and they look like mm"},
}};

/// What the answer would be by our convention if it followed the other one.
GivenAnswer translated(OtherConvention from, const Question& question, GivenAnswer answer,
                       const reference::Answer& truth) {
  switch (from) {
    case OtherConvention::force_sign:
      *answer.force_Me *= -1;
      break;
    case OtherConvention::torque_sign:
      *answer.torque_Me *= -1;
      break;
    case OtherConvention::torque_point:
      *answer.torque_Me -= question.pose.r.cross(truth.force_Me);
      break;
    case OtherConvention::millimetre_areas:
      for (GivenArea* side : {&answer.E, &answer.F})
        if (side->area) *side->area /= 1e6;
      break;
    case OtherConvention::millimetre_volumes:
      *answer.volume /= 1e9;
      break;
    case OtherConvention::millimetre_torques:
      *answer.torque_Me /= 1e3;
      break;
    case OtherConvention::millimetre_forces:
      *answer.force_Me /= 1e9;
      break;
  }
  return answer;
}

bool is_right_in(Fact fact, const std::vector<FactJudged>& judged) {
  return std::any_of(judged.begin(), judged.end(), [fact](const FactJudged& f) { return f.fact == fact && f.right; });
}

bool is_wrong_in(Fact fact, const std::vector<FactJudged>& judged) {
  return std::any_of(judged.begin(), judged.end(), [fact](const FactJudged& f) { return f.fact == fact && !f.right; });
}

}  // namespace

ConventionsTold told_by(const Question& question, const GivenAnswer& given, const reference::Answer& truth,
                        const Tolerances& tolerances, const std::vector<FactJudged>& judged) {
  ConventionsTold result;
  for (std::size_t k = 0; k < kOtherConventions; ++k) {
    const Fact fact = kConventions[k].fact;
    if (!is_wrong_in(fact, judged)) continue;
    const GivenAnswer ours = translated(static_cast<OtherConvention>(k), question, given, truth);
    result.told.set(k);
    result.followed.set(k, is_right_in(fact, judge_facts(question, ours, truth, tolerances)));
  }
  return result;
}

void Conventions::add(const ConventionsTold& of_one, std::int64_t line) {
  for (std::size_t k = 0; k < kOtherConventions; ++k) {
    if (!of_one.told[k]) continue;
    ++counts_[k].told;
    if (!of_one.followed[k]) continue;
    counts_[k].line = counts_[k].followed == 0 ? line : std::min(counts_[k].line, line);
    ++counts_[k].followed;
  }
}

void Conventions::merge(const Conventions& other) {
  for (std::size_t k = 0; k < kOtherConventions; ++k) {
    Count& count = counts_[k];
    const Count& more = other.counts_[k];
    if (more.followed > 0) count.line = count.followed == 0 ? more.line : std::min(count.line, more.line);
    count.told += more.told;
    count.followed += more.followed;
  }
}

Conventions Conventions::of(const std::array<Count, kOtherConventions>& counts) {
  Conventions conventions;
  conventions.counts_ = counts;
  return conventions;
}

Conventions::Found Conventions::found() const {
  for (std::size_t k = 0; k < kOtherConventions; ++k) {
    const Count& count = counts_[k];
    if (count.told >= kFewest && 10 * count.followed >= 9 * count.told)
      return {fmt::format("at {} of {} poses with a wrong {} {}", count.followed, count.told,
                          name(kConventions[k].fact), kConventions[k].cure),
              count.line};
  }
  return {};
}

}  // namespace pcm::compare
