// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/engine/force_by_scheme.h"

namespace pcm::fast {

namespace {

MasterForce sum_elements(const Intersection& intersection, Scheme scheme, Side master, const ForceProblem& problem,
                         PosedTeam& team, ForceScratch& scratch, LineMemory* memory, ElementRecord& record) {
  return scheme == Scheme::clipped
             ? sum_clipped_elements(intersection, master, problem, team, scratch.clipped, record)
             : sum_barycentric_elements(intersection, master, problem, team, scratch.barycentric, memory, record);
}

/// The same, with no record of the elements.
ForceProblem without_records(const ForceProblem& problem) {
  ForceProblem result = problem;
  result.keep_elements = result.with_statistics = result.keep_found = false;
  return result;
}

PairingForce sum_bounded_elements(const Intersection& intersection, Scheme scheme, Side master,
                                  const ForceProblem& problem, PosedTeam& team, ForceScratch& scratch,
                                  ElementRecord& record) {
  MasterBound bound(intersection, master, problem, scratch.undecided);
  MasterForce total =
      scheme == Scheme::clipped
          ? sum_bounded_clipped_elements(intersection, problem, scratch.clipped.face, scratch.clipped_bound, bound,
                                         record)
          : sum_bounded_barycentric_elements(intersection, problem, scratch.barycentric_bound, bound, record);
  if (problem.with_tangent) {
    ElementRecord none;
    total.tangent =
        sum_elements(intersection, scheme, master, without_records(problem), team, scratch, nullptr, none).tangent;
  }
  return {total, bound.result()};
}

/// Asks for the forces of each master, E first.
template <class OfMaster>
PairingForce force_by_mode(Mode mode, const OfMaster& of_master) {
  PairingForce result;
  if (mode == Mode::both) {
    const PairingForce on_E = of_master(Side::E);
    const PairingForce on_F = of_master(Side::F);
    result.total = mean(on_E.total, on_F.total);
    if (on_E.bound) result.bound = mean_bound(*on_E.bound, *on_F.bound, result.total);
  } else {
    result = of_master(mode == Mode::E ? Side::E : Side::F);
  }
  require_finite(result.total);
  return result;
}

}  // namespace

PairingForce compute_force(const Intersection& intersection, Scheme scheme, Mode mode, const ForceProblem& problem,
                           bool with_bound, PosedTeam& team, ForceScratch& scratch, LineMemories* memories,
                           ElementRecord& record) {
  record.clear();
  return force_by_mode(mode, [&](Side master) -> PairingForce {
    if (with_bound) return sum_bounded_elements(intersection, scheme, master, problem, team, scratch, record);
    LineMemory* const memory = memories != nullptr ? &(*memories)[static_cast<std::size_t>(master)] : nullptr;
    return {sum_elements(intersection, scheme, master, problem, team, scratch, memory, record), std::nullopt};
  });
}

MasterForce repeat_force(const FoundElements& found, Mode mode, const ForceProblem& problem, ForceScratch& scratch,
                         ElementRecord& record, WorkCounters& work) {
  record.clear();
  const auto of_master = [&](Side master) -> PairingForce {
    ElementQueue queue(problem, master, record, work, scratch.barycentric.search.lanes);
    for (const KeptLanes& kept : found.of(master)) queue.add_kept(kept);
    return {queue.total(), std::nullopt};
  };
  return force_by_mode(mode, of_master).total;
}

void form_elements_of_slave(const Intersection& intersection, Scheme scheme, Mode mode, const ForceProblem& problem,
                            PosedTeam& team, ForceScratch& scratch) {
  if (mode == Mode::both) return;
  ElementRecord none;
  sum_elements(intersection, scheme, mode == Mode::E ? Side::F : Side::E, without_records(problem), team, scratch,
               nullptr, none);
}

}  // namespace pcm::fast
