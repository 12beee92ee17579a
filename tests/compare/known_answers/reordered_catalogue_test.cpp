// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which vertices and faces are listed decides ties, and nothing that is true of the bodies.
#include <gtest/gtest.h>

#include <string>

#include "compare/known_answers/identity_support.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "pcm/check.h"
#include "pcm/engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

using reference::Problem;

/// Of the exact problem: what no tie rule enters.
void expect_same_body(const reference::Answer& a, const reference::Answer& b) {
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.E.area_interval, b.E.area_interval);
  EXPECT_EQ(a.F.area_interval, b.F.area_interval);
  EXPECT_EQ(a.force_Me, b.force_Me);
  EXPECT_EQ(a.torque_Me, b.torque_Me);
}

TEST(ReorderedCatalogue, HasTheSameVolumesForcesAndIntervalsOfAreasWithinWhichTheEnginesAreasLie) {
  constexpr std::uint64_t kSeed = 11;
  PoseRandom random(kSeed, 0, 0, 0);
  ContactLaw law;
  law.stiffness = 1e3;
  fast::Workspace workspace;
  int pairs = 0;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    if (!named.exactly_representable || !check(named.E).closed() || !check(named.F).closed()) continue;
    SCOPED_TRACE(named.name + ", seed " + std::to_string(kSeed));
    ++pairs;
    const Pose pose{named.A, named.r};
    const reference::Oracle plain(named.E, named.F, law, Mode::both, Scheme::clipped);
    const reference::Answer truth = plain.answer(Problem::exact, pose, {});
    for (int i = 0; i < 4; ++i) {
      const TriangleMesh E = reordered(named.E, random), F = reordered(named.F, random);
      const reference::Oracle other(E, F, law, Mode::both, Scheme::clipped);
      expect_same_body(other.answer(Problem::exact, pose, {}), truth);
      const fast::Pairing pairing(fast::Surface(E), fast::Surface(F), law, Mode::both, Scheme::clipped);
      const fast::Contact& contact = fast::evaluate(pairing, pose, {}, {}, workspace);
      // Of some hundred faces, each with a few roundings.
      const auto within = [](double area, const reference::AreaInterval& interval) {
        EXPECT_GE(area, interval.open * (1 - 0x1p-40));
        EXPECT_LE(area, interval.closed * (1 + 0x1p-40));
      };
      within(contact.E.area, truth.E.area_interval);
      within(contact.F.area, truth.F.area_interval);
    }
  }
  EXPECT_GT(pairs, 25);
}

}  // namespace
}  // namespace pcm::compare
