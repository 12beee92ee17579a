// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/barycentric/penetration_walks.h"

#include <gtest/gtest.h>

#include "fast/surface/prepare_surface.h"
#include "fast/surface/thickness.h"
#include "tests/fast/engine_support.h"

namespace pcm::fast {
namespace {

using Eigen::Vector3d;

struct BallOnPlate {
  TriangleMesh plate;
  Pose pose;
};

/// The ball is 0.2 m deep, and both are so far from the origin, m.
BallOnPlate ball_on_plate_at(double distance) {
  const Vector3d far(distance, 0, 0);
  return {translated(generate::box({4, 4, 2}), far), test::turned(0.7, far + Vector3d(0, 0, 1.8))};
}

/// Of how many faces of F it is known at this pose that the master is as thick as in its own frame.
int faces_of_known_thickness(const BallOnPlate& touch, const PreparedSurface& ball) {
  const PreparedSurface plate = prepare_surface(touch.plate);
  PosedPair posed;
  posed.place(plate, ball, touch.pose, 0, false);
  int known = 0;
  for (Index face = 0; face < std::ssize(ball.mesh.faces); ++face) {
    const FaceGeometry geometry(posed.face_Me(Side::F, face));
    known += thickness_holds(ball, posed.placement.vertex_error(Side::F), geometry) ? 1 : 0;
  }
  return known;
}

TEST(PenetrationWalks, LeaveTheElementToASearchWhereTheMastersThicknessIsNotKnownAtThePose) {
  const TriangleMesh mesh = generate::icosphere(1, 3);
  const PreparedSurface ball = prepare_surface(mesh);
  double distance = 1;
  while (faces_of_known_thickness(ball_on_plate_at(distance), ball) > 0) distance *= 1.0625;
  const auto work_at = [&](double at) {
    const BallOnPlate touch = ball_on_plate_at(at);
    return test::answer(touch.plate, mesh, touch.pose, test::stiffness(1), Mode::F).work;
  };
  const WorkCounters unknown = work_at(distance);
  EXPECT_GT(unknown.elements, 50);
  EXPECT_EQ(unknown.searches_master, unknown.elements);
  EXPECT_EQ(work_at(0.25 * distance).searches_master, 0);
}

}  // namespace
}  // namespace pcm::fast
