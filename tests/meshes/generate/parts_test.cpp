// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/generate/parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "tests/meshes/generate/generator_expectations.h"

namespace pcm {
namespace {

using std::numbers::pi;

TEST(GenerateParts, AreClosedWithTheFacesPromised) {
  test::expect_closed(generate::socket(1, 0.5, 24, 6), 2 * 24 * 8);
  test::expect_closed(generate::socket(1, 0.5, 3, 1), 2 * 3 * 3);
  test::expect_closed(generate::bumpy_sphere(), 20000);
  test::expect_closed(generate::bumpy_sphere(2, 0.2, 3, 20, 11), 400);
  test::expect_closed(generate::knotted_tube(1, 0.2, 96, 10), 2 * 96 * 10, 0);
  test::expect_closed(generate::spur_gear(17, 0.01, 0.02), 2 * 17 * 10 * 2);
  test::expect_closed(generate::spur_gear(6, 1, 2, 2, 3), 2 * 6 * 6 * 4);
  test::expect_closed(generate::spur_gear(200, 1, 2, 6, 1), 2 * 200 * 14 * 2);
}

TEST(GenerateParts, SocketVolumeConvergesAtSecondOrderToBlockWithoutHemisphere) {
  const double closed_form = pi * 1.5 * 1.5 * 1.5 - 2 * pi / 3;
  const auto error = [&](Index n) { return test::signed_volume(generate::socket(1, 0.5, n, n / 4)) - closed_form; };
  EXPECT_NEAR(error(48) / error(96), 4, 0.1);
}

TEST(GenerateParts, SocketHollowFacesItsCentre) {
  const TriangleMesh mesh = generate::socket(1, 0.25, 24, 6);
  int hollow_faces = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const Eigen::Vector3d p = mesh.vertices[a], q = mesh.vertices[b], s = mesh.vertices[c];
    if (std::max({p.norm(), q.norm(), s.norm()}) > 1 + 1e-15) continue;
    ++hollow_faces;
    EXPECT_LT((q - p).cross(s - p).dot(p), 0) << "out of the block is towards the hollow's centre";
  }
  EXPECT_EQ(hollow_faces, 24 + 2 * 24 * 5);
}

TEST(GenerateParts, BumpySphereIsNotConvex) {
  const TriangleMesh mesh = generate::bumpy_sphere();
  double least = 2, greatest = 0;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    least = std::min(least, vertex.norm());
    greatest = std::max(greatest, vertex.norm());
  }
  EXPECT_NEAR(least, 0.9, 0.01);
  EXPECT_NEAR(greatest, 1.1, 0.01);
  // A convex body would lie behind the plane of each of its faces.
  bool convex = true;
  for (std::size_t f = 0; f < mesh.faces.size(); f += 101) {
    const auto& [a, b, c] = mesh.faces[f];
    const Eigen::Vector3d p = mesh.vertices[a];
    const Eigen::Vector3d normal = (mesh.vertices[b] - p).cross(mesh.vertices[c] - p).normalized();
    for (const Eigen::Vector3d& vertex : mesh.vertices) convex = convex && normal.dot(vertex - p) < 1e-3;
  }
  EXPECT_FALSE(convex);
}

/// By the second theorem of Pappus the tube's volume is its cross-section times the length of its centre line, as long
/// as it does not overlap itself.
TEST(GenerateParts, KnottedTubeVolumeConvergesToLengthTimesCrossSection) {
  double length = 0;
  const int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double t = 2 * pi * i / steps;
    length += std::hypot(3.0, 2 * (2 + std::cos(3 * t))) * (2 * pi / steps) / 2;  // half: the ring radius is 1, not 2
  }
  const double closed_form = pi * 0.3 * 0.3 * length;
  const double coarse = closed_form - test::signed_volume(generate::knotted_tube(1, 0.3, 200, 20));
  const double fine = closed_form - test::signed_volume(generate::knotted_tube(1, 0.3, 400, 40));
  EXPECT_GT(fine, 0);
  EXPECT_NEAR(coarse / fine, 4, 0.1);
}

TEST(GenerateParts, ThickestKnottedTubeKeepsAwayFromItself) {
  // Centre lines of the knot nearer than twice 0.4 ring radii belong to neighbouring points of it: a tube of that
  // radius does not touch itself.
  const int n = 600;
  const auto knot = [&](int i) -> Eigen::Vector3d {
    const double t = 2 * pi * i / n;
    return Eigen::Vector3d((2 + std::cos(3 * t)) * std::cos(2 * t), (2 + std::cos(3 * t)) * std::sin(2 * t),
                           std::sin(3 * t)) /
           2;
  };
  for (int i = 0; i < n; ++i) {
    for (int step = n / 10; step <= n / 2; ++step) EXPECT_GT((knot(i) - knot((i + step) % n)).norm(), 0.8);
  }
}

TEST(GenerateParts, SpurGearTeethFillHalfThePitchCircle) {
  const TriangleMesh mesh = generate::spur_gear(24, 2, 10, 40, 1);
  const Index ring = static_cast<Index>(mesh.vertices.size() - 2) / 2;
  double tip = 0, root = 100, half_thickness = 0;
  for (Index k = 0; k + 1 < ring; ++k) {
    const Eigen::Vector3d p = mesh.vertices[1 + k], q = mesh.vertices[2 + k];
    tip = std::max(tip, p.norm());
    root = std::min(root, std::hypot(p.x(), p.y()));
    const double p_radius = std::hypot(p.x(), p.y()), q_radius = std::hypot(q.x(), q.y());
    if (k < ring / 24 && p_radius >= 24 && q_radius < 24) {  // the descending flank of the first tooth
      const double t = (p_radius - 24) / (p_radius - q_radius);
      half_thickness = std::atan2(p.y() + t * (q.y() - p.y()), p.x() + t * (q.x() - p.x()));
    }
  }
  EXPECT_NEAR(std::sqrt(tip * tip - 25), 26, 1e-12);
  EXPECT_NEAR(root, 24 - 2.5, 1e-12);
  EXPECT_NEAR(half_thickness, pi / 48, 1e-5);
}

TEST(GenerateParts, RefuseBadParametersByName) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    test::expect_refused([&] { generate::socket(bad, 1, 8, 4); }, "radius");
    test::expect_refused([&] { generate::socket(1, bad, 8, 4); }, "wall");
    test::expect_refused([&] { generate::bumpy_sphere(bad); }, "radius");
    test::expect_refused([&] { generate::bumpy_sphere(1, bad); }, "amplitude");
    test::expect_refused([&] { generate::knotted_tube(1, bad, 96, 8); }, "tube_radius");
    test::expect_refused([&] { generate::spur_gear(20, bad, 1); }, "module");
    test::expect_refused([&] { generate::spur_gear(20, 1, bad); }, "width");
  }
  test::expect_refused([] { generate::socket(1, 1, 2, 4); }, "segments");
  test::expect_refused([] { generate::socket(1, 1, 8, 0); }, "bands");
  test::expect_refused([] { generate::bumpy_sphere(1, 0.1, 0); }, "bumps");
  test::expect_refused([] { generate::knotted_tube(1, 0.41, 96, 8); }, "tube_radius");
  test::expect_refused([] { generate::knotted_tube(1, 0.2, 47, 8); }, "segments");
  test::expect_refused([] { generate::spur_gear(5, 1, 1); }, "teeth");
  test::expect_refused([] { generate::spur_gear(20, 1, 1, 1); }, "flank_points");
}

}  // namespace
}  // namespace pcm
