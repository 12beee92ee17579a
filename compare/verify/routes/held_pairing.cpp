// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/held_pairing.h"

#include <bit>
#include <chrono>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "compare/poses/rounded_vertices.h"
#include "compare/verify/routes/call_routes.h"
#include "compare/verify/routes/refused_tangent.h"
#include "compare/verify/verdict/tangent_verdict.h"
#include "pcm/check.h"

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
                                    const HeldPairing::Modes& modes, Scheme scheme) {
  const fast::Surface surface_E(mesh_E);
  const bool same = mesh_E.vertices == mesh_F.vertices && mesh_E.faces == mesh_F.faces;
  const fast::Surface surface_F = same ? surface_E : fast::Surface(mesh_F);
  std::vector<fast::Pairing> engines;
  for (const Mode mode : modes) engines.emplace_back(surface_E, surface_F, law, mode, scheme);
  return engines;
}

/// How far, in sizes of the smaller body, a scene's body is moved before it comes to the pose.
constexpr double kStepBefore = 0x1p-13;

/// One pose in this many has the oracle asked once more, afresh.
constexpr std::uint64_t kAfreshShare = 8;

bool asked_afresh(const Pose& pose) {
  std::uint64_t bits = 0;
  for (int k = 0; k < 3; ++k) bits = (bits ^ std::bit_cast<std::uint64_t>(pose.r[k])) * 0x9e3779b97f4a7c15;
  return (bits >> 40) % kAfreshShare == 0;
}

}  // namespace

HeldPairing::HeldPairing(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, const Modes& modes,
                         Scheme scheme)
    : mesh_E_(fit(std::move(mesh_E))),
      mesh_F_(fit(std::move(mesh_F))),
      features_(mesh_E_, mesh_F_),
      law_(law),
      engines_(pairings(mesh_E_, mesh_F_, law, modes, scheme)),
      oracle_(mesh_E_, mesh_F_, law, modes.front(), scheme) {}

HeldPairing::HeldPairing(NestedMeshes meshes, const ContactLaw& law, const Modes& modes, Scheme scheme)
    : HeldPairing(std::move(meshes.E), std::move(meshes.F), law, modes, scheme) {
  features_.ball = meshes.ball;
  features_.host = meshes.host;
}

std::vector<PoseOutcome> HeldPairing::hold(const State& state, fast::Workspace& workspace,
                                           const EngineSeam& seam) const {
  const Wanted everything;
  std::vector<PoseOutcome> outcomes;
  std::optional<reference::Inquiry> inquiry;
  std::string refusal;
  try {
    inquiry.emplace(oracle_, state.pose, state.velocity, everything, state.law, state.scheme);
  } catch (const std::exception& error) {
    refusal = std::string("oracle: ") + error.what();
  }
  for (const fast::Pairing& engine : engines_) {
    if (inquiry) {
      const fast::Pairing asked = engine_under(state.law, engine.mode(), state.scheme);
      outcomes.push_back(hold(asked, *inquiry, state, workspace, seam));
      continue;
    }
    outcomes.emplace_back().disagreements.push_back({Kind::failure, refusal});
  }
  return outcomes;
}

