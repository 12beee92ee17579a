// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/engine_seam.h"

namespace pcm::compare {

const fast::Contact& EngineSeam::evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                          const Ask& ask, fast::Workspace& workspace) const {
  return fast::evaluate(pairing, pose, velocity, ask.wanted, workspace, ask.savings);
}

const fast::Contact& EngineSeam::evaluate_for_draw(const fast::Pairing& pairing, const Pose& pose,
                                                   const Velocity& velocity, const Wanted& wanted,
                                                   fast::Workspace& workspace) const {
  return fast::evaluate(pairing, pose, velocity, wanted, workspace);
}

const fast::Contact& EngineSeam::evaluate_known(fast::PairingMemory& memory, const Pose& pose, const Velocity& velocity,
                                                const Ask& ask, fast::Workspace& workspace) const {
  return memory.evaluate(pose, velocity, ask.wanted, workspace, ask.savings);
}

const fast::Contact& EngineSeam::evaluate_in(fast::Scene& scene, fast::Workspace& workspace) const {
  return scene.evaluate(0, workspace);
}

std::vector<fast::BodyLoad> EngineSeam::body_loads_in(fast::Scene& scene) const {
  scene.evaluate_all();
  return scene.body_loads();
}

fast::SceneCounters EngineSeam::counters_of(const fast::Scene& scene) const {
  return scene.counters();
}

const EngineSeam& EngineSeam::none() {
  static const EngineSeam passes;
  return passes;
}

}  // namespace pcm::compare
