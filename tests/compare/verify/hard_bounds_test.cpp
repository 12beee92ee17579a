// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Answers of a right engine whose bounds are hard to state: whatever the surfaces, a bound is a number, and holds.
#include <gtest/gtest.h>

#include <cmath>

#include "compare/verify/disagreement_kind.h"
#include "compare/verify/held_pairing.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/hard_bodies.h"
#include "meshes/generate/round.h"

namespace pcm::compare {
namespace {

void expect_held(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const HeldPairing held(E, F, {}, HeldPairing::Modes{Mode::E, Mode::F, Mode::both}, scheme);
    fast::Workspace workspace;
    for (const auto& outcome : held.hold(pose, {}, workspace))
      for (const auto& disagreement : outcome.disagreements)
        ADD_FAILURE() << name(disagreement.kind) << ": " << disagreement.text;
  }
}

/// A hollow cube and an icosphere with their corners moved far about. Two corners of two of its faces are 3 ulps apart:
/// of the weights over these, doubles can tell nothing.
TEST(HardBounds, OfAFaceWithTwoCornersAFewUlpsApartAreNumbers) {
  TriangleMesh E = degenerate::hollow_cube(0.5), F = generate::icosphere(1, 0);
  E.vertices = {{-1.0, -1.0, -2.0},
                {0.0, 2.0, 0.0},
                {-1.0, -2.0, 1.9999999999999998},
                {0.0, 2.0, -2.0},
                {-2.0, 2.0, -2.0},
                {1.0, -2.0, 2.0},
                {1.0, 2.0, -0x1p-60},
                {-2.0, -1.0, -2.0},
                {-1.0, -2.0, -2.0},
                {2.0, -2.0, 0x1p-60},
                {-2.0, 2.0, -1.0},
                {-0.9999999999999999, 2.0, 2.0},
                {2.0, 1.0, 2.0},
                {-2.0, 0.9999999999999999, -1.0},
                {-1.0, -1.0000000000000002, 1.0},
                {-1.0, -0.9999999999999999, 1.0}};
  F.vertices = {{-0.4152292726119624, 1.0823304002943772, 0.45595498254132655},
                {0.46265357347348696, 1.167464811191939, 0.3887205934165679},
                {-0.6419417806545951, -0.9459620764862824, 0.182101729065481},
                {0.29320279579834274, -0.6090978848069923, 0.17812653650840118},
                {-0.13206764640483099, -0.8423286531995502, 1.0787642833614672},
                {0.2828946591469483, 0.20531534889337794, 0.6222455310285181},
                {-0.34977471492716855, -0.22678564494702802, -0.9334215584848672},
                {0.2735278031691131, 0.5148109912162376, -1.0914597485807296},
                {0.5388920039702061, -0.017298407836551333, -0.2606106915263176},
                {0.8347223365215729, 0.05328431974212234, 0.6212468553493727},
                {-1.1271929284356035, -0.3353226125710578, -0.8675155476754459},
                {-0.5561599093320113, 0.27778225784033234, 0.8787967234616199}};
  expect_held(E, F, {Eigen::Matrix3d::Identity(), {0.67084897690411882, 0.13041529317112976, 1.5}});
}

/// A box in the loop of a figure of eight that is wound about -1 times has an area though no face of it is active, with
/// roundings of its own.
TEST(HardBounds, OfAreasCountFacesOfNegativeWinding) {
  const TriangleMesh eight = degenerate::figure_of_eight();
  for (const double size : {0.01, 0.007, 0.003}) {
    const TriangleMesh small = generate::box({-0.15 - size / 3, -size, -10 * size}, {-0.15 + size, size, 7 * size});
    const Eigen::Matrix3d A{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}};
    expect_held(small, eight, {});
    expect_held(eight, small, {A, Eigen::Vector3d(-0.15, 0, 0) - A * Eigen::Vector3d(-0.15, 0, 0)});
  }
}

}  // namespace
}  // namespace pcm::compare
