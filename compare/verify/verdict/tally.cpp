// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/tally.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <climits>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

namespace pcm::compare {
namespace {

constexpr int kZeroBin = INT_MIN;
constexpr int kTopBin = INT_MAX;  // what is no finite number
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kBins = Histogram::kBinsPerFactorOfTwo;

int bin_of(double value) {
  if (!std::isfinite(value)) return kTopBin;
  if (!(value > 0)) return kZeroBin;
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);  // in [1/2, 1)
  return kBins * exponent + static_cast<int>((mantissa - 0.5) * (2 * kBins));
}

double upper_end(int bin) {
  if (bin == kZeroBin) return 0;
  if (bin == kTopBin) return kInfinity;
  const int exponent = bin >= 0 ? bin / kBins : -((kBins - 1 - bin) / kBins);
  // That of the greatest doubles' bin is beyond them.
  return std::min(std::ldexp(0.5 + (bin - kBins * exponent + 1) / (2.0 * kBins), exponent),
                  std::numeric_limits<double>::max());
}

}  // namespace

void Histogram::add(double value) {
  ++bins_[bin_of(value)];
  ++count_;
}

void Histogram::merge(const Histogram& other) {
  for (const auto& [bin, count] : other.bins_) bins_[bin] += count;
  count_ += other.count_;
}

double Histogram::quantile(double q) const {
  return at_rank(static_cast<std::int64_t>(std::ceil(q * static_cast<double>(count_))));
}

double Histogram::at_rank(std::int64_t wanted) const {
  std::int64_t seen = 0;
  for (const auto& [bin, count] : bins_) {
    seen += count;
    if (seen >= wanted) return upper_end(bin);
  }
  return 0;
}

nlohmann::ordered_json Histogram::to_json() const {
  auto json = nlohmann::ordered_json::array();
  for (const auto& [bin, count] : bins_) json.push_back({bin, count});
  return json;
}

Histogram Histogram::from_json(const nlohmann::ordered_json& json) {
  Histogram histogram;
  for (const auto& entry : json) {
    histogram.bins_[entry.at(0).get<int>()] = entry.at(1).get<std::int64_t>();
    histogram.count_ += entry.at(1).get<std::int64_t>();
  }
  return histogram;
}

void Widths::add(const Width& width) {
  if (!width.relative) {
    ++of_zero;
  } else if (!std::isfinite(*width.relative)) {
    ++infinite;
  } else {
    relative.add(*width.relative);
    wider += *width.relative > 1;
  }
}

void Widths::merge(const Widths& other) {
  relative.merge(other.relative);
  infinite += other.infinite;
  wider += other.wider;
  of_zero += other.of_zero;
}

double Widths::quantile(double q) const {
  const auto wanted = static_cast<std::int64_t>(std::ceil(q * static_cast<double>(relative.count() + infinite)));
  if (wanted > relative.count()) return kInfinity;
  return relative.at_rank(wanted);
}

nlohmann::ordered_json Widths::to_json() const {
  return {relative.to_json(), infinite, wider, of_zero};
}

Widths Widths::from_json(const nlohmann::ordered_json& json) {
  Widths widths;
  widths.relative = Histogram::from_json(json.at(0));
  widths.infinite = json.at(1).get<std::int64_t>();
  widths.wider = json.at(2).get<std::int64_t>();
  widths.of_zero = json.at(3).get<std::int64_t>();
  return widths;
}

void Greatest::add(double candidate, const std::string& candidate_pose) {
  if (candidate_pose.empty()) return;
  if (std::isnan(candidate)) candidate = kInfinity;
  if (pose.empty() || candidate > value || (candidate == value && candidate_pose < pose)) {
    value = candidate;
    pose = candidate_pose;
  }
}

Greatest Greatest::from_json(const nlohmann::ordered_json& value, const nlohmann::ordered_json& pose) {
  return {value.is_null() ? kInfinity : value.get<double>(), pose.get<std::string>()};
}

