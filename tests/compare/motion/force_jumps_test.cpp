// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths whose jumps are known by hand.

#include "compare/motion/force_jumps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "compare/motion/path_force.h"
#include "compare/motion/path_work.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr double kStiffness = 100;

Pose at(double x, double y, double z) {
  Pose pose;
  pose.r = {x, y, z};
  return pose;
}

fast::Pairing pairing(TriangleMesh E, TriangleMesh F, Mode mode = Mode::E, Scheme scheme = Scheme::barycentric,
                      double max_penetration = std::numeric_limits<double>::infinity()) {
  ContactLaw law;
  law.stiffness = kStiffness;
  law.max_penetration = max_penetration;
  return {fast::Surface(std::move(E)), fast::Surface(std::move(F)), law, mode, scheme};
}

PathWalk walk(const fast::Pairing& pair, const std::vector<Pose>& poses, std::int64_t steps = 8) {
  JumpSearch search;
  search.steps = steps;
  return walk(pair, PosePath(poses), search);
}

/// Both sides are neighbours on the grid, or as near as rounding tells a flush pose; what the engine says at them
/// differs by the jump and nothing else.
void expect_located(const fast::Pairing& pair, const ForceJump& jump) {
  EXPECT_EQ(jump.before.segment, jump.after.segment);
  EXPECT_LE(jump.after.tick - jump.before.tick, jump.faces.front().cause == JumpCause::flush ? 1 << 14 : 1);
  fast::Workspace workspace;
  const Eigen::Vector3d before = evaluate(pair, jump.pose_before, {}, {}, workspace).force_Me;
  const Eigen::Vector3d after = evaluate(pair, jump.pose_after, {}, {}, workspace).force_Me;
  EXPECT_LE((after - before - jump.force_Me).norm(), 1e-12 * std::max(before.norm(), after.norm()));
}

/// A prism over a profile in the x-z plane that is star-shaped about its first corner, counterclockwise seen from -y.
TriangleMesh extruded(const std::vector<std::pair<double, double>>& profile, double y0, double y1) {
  TriangleMesh mesh;
  const auto n = static_cast<Index>(profile.size());
  for (const double y : {y0, y1})
    for (const auto& [x, z] : profile) mesh.vertices.emplace_back(x, y, z);
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    mesh.faces.push_back({i, i + n, j + n});
    mesh.faces.push_back({i, j + n, j});
    if (i == 0 || j == 0) continue;
    mesh.faces.push_back({0, i, j});
    mesh.faces.push_back({n, j + n, i + n});
  }
  return mesh;
}

// Cells of 1/8 m; a box stands 1/16 m deep on one row of them and its front wall passes the barycentre of one of the
// triangles, at 2/3 of a cell, the wall behind none.
constexpr double kCell = 0.125, kDepth = 0.0625, kFace = kCell * kCell / 2;
TriangleMesh grid() {
  return generate::plate(2, 2, 1, 16, 16);
}
TriangleMesh block() {
  return generate::box(Eigen::Vector3d(-3.5 * kCell, 0.125 * kCell, 0), Eigen::Vector3d(0, 0.875 * kCell, 1));
}
const std::vector<Pose> kPassing{at(0.5 * kCell, 0, -kDepth), at(0.75 * kCell, 0, -kDepth)};

TEST(ForceJumps, BarycentrePassingTheEdgeOfABoxJumpsByStiffnessAreaDepth) {
  for (const Mode mode : {Mode::E, Mode::both}) {
    const fast::Pairing pair = pairing(grid(), block(), mode);
    const PathWalk found = walk(pair, kPassing);
    ASSERT_EQ(found.jumps.size(), 1U);
    const ForceJump& jump = found.jumps.front();
    const double size = kStiffness * kFace * kDepth * (mode == Mode::both ? 0.5 : 1);
    EXPECT_NEAR(jump.size(), size, 1e-12 * size);
    EXPECT_NEAR(jump.force_Me.z(), -size, 1e-12 * size);
    EXPECT_NEAR(jump.before.share(), 2.0 / 3, 1e-12);
    expect_located(pair, jump);
    ASSERT_EQ(jump.faces.size(), 1U);
    EXPECT_EQ(jump.faces.front().cause, JumpCause::entry);
    EXPECT_EQ(jump.faces.front().after.master, Side::E);
    EXPECT_TRUE(jump.faces.front().before.slave_faces.empty());
    EXPECT_FALSE(jump.faces.front().after.clamped);
  }
}

TEST(ForceJumps, NoneInTheClippedSchemeNorWithTheBoxAsMaster) {
  for (const Mode mode : {Mode::E, Mode::F, Mode::both})
    EXPECT_TRUE(walk(pairing(grid(), block(), mode, Scheme::clipped), kPassing).jumps.empty());
  EXPECT_TRUE(walk(pairing(grid(), block(), Mode::F), kPassing).jumps.empty());
}

