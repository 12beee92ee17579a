// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/scene.h"

#include <chrono>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "compare/rounded_vertices.h"
#include "meshes/check.h"

namespace pcm::compare {
namespace {

/// Seconds since construction.
class StopWatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The mesh, once it is known to be fit for contact: nothing below is prepared for others.
TriangleMesh fit(TriangleMesh mesh) {
  require_fit(mesh);
  return mesh;
}

std::vector<fast::Pairing> pairings(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const ContactLaw& law,
                                    const Scene::Modes& modes, Scheme scheme) {
  const fast::Surface surface_E(mesh_E), surface_F(mesh_F);
  std::vector<fast::Pairing> engines;
  for (const Mode mode : modes) engines.emplace_back(surface_E, surface_F, law, mode, scheme);
  return engines;
}

}  // namespace

Scene::Scene(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, const Modes& modes, Scheme scheme)
    : mesh_E_(fit(std::move(mesh_E))),
      mesh_F_(fit(std::move(mesh_F))),
      features_(mesh_E_, mesh_F_),
      law_(law),
      engines_(pairings(mesh_E_, mesh_F_, law, modes, scheme)),
      oracle_(mesh_E_, mesh_F_, law, modes.front(), scheme) {}

Scene::Scene(NestedMeshes meshes, const ContactLaw& law, const Modes& modes, Scheme scheme)
    : Scene(std::move(meshes.E), std::move(meshes.F), law, modes, scheme) {
  features_.ball = meshes.ball;
  features_.host = meshes.host;
}

std::vector<PoseOutcome> Scene::hold(const Pose& pose, const Velocity& velocity, fast::Workspace& workspace) const {
  Wanted everything;
  everything.bound = true;
  std::vector<PoseOutcome> outcomes;
  std::optional<reference::Inquiry> inquiry;
  std::string refusal;
  try {
    inquiry.emplace(oracle_, pose, velocity, everything);
  } catch (const std::exception& error) {
    refusal = std::string("oracle: ") + error.what();
  }
  for (const fast::Pairing& engine : engines_) {
    if (inquiry) {
      outcomes.push_back(hold(engine, *inquiry, pose, velocity, workspace));
      continue;
    }
    outcomes.emplace_back().disagreements.push_back({Kind::failure, refusal});
  }
  return outcomes;
}

PoseOutcome Scene::hold(const fast::Pairing& engine, reference::Inquiry& inquiry, const Pose& pose,
                        const Velocity& velocity, fast::Workspace& workspace) const {
  PoseOutcome outcome;
  Wanted everything;
  everything.bound = true;
  const char* who = "engine";
  try {
    const StopWatch engine_watch;
    const fast::Contact& subj = fast::evaluate(engine, pose, velocity, everything, workspace);
    outcome.engine_seconds = engine_watch.seconds();

    who = "oracle, rounded problem";
    const StopWatch oracle_watch;
    // Forces of the clipped scheme are held against the exact problem alone, by the engine's own bounds.
    const reference::Answer true_rounded = engine.scheme() == Scheme::clipped
                                               ? inquiry.facts(reference::Problem::rounded, engine.mode())
                                               : inquiry.answer(reference::Problem::rounded, engine.mode());
    outcome.oracle_seconds = oracle_watch.seconds();

    who = "oracle, exact problem";
    const StopWatch exact_watch;
    const reference::Answer true_exact = inquiry.answer(reference::Problem::exact, engine.mode());
    outcome.oracle_exact_seconds = exact_watch.seconds();

    who = "comparison";
    const Question asked = question(engine, pose, velocity);
    outcome.touching = true_rounded.touching;
    outcome.nested = true_rounded.nested;
    outcome.ambiguous = true_rounded.ambiguous;
    outcome.too_deep = true_rounded.too_deep > 0;
    outcome.flipped = engine.scheme() == Scheme::barycentric && flipped(true_rounded, true_exact);
    outcome.unbounded = subj.bound && !(subj.bound->force_Me.allFinite() && subj.bound->torque_Me.allFinite());
    outcome.predicates = subj.work.predicates;
    outcome.exact_predicates = subj.work.exact_predicates;
    outcome.disagreements = disagreements(asked, subj, true_rounded);
    for (Disagreement& broken : broken_bounds(asked, subj, true_rounded, true_exact))
      outcome.disagreements.push_back(std::move(broken));
    outcome.errors = relative_errors(asked, subj, true_exact, outcome.flipped);
    outcome.backward_error_ulps = backward_error_ulps(mesh_F_, pose);
  } catch (const std::exception& error) {
    outcome.disagreements.push_back({Kind::failure, std::string(who) + ": " + error.what()});
  }
  return outcome;
}

}  // namespace pcm::compare
