// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Clipped forces of faces that lie flush but for some ulps: what hides what, and up to which line, is decided by
// heights of some ulps, whose digits roundings would leave none of (fast/prism/master_prism.h). Engine against the
// oracle's rounded problem.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "compare/poses/rounded_vertices.h"
#include "compare/random/random.h"
#include "fast/clipped/visible_parts.h"
#include "meshes/generate/boxes.h"
#include "pcm/bad_input.h"
#include "pcm/engine.h"
#include "reference/oracle.h"
#include "tests/compare/tetrahedron.h"

namespace pcm::compare::nearly_flush_test {
namespace {

struct Held {
  double error = 0;  ///< of force or torque, over the greatest coordinate to the third or fourth, at stiffness 1
  double force = 0;  ///< the oracle's, likewise
};

/// Where faces cross at an angle of some ulps, heights over their planes are some ulps too and hence exact; elsewhere
/// the angle is that of the bodies themselves. So every line that parts what is seen is where the rounded problem has
/// it but for roundings of its ends' places (fast/clipped/visible_parts.h), q of these faces being a few. What two
/// bodies of so few faces see of each other has rims of less than 2^7 S in all and lies no deeper than 2 S beneath
/// them.
constexpr double kGreatestError = fast::kPlaceRoundings * 0x1p-53 * 0x1p7 * 2;

Held hold(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose = {}) {
  ContactLaw law;
  law.stiffness = 1;
  Wanted force;
  force.polygons = force.areas = false;
  const double size = coordinate_scale(E, F, pose);
  const double unit = size * size * size;
  const reference::Oracle oracle(E, F, law, Mode::E, Scheme::clipped);
  reference::Inquiry inquiry(oracle, pose, {}, force);
  const fast::Surface surface_E(E), surface_F(F);
  fast::Workspace workspace;
  Held held;
  for (const Mode mode : {Mode::E, Mode::F}) {
    const fast::Pairing pairing(surface_E, surface_F, law, mode, Scheme::clipped);
    const fast::Contact& subj = fast::evaluate(pairing, pose, {}, force, workspace);
    const reference::Answer truth = inquiry.answer(reference::Problem::rounded, mode);
    held.error = std::max({held.error, (subj.force_Me - truth.force_Me).norm() / unit,
                           (subj.torque_Me - truth.torque_Me).norm() / (unit * size)});
    held.force = std::max(held.force, truth.force_Me.norm() / unit);
  }
  return held;
}

double ulp_of_one_to_eight(PoseRandom& random) {
  const double steps = 1 + static_cast<double>(random.below(8));
  return (random.coin() ? steps : -steps) * 0x1p-52;
}

/// Every coordinate moved by 1 to 8 ulps of 1, or left.
TriangleMesh moved_by_ulps(TriangleMesh mesh, PoseRandom& random) {
  for (Eigen::Vector3d& x : mesh.vertices)
    for (Eigen::Index k = 0; k < 3; ++k)
      if (random.coin()) x[k] += ulp_of_one_to_eight(random);
  return mesh;
}

/// On the lattice of eighths from -1 to 1.
Eigen::Vector3d lattice_point(PoseRandom& random) {
  const auto coordinate = [&random] { return (static_cast<double>(random.below(17)) - 8) / 8; };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

/// A tetrahedron with a face in the plane of one of the other's faces, on the same side of it.
Corners flush_with(const Corners& e, PoseRandom& random) {
  const auto quarter = [&random] { return (static_cast<double>(random.below(9)) - 2) / 4; };
  Corners f;
  for (std::size_t k = 0; k < 3; ++k) {
    const double s = quarter(), t = quarter();
    f[k] = e[0] + s * (e[1] - e[0]) + t * (e[2] - e[0]);
  }
  const double s = quarter(), t = quarter();
  f[3] = e[3] + s * (e[1] - e[0]) + t * (e[2] - e[0]);
  return f;
}

struct Bodies {
  TriangleMesh E, F;
};

/// Every fourth pair lies exactly flush.
TriangleMesh moved_by_ulps_or_not(const TriangleMesh& mesh, PoseRandom& random) {
  return random.below(4) == 0 ? mesh : moved_by_ulps(mesh, random);
}

Bodies draw_tetrahedra(PoseRandom& random) {
  Corners e;
  for (Eigen::Vector3d& corner : e) corner = lattice_point(random);
  return {tetrahedron(e), moved_by_ulps_or_not(tetrahedron(flush_with(e, random)), random)};
}

/// Boxes each side of which is in the plane of the other's or is not, turned by one rotation or not.
Bodies draw_boxes(PoseRandom& random) {
  const auto low = [&random] { return -static_cast<double>(1 + random.below(3)) / 4; };
  const auto high = [&random] { return static_cast<double>(1 + random.below(3)) / 4; };
  std::array<Eigen::Vector3d, 4> corners;
  for (Eigen::Index k = 0; k < 3; ++k) {
    corners[0][k] = low();
    corners[1][k] = high();
    corners[2][k] = random.coin() ? corners[0][k] : low();
    corners[3][k] = random.coin() ? corners[1][k] : high();
  }
  Bodies boxes{generate::box(corners[0], corners[1]), generate::box(corners[2], corners[3])};
  if (random.coin()) {
    const Eigen::Matrix3d A = random.rotation();
    for (TriangleMesh* mesh : {&boxes.E, &boxes.F})
      for (Eigen::Vector3d& x : mesh->vertices) x = ordered_product(A, x);
  }
  boxes.F = moved_by_ulps_or_not(boxes.F, random);
  return boxes;
}

/// The slave's second component overlaps the first and has its lower and upper side in the same planes.
Bodies draw_overlapping_components(PoseRandom& random) {
  Bodies boxes = draw_boxes(random);
  const auto eighth = [&random] { return static_cast<double>(2 * random.below(3) + 1) / 8; };
  const double x = eighth(), y = eighth();
  const Eigen::Vector3d along = (boxes.F.vertices[1] - boxes.F.vertices[0]).normalized();
  const Eigen::Vector3d across = (boxes.F.vertices[3] - boxes.F.vertices[0]).normalized();
  TriangleMesh second = boxes.F;
  for (Eigen::Vector3d& corner : second.vertices) corner += x * along + y * across;
  const auto first = static_cast<Index>(boxes.F.vertices.size());
  boxes.F.vertices.insert(boxes.F.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const Triangle& t : second.faces) boxes.F.faces.push_back({t[0] + first, t[1] + first, t[2] + first});
  return boxes;
}

/// Turned out of each other's planes about a drawn axis, by any angle.
Bodies draw_tilted_boxes(PoseRandom& random) {
  Bodies boxes = draw_boxes(random);
  const Eigen::Vector3d axis = random.direction();
  const double angle = random.log_uniform(0x1p-50, 0x1p-2);
  for (Eigen::Vector3d& x : boxes.F.vertices) x += angle * ordered_cross(axis, x);
  return boxes;
}

template <class Draw>
void expect_forces_as_the_oracle_has_them(const Draw& draw, std::uint64_t seed, int trials) {
  std::printf("  seed %llu\n", static_cast<unsigned long long>(seed));
  int held = 0, with_force = 0;
  double greatest = 0;
  for (int trial = 0; trial < trials; ++trial) {
    PoseRandom random(seed, 0, 0, static_cast<std::uint64_t>(trial));
    const Bodies bodies = draw(random);
    try {
      const Held answer = hold(bodies.E, bodies.F);
      EXPECT_LE(answer.error, kGreatestError) << "trial " << trial;
      greatest = std::max(greatest, answer.error);
      ++held;
      with_force += answer.force > 0x1p-20 ? 1 : 0;
    } catch (const BadInput&) {
      continue;  // A face without area.
    }
  }
  std::printf("  greatest error %.2g of %.2g\n", greatest, kGreatestError);
  EXPECT_GE(held, trials * 3 / 4);
  EXPECT_GE(with_force, trials / 2);
}

TEST(NearlyFlush, TetrahedraMovedByUlpsOutOfOnePlaneGetTheRoundedProblemsForce) {
  expect_forces_as_the_oracle_has_them(draw_tetrahedra, 15, 2000);
}

TEST(NearlyFlush, BoxesMovedByUlpsOutOfTheirPlanesGetTheRoundedProblemsForce) {
  expect_forces_as_the_oracle_has_them(draw_boxes, 16, 500);
}

TEST(NearlyFlush, FlushSidesOfOverlappingComponentsCountOnce) {
  expect_forces_as_the_oracle_has_them(draw_overlapping_components, 18, 60);
}

TEST(NearlyFlush, BoxesTiltedByAnyAngleOutOfTheirPlanesGetTheRoundedProblemsForce) {
  expect_forces_as_the_oracle_has_them(draw_tilted_boxes, 17, 500);
}

/// The pose, and those some ulps of 1 beside it.
void hold_with_neighbours(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int ulps = -2; ulps <= 2; ++ulps) {
      Pose beside = pose;
      beside.r[axis] += ulps * 0x1p-52;
      EXPECT_LE(hold(E, F, beside).error, kGreatestError) << "axis " << axis << ", " << ulps << " ulps";
    }
  }
}

TEST(NearlyFlush, MasterIsCutWhereATetrahedronsFacePassesItsPlaneAtAnAngleOfUlps) {
  const TriangleMesh E =
      tetrahedron({Eigen::Vector3d{0.625, -0.5, -1}, {1, -0.75, -0.625}, {0.875, 0, -0.875}, {-0.875, 0.5, -0.125}});
  const TriangleMesh F = tetrahedron({Eigen::Vector3d{0x1.ep-1, 0x1p-3, -0x1.bp-1},
                                      {0x1.5000000000004p-1, -0x1.8000000000038p-3, -0x1.08p+0},
                                      {0x1.efffffffffffp-1, -0x1.1p+0, -0x1.300000000000ap-1},
                                      {-0x1.6p-2, 0x1.3fffffffffffp-2, 0x1.8p-2}});
  hold_with_neighbours(E, F, {});
}

TEST(NearlyFlush, MasterIsCutWhereALargerTetrahedronsFacePassesItsPlaneAtAnAngleOfUlps) {
  const TriangleMesh E =
      tetrahedron({Eigen::Vector3d{0.125, 0, 0.5}, {-0.875, -0.75, -0.375}, {-0.5, 0.125, -1}, {0.625, -0.5, 0.375}});
  const TriangleMesh F = tetrahedron({Eigen::Vector3d{0x1.8p-3, -0x1.000000000002p-2, 0x1.0800000000002p+0},
                                      {-0x1.7800000000005p+0, -0x1.58p+0, -0x1.5p-1},
                                      {-0x1.4p-2, 0x1.2p-1, -0x1.5p+0},
                                      {0x1.0800000000002p+0, -0x1.600000000002p-2, 0x1.fp-1}});
  hold_with_neighbours(E, F, {});
}

Pose pose_of(const std::array<double, 12>& numbers) {
  Pose pose;
  for (Eigen::Index k = 0; k < 9; ++k) pose.A(k / 3, k % 3) = numbers[static_cast<std::size_t>(k)];
  for (Eigen::Index k = 0; k < 3; ++k) pose.r[k] = numbers[static_cast<std::size_t>(9 + k)];
  return pose;
}

TEST(NearlyFlush, WedgesThatNearlyCoincideHideAsMuchOfEachOtherAsInTheRoundedProblem) {
  const TriangleMesh wedge = generate::wedge(45, 1, 1, 1);
  hold_with_neighbours(wedge, wedge,
                       pose_of({0x1.0000000000003p+0, -0x1.6cac88d66161p-51, -0x1.e2cee7f47104dp-51,
                                0x1.f37aae23a834cp-48, 0x1.fffffffffff5fp-1, 0x1.f1110dcdf864p-35,
                                0x1.8f0a92f493304p-50, 0x1.87317af2c3ec2p-41, 0x1.ffffffffff2b8p-1, 0, 0x1.8p-51, 0}));
  hold_with_neighbours(
      wedge, wedge,
      pose_of({0x1.10989d97877f8p-38, -0x1.cce430fe160cfp-44, 0x1.fffffffffff69p-1, -0x1.d7b8f8d0c8338p-52,
               0x1.ffffffffff448p-1, -0x1.dad73f24593fep-37, -0x1.00000000014a8p+0, -0x1.f59efd11d63bap-40,
               0x1.5c6d270fcdb8p-48, -0x1.fffffffffffe8p-2, 0x1.8p-51, 0x1p-1}));
}

/// A box with other corners.
TriangleMesh box_of(const std::array<Eigen::Vector3d, 8>& corners) {
  TriangleMesh mesh = generate::box(Eigen::Vector3d(1, 1, 1));
  mesh.vertices.assign(corners.begin(), corners.end());
  return mesh;
}

TEST(NearlyFlush, BoxWhoseFlankPassesThatOfALargerBoxAtAnAngleOfUlpsIsMetOnlyBeyondIt) {
  const TriangleMesh E = box_of({Eigen::Vector3d{0x1.05467fe6a1f78p-2, 0x1.df7d67ec8080ap-4, 0x1.16a6398031bb2p-1},
                                 {0x1.8b84469f85639p-1, 0x1.e405c8ddecd9ap-2, -0x1.df8d0afa8b89cp-3},
                                 {0x1.905aa00f6f44ep-2, 0x1.8c813a08156d1p-1, -0x1.6644ca6e4bebap-2},
                                 {-0x1.02ceda91f3153p-3, 0x1.acdc052d5e20ap-2, 0x1.b6ce2e0f5d4fap-2},
                                 {-0x1.0ef332c675ba5p-3, -0x1.31779e4f623ebp-1, -0x1.42258e84459p-5},
                                 {-0x1.0713c3496b2fap-1, -0x1.2df2916c867cep-2, -0x1.3d85ed831db15p-3},
                                 {0x1.cd4362c9381cp-9, 0x1.f19eebb231e5p-5, -0x1.ddeaf79f9c09fp-1},
                                 {0x1.8a4873f52df26p-2, -0x1.ed919b77ef87bp-3, -0x1.a2abd52718f69p-1}});
  const TriangleMesh F = box_of({Eigen::Vector3d{0x1.442cf3285584cp-3, -0x1.f6a25d5ac839cp-5, 0x1.97e829cc286c3p-2},
                                 {0x1.aaf780405f2a6p-2, 0x1.dcfbaf18355e2p-4, 0x1.2bd5b1aa79b3p-7},
                                 {0x1.224c98861d43ep-5, 0x1.ac3b96f84b56p-2, -0x1.b47e5d8ec9604p-4},
                                 {-0x1.c92ee736e17cp-3, 0x1.ec50bf0dc9f27p-3, 0x1.2169e4db22448p-2},
                                 {-0x1.0ef332c675ba5p-3, -0x1.31779e4f623ddp-1, -0x1.42258e84459cp-5},
                                 {-0x1.0713c3496b306p-1, -0x1.2df2916c867cep-2, -0x1.3d85ed831db15p-3},
                                 {-0x1.05467fe6a1f68p-2, -0x1.df7d67ec807dap-4, -0x1.16a6398031bb2p-1},
                                 {0x1.02ceda91f317bp-3, -0x1.acdc052d5e20ep-2, -0x1.b6ce2e0f5d4dap-2}});
  hold_with_neighbours(E, F, {});
}

}  // namespace
}  // namespace pcm::compare::nearly_flush_test