TEST(ForceJumps, MaxPenetrationBoundsTheJump) {
  const PathWalk found = walk(pairing(grid(), block(), Mode::E, Scheme::barycentric, kDepth / 4), kPassing);
  ASSERT_EQ(found.jumps.size(), 1U);
  EXPECT_NEAR(found.jumps.front().size(), kStiffness * kFace * kDepth / 4, 1e-14);
  EXPECT_TRUE(found.jumps.front().faces.front().after.clamped);
}

TEST(ForceJumps, ReachingMaxPenetrationIsContinuous) {
  const fast::Pairing pair = pairing(grid(), block(), Mode::E, Scheme::barycentric, kDepth / 4);
  EXPECT_TRUE(walk(pair, {at(0.5 * kCell, 0, -kDepth / 8), at(0.5 * kCell, 0, -kDepth)}).jumps.empty());
}

TEST(ForceJumps, StepInTheSlaveMovesTheLineToAnotherFace) {
  // The step's riser is upright, so that the line passes from the low tread to the high one.
  const double low = 0, high = 0.03125;
  const TriangleMesh stairs =
      extruded({{0, high}, {3.5 * kCell, high}, {3.5 * kCell, 1}, {-3.5 * kCell, 1}, {-3.5 * kCell, low}, {0, low}},
               0.125 * kCell, 0.875 * kCell);
  const fast::Pairing pair = pairing(grid(), stairs);
  const PathWalk found = walk(pair, {at(0.55 * kCell, 0, -kDepth), at(0.75 * kCell, 0, -kDepth)});
  ASSERT_EQ(found.jumps.size(), 1U);
  const ForceJump& jump = found.jumps.front();
  EXPECT_NEAR(jump.size(), kStiffness * kFace * (high - low), 1e-14);
  EXPECT_EQ(jump.faces.front().cause, JumpCause::edge);
  EXPECT_NE(jump.faces.front().before.slave_faces, jump.faces.front().after.slave_faces);
  expect_located(pair, jump);
}

TEST(ForceJumps, PassingToAnAdjacentSlaveFaceIsNone) {
  // A keel: the line passes from one of its flanks to the other.
  const TriangleMesh keel = extruded({{0, 0}, {3, 1.5}, {-3, 1.5}}, -2, 2);
  EXPECT_TRUE(walk(pairing(grid(), keel), {at(-0.1, 0, -kDepth), at(0.1, 0.01, -kDepth)}).jumps.empty());
}

TEST(ForceJumps, SlaveAsDeepAsTheMasterIsThick) {
  // All of the plate's faces under the box lose their force together.
  const double thickness = 0.125;
  const fast::Pairing pair = pairing(generate::plate(2, 2, thickness, 4, 4),
                                     generate::box(Eigen::Vector3d(-3, -3, 0), Eigen::Vector3d(3, 3, 2)));
  const PathWalk found = walk(pair, {at(0, 0, -0.0625), at(0, 0, -0.2)});
  ASSERT_EQ(found.jumps.size(), 1U);
  const ForceJump& jump = found.jumps.front();
  EXPECT_NEAR(jump.size(), kStiffness * 4 * thickness, 1e-12);
  EXPECT_NEAR(jump.relative(), 1, 1e-12);
  EXPECT_EQ(jump.faces.size(), 32U);
  EXPECT_EQ(jump.faces.front().cause, JumpCause::depth);
  EXPECT_GE(found.most_too_deep, 32);
  EXPECT_NEAR(jump.pose_before.r.z(), -thickness, 1e-15);
}

/// The grid [-1, 1]^2 in the plane z = 0 with a wall down to z = -1 at x = 1.
TriangleMesh table_with_wall() {
  TriangleMesh mesh = generate::rectangle(2, 2, 4, 4);
  std::vector<std::pair<double, Index>> rim;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (mesh.vertices[i].x() == 1) rim.emplace_back(mesh.vertices[i].y(), static_cast<Index>(i));
  std::sort(rim.begin(), rim.end());
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const auto below = static_cast<Index>(mesh.vertices.size());
    mesh.vertices.emplace_back(1, rim[i].first, -1);
    if (i == 0) continue;
    mesh.faces.push_back({rim[i - 1].second, below - 1, below});
    mesh.faces.push_back({rim[i - 1].second, below, rim[i].second});
  }
  return mesh;
}

