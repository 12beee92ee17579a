// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/verify/routes/asks.h"
#include "pcm/engine.h"
#include "pcm/pairing_memory.h"
#include "pcm/scene.h"

namespace pcm::compare {

/// Stands between the engine and the comparison. This one lets answers pass; tests put others in its place, which alter
/// them, to see the comparison notice.
class EngineSeam {
 public:
  EngineSeam() = default;
  EngineSeam(const EngineSeam&) = delete;
  EngineSeam& operator=(const EngineSeam&) = delete;
  virtual ~EngineSeam() = default;

  /// The answer lives until the next call with that workspace. Throws as fast::evaluate does.
  virtual const fast::Contact& evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                        const Ask& ask, fast::Workspace& workspace) const;
  /// Elements that a law's thresholds are drawn at (state_draw.h).
  virtual const fast::Contact& evaluate_for_draw(const fast::Pairing& pairing, const Pose& pose,
                                                 const Velocity& velocity, const Wanted& wanted,
                                                 fast::Workspace& workspace) const;
  virtual const fast::Contact& evaluate_known(fast::PairingMemory& memory, const Pose& pose, const Velocity& velocity,
                                              const Ask& ask, fast::Workspace& workspace) const;
  /// The answer of a scene's only pairing, where its bodies are.
  virtual const fast::Contact& evaluate_in(fast::Scene& scene, fast::Workspace& workspace) const;
  /// What acts on its two bodies there.
  virtual std::vector<fast::BodyLoad> body_loads_in(fast::Scene& scene) const;
  /// What it has counted since its last move.
  virtual fast::SceneCounters counters_of(const fast::Scene& scene) const;

  /// The one that lets answers pass.
  static const EngineSeam& none();
};

}  // namespace pcm::compare
