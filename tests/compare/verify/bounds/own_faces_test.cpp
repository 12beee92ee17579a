// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Clipped elements where other faces of the master lie in or near the plane of a master face: what the thickness known
// beforehand may spare, and what not (fast/surface/thickness.h). Engine against the oracle's rounded problem.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/degenerate/bodies.h"
#include "pcm/engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

struct Answers {
  fast::Contact subj;
  reference::Answer truth;
};

Answers both(const TriangleMesh& E, const TriangleMesh& F, Mode mode, const Pose& pose, Scheme scheme) {
  const ContactLaw law;
  const reference::Oracle oracle(E, F, law, mode, scheme);
  const fast::Pairing pairing(fast::Surface(E), fast::Surface(F), law, mode, scheme);
  fast::Workspace workspace;
  return {fast::evaluate(pairing, pose, {}, {}, workspace), oracle.answer(reference::Problem::rounded, pose)};
}

/// A pose far beyond a thin body's thickness, whose rounding folds it flat or over: what lay above a face by less than
/// a rounding may lie beneath it.
TEST(OwnFaces, BodyThinnerThanRoundingsIsAnsweredAsRoundedNotAsItWas) {
  const TriangleMesh E = generate::box({1, 4, 4});
  for (const double thin : {0x1p-56, 0x1p-57, 0x1p-60, 0x1p-80, 0x1p-200}) {
    TriangleMesh F = generate::pyramid(2, 0.6);
    for (Eigen::Vector3d& x : F.vertices) x[0] *= thin;
    for (const double x : {-0.3, 0.4, -0.4}) {
      const Pose pose{Eigen::Matrix3d::Identity(), {x, 0.1, 0.2}};
      const auto [subj, truth] = both(E, F, Mode::F, pose, Scheme::clipped);
      EXPECT_EQ(subj.elements.size(), truth.elements.size()) << thin << ' ' << x;
      EXPECT_EQ(subj.too_deep, truth.too_deep) << thin << ' ' << x;
      EXPECT_NEAR((subj.force_Me - truth.force_Me).norm(), 0, 1e-12 * truth.force_scale) << thin << ' ' << x;
    }
  }
}

/// A block with a pit no wider than `half_width` either way: rounded far from the origin, its walls lie upon each other
/// or swap places, and hide what is behind them or not.
TriangleMesh block_with_slit(double half_width) {
  TriangleMesh mesh;
  const double k = half_width;
  mesh.vertices = {{-1, -1, -1}, {1, -1, -1},   {1, 1, -1},   {-1, 1, -1}, {-1, -1, 0},  {1, -1, 0},   {1, 1, 0},
                   {-1, 1, 0},   {-k, -0.8, 0}, {k, -0.8, 0}, {k, 0.8, 0}, {-k, 0.8, 0}, {0, 0, -0.75}};
  mesh.faces = {{0, 3, 2}, {0, 2, 1},  {0, 1, 5},  {0, 5, 4},   {1, 2, 6},    {1, 6, 5},  {2, 3, 7},  {2, 7, 6},
                {3, 0, 4}, {3, 4, 7},  {4, 5, 9},  {4, 9, 8},   {5, 6, 10},   {5, 10, 9}, {6, 7, 11}, {6, 11, 10},
                {7, 4, 8}, {7, 8, 11}, {8, 9, 12}, {9, 10, 12}, {10, 11, 12}, {11, 8, 12}};
  mesh.name = "block with a slit";
  return mesh;
}

/// A wall off by a rounding of 100 m moves what is seen by that over the slit's slope, 1e-14 of the body: 1e-10 is far
/// from both that and the 0.17 that overlooking a wall costs.
TEST(OwnFaces, WallsOfASlitThatRoundingFoldsHideWhatIsBehindThem) {
  int touching = 0;
  for (const double half_width : {1e-17, 1e-15, 1e-13}) {
    const TriangleMesh F = block_with_slit(half_width);
    for (const double away : {0.0, 1.0, 100.0}) {
      for (int step = 0; step < 4; ++step) {
        Pose pose;
        pose.A = Eigen::AngleAxisd(0.3 * step, Eigen::Vector3d(3, -2, 1).normalized()).toRotationMatrix();
        pose.r = away * Eigen::Vector3d(1, 0.7, -0.3);
        TriangleMesh E = generate::box({-0.2, -0.5, -0.6}, {0.3, 0.4, 0.5});
        for (Eigen::Vector3d& x : E.vertices) x = pose.A * x + pose.r;
        const auto [subj, truth] = both(E, F, Mode::F, pose, Scheme::clipped);
        touching += truth.touching ? 1 : 0;
        EXPECT_NEAR((subj.force_Me - truth.force_Me).norm(), 0, 1e-10 * truth.force_scale)
            << half_width << ' ' << away << ' ' << step;
        EXPECT_EQ(subj.too_deep, truth.too_deep) << half_width << ' ' << away << ' ' << step;
      }
    }
  }
  EXPECT_GE(touching, 30);
}

