// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "pcm/bad_input.h"
#include "tests/meshes/generate/generator_expectations.h"

namespace pcm {
namespace {

using std::numbers::pi;

constexpr Index kMaxBadCount = 1 << 30;

/// The error against the closed form falls by about four when the edge length is halved.
void expect_second_order(const std::function<double(Index)>& volume_at, double closed_form) {
  const double coarse = closed_form - volume_at(24);
  const double fine = closed_form - volume_at(48);
  EXPECT_GT(fine, 0) << "an inscribed convex body is smaller than the smooth one";
  EXPECT_NEAR(coarse / fine, 4, 0.1);
}

TEST(GenerateBoxes, AreClosedWithTheFacesPromised) {
  test::expect_closed(generate::box({1, 2, 3}), 12);
  test::expect_closed(generate::box({0, 0, 0}, {2, 2, 2}), 12);
  test::expect_closed(generate::gridded_box(1, 1), 12);
  test::expect_closed(generate::gridded_box(1, 7), 12 * 49);
  test::expect_closed(generate::gridded_box({-1, 0, 5}, {1, 3, 9}, {2, 3, 4}), 4 * (6 + 12 + 8));
  test::expect_closed(generate::plate(2, 1, 0.01, 8, 4), 4 * (32 + 8 + 4));
  test::expect_closed(generate::wedge(30, 1, 2), 8);
  test::expect_closed(generate::wedge(15, 0.1, 2, 5), 8 * 25);
}

TEST(GenerateBoxes, HaveTheVolumesOfTheBodies) {
  EXPECT_EQ(test::signed_volume(generate::box({1, 2, 3})), 6);
  EXPECT_EQ(test::signed_volume(generate::gridded_box({0, 0, 0}, {2, 2, 2}, {4, 2, 8})), 8);
  EXPECT_NEAR(test::signed_volume(generate::plate(2, 1, 0.01, 8, 4)), 0.02, 1e-15);
  // A right triangle of height h over its hypotenuse has the area h^2 (tan p + 1 / tan p) / 2.
  const double p = pi / 6;
  EXPECT_NEAR(test::signed_volume(generate::wedge(30, 1.5, 2, 4)), 1.5 * 1.5 * (std::tan(p) + 1 / std::tan(p)), 1e-13);
}

TEST(GenerateBoxes, CornersAreExact) {
  const Eigen::Vector3d low(0.1, 0.2, 0.3), high(0.7, 1.1, 1.3);
  const TriangleMesh mesh = generate::gridded_box(low, high, {3, 7, 11});
  Eigen::Vector3d least = mesh.vertices[0], greatest = mesh.vertices[0];
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    least = least.cwiseMin(vertex);
    greatest = greatest.cwiseMax(vertex);
  }
  EXPECT_EQ(least, low);
  EXPECT_EQ(greatest, high);
}

TEST(GenerateBoxes, WedgeFacesArePerpendicularAndOneIsTilted) {
  const TriangleMesh mesh = generate::wedge(20, 1, 1);
  // Outward normals of the two lower faces: (-sin p, 0, -cos p) for the tilted one, (cos p, 0, -sin p) for the other.
  const Eigen::Vector3d tilted(-std::sin(pi / 9), 0, -std::cos(pi / 9)), other(std::cos(pi / 9), 0, -std::sin(pi / 9));
  int tilted_faces = 0, other_faces = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const Eigen::Vector3d n =
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).normalized();
    tilted_faces += (n - tilted).norm() < 1e-14;
    other_faces += (n - other).norm() < 1e-14;
  }
  EXPECT_EQ(tilted_faces, 2);
  EXPECT_EQ(other_faces, 2);
}

TEST(GenerateBoxes, RectangleIsOpenWithItsNormalUp) {
  const TriangleMesh mesh = generate::rectangle(2, 1, 4, 3);
  test::expect_open(mesh, 24, 14);
  EXPECT_NEAR(test::area(mesh), 2, 1e-15);
  for (const auto& [a, b, c] : mesh.faces) {
    EXPECT_GT((mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).z(), 0);
  }
}

TEST(GenerateRound, AreClosedWithTheFacesPromised) {
  test::expect_closed(generate::icosphere(1, 0), 20);
  test::expect_closed(generate::icosphere(0.3, 3), 1280);
  test::expect_closed(generate::uv_sphere(1, 3, 2), 6);
  test::expect_closed(generate::uv_sphere(2, 16, 9), 2 * 16 * 8);
  test::expect_closed(generate::cylinder(1, 2, 12), 2 * 12 * 2);
  test::expect_closed(generate::cylinder(1, 2, 12, 5, 3), 2 * 12 * 10);
  test::expect_closed(generate::cone(1, 2, 12), 2 * 12);
  test::expect_closed(generate::cone(1, 2, 12, 4, 3), 2 * 12 * 6);
  test::expect_closed(generate::torus(1, 0.25, 16, 8), 2 * 16 * 8, 0);
  test::expect_closed(generate::tube(1, 2, 3, 12), 4 * 12 * 2, 0);
  test::expect_closed(generate::tube(1, 2, 3, 12, 5), 4 * 12 * 6, 0);
}

TEST(GenerateRound, SphereVerticesLieOnTheSphere) {
  for (const TriangleMesh& mesh : {generate::icosphere(3, 4), generate::uv_sphere(3, 20, 10)}) {
    for (const Eigen::Vector3d& vertex : mesh.vertices) EXPECT_NEAR(vertex.norm(), 3, 2e-15);
  }
}

