// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/fast/engine_support.h"
#include "tests/meshes/mesh_measures.h"

/// The elastic force of the clipped scheme is continuous in the pose, but for flush poses.
///
/// Bound of the jump: let F move by d, |d| = h. On a master face e the visible part of a slave face f changes u by at
/// most h / |n_e . n_f| on an area of at most |n_e . n_f| A_f: at most h A_f in the integral. The parts' borders move:
/// projected edges by at most h, lines along which two planes meet by at most h over the sine of their angle. u jumps
/// there by at most the bodies' size D. So each master face changes the force by at most c_l h (A + D L / sin), A and L
/// the area and the length of all edges of both surfaces, and there are `faces` of them.
namespace pcm::fast {
namespace {

using namespace test;
using Eigen::Vector3d;

struct Path {
  const char* name;
  TriangleMesh E;
  TriangleMesh F;
  Eigen::Matrix3d A;
  Vector3d r;          ///< where F is at the critical pose
  Vector3d direction;  ///< unit
  Mode mode;
};

double length_of_edges(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum += (mesh.vertices[static_cast<std::size_t>(t[k])] - mesh.vertices[static_cast<std::size_t>(t[(k + 1) % 3])])
                 .norm();
    }
  }
  return sum / 2;
}

double size_of(const TriangleMesh& mesh) {
  double size = 0;
  for (const Vector3d& x : mesh.vertices) size = std::max(size, x.norm());
  return 2 * size;
}

/// How much the force may change per length that F moves, for c_l = 1.
double steepest(const Path& path) {
  const double area = pcm::test::area(path.E) + pcm::test::area(path.F);
  const double length = length_of_edges(path.E) + length_of_edges(path.F);
  const double size = size_of(path.E) + size_of(path.F);
  double least_sine = 1;
  for (const TriangleMesh* a : {&path.E, &path.F}) {
    for (const TriangleMesh* b : {&path.E, &path.F}) {
      for (const Triangle& s : a->faces) {
        for (const Triangle& t : b->faces) {
          const auto normal = [&](const TriangleMesh* mesh, const Triangle& f) {
            const auto x = [&](std::size_t k) { return mesh->vertices[static_cast<std::size_t>(f[k])]; };
            const Vector3d n = (x(1) - x(0)).cross(x(2) - x(0)).normalized();
            return mesh == &path.F ? Vector3d(path.A * n) : n;
          };
          const double sine = normal(a, s).cross(normal(b, t)).norm();
          // Parallel planes do not meet.
          if (sine > 1e-9) least_sine = std::min(least_sine, sine);
        }
      }
    }
  }
  const auto faces = static_cast<double>(path.E.faces.size() + path.F.faces.size());
  return faces * (area + size * length / least_sine);
}

Eigen::Matrix3d tilted(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d(1, 0.4, 0).normalized()).toRotationMatrix();
}

std::vector<Path> paths() {
  const TriangleMesh floor = generate::plate(6, 6, 2);
  const TriangleMesh thin = generate::plate(6, 6, 0.25);
  const TriangleMesh cube = generate::box(Vector3d(-0.5, -0.5, -0.5), Vector3d(0.5, 0.5, 0.5));
  const TriangleMesh pin = generate::box(Vector3d(-0.1, -0.1, 0), Vector3d(0.1, 0.1, 2));
  const Vector3d down(0, 0, -1);
  const auto lowest = [&](const TriangleMesh& mesh, const Eigen::Matrix3d& A, double sign) {
    double least = 1e300;
    for (const Vector3d& x : mesh.vertices) least = std::min(least, sign * (A * x).z());
    return sign * least;
  };
  std::vector<Path> result;
  for (const Mode mode : {Mode::E, Mode::F}) {
    const Eigen::Matrix3d A = tilted(0.6);
    const double bottom = lowest(cube, A, 1), top = lowest(cube, A, -1);
    result.push_back({"a corner touches", floor, cube, A, {0.1, 0.2, -bottom}, down, mode});
    result.push_back(
        {"opposite faces coplanar", floor, cube, Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.5}, down, mode});
    result.push_back(
        {"a corner comes out beneath a thin plate", thin, cube, A, {0.1, 0.2, -bottom - 0.25}, down, mode});
    result.push_back({"a cube is pushed wholly through", thin, cube, A, {0.1, 0.2, -top}, down, mode});
    const Eigen::Matrix3d B = tilted(0.15);
    result.push_back({"a pin comes through", thin, pin, B, {0.1, 0.2, -lowest(pin, B, 1) - 0.25}, down, mode});
    result.push_back({"a pin slides over the plate's edge", thin, pin, B, {3, 0.2, -1}, {1, 0, 0}, mode});
    result.push_back({"a cube splits off beneath the surface", floor, cube, A, {0.1, 0.2, -top}, down, mode});
    result.push_back({"a cube's edge passes the other triangle", floor, cube, A, {0, 0, 0.1}, {1, 0, 0}, mode});
  }
  return result;
}

