// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/generate/degenerate/hard_bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/lattice_tetrahedra.h"
#include "pcm/check.h"
#include "tests/meshes/generate/generator_expectations.h"

namespace pcm::hard_bodies_test {
namespace {

/// Sum of the solid angles of the faces seen from the point over 4 pi, to the nearest whole number.
int winding_number(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  double solid_angles = 0;
  for (const auto& [i, j, k] : mesh.faces) {
    const Eigen::Vector3d a = mesh.vertices[i] - point, b = mesh.vertices[j] - point, c = mesh.vertices[k] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    solid_angles += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return static_cast<int>(std::lround(solid_angles / (4 * std::numbers::pi)));
}

TEST(HardBodies, AreFitForContact) {
  using namespace degenerate;
  for (const TriangleMesh& mesh :
       {fan_tipped_spike(0x1p-20), needle(0x1p-20), open_box({1, 1, 0.5}), without_face(generate::box({1, 1, 1}), 3),
        folded_sheet(6, 0.125, 0.25), hollow_cube(0.5), pentagram(), figure_of_eight(), shrinking_cubes(4, 15),
        plate_stack(8, 0x1p-3, 0x1p-7), block_with_touching_keel(0x1p-48), torus_chain(3, 4, 1, 4, 4)}) {
    EXPECT_NO_THROW(require_fit(mesh)) << mesh.name << '\n' << check(mesh).summary();
    EXPECT_EQ(test::flaw(mesh), "") << mesh.name;
  }
}

TEST(HardBodies, ClosedOnesHaveTheFacesPromised) {
  test::expect_closed(degenerate::fan_tipped_spike(0x1p-20), 32);
  test::expect_closed(degenerate::needle(0x1p-20), 8);
  test::expect_closed(degenerate::hollow_cube(0.5), 24, 4);
  test::expect_closed(degenerate::pentagram(), 20);
  test::expect_closed(degenerate::figure_of_eight(), 16);
  test::expect_closed(degenerate::shrinking_cubes(4, 15), 48, 8);
  test::expect_closed(degenerate::plate_stack(8, 0x1p-3, 0x1p-7), 64, 16);
  test::expect_closed(degenerate::block_with_touching_keel(0x1p-48), 22, 4);
  test::expect_closed(degenerate::torus_chain(3, 0.5, 0.125, 16, 8), 3 * 2 * 16 * 8, 0);
}

TEST(HardBodies, OpenOnesHaveTheBordersPromised) {
  test::expect_open(degenerate::open_box({1, 1, 0.5}), 10, 4);
  test::expect_open(degenerate::without_face(generate::box({1, 1, 1}), 3), 11, 3);
  test::expect_open(degenerate::folded_sheet(6, 0.125, 0.25), 12, 14);
}

TEST(HardBodies, VolumesAreThoseWorkedOutByHand) {
  // An octagon of half-width 4 has area 48: a frustum of areas 48/256 and 48/16 tip^2, and the pyramid below.
  const double tip = 0x1p-3, base = 48.0 / 256, top = 48.0 / 16 * tip * tip;
  EXPECT_NEAR(test::signed_volume(degenerate::fan_tipped_spike(tip)),
              (base + top + std::sqrt(base * top)) / 3 + top * tip / 3, 1e-15);
  EXPECT_DOUBLE_EQ(test::signed_volume(degenerate::needle(0.25)), 2 * 0.25 * 0.25 / 3);
  EXPECT_DOUBLE_EQ(test::signed_volume(degenerate::hollow_cube(0.5)), 1 - 0.125);
  EXPECT_DOUBLE_EQ(test::signed_volume(degenerate::shrinking_cubes(2, 1)), 1 + 0.125);
  // Frustums over triangles of area 7/4.
  EXPECT_NEAR(test::signed_volume(degenerate::plate_stack(2, 0.125, 0x1p-7)),
              2 * 0.125 / 3 * 1.75 * (1 + 0.75 + 0.75 * 0.75), 1e-15);
}

TEST(HardBodies, PentagramWindsTwiceAboutItsCoreAndOnceAboutItsPoints) {
  const TriangleMesh mesh = degenerate::pentagram();
  EXPECT_EQ(winding_number(mesh, {0.01, 0.02, 0.1}), 2);
  EXPECT_EQ(winding_number(mesh, {0.45, 0.001, 0.1}), 1);
  EXPECT_EQ(winding_number(mesh, {0.4, 0.4, 0.1}), 0);
}

TEST(HardBodies, FigureOfEightWindsBackwardsAboutItsSmallerLoop) {
  const TriangleMesh mesh = degenerate::figure_of_eight();
  EXPECT_EQ(winding_number(mesh, {0.6, 0.1, 0.1}), 1);
  EXPECT_EQ(winding_number(mesh, {-0.2, 0.01, 0.1}), -1);
  EXPECT_EQ(winding_number(mesh, {-0.2, 0.4, 0.1}), 0);
}

TEST(HardBodies, CubesShrinkToTheSizeAndDistancePromised) {
  const TriangleMesh mesh = degenerate::shrinking_cubes(4, 15);
  Eigen::Vector3d low = mesh.vertices[24], high = low;
  for (std::size_t v = 24; v < 32; ++v) {
    low = low.cwiseMin(mesh.vertices[v]);
    high = high.cwiseMax(mesh.vertices[v]);
  }
  EXPECT_EQ(low.x(), 1 + 0x1p-14 + 0x1p-29 + 0x1p-45);
  EXPECT_EQ(high - low, Eigen::Vector3d::Constant(0x1p-45));
}

TEST(HardBodies, PlatesOfAStackLieAsFarApartAsPromised) {
  const TriangleMesh mesh = degenerate::plate_stack(3, 0.125, 0x1p-7);
  ASSERT_EQ(mesh.vertices.size(), 18U);
  for (std::size_t v = 6; v < 18; v += 6) EXPECT_EQ(mesh.vertices[v].z() - mesh.vertices[v - 1].z(), 0x1p-7);
  EXPECT_EQ(mesh.vertices[3].z() - mesh.vertices[0].z(), 0.125);
  EXPECT_EQ(mesh.vertices[0].z(), -mesh.vertices[17].z());
  EXPECT_EQ(mesh.vertices[4].x(), 0.75) << "the first plate's upper side is the smaller one";
  EXPECT_EQ(mesh.vertices[10].x(), 1) << "the second one's is the larger one";
}

TEST(HardBodies, LinksOfAChainDoNotTouchAndPassThroughEachOther) {
  const TriangleMesh chain = degenerate::torus_chain(3, 4, 1, 4, 4);
  for (const Eigen::Vector3d& x : chain.vertices) EXPECT_EQ(x * 2, (x * 2).array().round().matrix()) << x.transpose();
  // The square rings are | |x| + |y| - 4 | + |z| <= 1, with y and z exchanged in every other one. The function grows by
  // at most 2 a metre, so a grid of 80 steps to an edge of at most 8 metres misses less than 0.2 of it.
  const auto function_of_link = [](int link, Eigen::Vector3d x) {
    x.x() -= 5.5 * link;
    if (link % 2 == 1) std::swap(x.y(), x.z());
    return std::abs(std::abs(x.x()) + std::abs(x.y()) - 4) + std::abs(x.z());
  };
  constexpr int kSteps = 80;
  for (std::size_t f = 0; f < chain.faces.size(); ++f) {
    const auto link = static_cast<int>(f / 32);
    const auto& [a, b, c] = chain.faces[f];
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j) {
        const Eigen::Vector3d x =
            (chain.vertices[a] * i + chain.vertices[b] * j + chain.vertices[c] * (kSteps - i - j)) / kSteps;
        EXPECT_NEAR(function_of_link(link, x), 1, 1e-12);
        for (int other = 0; other < 3; ++other) {
          if (other == link) continue;
          ASSERT_GT(function_of_link(other, x), 1.2) << link << ' ' << other << ' ' << x.transpose();
        }
      }
  }
  // The second link's axis is along y: the first one's tube passes its centre's plane within its hole.
  EXPECT_EQ(winding_number(chain, {4, 0, 0}), 1) << "the tube of the first link, in the hole of the second";
  EXPECT_EQ(winding_number(chain, {5.5, 0, 0}), 0) << "the centre of the second link";
}

TEST(LatticeTetrahedra, AreFitSmallIntegersAndExchangedEverySecondTime) {
  std::set<std::vector<double>> seen;
  int shared_corner = 0, shared_plane = 0;
  constexpr int kPairs = 96;
  for (std::uint64_t number = 0; number < kPairs; ++number) {
    const auto pair = degenerate::lattice_tetrahedra(number);
    const auto partner = degenerate::lattice_tetrahedra(number ^ 1);
    EXPECT_EQ(pair[0].vertices, partner[1].vertices) << number;
    EXPECT_EQ(pair[1].faces, partner[0].faces) << number;
    std::vector<double> all;
    for (const TriangleMesh& mesh : pair) {
      test::expect_closed(mesh, 4);
      EXPECT_NO_THROW(require_fit(mesh)) << number;
      for (const Eigen::Vector3d& x : mesh.vertices)
        for (int j = 0; j < 3; ++j) {
          EXPECT_TRUE(std::abs(x[j]) <= 2 && x[j] == std::round(x[j])) << number;
          all.push_back(x[j]);
        }
    }
    EXPECT_TRUE(seen.insert(all).second) << number;
    bool corner = false, plane = false;
    for (const Eigen::Vector3d& x : pair[0].vertices) {
      for (const Eigen::Vector3d& y : pair[1].vertices) corner = corner || x == y;
      for (const auto& [a, b, c] : pair[1].faces) {
        const Eigen::Vector3d& p = pair[1].vertices[a];
        plane = plane || (pair[1].vertices[b] - p).cross(pair[1].vertices[c] - p).dot(x - p) == 0;
      }
    }
    shared_corner += corner;
    shared_plane += plane;
  }
  EXPECT_GE(shared_corner, kPairs / 24);
  EXPECT_GE(shared_plane, kPairs / 2);
}

}  // namespace
}  // namespace pcm::hard_bodies_test