TEST(ForceJumps, OpenSlaveThatBeginsToPierceTheMasterMakesFacesActive) {
  // A sheet below the table crosses nothing; where it reaches the wall, the table above it turns out to be inside.
  TriangleMesh sheet = generate::rectangle(1, 6);
  for (Triangle& face : sheet.faces) std::swap(face[1], face[2]);
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const fast::Pairing pair = pairing(table_with_wall(), sheet, Mode::E, scheme);
    const PathWalk found = walk(pair, {at(0.25, 0, -kDepth), at(0.75, 0, -kDepth)});
    ASSERT_FALSE(found.jumps.empty());
    const ForceJump& jump = found.jumps.front();
    EXPECT_NEAR(jump.pose_before.r.x(), 0.5, 1e-12);
    EXPECT_NEAR(jump.size(), kStiffness * 2 * kDepth, 1e-12);
    EXPECT_EQ(jump.faces.front().cause, JumpCause::activity);
    EXPECT_EQ(jump.faces.size(), 16U);
  }
}

TEST(ForceJumps, FlushFlanksJumpInBothSchemes) {
  // E's wall at x = 0 sees F's at x = 2 before, its wall at x = 2 sees F's at x = 0 after: 2 m deep on 2 m^2 each.
  const TriangleMesh E = generate::box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 2));
  const TriangleMesh F = generate::box(Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(2, 2, 3));
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const fast::Pairing pair = pairing(E, F, Mode::E, scheme);
    const PathWalk found = walk(pair, {at(-0.25, 0.125, 0), at(0.5, 0.125, 0)});
    double sum = 0;
    for (const ForceJump& jump : found.jumps) {
      if (std::abs(jump.before.share() - 1.0 / 3) > 1e-12) continue;
      sum += jump.force_Me.x();
      for (const FaceJump& face : jump.faces) EXPECT_EQ(face.cause, JumpCause::flush);
    }
    const double width = scheme == Scheme::clipped ? 1.875 : 2;  // y: 1/8 m beside; a triangle counts whole
    EXPECT_NEAR(sum, -kStiffness * 4 * width, 1e-10);
    EXPECT_TRUE(scheme == Scheme::barycentric || found.jumps.size() == 1);
  }
}

TEST(ForceJumps, LoadsThatJumpWithoutAForceBeforeOrAfterHaveNoShareInIt) {
  EXPECT_EQ(ForceJump().relative(), 0);
}

TEST(ForceJumps, FlushInTheMidstOfATurnIsFound) {
  // F, 1 m wide, turns about y through the pose in which its wall lies in E's: before, the metre of E's wall below the
  // axis is inside F, after, the half metre above it.
  const TriangleMesh E = generate::box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 2));
  const TriangleMesh F = generate::box(Eigen::Vector3d(-1, 0, -1), Eigen::Vector3d(0, 2, 1));
  const auto turned = [](double angle) {
    Pose pose = at(2, 0, 1.5);
    pose.A << std::cos(angle), 0, std::sin(angle), 0, 1, 0, -std::sin(angle), 0, std::cos(angle);
    return pose;
  };
  const fast::Pairing pair = pairing(E, F, Mode::E, Scheme::clipped);
  const PathWalk found = walk(pair, {turned(-0.1), turned(0.2)});
  ASSERT_EQ(found.jumps.size(), 1U);
  EXPECT_NEAR(found.jumps.front().before.share(), 1.0 / 3, 1e-12);
  EXPECT_NEAR(found.jumps.front().force_Me.x(), kStiffness * 2 * (1 - 0.5), 1e-9);
  EXPECT_EQ(found.jumps.front().faces.front().cause, JumpCause::flush);
  expect_located(pair, found.jumps.front());
}

TEST(ForceJumps, BubblesHaveNoneInTheClippedScheme) {
  Pose turned = at(0.15, -0.02, 0.1);
  turned.A << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
  const std::vector<Pose> poses{at(0.15, 0.02, 0.1), turned};
  for (const Mode mode : {Mode::E, Mode::F}) {
    const TriangleMesh bubble = generate::bubble();
    EXPECT_TRUE(walk(pairing(bubble, bubble, mode, Scheme::clipped), poses).jumps.empty());
    const fast::Pairing pair = pairing(bubble, bubble, mode);
    const PathWalk found = walk(pair, poses);
    EXPECT_GT(found.jumps.size(), 10U);
    for (const ForceJump& jump : found.jumps) {
      expect_located(pair, jump);
      for (const FaceJump& face : jump.faces) EXPECT_GT(face.size, face.continuous);
    }
  }
}

