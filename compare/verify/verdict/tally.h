// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compare/verify/verdict/verdict.h"

/// What is kept of the answers to the poses of one pair and stratum in one mode: counts, and distributions as
/// histograms. Memory does not grow with the number of poses, and no entry depends on the order in which poses are
/// added.
namespace pcm::compare {

/// A distribution of numbers >= 0 over bins that part every factor of two evenly.
class Histogram {
 public:
  static constexpr int kBinsPerFactorOfTwo = 64;

  /// What is no finite number counts as greater than all others.
  void add(double value);
  void merge(const Histogram& other);
  std::int64_t count() const { return count_; }
  /// The q-quantile, estimated from above: the upper end of the first bin by which a fraction q of the numbers is
  /// reached, at most 1/64 too large; infinite where it is no finite number. 0 for an empty distribution.
  double quantile(double q) const;
  /// The same for the number of that rank, from 1.
  double at_rank(std::int64_t rank) const;

  nlohmann::ordered_json to_json() const;
  static Histogram from_json(const nlohmann::ordered_json& json);

 private:
  std::map<int, std::int64_t> bins_;  // by 64 * exponent + place of the mantissa; zeros in a bin of their own
  std::int64_t count_ = 0;
};

/// The greatest of the values added and the first pose (in the order of pose names) that has it. What is no number
/// counts as infinite.
struct Greatest {
  double value = 0;
  std::string pose;

  void add(double candidate, const std::string& candidate_pose);
  /// JSON has no infinity: null stands for it.
  static Greatest from_json(const nlohmann::ordered_json& value, const nlohmann::ordered_json& pose);
};

/// How wide the checks of one kind were (checks.h).
struct Widths {
  Histogram relative;         ///< the finite ones
  std::int64_t infinite = 0;  ///< passed anything
  std::int64_t wider = 0;     ///< finite, and wider than what they held
  std::int64_t of_zero = 0;   ///< held 0 to within a finite bound: no quantile counts these

  void add(const Width& width);
  void merge(const Widths& other);
  std::int64_t count() const { return relative.count() + infinite + of_zero; }
  bool has_quantiles() const { return relative.count() + infinite > 0; }
  /// Over all that have a width, infinite ones last; 0 where none has.
  double quantile(double q) const;
  nlohmann::ordered_json to_json() const;
  static Widths from_json(const nlohmann::ordered_json& json);
};

/// What the tables show of a distribution: median, 99th and 99.9th percentile.
inline constexpr std::array<double, 3> kShownQuantiles = {0.5, 0.99, 0.999};

/// Upper end of the one-sided 95 % confidence interval (Clopper and Pearson 1934) of the rate of what was seen `seen`
/// times in `trials`; about 3 / n where it never was.
double rate_upper_bound(std::int64_t seen, std::int64_t trials);

inline constexpr int kErrors = 8;

/// The errors of RelativeErrors in their order there, by name; the engine's own bounds last.
inline constexpr std::array<const char*, kErrors> kErrorNames = {"area",  "vector area", "volume",      "penetration",
                                                                 "force", "torque",      "force bound", "torque bound"};
inline constexpr std::size_t kPenetrationError = 3;
inline constexpr std::size_t kFirstBound = 6;

/// All that the tables need of one pose in one mode.
struct PoseOutcome {
  bool touching = false;
  bool nested = false;
  bool ambiguous = false;
  bool flipped = false;
  bool unbounded = false;
  bool announced = false;
  bool too_deep = false;
  std::vector<Disagreement> disagreements;
  std::vector<Width> widths;
  std::int64_t predicates = 0;
  std::int64_t exact_predicates = 0;
  RelativeErrors errors;
  double backward_error_ulps = 0;
  double engine_seconds = 0;
  double oracle_seconds = 0;        ///< on the rounded problem
  double oracle_exact_seconds = 0;  ///< on the exact problem, after the rounded one, with which it shares work
};

struct Tally {
  std::int64_t poses = 0;  ///< once for each mode, where tallies of several modes are merged
  std::int64_t touching = 0;
  std::int64_t nested = 0;
  std::int64_t ambiguous = 0;
  std::int64_t flipped = 0;
  std::int64_t unbounded = 0;  ///< the engine promises nothing about force or torque
  std::int64_t announced = 0;  ///< the engine says that a decision may be another one (ForceBound::flipped)
  std::int64_t too_deep = 0;
  std::int64_t disagreeing = 0;  ///< poses with a disagreement of any kind
  std::array<std::int64_t, kKinds> by_kind{};
  std::array<Widths, kKinds> widths;
  std::int64_t predicates = 0;
  std::int64_t exact_predicates = 0;
  std::array<Histogram, kErrors> errors;
  std::array<Greatest, kErrors> worst;
  Greatest backward_error_ulps;
  Histogram engine_seconds;
  Histogram oracle_seconds;
  Histogram oracle_exact_seconds;

  void add(const PoseOutcome& outcome, const std::string& pose);
  void merge(const Tally& other);

  /// Quantile q of error k: rounded up by the histogram, but never above the greatest.
  double error_quantile(std::size_t k, double q) const;

  /// Of the rate of disagreeing poses.
  double disagreement_rate_bound() const;

  nlohmann::ordered_json to_json() const;
  static Tally from_json(const nlohmann::ordered_json& json);
};

}  // namespace pcm::compare
