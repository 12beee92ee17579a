// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "fast/surface/prepare_surface.h"
#include "fast/surface/thickness.h"
#include "tests/fast/exact_mesh.h"
#include "tests/spike.h"

/// How far the line of a face's barycentre stays in its own body, exactly, against rational numbers: in front of faces
/// that are tiny or needles beside their distance.
namespace pcm::fast {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where the line from the barycentre of `face` along its inward normal first passes through another one, m.
double exact_distance(const TriangleMesh& mesh, std::size_t face) {
  const mpq_class third(1, 3);
  return exact_first_met(mesh, static_cast<Index>(face), third, third);
}

/// No bound above the exact distance; true where a line meets another face and the bound tells something.
bool expect_no_greater(const TriangleMesh& mesh, std::size_t face, const std::string& what) {
  const double bound = thickness(prepare_surface(mesh), static_cast<Index>(face)), truth = exact_distance(mesh, face);
  EXPECT_LE(bound, truth * (1 + 1e-14)) << what << ", face " << face;
  return truth < kInfinity && bound > truth / 8;
}

TEST(BarycentreThickness, SeesTheTinyTipOfASpike) {
  const TriangleMesh mesh = spike();
  int met = 0;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) met += expect_no_greater(mesh, face, "spike") ? 1 : 0;
  EXPECT_GE(met, 1);
}

/// A frame about a face's inward normal, and two triangles: the master face about the origin, and another.
struct Scene {
  Eigen::Matrix3d frame;
  double turn;

  explicit Scene(Doubles& random)
      : frame(Eigen::Quaterniond(random.unit(), random.unit(), random.unit(), random.unit()).normalized()),
        turn(3 * random.unit()) {}

  Eigen::Vector3d down() const { return -frame.col(2); }
  Eigen::Vector3d across(double angle) const {
    return std::cos(turn + angle) * frame.col(0) + std::sin(turn + angle) * frame.col(1);
  }
  TriangleMesh with(double size, std::array<Eigen::Vector3d, 3> other) const {
    TriangleMesh mesh;
    for (const double angle : {0.0, 2.0943951, 4.1887902}) mesh.vertices.push_back(size * across(angle));
    if ((other[1] - other[0]).cross(other[2] - other[0]).dot(down()) < 0) std::swap(other[1], other[2]);
    mesh.vertices.insert(mesh.vertices.end(), other.begin(), other.end());
    mesh.faces = {{0, 1, 2}, {3, 4, 5}};
    return mesh;
  }
};

double log_uniform(Doubles& random, double least, double greatest) {
  return least * std::pow(greatest / least, (random.unit() + 1) / 2);
}

TEST(BarycentreThickness, SeesTinyFacesFarAway) {
  Doubles random(41);
  int met = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Scene scene(random);
    const double size = log_uniform(random, 2e-9, 1e-5), distance = 0.3 + std::abs(random.unit());
    const Eigen::Vector3d hit = distance * scene.down() + 0.2 * size * random.unit() * scene.across(1.5);
    const Eigen::Vector3d edge = size * (scene.across(0) + random.unit() * scene.down());
    const Eigen::Vector3d aside = size * scene.across(1.57);
    const std::array<Eigen::Vector3d, 3> tiny{hit - 0.5 * edge - 0.4 * aside, hit + 0.5 * edge - 0.4 * aside,
                                              hit + 0.6 * aside};
    const TriangleMesh mesh = scene.with(log_uniform(random, 1e-4, 1), tiny);
    met += expect_no_greater(mesh, 0, "trial " + std::to_string(trial)) ? 1 : 0;
  }
  std::printf("  %d lines meet the tiny face\n", met);
  EXPECT_GE(met, 2000);
}

TEST(BarycentreThickness, SeesNeedlesNearlyAlongTheLine) {
  Doubles random(42);
  int met = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Scene scene(random);
    const double width = log_uniform(random, 1e-9, 8e-9), distance = 1.5 + 0.5 * random.unit();
    const double steepness = 210 + 44 * random.unit();
    const Eigen::Vector3d axis = (scene.down() + scene.across(0) / steepness).normalized();
    const double half = 0.8 * distance;
    const Eigen::Vector3d hit = distance * scene.down(), aside = width * scene.across(1.57);
    // Both sides from the first corner are long: their cross product has lost most of its digits.
    const std::array<Eigen::Vector3d, 3> needle{hit + half * axis, hit - half * axis - aside,
                                                hit - half * axis + aside};
    const TriangleMesh mesh = scene.with(log_uniform(random, 1e-3, 1), needle);
    met += expect_no_greater(mesh, 0, "trial " + std::to_string(trial)) ? 1 : 0;
  }
  std::printf("  %d lines meet the needle\n", met);
  EXPECT_GE(met, 5000);
}

/// The direction of a needle's line is known to a few units in the last place over its height alone.
TEST(BarycentreThickness, OfANeedleWhoseNormalIsNotKnownIsNothingHoweverFlatTheBody) {
  const auto over_a_sheet = [](double width) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, width, 0}};
    for (const Eigen::Vector2d& x : {Eigen::Vector2d(-2, -2), {0, 2}, {2, -2}}) {
      mesh.vertices.emplace_back(x.x(), x.y(), -0x1p-16);
    }
    mesh.faces = {{0, 1, 2}, {3, 4, 5}};
    return thickness(prepare_surface(mesh), 0);
  };
  EXPECT_EQ(over_a_sheet(0x1p-26), 0);
  EXPECT_GT(over_a_sheet(0.5), 0x1p-17);
}

}  // namespace
}  // namespace pcm::fast