TEST(GenerateRound, VolumesConvergeAtSecondOrder) {
  expect_second_order([](Index n) { return test::signed_volume(generate::uv_sphere(0.5, n, n / 2)); }, pi / 6);
  expect_second_order([](Index n) { return test::signed_volume(generate::icosphere(1, n / 24 + 2)); }, 4 * pi / 3);
  expect_second_order([](Index n) { return test::signed_volume(generate::cylinder(0.5, 2, n, 3, 2)); }, pi / 2);
  expect_second_order([](Index n) { return test::signed_volume(generate::cone(0.5, 3, n, 3, 2)); }, pi / 4);
  expect_second_order([](Index n) { return test::signed_volume(generate::torus(2, 0.5, 2 * n, n)); }, pi * pi);
  expect_second_order([](Index n) { return test::signed_volume(generate::tube(1, 2, 0.5, n)); }, 1.5 * pi);
}

TEST(GenerateBubbles, BubbleHasNineHundredFiftyFacesAndAConcaveWaist) {
  const TriangleMesh mesh = generate::bubble();
  test::expect_closed(mesh, 950);
  EXPECT_EQ(mesh.vertices.front().z(), -0.2);
  EXPECT_EQ(mesh.vertices.back().z(), 0.2);
  const auto ring_radius = [&](Index ring) { return mesh.vertices[1 + 25 * ring].x(); };
  EXPECT_EQ(mesh.vertices[1 + 25 * 9].z(), 0);
  for (Index ring = 6; ring < 9; ++ring) {
    EXPECT_GT(ring_radius(ring), ring_radius(ring + 1));
    EXPECT_EQ(ring_radius(ring), ring_radius(18 - ring)) << "mirror image in the plane of the waist";
  }
}

TEST(GenerateBubbles, FinerBubblesKeepTheVerticesOfTheCoarseOne) {
  const TriangleMesh coarse = generate::bubble(), fine = generate::bubble(0.40, 2);
  test::expect_closed(fine, 3900);
  for (Index ring = 1; ring < 20; ++ring)
    for (Index k = 0; k < 25; ++k)
      EXPECT_EQ(coarse.vertices[1 + 25 * (ring - 1) + k], fine.vertices[1 + 50 * (2 * ring - 1) + 2 * k]);
}

TEST(GenerateBubbles, PyramidIsAnOpenContainerOfFourTrianglesFacingUp) {
  const TriangleMesh mesh = generate::pyramid();
  test::expect_open(mesh, 4, 4);
  for (const auto& [a, b, c] : mesh.faces) {
    EXPECT_EQ(a, 0) << "the apex is shared";
    EXPECT_GT((mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).z(), 0);
  }
}

TEST(Generate, RefusesBadParametersByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinity, -infinity, 1e-300, 1e300}) {
    test::expect_refused([&] { generate::box({1, bad, 1}); }, "extent_y");
    test::expect_refused([&] { generate::box({0, 0, 0}, {1, 1, bad}); }, "z");
    test::expect_refused([&] { generate::gridded_box(bad, 1); }, "edge_length");
    test::expect_refused([&] { generate::plate(1, 1, bad); }, "thickness");
    test::expect_refused([&] { generate::rectangle(1, bad); }, "extent_y");
    test::expect_refused([&] { generate::wedge(30, bad, 1); }, "height");
    test::expect_refused([&] { generate::icosphere(bad, 1); }, "radius");
    test::expect_refused([&] { generate::uv_sphere(bad, 8, 4); }, "radius");
    test::expect_refused([&] { generate::cylinder(1, bad, 8); }, "length");
    test::expect_refused([&] { generate::cone(1, bad, 8); }, "height");
    test::expect_refused([&] { generate::torus(1, bad, 8, 8); }, "tube_radius");
    test::expect_refused([&] { generate::bubble(bad); }, "length");
    test::expect_refused([&] { generate::pyramid(1, bad); }, "depth");
  }
  for (const Index bad : {-1, 0, kMaxBadCount}) {
    test::expect_refused([&] { generate::gridded_box(1, bad); }, "subdivisions");
    test::expect_refused([&] { generate::plate(1, 1, 0.1, 1, bad); }, "subdivisions_y");
    test::expect_refused([&] { generate::rectangle(1, 1, bad); }, "subdivisions_x");
    test::expect_refused([&] { generate::bubble(1, bad); }, "finer");
    test::expect_refused([&] { generate::wedge(30, 1, 1, bad); }, "subdivisions");
    test::expect_refused([&] { generate::uv_sphere(1, bad, 4); }, "segments");
    test::expect_refused([&] { generate::uv_sphere(1, 4, bad); }, "bands");
    test::expect_refused([&] { generate::cylinder(1, 1, 8, bad); }, "bands");
    test::expect_refused([&] { generate::cylinder(1, 1, 8, 1, bad); }, "cap_rings");
    test::expect_refused([&] { generate::cone(1, 1, bad); }, "segments");
    test::expect_refused([&] { generate::torus(1, 0.5, 8, bad); }, "tube_segments");
  }
  test::expect_refused([] { generate::icosphere(1, -1); }, "level");
  test::expect_refused([] { generate::icosphere(1, 11); }, "level");
  test::expect_refused([] { generate::wedge(90, 1, 1); }, "tilt_degrees");
  test::expect_refused([] { generate::torus(1, 1, 8, 8); }, "tube_radius");
  test::expect_refused([] { generate::tube(1, 1, 1, 8); }, "inner_radius");
  test::expect_refused([] { generate::box({1, 1, 1}, {1, 2, 2}); }, "extent_x");
}

TEST(Generate, RefusesDimensionsThatVanishInRounding) {
  EXPECT_THROW(generate::torus(1e20, 1, 8, 8), BadInput);
  EXPECT_THROW(generate::gridded_box({1e16, 0, 0}, {1e16 + 4, 1, 1}, {16, 1, 1}), BadInput);
}

}  // namespace
}  // namespace pcm
