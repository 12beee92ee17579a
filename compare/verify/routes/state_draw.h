// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "compare/verify/routes/held_pairing.h"

namespace pcm::compare {

/// The engine broke down, by no BadInput, while it was asked for the figures that a law's thresholds are drawn from.
class DrawFailure : public std::runtime_error {
 public:
  DrawFailure(const std::string& what, const HeldPairing::State& state) : std::runtime_error(what), state_(state) {}
  /// What it was asked, in mode `both`.
  const HeldPairing::State& state() const { return state_; }

 private:
  HeldPairing::State state_;
};

/// What a drawn pose is asked with: a law drawn in three steps, with thresholds at the figures of the engine's own
/// elements there (law_draw.h), in mode `both`; and in the hard strata a velocity drawn anew, for there it may be
/// exactly 0, along a face's normal or in its plane. A pure function of bodies, pose, scheme and random numbers. Where
/// the engine refuses the state (BadInput) there are no figures; whatever else it throws becomes a DrawFailure.
HeldPairing::State draw_state(const HeldPairing& held, Stratum stratum, const DrawnPose& drawn, Scheme scheme,
                              PoseRandom for_law, PoseRandom for_velocity, const EngineSeam& seam = EngineSeam::none());

/// The same under a given law: only the velocity of the hard strata is drawn, as there.
HeldPairing::State state_under_law(const HeldPairing& held, Stratum stratum, const DrawnPose& drawn, Scheme scheme,
                                   const ContactLaw& law, PoseRandom for_velocity);

}  // namespace pcm::compare
