// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/surface/exit_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "fast/surface/prepare_surface.h"
#include "fast/surface/thickness.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"
#include "tests/fast/exact_mesh.h"

/// By which depth the lines of a face have met another face of their own body, exactly, against rational numbers.
namespace pcm::fast::exit_depth_test {
namespace {

using degenerate::inverted;
using degenerate::joined;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Count {
  int faces = 0, known = 0, tight = 0;

  void print() const { std::printf("  of %d faces %d are known, %d nearly exactly\n", faces, known, tight); }
};

/// The deepest exit of a face's lines that was found, for lines drawn all over it.
double deepest_found(const TriangleMesh& mesh, Index face, Doubles& random) {
  constexpr long kParts = 10007;  // A prime: no line passes through an edge between small integers.
  double deepest = 0;
  for (int i = 0; i < 12; ++i) {
    mpq_class s(static_cast<long>(random.integer(1, kParts - 1)), kParts),
        t(static_cast<long>(random.integer(1, kParts - 1)), kParts);
    if (s + t >= 1) {
      s = 1 - s;
      t = 1 - t;
    }
    // Near the border every third time.
    if (i % 3 == 0) t /= 100000;
    if (s + t < 1) deepest = std::max(deepest, exact_first_met(mesh, face, s, t));
  }
  return deepest;
}

/// No line of `moved`, the same body with its vertices moved by up to `vertex_error`, m, goes deeper than what is known
/// of `mesh`.
void expect_no_deeper(const TriangleMesh& mesh, const TriangleMesh& moved, double vertex_error, Doubles& random,
                      Count& count) {
  const PreparedSurface surface = prepare_surface(mesh);
  for (Index face = 0; face < static_cast<Index>(mesh.faces.size()); ++face) {
    const double bound = exit_depth(surface, face);
    ++count.faces;
    const Triangle& t = mesh.faces[static_cast<std::size_t>(face)];
    const auto vertex = [&](std::size_t k) { return moved.vertices[static_cast<std::size_t>(t[k])]; };
    if (bound == kInfinity || !thickness_holds(surface, vertex_error, FaceGeometry({vertex(0), vertex(1), vertex(2)})))
      continue;
    ++count.known;
    const double found = deepest_found(moved, face, random);
    EXPECT_LE(found, bound) << mesh.name << ", face " << face;
    count.tight += found > 0.9 * bound ? 1 : 0;
  }
}

TriangleMesh turned(TriangleMesh mesh) {
  const Eigen::Vector3d by(0.3, -2, 1);
  const Eigen::Matrix3d Q = Eigen::AngleAxisd(0.7, by.normalized()).toRotationMatrix();
  for (Eigen::Vector3d& x : mesh.vertices) x = Q * x + by;
  return mesh;
}

/// A box of 2 x 2 x 2 m with a hole in its middle, and one with two boxes that pass through each other's faces.
std::vector<TriangleMesh> bodies() {
  const Eigen::Vector3d one(1, 1, 1);
  std::vector<TriangleMesh> meshes{generate::box({1, 2, 0.1}),
                                   generate::gridded_box({1, 0.7, 0.3}, {2, 3, 2}),
                                   generate::wedge(17, 1, 0.3),
                                   generate::icosphere(1, 1),
                                   generate::cylinder(0.3, 1, 7),
                                   generate::cone(0.3, 1, 6),
                                   generate::tube(0.2, 0.3, 1, 6),
                                   generate::torus(1, 0.3, 6, 5),
                                   generate::socket(1, 0.5, 6, 3),
                                   joined(generate::box(-one, one), inverted(generate::box(-0.25 * one, 0.25 * one))),
                                   joined(generate::box(-one, one), generate::box({0.1, -0.3, -0.2}, {1.7, 0.4, 0.3}))};
  const std::size_t as_made = meshes.size();
  for (std::size_t i = 0; i < as_made; ++i) meshes.push_back(turned(meshes[i]));
  return meshes;
}

TEST(ExitDepth, NoLineOfABodyGoesDeeper) {
  Doubles random(41);
  Count count;
  for (const TriangleMesh& mesh : bodies()) expect_no_deeper(mesh, mesh, 0, random, count);
  count.print();
  EXPECT_GE(count.known, count.faces / 2);
  EXPECT_GE(count.tight, count.known / 4);
}

TEST(ExitDepth, NoLineOfABodyThatPassesThroughItselfGoesDeeper) {
  // Where a sheet rises through the face it lies beneath, some of its lines may meet nothing.
  Doubles random(43);
  Count count;
  for (int trial = 0; trial < 300; ++trial) {
    TriangleMesh mesh = trial % 2 == 0 ? generate::box({4, 4, 4}) : generate::icosphere(4, 0);
    mesh.name += ' ' + std::to_string(trial);
    const auto move = [&] { return trial % 4 < 2 ? random.small_integer(3) : 3 * random.unit(); };
    for (Eigen::Vector3d& x : mesh.vertices) {
      if (random.integer(0, 2) == 0) x += Doubles::point(move);
    }
    if (no_face_has_area_0(mesh)) expect_no_deeper(mesh, mesh, 0, random, count);
  }
  count.print();
  EXPECT_GE(count.known, count.faces / 4);
}

TEST(ExitDepth, HoldsForVerticesMovedLessThanItsTolerance) {
  Doubles random(42);
  Count count;
  for (const TriangleMesh& mesh : bodies()) {
    TriangleMesh moved = mesh;
    const double most = 0x1p-10 * kThicknessTolerance * prepare_surface(mesh).max_coordinates.maxCoeff();
    for (Eigen::Vector3d& x : moved.vertices) x += most * Doubles::point([&random] { return random.unit(); });
    expect_no_deeper(mesh, moved, 2 * most, random, count);
  }
  EXPECT_GE(count.known, count.faces / 2);
}

TEST(ExitDepth, OfABoxIsItsWidth) {
  const Eigen::Vector3d width(1, 2, 3);
  const TriangleMesh box = generate::box(width);
  const PreparedSurface surface = prepare_surface(box);
  for (Index face = 0; face < static_cast<Index>(box.faces.size()); ++face) {
    const Triangle& t = surface.face(face);
    const Eigen::Vector3d N =
        (surface.vertex(t[1]) - surface.vertex(t[0])).cross(surface.vertex(t[2]) - surface.vertex(t[0]));
    EXPECT_NEAR(exit_depth(surface, face), N.normalized().cwiseAbs().dot(width), 1e-7);
  }
}

TEST(ExitDepth, IsOpenWhereTheSurfaceIs) {
  TriangleMesh box = generate::box({1, 1, 1});
  box.faces.pop_back();
  const PreparedSurface surface = prepare_surface(box);
  for (Index face = 0; face < static_cast<Index>(box.faces.size()); ++face)
    EXPECT_EQ(exit_depth(surface, face), kInfinity);
}

TEST(ExitDepth, ASheetThatEndsBeneathTheFaceIsNotAllThatIsThere) {
  // What is nearest beneath a face of the outer box is a hole, or a box that stands in it from below.
  const Eigen::Vector3d one(1, 1, 1);
  const TriangleMesh outer = generate::box(-one, one);
  for (const TriangleMesh& inner :
       {inverted(generate::box({-0.9, -0.9, 0}, {0.9, 0.9, 0.5})), generate::box({-0.9, -0.9, -2}, {0.9, 0.9, 0})}) {
    const TriangleMesh mesh = joined(outer, inner);
    const PreparedSurface surface = prepare_surface(mesh);
    int looking_down = 0;
    for (Index face = 0; face < static_cast<Index>(outer.faces.size()); ++face) {
      const Triangle& t = surface.face(face);
      if (surface.vertex(t[0])[2] < 1 || surface.vertex(t[1])[2] < 1 || surface.vertex(t[2])[2] < 1) continue;
      ++looking_down;
      EXPECT_GE(exit_depth(surface, face), 2);
    }
    EXPECT_EQ(looking_down, 2);
  }
}

/// A step seen from its upper side, in z = 0 and parted at x = 1: of depth 1 m up to x = 1 + ledge, of 3 m from there
/// on.
TriangleMesh step(double ledge) {
  const double x = 1 + ledge;
  TriangleMesh mesh;
  for (const double y : {0.0, 1.0})
    mesh.vertices.insert(mesh.vertices.end(),
                         {{0, y, 0}, {0, y, -1}, {x, y, -1}, {x, y, -3}, {3, y, -3}, {3, y, 0}, {1, y, 0}});
  for (const Triangle& t : {Triangle{0, 1, 2}, {0, 2, 6}, {4, 5, 6}, {4, 6, 2}, {4, 2, 3}}) {
    mesh.faces.push_back(t);
    mesh.faces.push_back({t[2] + 7, t[1] + 7, t[0] + 7});
  }
  for (Index k = 0; k < 7; ++k) {
    const Index next = (k + 1) % 7;
    mesh.faces.push_back({next, k, k + 7});
    mesh.faces.push_back({next, k + 7, next + 7});
  }
  return mesh;
}

/// The least and the greatest exit depth of the faces in z = 0 whose corners are no farther than x = 1.
std::pair<double, double> exits_of_upper_side(const TriangleMesh& mesh, int expected_faces) {
  const PreparedSurface surface = prepare_surface(mesh);
  EXPECT_TRUE(surface.closed);
  double least = kInfinity, greatest = 0;
  int count = 0;
  for (Index face = 0; face < static_cast<Index>(mesh.faces.size()); ++face) {
    const auto in_upper_side = [&](Index v) { return surface.vertex(v).z() == 0 && surface.vertex(v).x() <= 1; };
    const Triangle& t = surface.face(face);
    if (!std::all_of(t.begin(), t.end(), in_upper_side)) continue;
    ++count;
    least = std::min(least, exit_depth(surface, face));
    greatest = std::max(greatest, exit_depth(surface, face));
  }
  EXPECT_EQ(count, expected_faces);
  return {least, greatest};
}

TEST(ExitDepth, WhatBeginsBesideTheFaceByLessThanTheToleranceLiesBeneathIt) {
  const double tolerance = 2 * kThicknessTolerance * 3;
  for (const double ledge : {0.0, 0x1p-52, 0x1p-46, 0.9 * tolerance}) {
    const auto [least, greatest] = exits_of_upper_side(step(ledge), 2);
    EXPECT_GE(least, 3) << ledge;
    EXPECT_NEAR(greatest, 3, 1e-7) << ledge;
  }
  EXPECT_NEAR(exits_of_upper_side(step(2 * tolerance), 2).second, 1, 1e-7);
}

/// A block of three sides, 4 m high, its upper side in z = 0.
TriangleMesh block() {
  TriangleMesh mesh;
  for (const double z : {0.0, -4.0}) mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, z}, {1, -1, z}, {1, 1, z}});
  mesh.faces = {{0, 1, 2}, {3, 5, 4}, {0, 3, 1}, {1, 3, 4}, {1, 4, 2}, {2, 4, 5}, {2, 5, 0}, {0, 5, 3}};
  return mesh;
}