void Tally::add(const PoseOutcome& outcome, const std::string& pose) {
  ++poses;
  touching += outcome.touching;
  nested += outcome.nested;
  ambiguous += outcome.ambiguous;
  flipped += outcome.flipped;
  unbounded += outcome.unbounded;
  announced += outcome.announced;
  too_deep += outcome.too_deep;
  disagreeing += !outcome.disagreements.empty();
  for (const Disagreement& d : outcome.disagreements) ++by_kind[static_cast<std::size_t>(d.kind)];
  for (const Width& width : outcome.widths) widths[static_cast<std::size_t>(width.kind)].add(width);
  predicates += outcome.predicates;
  exact_predicates += outcome.exact_predicates;
  const RelativeErrors& e = outcome.errors;
  const std::array<const std::optional<double>*, kErrors> values = {
      &e.area, &e.vector_area, &e.volume, &e.penetration, &e.force, &e.torque, &e.force_bound, &e.torque_bound};
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!values[k]->has_value()) continue;
    errors[k].add(**values[k]);
    worst[k].add(**values[k], pose);
  }
  backward_error_ulps.add(outcome.backward_error_ulps, pose);
  engine_seconds.add(outcome.engine_seconds);
  oracle_seconds.add(outcome.oracle_seconds);
  oracle_exact_seconds.add(outcome.oracle_exact_seconds);
}

void Tally::merge(const Tally& other) {
  poses += other.poses;
  touching += other.touching;
  nested += other.nested;
  ambiguous += other.ambiguous;
  flipped += other.flipped;
  unbounded += other.unbounded;
  announced += other.announced;
  too_deep += other.too_deep;
  disagreeing += other.disagreeing;
  for (std::size_t k = 0; k < by_kind.size(); ++k) by_kind[k] += other.by_kind[k];
  for (std::size_t k = 0; k < widths.size(); ++k) widths[k].merge(other.widths[k]);
  predicates += other.predicates;
  exact_predicates += other.exact_predicates;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    errors[k].merge(other.errors[k]);
    worst[k].add(other.worst[k].value, other.worst[k].pose);
  }
  backward_error_ulps.add(other.backward_error_ulps.value, other.backward_error_ulps.pose);
  engine_seconds.merge(other.engine_seconds);
  oracle_seconds.merge(other.oracle_seconds);
  oracle_exact_seconds.merge(other.oracle_exact_seconds);
}

double Tally::error_quantile(std::size_t k, double q) const {
  return std::min(errors[k].quantile(q), worst[k].value);
}

double rate_upper_bound(std::int64_t seen, std::int64_t trials) {
  if (trials == 0 || seen == trials) return 1;
  return boost::math::binomial_distribution<>::find_upper_bound_on_p(static_cast<double>(trials),
                                                                     static_cast<double>(seen), 0.05);
}

double Tally::disagreement_rate_bound() const {
  return rate_upper_bound(disagreeing, poses);
}

nlohmann::ordered_json Tally::to_json() const {
  nlohmann::ordered_json json;
  json["counts"] = {poses,    touching,    nested,     ambiguous,        flipped,  unbounded,
                    too_deep, disagreeing, predicates, exact_predicates, announced};
  json["by_kind"] = by_kind;
  for (const Widths& of_kind : widths) json["widths"].push_back(of_kind.to_json());
  for (std::size_t k = 0; k < errors.size(); ++k)
    json["errors"].push_back({errors[k].to_json(), worst[k].value, worst[k].pose});
  json["backward_error_ulps"] = {backward_error_ulps.value, backward_error_ulps.pose};
  json["seconds"] = {engine_seconds.to_json(), oracle_seconds.to_json(), oracle_exact_seconds.to_json()};
  return json;
}

Tally Tally::from_json(const nlohmann::ordered_json& json) {
  Tally tally;
  std::size_t at = 0;
  for (std::int64_t* count :
       {&tally.poses, &tally.touching, &tally.nested, &tally.ambiguous, &tally.flipped, &tally.unbounded,
        &tally.too_deep, &tally.disagreeing, &tally.predicates, &tally.exact_predicates, &tally.announced})
    *count = json.at("counts").at(at++).get<std::int64_t>();
  tally.by_kind = json.at("by_kind").get<std::array<std::int64_t, kKinds>>();
  for (std::size_t k = 0; k < tally.widths.size(); ++k) tally.widths[k] = Widths::from_json(json.at("widths").at(k));
  for (std::size_t k = 0; k < tally.errors.size(); ++k) {
    const auto& entry = json.at("errors").at(k);
    tally.errors[k] = Histogram::from_json(entry.at(0));
    tally.worst[k] = Greatest::from_json(entry.at(1), entry.at(2));
  }
  const auto& backward = json.at("backward_error_ulps");
  tally.backward_error_ulps = Greatest::from_json(backward.at(0), backward.at(1));
  tally.engine_seconds = Histogram::from_json(json.at("seconds").at(0));
  tally.oracle_seconds = Histogram::from_json(json.at("seconds").at(1));
  tally.oracle_exact_seconds = Histogram::from_json(json.at("seconds").at(2));
  return tally;
}

}  // namespace pcm::compare
