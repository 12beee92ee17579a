// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/peer.h"

namespace pcm::compare {
namespace {

/// Somebody this program was built without.
[[maybe_unused]] PeerEntry absent(const char* who, const char* package) {
  return {who, "", "", package, true, {}};
}

}  // namespace

Velocity bench_velocity() {
  return {.v = {0.1, -0.2, 0.3}, .w = {0.3, 0.2, -0.1}};
}

ContactLaw bench_law() {
  ContactLaw law;
  law.stiffness = 5.9e5;
  law.damping = 1000;
  law.transition_depth = 1e-3;
  law.friction = 0.25;
  law.slip_velocity = 1e-3;
  return law;
}

std::vector<PeerEntry> all_peers() {
  std::vector<PeerEntry> all = engine_peers();
  const auto add = [&all](std::vector<PeerEntry> more) {
    for (PeerEntry& entry : more) all.push_back(std::move(entry));
  };
  add(published_peers());
#ifdef PCM_WITH_FCL
  add(fcl_peers());
#else
  add({absent("FCL", "libfcl-dev")});
#endif
#ifdef PCM_WITH_EMBREE
  add(embree_peers());
#else
  add({absent("Embree", "libembree-dev")});
#endif
#ifdef PCM_WITH_ODE
  add(ode_peers());
#else
  add({absent("ODE", "libode-dev")});
#endif
#ifdef PCM_WITH_SIMBODY
  add(simbody_peers());
#else
  add({absent("Simbody", "libsimbody-dev")});
#endif
#ifdef PCM_WITH_CGAL
  add(cgal_peers());
#else
  add({absent("CGAL", "libcgal-dev")});
#endif
  add(oracle_peers());
  return all;
}

}  // namespace pcm::compare
