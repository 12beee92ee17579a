// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/compare/verify/routes/held_altered.h"

#include <vector>

#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/routes/state_draw.h"
#include "tests/compare/small_pair.h"

namespace pcm::compare {

Held hold_altered(const AlteringSeam& seam, Stratum stratum, Scheme scheme, int enough, int most_poses) {
  const SurfacePair pair = small_pair();
  static const HeldPairing usual(pair.E, pair.F, ContactLaw{}, HeldPairing::Modes{Mode::E, Mode::F, Mode::both});
  static const HeldPairing nested(*nested_meshes(pair.E, pair.F), ContactLaw{},
                                  HeldPairing::Modes{Mode::E, Mode::F, Mode::both});
  const HeldPairing& pairing = stratum == Stratum::nested ? nested : usual;
  fast::Workspace workspace;
  Held held;
  for (int i = 0; i < most_poses && held.altered < enough; ++i) {
    const auto number = static_cast<std::uint64_t>(i);
    const DrawnPose drawn = draw_pose(stratum, pairing.features(), PoseRandom(kSeed, 0, 0, number));
    const HeldPairing::State state =
        draw_state(pairing, stratum, drawn, scheme, PoseRandom(kSeed, 0, 0, number, Purpose::law),
                   PoseRandom(kSeed, 0, 0, number, Purpose::velocity));
    seam.take_altered();
    const std::vector<PoseOutcome> outcomes = pairing.hold(state, workspace, seam);
    std::set<Kind> kinds;
    for (const PoseOutcome& outcome : outcomes)
      for (const Disagreement& d : outcome.disagreements) kinds.insert(d.kind);
    const bool altered = seam.take_altered();
    ++(altered ? held.altered : held.unaltered);
    (altered ? held.flagged : held.unaltered_flagged) += !kinds.empty();
    if (altered) held.kinds.merge(kinds);
  }
  return held;
}

INSTANTIATE_TEST_SUITE_P(Schemes, SeamOverSchemes, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const testing::TestParamInfo<Scheme>& scheme) {
                           return scheme.param == Scheme::clipped ? "clipped" : "barycentric";
                         });

}  // namespace pcm::compare
