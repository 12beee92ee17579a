// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/hard_state.h"

#include <utility>

namespace pcm::compare {

HardState hard_state(const TriangleMesh& E, const TriangleMesh& F, Scheme scheme) {
  return {held_in_all_modes(E, F, {}, scheme), 0, {{}, {}, {}, scheme, {}}};
}

HardState hard_state(const Case& posed) {
  HardState hard{held_in_all_modes(posed.E, posed.F, posed.law, posed.scheme),
                 0,
                 {posed.pose, posed.velocity, posed.law, posed.scheme, {}}};
  hard.ask_in(posed.mode);
  return hard;
}

Case as_case(const HardState& hard, std::string origin) {
  Case posed;
  posed.origin = std::move(origin);
  posed.E = hard.held->features().E.mesh;
  posed.F = hard.held->features().F.mesh;
  posed.pose = hard.state.pose;
  posed.velocity = hard.state.velocity;
  posed.law = hard.state.law;
  posed.mode = hard.mode_asked();
  posed.scheme = hard.state.scheme;
  return posed;
}

}  // namespace pcm::compare