TEST(ExitDepth, ACavityNoWiderThanTheToleranceBeneathTheCountedPointIsNotMetByAllLines) {
  // Sides whose ends are 2 to 2.1 tolerances from that point, added up, pass it nearer than their ends may be moved.
  const double tolerance = 2 * kThicknessTolerance * 4;
  const auto at = [&](double off_s, double off_t, double z) {
    const double s = 0.3125 - 0x1p-10 + off_s * std::sqrt(0.5) * tolerance, t = 0.25 + 0x1p-7 + off_t * 0.5 * tolerance;
    return Eigen::Vector3d(-1 + 2 * s + 2 * t, -1 + 2 * t, z);
  };
  for (const double size : {0.5, 0.97, 1.0, 1.03, 1.5, 3.0}) {
    const TriangleMesh speck = degenerate::tetrahedron(
        {at(0, 0, -0.5), at(0.6 * size, -0.45 * size, -1), at(-0.6 * size, -0.45 * size, -1), at(0, 0.97 * size, -1)});
    EXPECT_NEAR(exits_of_upper_side(joined(block(), inverted(speck)), 1).second, 4, 1e-7) << size;
  }
}

TEST(ExitDepth, ARoofThatMayRiseThroughTheFaceIsNotMetByAllLines) {
  // Passed through by a wide tent whose tip is so far beneath the block's upper side and whose floor is 3 m below it.
  const auto exit_below_tip = [](double tip) {
    const TriangleMesh tent = degenerate::tetrahedron({Eigen::Vector3d(0.25, -0.25, -tip), Eigen::Vector3d(-18, -9, -3),
                                                       Eigen::Vector3d(9, -9, -3), Eigen::Vector3d(9, 18, -3)});
    return exits_of_upper_side(joined(block(), tent), 1).second;
  };
  const double tolerance = 2 * kThicknessTolerance * 18;
  for (const double tip : {0.0, 0x1p-50, 0.9 * tolerance}) EXPECT_GE(exit_below_tip(tip), 3) << tip;
  EXPECT_LT(exit_below_tip(0.5), 2);
}

TEST(ExitDepth, IsNotKnownWhereAFacesAreaTimesTheToleranceUnderflows) {
  const auto exit_of_end = [](double width) {
    TriangleMesh rod = generate::box({width, width, 1});
    for (Eigen::Vector3d& x : rod.vertices) x *= 0x1p-299;
    const PreparedSurface surface = prepare_surface(rod);
    const auto is_end = [&](Index face) {
      const auto p = surface.points_of(face);
      return p[0].z() == p[1].z() && p[1].z() == p[2].z();
    };
    Index face = 0;
    while (!is_end(face)) ++face;
    return exit_depth(surface, face);
  };
  EXPECT_NEAR(0x1p299 * exit_of_end(0x1p-20), 1, 1e-7);
  for (const int exponent : {-46, -50, -70}) EXPECT_EQ(exit_of_end(std::ldexp(1.0, exponent)), kInfinity);
}

}  // namespace
}  // namespace pcm::fast::exit_depth_test
