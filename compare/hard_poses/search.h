// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compare/hard_poses/climb.h"
#include "compare/io/tables/kept_values.h"
#include "compare/poses/pairs.h"

/// The adversary: climbs to every goal from many places, and the verdict on each state in which one ends.
namespace pcm::compare {

/// What a search is. Climb i is towards goal i modulo their number; schemes, and then places to begin at, take turns
/// after that. A climb begins at states drawn for a pair, or where there are cases at one of these, in its scheme.
struct SearchPlan {
  std::int64_t climbs = 0;  ///< 0: one for each goal, scheme and pair, or goal and case
  std::uint64_t seed = 1;
  std::vector<Scheme> schemes{Scheme::barycentric, Scheme::clipped};
  std::vector<SurfacePair> pairs;
  std::vector<Case> cases;
};

/// The built-in pairs that are small enough to be asked some hundred times a second.
std::vector<SurfacePair> searched_pairs();

/// How many climbs the plan comes to.
std::int64_t climbs_of(const SearchPlan& plan);

/// A climb, and what became of the state in which it ended.
struct Climbed {
  std::string name;  ///< of the climb: goal, scheme, where it began, its number
  std::string from;  ///< the pair or the case
  Goal goal = Goal::margins;
  double begun_at = 0;  ///< hardness (hardness.h); -1 where engine or oracle refuses that state
  double reached = 0;
  Case hardest;  ///< with its disagreements; in the first mode that has any
};

struct SearchReport {
  std::int64_t planned = 0;
  std::vector<Climbed> climbs;  ///< in their order; fewer than planned where the search was stopped

  bool finished() const { return static_cast<std::int64_t>(climbs.size()) == planned; }
  std::int64_t disagreeing() const;
};

/// Each state in which a climb ends is asked on every route in all modes and held against the oracle
/// (HeldPairing::hold). Climbs that are kept are not climbed again; the same bits on any number of threads. `stop` is
/// asked before each climb, `progress` is told how many are done.
SearchReport search(const SearchPlan& plan, int jobs, KeptValues& kept, const std::function<bool()>& stop,
                    const std::function<void(std::int64_t)>& progress, const EngineSeam& seam = EngineSeam::none());

}  // namespace pcm::compare
