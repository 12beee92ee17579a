// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of the master, tiny or needles, that a penetration line meets before it leaves the slave.
#include <gtest/gtest.h>

#include "compare/verify/routes/held_pairing.h"
#include "tests/spike.h"

namespace pcm::compare::tiny_faces_test {
namespace {

/// A body of a cube's connections.
TriangleMesh block(std::vector<Eigen::Vector3d> corners) {
  TriangleMesh mesh;
  mesh.vertices = std::move(corners);
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Engine against oracle, bounds included, with either body and both as masters, in both schemes.
void hold(const TriangleMesh& E, const TriangleMesh& F) {
  ContactLaw law;
  law.stiffness = 1;
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const HeldPairing held(E, F, law, HeldPairing::Modes{Mode::E, Mode::F, Mode::both}, scheme);
    fast::Workspace workspace;
    const auto outcomes = held.hold({}, {}, workspace);
    EXPECT_TRUE(outcomes.front().too_deep);
    for (const auto& outcome : outcomes) {
      for (const Disagreement& disagreement : outcome.disagreements) ADD_FAILURE() << disagreement.text;
    }
  }
}

TEST(TinyFaces, TheTipOfASpikeIsMetBeforeTheSlaveIsLeft) {
  hold(spike(), block({{0x1.6p-2, 0x1.fcp+1, 0x1.62p+2},
                       {0x1.e4p+0, 0x1.4p+2, 0x1.ecp+0},
                       {0x1.acp+1, -0x1.c4p+1, 0x1.42p+2},
                       {0x1.39p+2, -0x1.4p+1, 0x1.6cp+0},
                       {-0x1.ebp+1, 0x1.39p+1, 0x1.a7p+1},
                       {-0x1.25p+1, 0x1.bdp+1, -0x1.38p-2},
                       {-0x1.acp-1, -0x1.438p+2, 0x1.67p+1},
                       {0x1.6cp-1, -0x1.018p+2, -0x1.9cp-1}}));
}

TEST(TinyFaces, ANeedleNearlyAlongTheLineIsMetBeforeTheSlaveIsLeft) {
  TriangleMesh sheets;
  sheets.vertices = {{0x1.c99255a2f308ap-10, -0x1.f205d5ae8764ep-12, -0x1.00c534042593bp-12},
                     {-0x1.77cec6843517bp-11, 0x1.67bffea5c92ecp-10, -0x1.fb04064e6369p-11},
                     {-0x1.0daaf26de9c84p-10, -0x1.d67d1242453f7p-11, 0x1.3db3501699d77p-10},
                     {-0x1.19800a6b47692p+0, -0x1.4edf000b70a27p+1, -0x1.70f67eab14cc9p+1},
                     {-0x1.7716443898e26p-2, -0x1.b44e0fad8d4b6p-1, -0x1.e151939054366p-1},
                     {-0x1.7716442d4647ap-2, -0x1.b44e0f845ac08p-1, -0x1.e15193b7e1236p-1}};
  sheets.faces = {{0, 1, 2}, {3, 4, 5}};
  hold(sheets, block({{-0x1.d8d32ff54db13p+1, -0x1.1bd2fa56910b5p+1, 0x1.144ee31f576e4p+0},
                      {-0x1.755b85ab25daep-1, -0x1.831521415ce43p+1, 0x1.53aa2685eca86p-1},
                      {-0x1.921d2df30a7e5p+1, 0x1.cd79f0402d1f5p+0, -0x1.63d67181a58b5p+1},
                      {-0x1.6a0df688643d4p-3, 0x1.fdeb44d52adb2p-1, -0x1.9913596fd6185p+1},
                      {-0x1.8bdf6569d9cap+1, -0x1.9e19842ea250ep-1, 0x1.50f9f06644c28p+1},
                      {-0x1.06316df558f8dp-3, -0x1.9d910fece8da3p+0, 0x1.1bbd087814358p+1},
                      {-0x1.4529636796972p+1, 0x1.9b09916aff06cp+1, -0x1.3a07e55618ffep+0},
                      {0x1.b29759176d1acp-2, 0x1.33c76a80332dep+1, -0x1.a481b5327a19ep+0}}));
}

}  // namespace
}  // namespace pcm::compare::tiny_faces_test
