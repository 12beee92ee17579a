// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/search.h"

#include <fmt/core.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

#include "compare/io/names.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// Where random numbers are told from those of the strata and of stability, which take less.
constexpr std::uint64_t kFirstStream = 3000;

/// Of built-in pairs.
constexpr std::size_t kMostFacesBuiltIn = 200;

/// Where a climb begins: of a pair or of a case.
struct Place {
  std::string name;
  HardState begun;
};

std::size_t number_of_places(const SearchPlan& plan) {
  return plan.cases.empty() ? plan.schemes.size() * plan.pairs.size() : plan.cases.size();
}

Place place(const SearchPlan& plan, std::size_t number) {
  if (!plan.cases.empty()) {
    const Case& posed = plan.cases[number];
    return {fmt::format("case {}", number + 1), hard_state(posed)};
  }
  const Scheme scheme = plan.schemes[number % plan.schemes.size()];
  const SurfacePair& pair = plan.pairs[number / plan.schemes.size()];
  return {pair.name, hard_state(pair.E, pair.F, scheme)};
}

Goal goal_of(std::uint64_t number) {
  return kGoals[number % kGoals.size()];
}

/// The state as a case, with what disagrees there: in its own mode, or else in the first that has a disagreement.
Case held_case(HardState hard, std::string origin, fast::Workspace& workspace, const EngineSeam& seam) {
  const std::vector<PoseOutcome> outcomes = hard.held->hold(hard.state, workspace, seam);
  const auto disagrees = [](const PoseOutcome& outcome) { return !outcome.disagreements.empty(); };
  if (const auto first = std::ranges::find_if(outcomes, disagrees);
      first != outcomes.end() && !disagrees(outcomes[hard.mode]))
    hard.mode = static_cast<std::size_t>(first - outcomes.begin());
  Case posed = as_case(hard, std::move(origin));
  posed.disagreements = in_words(outcomes[hard.mode].disagreements);
  return posed;
}

/// Without where that case came from in its turn.
std::string origin_of(const Case& posed) {
  return posed.origin.substr(0, posed.origin.find(", from "));
}

Climbed climb_number(const SearchPlan& plan, std::uint64_t number, const EngineSeam& seam, fast::Workspace& workspace) {
  const Goal goal = goal_of(number);
  const std::uint64_t of_goal = number / kGoals.size();
  const std::size_t place_number = of_goal % number_of_places(plan);
  const Place from = place(plan, place_number);
  const PoseRandom random(plan.seed, kFirstStream + static_cast<std::uint64_t>(goal), 0, of_goal);
  const Climb climbed =
      plan.cases.empty() ? climb(goal, from.begun, random, workspace) : climb_from(goal, from.begun, random, workspace);
  Climbed found;
  found.name = fmt::format("{}/{}/{}/{}", name(goal), name(from.begun.state.scheme), from.name, number);
  found.from = from.name;
  found.goal = goal;
  found.begun_at = climbed.begun_at;
  found.reached = climbed.reached;
  std::string origin = fmt::format("seed {}, {}", plan.seed, found.name);
  if (!plan.cases.empty()) origin += ", from " + origin_of(plan.cases[place_number]);
  found.hardest = held_case(climbed.hardest, std::move(origin), workspace, seam);
  return found;
}

nlohmann::ordered_json kept_climb(const Climbed& found) {
  return {{"name", found.name},
          {"from", found.from},
          {"begun_at", kept_number(found.begun_at)},
          {"reached", kept_number(found.reached)},
          {"hardest", format_case(found.hardest, {}, {})}};
}

/// Throws BadInput where it is none.
Climbed climb_from_kept(std::uint64_t number, const nlohmann::ordered_json& kept) {
  try {
    return {kept.at("name").get<std::string>(),
            kept.at("from").get<std::string>(),
            goal_of(number),
            number_from_kept(kept.at("begun_at")),
            number_from_kept(kept.at("reached")),
            case_from_text(kept.at("hardest").get<std::string>(), {})};
  } catch (const std::exception& error) {
    throw BadInput(fmt::format("climb {} is kept, and damaged ({}); remove search.kept, and all are climbed again",
                               number, error.what()));
  }
}

}  // namespace

std::vector<SurfacePair> searched_pairs() {
  std::vector<std::string> missing;
  std::vector<SurfacePair> pairs = built_in_pairs({}, missing);
  std::erase_if(pairs,
                [](const SurfacePair& pair) { return !pair.for_hard_strata || pair.faces() > kMostFacesBuiltIn; });
  return pairs;
}

std::int64_t climbs_of(const SearchPlan& plan) {
  return plan.climbs > 0 ? plan.climbs : static_cast<std::int64_t>(kGoals.size() * number_of_places(plan));
}

std::int64_t SearchReport::disagreeing() const {
  return std::ranges::count_if(climbs, [](const Climbed& found) { return !found.hardest.disagreements.empty(); });
}

SearchReport search(const SearchPlan& plan, int jobs, KeptValues& kept, const std::function<bool()>& stop,
                    const std::function<void(std::int64_t)>& progress, const EngineSeam& seam) {
  SearchReport report;
  report.planned = climbs_of(plan);
  std::vector<std::optional<Climbed>> climbs(static_cast<std::size_t>(report.planned));
  std::atomic<std::int64_t> done = 0;
  oneapi::tbb::enumerable_thread_specific<fast::Workspace> workspaces;
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    oneapi::tbb::parallel_for(std::int64_t{0}, report.planned, [&](std::int64_t i) {
      if (stop()) return;
      const auto number = static_cast<std::uint64_t>(i);
      const nlohmann::ordered_json found = kept.get(fmt::format("seed {}, climb {}", plan.seed, i), [&] {
        return kept_climb(climb_number(plan, number, seam, workspaces.local()));
      });
      climbs[static_cast<std::size_t>(i)] = climb_from_kept(number, found);
      progress(++done);
    });
  });
  for (std::optional<Climbed>& found : climbs)
    if (found) report.climbs.push_back(std::move(*found));
  return report;
}

}  // namespace pcm::compare
