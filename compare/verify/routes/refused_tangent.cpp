// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/refused_tangent.h"

#include <limits>

#include "compare/verify/routes/refusal.h"
#include "compare/verify/routes/two_bodies.h"
#include "compare/verify/routes/wanted_presets.h"
#include "compare/verify/verdict/tangent_verdict.h"

namespace pcm::compare {
namespace {

constexpr double kWeakening = 0x1p-128;

}  // namespace

std::string refusal_of_tangent(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose,
                               const Velocity& velocity, fast::Workspace& workspace) {
  return refusal_of([&] { seam.evaluate(pairing, pose, velocity, {Route::tangent, kForceAndTangent, {}}, workspace); });
}

void hold_refusal(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                  const std::string& refusal, fast::Workspace& workspace, Checks& checks) {
  const auto hold = [&](Route route, const auto& ask) {
    checks.checked(Kind::paths);
    const std::string said = refusal_of(ask);
    if (said == refusal) return;
    checks.add(Kind::paths, "{}: a tangent is refused with \"{}\", on another route with \"{}\"", name(route), said,
               refusal);
  };
  for (Ask ask : asks_at(pose, velocity)) {
    ask.wanted.tangent = true;
    hold(ask.route, [&] { seam.evaluate(pairing, pose, velocity, ask, workspace); });
  }
  fast::PairingMemory memory(pairing);
  for (Ask ask : known_pose_asks_at(pose, velocity)) {
    ask.wanted.tangent = true;
    hold(ask.route, [&] { seam.evaluate_known(memory, pose, velocity, ask, workspace); });
  }
  if (!is_pose_for_scenes(pose)) return;
  for (Ask ask : scene_asks_at(pose, velocity)) {
    ask.wanted.tangent = true;
    fast::Scene scene = scene_of(pairing, ask.wanted, ask.savings);
    scene.move({{}, {pose, velocity}});
    hold(ask.route, [&] { seam.evaluate_in(scene, workspace); });
  }
}

ContactLaw weakened(const ContactLaw& law) {
  ContactLaw weak = law;
  weak.stiffness *= kWeakening;
  weak.damping *= kWeakening;
  if (weak.layers) {
    weak.layers->c_E *= kWeakening;
    weak.layers->c_F *= kWeakening;
  }
  return weak;
}

void hold_beyond_doubles(const fast::Tangent& under_weakened_law, Checks& checks) {
  constexpr double kLeast = kWeakening * std::numeric_limits<double>::max() / kGreatestOnTheWay;
  const double greatest = under_weakened_law.lpNorm<Eigen::Infinity>();
  if (greatest < kLeast)
    checks.add(Kind::tangent, "refused, though its greatest entry under a law 2^-128 times as strong is {}", greatest);
}

}  // namespace pcm::compare
