// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/wrong_answers/engine_comparison.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>

#include "compare/verify/run/planned_poses.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// What is deep counts as shallow up to this part of the smaller body's size.
constexpr double kShallow = 0.1;

/// The engines on the surfaces of a cell.
using TestedEngines = std::vector<std::unique_ptr<const TestedEngine>>;

TestedEngines tested_engines_of(const HeldPairing& held, Mode mode, const std::vector<Engine>& engines) {
  TestedEngines tested;
  for (const Engine engine : engines)
    tested.push_back(make_tested_engine(engine, held.features().E.mesh, held.features().F.mesh, held.law(), mode,
                                        Scheme::barycentric));
  return tested;
}

/// Adds one engine's answer.
void add(ComparisonTally& tally, Engine engine, Wrongs found, bool rule, bool shallow) {
  ComparisonTally::OfEngine& of_engine = tally.engines[static_cast<std::size_t>(engine)];
  constexpr auto kElements = static_cast<std::size_t>(Wrong::elements), kForce = static_cast<std::size_t>(Wrong::force);
  if (!rule && engine != Engine::fast) {
    of_engine.differs_without_rule += found[kForce];
    of_engine.shallow_differs_without_rule += shallow && found[kForce];
    found[kElements] = found[kForce] = false;
  }
  of_engine.wrong += found.any();
  of_engine.shallow_force_wrong += shallow && rule && found[kForce];
  for (std::size_t k = 0; k < kWrongs; ++k) of_engine.by[k] += found[k];
}

/// One pose: the oracle once, then every engine.
ComparisonTally hold(const HeldPairing& held, Mode mode, const DrawnPose& drawn, const std::vector<Engine>& engines,
                     const TestedEngines& tested, TestedEngineWorkspace& workspace) {
  ComparisonTally tally;
  const Question question{held.features().E,   held.features().F, held.law(),    mode,
                          Scheme::barycentric, drawn.pose,        drawn.velocity};
  reference::Inquiry inquiry(held.oracle(), drawn.pose, drawn.velocity);
  const reference::Answer truth = inquiry.answer(reference::Problem::rounded, mode);
  const bool rule = !without_rule(truth);
  const bool shallow = truth.max_penetration <= kShallow * held.features().size();
  tally.poses = 1;
  tally.without_rule = !rule;
  tally.shallow = shallow;
  tally.shallow_without_rule = shallow && !rule;
  for (std::size_t k = 0; k < engines.size(); ++k) {
    const fast::Contact* contact = nullptr;
    try {
      contact = &tested[k]->evaluate(drawn.pose, drawn.velocity, {}, workspace);
    } catch (const std::exception&) {
      // Counted as a failure.
    }
    add(tally, engines[k], wrongs(question, engines[k], contact, truth), rule, shallow);
  }
  return tally;
}

}  // namespace

void ComparisonTally::merge(const ComparisonTally& other) {
  poses += other.poses;
  without_rule += other.without_rule;
  shallow += other.shallow;
  shallow_without_rule += other.shallow_without_rule;
  for (std::size_t e = 0; e < engines.size(); ++e) {
    const OfEngine& theirs = other.engines[e];
    OfEngine& ours = engines[e];
    ours.wrong += theirs.wrong;
    for (std::size_t k = 0; k < kWrongs; ++k) ours.by[k] += theirs.by[k];
    ours.differs_without_rule += theirs.differs_without_rule;
    ours.shallow_force_wrong += theirs.shallow_force_wrong;
    ours.shallow_differs_without_rule += theirs.shallow_differs_without_rule;
  }
}

bool EngineComparison::anything_wrong() const {
  for (const ComparisonTally::OfEngine& engine : all.engines)
    if (engine.wrong > 0) return true;
  return false;
}

EngineComparison compare_engines(VerificationPlan plan, const std::vector<Engine>& engines, int jobs,
                                 const std::function<bool()>& stop, const std::function<void(std::int64_t)>& progress) {
  if (plan.schemes != std::vector{Scheme::barycentric})
    throw BadInput("--engine: the published algorithms know the barycentric scheme only");
  const PlannedPoses poses(std::move(plan));
  std::map<Stratum, ComparisonTally> strata;
  std::map<std::pair<const HeldPairing*, Mode>, TestedEngines> known;
  std::int64_t done = 0;
  for (const PlannedCell& cell : poses.cells()) {
    for (std::int64_t pose = 0; pose < cell.poses; ++pose) {
      const HeldPairing& held = poses.held_pairing(cell, pose);
      TestedEngines& tested = known[{&held, cell.mode}];
      if (tested.empty()) tested = tested_engines_of(held, cell.mode, engines);
    }
    struct Local {
      TestedEngineWorkspace workspace;
      ComparisonTally tally;
    };
    oneapi::tbb::enumerable_thread_specific<Local> locals;
    oneapi::tbb::task_arena arena(jobs);
    arena.execute([&] {
      oneapi::tbb::parallel_for(std::int64_t{0}, cell.poses, [&](std::int64_t pose) {
        if (stop()) return;
        Local& local = locals.local();
        const HeldPairing& held = poses.held_pairing(cell, pose);
        local.tally.merge(
            hold(held, cell.mode, poses.draw(cell, pose), engines, known.at({&held, cell.mode}), local.workspace));
      });
    });
    for (const Local& local : locals) strata[cell.stratum].merge(local.tally);
    progress(done += cell.poses);
  }
  EngineComparison result;
  result.engines = engines;
  result.seed = poses.plan().seed;
  result.omissions = poses.omissions();
  std::int64_t planned = 0;
  for (const PlannedCell& cell : poses.cells()) planned += cell.poses;
  for (const auto& [stratum, tally] : strata) {
    result.strata.emplace_back(stratum, tally);
    result.all.merge(tally);
  }
  result.finished = result.all.poses == planned;
  return result;
}

}  // namespace pcm::compare
