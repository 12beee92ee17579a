// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/held_again.h"

namespace pcm::compare {

PoseOutcome held_again(const Case& posed, const EngineSeam& seam) {
  const HeldPairing held(posed.E, posed.F, posed.law, posed.mode, posed.scheme);
  fast::Workspace workspace;
  return held.hold({posed.pose, posed.velocity, posed.law, posed.scheme, posed.before}, workspace, seam).front();
}

}  // namespace pcm::compare
