// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/compare/verify/routes/held_altered.h"

#include <memory>
#include <vector>

#include "compare/poses/extreme_meshes.h"
#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/routes/state_draw.h"
#include "tests/compare/small_pair.h"

namespace pcm::compare {

namespace {

const HeldPairing::Modes kAllModes{Mode::E, Mode::F, Mode::both};

std::vector<std::unique_ptr<HeldPairing>> extreme_pairings(const SurfacePair& pair) {
  std::vector<std::unique_ptr<HeldPairing>> held;
  for (std::size_t k = 0; k < kExtremes; ++k) {
    const auto [E, F] = extreme_meshes(pair.E, pair.F, k);
    held.push_back(std::make_unique<HeldPairing>(E, F, ContactLaw{}, kAllModes));
  }
  return held;
}

/// The small pair as the stratum takes it, prepared when it is first asked for; in extreme one extreme after the other.
const HeldPairing& pairing_for(Stratum stratum, std::size_t number) {
  static const SurfacePair pair = small_pair();
  if (stratum == Stratum::nested) {
    static const HeldPairing nested(*nested_meshes(pair.E, pair.F), ContactLaw{}, kAllModes);
    return nested;
  }
  if (stratum == Stratum::extreme) {
    static const std::vector<std::unique_ptr<HeldPairing>> extreme = extreme_pairings(pair);
    return *extreme[number % kExtremes];
  }
  static const HeldPairing usual(pair.E, pair.F, ContactLaw{}, kAllModes);
  return usual;
}

}  // namespace

Held hold_altered(const AlteringSeam& seam, Stratum stratum, Scheme scheme, int enough, int most_poses) {
  fast::Workspace workspace;
  Held held;
  for (int i = 0; i < most_poses && held.altered < enough; ++i) {
    const auto number = static_cast<std::uint64_t>(i);
    const HeldPairing& pairing = pairing_for(stratum, number);
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
