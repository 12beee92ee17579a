// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "compare/verify/routes/engine_seam.h"

namespace pcm::compare {

/// Alters the engine's answers on their way to the comparison; for one thread.
class AlteringSeam final : public EngineSeam {
 public:
  /// Alters an answer; false where it has nothing to alter, or where altering changes nothing.
  using Alteration = std::function<bool(fast::Contact&)>;

  /// On one route, or on all of them alike.
  explicit AlteringSeam(Alteration alter, std::optional<Route> only = std::nullopt)
      : alter_(std::move(alter)), only_(only) {}

  const fast::Contact& evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                const Ask& ask, fast::Workspace& workspace) const override {
    return altered(ask.route, EngineSeam::evaluate(pairing, pose, velocity, ask, workspace));
  }
  const fast::Contact& evaluate_known(fast::PairingMemory& memory, const Pose& pose, const Velocity& velocity,
                                      const Ask& ask, fast::Workspace& workspace) const override {
    return altered(ask.route, EngineSeam::evaluate_known(memory, pose, velocity, ask, workspace));
  }
  const fast::Contact& evaluate_in(fast::Scene& scene, fast::Workspace& workspace) const override {
    return altered(Route::scene, EngineSeam::evaluate_in(scene, workspace));
  }

  /// Whether anything was altered since the last call.
  bool take_altered() const { return std::exchange(has_altered_, false); }

 private:
  const fast::Contact& altered(Route route, const fast::Contact& answer) const {
    if (only_ && route != *only_) return answer;
    answer_ = answer;
    if (!alter_(answer_)) return answer;
    has_altered_ = true;
    return answer_;
  }

  Alteration alter_;
  std::optional<Route> only_;
  mutable fast::Contact answer_;
  mutable bool has_altered_ = false;
};

}  // namespace pcm::compare