/// Two wedges stand with an edge on a plate, over the barycentres of its upper faces: the penetration lines meet them
/// at distance 0, before the slave, so these faces are too deep though nothing of them is hidden (PCM section 6).
TEST(OwnFaces, WedgesStandingOnBarycentresMakeFacesTooDeepInBothSchemes) {
  const TriangleMesh plate = generate::box({-3, -3, -1}, {3, 3, 0});
  const TriangleMesh one = degenerate::tetrahedron({Eigen::Vector3d(-2, -1, 0), {2, -1, 0}, {0, -2, 1}, {0, 0, 1}});
  const TriangleMesh two = degenerate::tetrahedron({Eigen::Vector3d(-2, 1, 0), {2, 1, 0}, {0, 0.5, 1}, {0, 2, 1}});
  const TriangleMesh body = degenerate::joined(degenerate::joined(plate, one), two);
  const TriangleMesh other = generate::box({-4, -4, -0.5}, {4, 4, 5});
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const auto [as_E, true_as_E] = both(body, other, Mode::E, {}, scheme);
    EXPECT_EQ(as_E.too_deep, true_as_E.too_deep);
    EXPECT_EQ(as_E.too_deep, 14);
    const auto [as_F, true_as_F] = both(other, body, Mode::F, {}, scheme);
    EXPECT_EQ(as_F.too_deep, true_as_F.too_deep);
  }
}

/// The law's bound is so small that clamped means underflow: such parts make no element, and tell how deep they are.
TEST(OwnFaces, PenetrationIsToldWhereTheClampedMeanUnderflows) {
  ContactLaw law;
  law.max_penetration = 5e-324;
  const fast::Surface box(generate::box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  const fast::Pairing pairing(box, box, law, Mode::E, Scheme::clipped);
  fast::Workspace workspace;
  const fast::Contact& subj =
      fast::evaluate(pairing, {Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.9}}, {}, {}, workspace);
  EXPECT_TRUE(subj.penetration_exceeded);
  EXPECT_GT(subj.max_penetration, 0.05);
}

/// The foot of an element is a point of the master face, so it is rounded to its coordinates' last place, which counts
/// in the torque's bound where the body lies far from the markers.
TEST(OwnFaces, TorqueBoundHoldsForBodiesFarFromTheirMarkers) {
  std::mt19937_64 random(3);
  SCOPED_TRACE("seed 3");
  const auto jitter = [&random] { return std::ldexp(static_cast<double>(random() % 64), -12); };
  const auto jittered = [&jitter](TriangleMesh mesh) {
    for (Eigen::Vector3d& x : mesh.vertices)
      for (int k = 0; k < 3; ++k) x[k] += jitter();
    return mesh;
  };
  int held = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const double far = trial % 2 == 0 ? 1e6 : 1e9;
    const auto coordinate = [&] {
      return std::round(far * std::ldexp(static_cast<double>(random() % 1024) - 512, -9));
    };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    const Eigen::Vector3d away(x, y, z);
    TriangleMesh E = jittered(generate::box({-1, -1, -1}, {1, 1, 0}));
    const TriangleMesh F = jittered(generate::box({-0.125, -0.0625, -0.25}, {0.125, 0.0625, 1}));
    for (Eigen::Vector3d& vertex : E.vertices) vertex += away;
    const Pose pose{Eigen::Matrix3d::Identity(), away + Eigen::Vector3d(0.25, 0.125, 0)};
    const ContactLaw law;
    const Mode mode = trial % 4 < 2 ? Mode::E : Mode::F;
    const reference::Oracle oracle(E, F, law, mode, Scheme::clipped);
    const reference::Answer truth = oracle.answer(reference::Problem::exact, pose);
    const fast::Pairing pairing(fast::Surface(E), fast::Surface(F), law, mode, Scheme::clipped);
    fast::Workspace workspace;
    Wanted wanted;
    wanted.bound = true;
    const fast::Contact& subj = fast::evaluate(pairing, pose, {}, wanted, workspace);
    if (!truth.touching) continue;
    ++held;
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(std::abs(subj.torque_Me[k] - truth.torque_Me[k]), subj.bound->torque_Me[k]) << trial;
      EXPECT_LE(std::abs(subj.force_Me[k] - truth.force_Me[k]), subj.bound->force_Me[k]) << trial;
    }
  }
  EXPECT_GE(held, 500);
}

}  // namespace
}  // namespace pcm::compare
