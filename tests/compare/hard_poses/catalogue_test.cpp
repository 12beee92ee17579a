// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The named degenerate pairs: as they are, and moved by 1 to 8 ulps along each axis.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "compare/io/names.h"
#include "compare/poses/rounded_vertices.h"
#include "compare/verify/routes/held_pairing.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "tests/compare/law_of_all.h"

namespace pcm::compare::catalogue_test {
namespace {

double area_of(const TriangleMesh& mesh) {
  double twice = 0;
  for (const Triangle& t : mesh.faces) {
    const auto vertex = [&](int k) { return mesh.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
    twice += (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)).norm();
  }
  return twice / 2;
}

class CatalogueInScheme : public testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, CatalogueInScheme, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& scheme) { return std::string(name(scheme.param)); });

using Moved = std::tuple<Scheme, int>;  ///< along this axis

class MovedCatalogue : public testing::TestWithParam<Moved> {};

std::string name_of(const testing::TestParamInfo<Moved>& moved) {
  return std::string(name(std::get<Scheme>(moved.param))) + "xyz"[std::get<int>(moved.param)];
}

INSTANTIATE_TEST_SUITE_P(Schemes, MovedCatalogue,
                         testing::Combine(testing::Values(Scheme::barycentric, Scheme::clipped),
                                          testing::Values(0, 1, 2)),
                         name_of);

TEST_P(MovedCatalogue, EngineAndOracleAgreeAndVolumesAreThoseWorkedOutByHandToUlps) {
  const auto [scheme, axis] = GetParam();
  const Velocity velocity{{0.3, -0.2, 0.1}, {0.5, 0.4, -0.3}};
  fast::Workspace workspace;
  int poses = 0, volumes = 0;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    const HeldPairing held(named.E, named.F, law_of_all(), HeldPairing::Modes{Mode::E, Mode::F, Mode::both}, scheme);
    const Pose plain{named.A, named.r};
    const double scale = coordinate_scale(named.E, named.F, plain), ulp = ulp_of(scale);
    for (int ulps = -8; ulps <= 8; ++ulps) {
      if (ulps == 0 && axis > 0) continue;
      SCOPED_TRACE(named.name + ", " + std::to_string(ulps) + " ulps along " + "xyz"[axis]);
      Pose pose = plain;
      pose.r[axis] += ulps * ulp;
      for (const PoseOutcome& outcome : held.hold(pose, velocity, workspace)) {
        ++poses;
        for (const Disagreement& d : outcome.disagreements) ADD_FAILURE() << name(d.kind) << ": " << d.text;
      }
      if (scheme != Scheme::barycentric || !named.volume) continue;
      const auto volume = held.oracle().answer(reference::Problem::exact, pose, {}).volume;
      ASSERT_TRUE(volume.has_value());
      // What a surface sweeps.
      const double roundings = named.exactly_representable ? 0 : 8;
      EXPECT_NEAR(*volume, *named.volume, (std::abs(ulps) + roundings) * ulp * area_of(named.E));
      ++volumes;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(poses, 2000);
  if (scheme == Scheme::barycentric) {
    EXPECT_GT(volumes, 600);
  }
}

TEST_P(CatalogueInScheme, BodiesThatMeetInNoVolumeHaveNoElementsAndNoForce) {
  int empty = 0;
  fast::Workspace workspace;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    if (!named.volume || *named.volume != 0) continue;
    SCOPED_TRACE(named.name);
    ++empty;
    const Pose pose{named.A, named.r};
    for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
      const HeldPairing held(named.E, named.F, ContactLaw{}, mode, GetParam());
      const fast::Contact& contact = fast::evaluate(held.engine(), pose, {}, {}, workspace);
      const reference::Answer truth = held.oracle().answer(reference::Problem::exact, pose, {});
      EXPECT_EQ(truth.elements.size(), 0U);
      EXPECT_TRUE(truth.force_Me.isZero(0));
      if (!named.exactly_representable) continue;
      EXPECT_EQ(contact.element_count, 0);
      EXPECT_TRUE(contact.force_Me.isZero(0)) << contact.force_Me.transpose();
    }
  }
  EXPECT_GT(empty, 15);
}

}  // namespace
}  // namespace pcm::compare::catalogue_test