TEST(PathWork, LoopWithinThePlaneOfTheForceDoesNone) {
  // The plate's force is upright, whatever jumps: no work on a level way.
  const fast::Pairing pair = pairing(grid(), block());
  const std::vector<Pose> loop{at(0, 0, -kDepth), at(0.3, 0.1, -kDepth), at(0.2, -0.3, -kDepth), at(0, 0, -kDepth)};
  const PosePath path(loop);
  const PathWalk found = walk(pair, loop, 32);
  EXPECT_TRUE(path.closed());
  EXPECT_FALSE(found.jumps.empty());
  EXPECT_EQ(path_work(path, found).work, 0);
  const TangentialForce tangential = tangential_force(found, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(tangential.greatest, 0);
  EXPECT_EQ(tangential.normal_there, found.points.front().force_Me.norm());
}

TEST(PathWork, PressSlideLiftIsWithoutLossOnAPlateInTheClippedScheme) {
  // Force and depth are the same at both ends of the slide.
  const fast::Pairing pair = pairing(grid(), block(), Mode::E, Scheme::clipped);
  const std::vector<Pose> loop{at(0, 0, 0.01), at(0, 0, -kDepth), at(0.171, 0.3, -kDepth), at(0.171, 0.3, 0.01),
                               at(0, 0, 0.01)};
  const PosePath path(loop);
  const PathWork sum = path_work(path, walk(pair, loop, 32));
  EXPECT_LE(std::abs(sum.share()), 1e-14);
  EXPECT_GT(sum.greatest_force, 1e-2);
}

TEST(PathWork, JumpsAreResolvedSoThatWorkIsRightInCoarseSteps) {
  // Pressing down through the depth limit: K A u up to the plate's thickness, then nothing. W = - K A t^2 / 2.
  const double thickness = 0.125;
  const fast::Pairing pair = pairing(generate::plate(2, 2, thickness, 2, 2),
                                     generate::box(Eigen::Vector3d(-3, -3, 0), Eigen::Vector3d(3, 3, 2)));
  const std::vector<Pose> press{at(0, 0, 0), at(0, 0, -0.3)};
  const PathWork sum = path_work(PosePath(press), walk(pair, press, 3));
  EXPECT_NEAR(sum.work, -kStiffness * 4 * thickness * thickness / 2, 1e-12);
  EXPECT_LE(sum.error, 1e-12);
}

TEST(PosePath, EndsAreThePosesBitForBitAndTheMiddleIsHalfTheTurn) {
  const double h = std::numbers::pi / 4;
  Pose from = at(1, 2, 3), to = at(2, 2, 5);
  to.A << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const PathSegment segment(from, to);
  EXPECT_EQ(segment.at(0).A, from.A);
  EXPECT_EQ(segment.at(1).A, to.A);
  EXPECT_EQ(segment.at(1).r, to.r);
  EXPECT_LE((segment.turn_Me() - Eigen::Vector3d(0, 0, 2 * h)).norm(), 1e-15);
  Eigen::Matrix3d half;
  half << std::cos(h), -std::sin(h), 0, std::sin(h), std::cos(h), 0, 0, 0, 1;
  EXPECT_LE((segment.at(0.5).A - half).norm(), 1e-15);
  EXPECT_EQ(segment.at(0.5).r, Eigen::Vector3d(1.5, 2, 4));
}

TEST(PosePath, MatricesThatAreRotationsToOnePartInABillionOnlyAreJoinedWithoutAStep) {
  Pose from = at(0, 0, 0), to = at(0, 0, 0);
  to.A << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  from.A(0, 0) = 1 + 4e-10;
  to.A(2, 2) = 1 - 4e-10;
  const PathSegment segment(from, to);
  EXPECT_LE((segment.at(0x1p-52).A - from.A).norm(), 1e-15);
  EXPECT_LE((segment.at(1 - 0x1p-53).A - to.A).norm(), 1e-15);
}

TEST(PosePath, OnePoseIsNoPath) {
  EXPECT_THROW(PosePath({Pose()}), BadInput);
}

// A wedge dips 1/5 into a block: penetrations from 0 to 1/5, means of 1/10.
TEST(PathForce, AFaceIsClampedWhereSomeOfItIsTooDeepThoughItsMeanIsNot) {
  const auto clamped_faces = [](Scheme scheme, double max_penetration) {
    const fast::Pairing pair =
        pairing(generate::box({-2, -2, -1}, {2, 2, 0}), generate::wedge(45, 1, 1), Mode::E, scheme, max_penetration);
    const PosePath path({at(0, 0, -0.2), at(0, 0, -0.1)});
    const PathSample sample = PathForce(pair, path).at({0, 0});
    EXPECT_FALSE(sample.loads.empty());
    return std::count_if(sample.loads.begin(), sample.loads.end(), [](const FaceLoad& load) { return load.clamped; });
  };
  constexpr double kNone = std::numeric_limits<double>::infinity();
  EXPECT_EQ(clamped_faces(Scheme::clipped, 0.15), 2) << "both triangles of the block's top";
  EXPECT_EQ(clamped_faces(Scheme::clipped, 0.05), 2);
  EXPECT_EQ(clamped_faces(Scheme::clipped, 0.25), 0);
  EXPECT_EQ(clamped_faces(Scheme::clipped, kNone), 0);
}

}  // namespace
}  // namespace pcm::compare
