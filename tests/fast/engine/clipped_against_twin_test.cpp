// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's clipped scheme against the brute-force twin's on small meshes: force, torque and the elements' total
// area within a bound derived from the pose.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/hard_bodies.h"
#include "pcm/engine.h"
#include "tests/fast/engine_support.h"
#include "tests/reference/brute_force/twin_comparison.h"

namespace pcm::brute_force {
namespace {

/// Surfaces of more faces are left out: the twin's work grows as the cube of their number.
constexpr std::size_t kMostFaces = 48;

/// Greatest coordinate of both surfaces, m.
double greatest_coordinate(const Scene& scene) {
  double size = 0;
  for (const Body* body : {&scene.E, &scene.F})
    for (const Vector& x : body->vertices)
      for (const Rational& c : x) size = std::max(size, std::abs(rounded(Rational(c * scene.unit))));
  return size;
}

std::array<double, 2> area_by_master(const auto& elements, const auto& area_of) {
  std::array<double, 2> sums{};
  for (const auto& element : elements) sums[element.master == Side::E ? 0 : 1] += area_of(element);
  return sums;
}

/// With S the greatest coordinate, the corners of an element are off by a few eps S over the sine of the angle of the
/// planes that meet there; so its area is off by that times its rim (<= a few S), its volume, which is the force over
/// the stiffness, by S times as much, its torque by S times more. Of these poses' angles and numbers of elements 64 eps
/// bounds the product. Poses moved by ulps out of a flush one are left out: there the force itself jumps.
Answer compare(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  if (std::max(E.faces.size(), F.faces.size()) > kMostFaces) return {};
  Answer twin = answer(E, F, pose, reference::Problem::rounded, Mode::both, Scheme::clipped);
  ContactLaw law;
  law.stiffness = 1;
  fast::Workspace workspace;
  const fast::Pairing pairing(fast::Surface(E), fast::Surface(F), law, Mode::both, Scheme::clipped);
  const fast::Contact& contact = fast::evaluate(pairing, pose, {}, {}, workspace);
  EXPECT_EQ(contact.too_deep, twin.too_deep);
  const double size = greatest_coordinate(twin.scene);
  const double area_bound = 64 * std::numeric_limits<double>::epsilon() * size * size;
  const auto expected = area_by_master(twin.elements, [&](const Element& x) { return element_area(twin.scene, x); });
  const auto found = area_by_master(contact.elements, [](const fast::Element& x) { return x.area; });
  for (std::size_t side = 0; side < 2; ++side) EXPECT_NEAR(found[side], expected[side], area_bound);
  const ForceAndTorque load = elastic_force(twin, 1, Mode::both);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(contact.force_Me[static_cast<Index>(i)], load.force[i], area_bound * size);
    EXPECT_NEAR(contact.torque_Me[static_cast<Index>(i)], load.torque[i], area_bound * size * size);
  }
  return twin;
}

TEST(ClippedAgainstTwin, AgreesOnTheDegenerateCatalogue) {
  compare_on_catalogue(compare);
}

/// Rounding turns F's top a little against the keel, so that one half of it lies beneath, by some hundredths of an ulp,
/// and hides a strip as wide as that over the rise. In F's own frame nothing lies beneath the top but the block's other
/// side.
TEST(ClippedAgainstTwin, AgreesWhereRoundingTiltsTheMasterAgainstAKeelThatTouchesIt) {
  for (const double rise : {0x1p-30, 0x1p-40, 0x1p-48}) {
    const TriangleMesh F = degenerate::block_with_touching_keel(rise);
    for (const double angle : {0.15, 0.2, 0.35, 0.4}) {
      const Pose pose = fast::test::turned(angle, {0, 0, 0});
      TriangleMesh E = generate::box({-4, -4, -0.25}, {4, 4, 3});
      for (Eigen::Vector3d& x : E.vertices) x = pose.A * x;
      const Answer twin = compare(E, F, pose);
      const auto area = area_by_master(twin.elements, [&](const Element& x) { return element_area(twin.scene, x); });
      EXPECT_LT(area[1], 16 - 1e-11);
    }
  }
}

class ClippedAgainstTwinPoses : public testing::TestWithParam<Series> {};

TEST_P(ClippedAgainstTwinPoses, Agree) {
  compare_on_trials(GetParam(), 80, compare);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ClippedAgainstTwinPoses,
                         testing::Values(Series{Kind::generic, 100}, Series{Kind::lattice, 300},
                                         Series{Kind::grids, 60}, Series{Kind::open, 200}, Series{Kind::folded, 40}),
                         series_name);

}  // namespace
}  // namespace pcm::brute_force