Vector3d force_at(const Path& path, const Pairing& pairing, double way, Workspace& workspace) {
  Wanted wanted{false, false, true, false};
  Pose pose;
  pose.A = path.A;
  pose.r = path.r + way * path.direction;
  return evaluate(pairing, pose, {}, wanted, workspace).force_Me;
}

TEST(ClippedContinuity, ForceDoesNotJumpAlongPathsThroughCriticalPosesThatAreNotFlush) {
  for (const Path& path : paths()) {
    SCOPED_TRACE(path.name);
    const Pairing pairing(Surface(path.E), Surface(path.F), stiffness(1), path.mode, Scheme::clipped);
    const double slope = steepest(path);
    Workspace workspace;
    const Vector3d at_pose = force_at(path, pairing, 0, workspace);
    double greatest = at_pose.norm();
    for (double step = 0x1p-2; step > 1e-12; step /= 2) {
      // Two steps on both sides, so that an event that rounding has moved a little is passed as well.
      for (int i = -2; i < 2; ++i) {
        const Vector3d a = force_at(path, pairing, i * step, workspace);
        const Vector3d b = force_at(path, pairing, (i + 1) * step, workspace);
        greatest = std::max(greatest, a.norm());
        ASSERT_LT((b - a).norm(), slope * (step + 1e-15)) << "step " << step;
      }
    }
    // The path leads through contact, and the bound is far below the force where the steps are small.
    EXPECT_GT(greatest, 1e-6);
    EXPECT_LT(slope * 1e-12, 1e-3 * greatest);
  }
}

TEST(ClippedContinuity, ForceJumpsWhereACubesTopPassesTheSurfaceFlush) {
  // As long as the cube sticks out, lines from the floor's surface leave it at its bottom; once its top is beneath,
  // they enter it first.
  const TriangleMesh floor = generate::plate(6, 6, 4);
  const TriangleMesh cube = generate::box(Vector3d(-0.5, -0.5, -0.5), Vector3d(0.5, 0.5, 0.5));
  const auto force = [&](double top) {
    return answer(floor, cube, shifted(0.125, 0.25, top - 0.5), stiffness(1), Mode::E, {}, {}, Scheme::clipped)
        .force_Me.z();
  };
  EXPECT_NEAR(force(0x1p-40), -1, 1e-11);
  EXPECT_EQ(force(0), 0);
  EXPECT_EQ(force(-0x1p-40), 0);
}

TEST(ClippedContinuity, ForceJumpsWhereACubesBottomPassesAThinPlatesBottomFlush) {
  const double t = 0.25;
  const TriangleMesh plate = generate::plate(6, 6, t);
  const TriangleMesh cube = generate::box(Vector3d(-0.5, -0.5, 0), Vector3d(0.5, 0.5, 1));
  const auto force = [&](double depth) {
    return answer(plate, cube, shifted(0.125, 0.25, -depth), stiffness(1), Mode::E, {}, {}, Scheme::clipped)
        .force_Me.z();
  };
  EXPECT_NEAR(force(t - 0x1p-40), -t, 1e-11);
  // Exactly flush the plate is not left before the cube.
  EXPECT_NEAR(force(t), -t, 1e-15);
  EXPECT_NEAR(force(t + 0x1p-40), 0, 1e-11);
}

}  // namespace
}  // namespace pcm::fast
