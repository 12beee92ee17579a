// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/verify/run/verification_plan.h"
#include "compare/wrong_answers/wrong_answers.h"

/// Several engines held against the oracle on the same poses: what exactness buys.
namespace pcm::compare {

/// Poses of one stratum.
struct ComparisonTally {
  std::int64_t poses = 0;
  std::int64_t without_rule = 0;  ///< the published algorithms have no rule for them
  /// Nothing in it is deeper than a tenth of the smaller body.
  std::int64_t shallow = 0;
  std::int64_t shallow_without_rule = 0;

  /// One engine's share in it.
  struct OfEngine {
    std::int64_t wrong = 0;                  ///< poses wrong in anything
    std::array<std::int64_t, kWrongs> by{};  ///< poses wrong in this; where there is no rule, elements and force apart
    std::int64_t differs_without_rule = 0;   ///< force or torque differs where there is no rule
    std::int64_t shallow_force_wrong = 0;    ///< of shallow poses with a rule
    std::int64_t shallow_differs_without_rule = 0;
  };
  std::array<OfEngine, kEngines.size()> engines;

  const OfEngine& of(Engine engine) const { return engines[static_cast<std::size_t>(engine)]; }
  void merge(const ComparisonTally& other);
};

/// The engines compared over a plan's poses. Barycentric scheme only.
struct EngineComparison {
  std::vector<Engine> engines;
  std::uint64_t seed = 0;
  bool finished = true;
  std::vector<std::pair<Stratum, ComparisonTally>> strata;
  ComparisonTally all;
  std::vector<std::string> omissions;  ///< what has no poses (verify.h)

  bool anything_wrong() const;
};

/// Holds every engine against the oracle at every pose of the plan, on `jobs` threads. Once `stop` says yes the poses
/// at hand are finished. `progress` gets the number of poses done. Throws BadInput for the clipped scheme, which the
/// published algorithms do not know.
EngineComparison compare_engines(VerificationPlan plan, const std::vector<Engine>& engines, int jobs,
                                 const std::function<bool()>& stop, const std::function<void(std::int64_t)>& progress);

}  // namespace pcm::compare