PoseOutcome HeldPairing::hold(const fast::Pairing& engine, reference::Inquiry& inquiry, const State& state,
                              fast::Workspace& workspace, const EngineSeam& seam) const {
  PoseOutcome outcome;
  Checks checks;
  const Pose& pose = state.pose;
  const Velocity& velocity = state.velocity;
  const char* who = "engine";
  try {
    const StopWatch engine_watch;
    const fast::Contact& answered = seam.evaluate(engine, pose, velocity, {}, workspace);
    outcome.engine_seconds = engine_watch.seconds();
    const fast::Contact subj = answered;  // the other routes use the same workspace

    who = "oracle, rounded problem";
    const StopWatch oracle_watch;
    const reference::Answer true_rounded = inquiry.answer(reference::Problem::rounded, engine.mode());
    outcome.oracle_seconds = oracle_watch.seconds();

    who = "oracle, exact problem";
    const StopWatch exact_watch;
    const reference::Answer true_exact = inquiry.answer(reference::Problem::exact, engine.mode());
    outcome.oracle_exact_seconds = exact_watch.seconds();

    who = "comparison";
    const Question asked{features_.E, features_.F, state.law, engine.mode(), engine.scheme(), pose, velocity};
    outcome.touching = true_rounded.touching;
    outcome.nested = true_rounded.nested;
    outcome.ambiguous = true_rounded.ambiguous;
    outcome.too_deep = true_rounded.too_deep > 0;
    outcome.flipped = engine.scheme() == Scheme::barycentric && flipped(true_rounded, true_exact);
    outcome.predicates = subj.work.predicates;
    outcome.exact_predicates = subj.work.exact_predicates;
    checks.merge(hold_answer(asked, subj, true_rounded));
    if (asked_afresh(pose)) {
      reference::Inquiry afresh(oracle_, pose, velocity, {}, state.law, state.scheme);
      checks.merge(hold_history(true_exact, afresh.answer(reference::Problem::exact, engine.mode())));
    }

    who = "oracle, tangent";
    const reference::Tangent true_tangent = inquiry.tangent(reference::Problem::rounded, engine.mode());
    const fast::Tangent allowed = allowed_errors(asked, subj.elements, true_rounded, true_tangent);

    who = "engine on another path";
    const std::string refusal = may_overflow(true_tangent, allowed)
                                    ? refusal_of_tangent(seam, engine, pose, velocity, workspace)
                                    : std::string();
    if (!refusal.empty()) {
      hold_refusal(seam, engine, pose, velocity, refusal, workspace, checks);
      checks.merge(hold_weak_tangent(engine, state, workspace, seam));
    }
    const AnsweredState there{seam, engine, pose, velocity, subj, features_.size() * kStepBefore};
    if (!state.before.empty()) hold_motion(there, state.before, workspace, checks);
    hold_routes(
        there, refusal.empty(), workspace, checks,
        [&](const fast::Contact& bounded) {
          outcome.unbounded =
              bounded.bound && !(bounded.bound->force_Me.allFinite() && bounded.bound->torque_Me.allFinite());
          outcome.announced = bounded.bound && bounded.bound->flipped;
          checks.merge(broken_bounds(asked, bounded, true_rounded, true_exact));
          outcome.errors = relative_errors(asked, bounded, true_exact, outcome.flipped);
        },
        [&](const fast::Contact& with_tangent) { check_tangent(with_tangent, true_tangent, allowed, checks); });
    outcome.backward_error_ulps = backward_error_ulps(mesh_F_, pose);
  } catch (const std::exception& error) {
    checks.add(Kind::failure, "{}: {}", who, error.what());
  }
  outcome.disagreements = checks.sorted();
  outcome.widths = checks.widths();
  return outcome;
}

Checks HeldPairing::hold_weak_tangent(const fast::Pairing& engine, const State& state, fast::Workspace& workspace,
                                      const EngineSeam& seam) const {
  const ContactLaw weak = weakened(state.law);
  const fast::Pairing asked = engine_under(weak, engine.mode(), engine.scheme());
  Wanted wanted;
  wanted.tangent = true;
  const fast::Contact& subj = seam.evaluate(asked, state.pose, state.velocity, {Route::tangent, wanted, {}}, workspace);
  reference::Inquiry inquiry(oracle_, state.pose, state.velocity, {}, weak, engine.scheme());
  const reference::Answer truth = inquiry.answer(reference::Problem::rounded, engine.mode());
  const reference::Tangent true_tangent = inquiry.tangent(reference::Problem::rounded, engine.mode());
  const Question question{features_.E, features_.F, weak, engine.mode(), engine.scheme(), state.pose, state.velocity};
  Checks checks;
  check_tangent(subj, true_tangent, allowed_errors(question, subj.elements, truth, true_tangent), checks);
  if (subj.tangent) hold_beyond_doubles(*subj.tangent, checks);
  return checks;
}

}  // namespace pcm::compare
