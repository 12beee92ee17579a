// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How much work answers take, counted: what sorts out faces, pairs and lines too late changes no bit of any answer, and
// shows here alone. The numbers are what they were found to be; whoever makes the engine do less puts the new ones into
// work.csv, which a failing test leaves where it ran.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "compare/random/integer_quaternion.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "pcm/pairing_memory.h"
#include "pcm/scene.h"
#include "tests/fast/engine/kept_table.h"
#include "tests/fast/engine_support.h"

namespace pcm::fast::work_test {
namespace {

using Eigen::Vector3d;

/// Poses all about a body, at a distance.
std::vector<Pose> poses_about(double distance) {
  std::vector<Pose> poses;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        Pose pose;
        pose.A = compare::rotation_of({5, 1 + 2 * x, 3 * y - 1, 2 + z});
        pose.r = distance * Vector3d(x + 0.125, y - 0.0625, z).normalized();
        poses.push_back(pose);
      }
    }
  }
  return poses;
}

constexpr const char* kColumns =
    "bodies,question,box_tests,node_pairs,face_rows,live_lanes,candidate_pairs,unsure_pairs,crossing_pairs,"
    "vertices_transformed,predicates,exact_predicates,tie_breaks,elements,velocities,law_only,lines,lines_settled,"
    "searches_unseen,searches_oblique,searches_slave,searches_master";

std::string row_of(const std::string& bodies, const std::string& question, const WorkCounters& work) {
  std::string row = bodies + ',' + question;
  for (const std::int64_t count :
       {work.box_tests,       work.node_pairs,       work.face_rows,      work.live_lanes,
        work.candidate_pairs, work.unsure_pairs,     work.crossing_pairs, work.vertices_transformed,
        work.predicates,      work.exact_predicates, work.tie_breaks,     work.elements,
        work.velocities,      work.law_only,         work.lines,          work.lines_settled,
        work.searches_unseen, work.searches_oblique, work.searches_slave, work.searches_master})
    row += ',' + std::to_string(count);
  return row;
}

Velocity sliding() {
  Velocity velocity;
  velocity.v = {0.25, -0.5, 1};
  return velocity;
}

constexpr Wanted kForce{.polygons = false, .areas = false, .force = true, .elements = false};
constexpr Wanted kTouch{.polygons = false, .areas = false, .force = false, .elements = false};

WorkCounters work_at(const Pairing& pairing, const std::vector<Pose>& poses, const Wanted& wanted) {
  Workspace workspace;
  WorkCounters work;
  for (const Pose& pose : poses) work += evaluate(pairing, pose, sliding(), wanted, workspace).work;
  return work;
}

/// Along steps from each pose, every fourth of them none, of a memory that follows them.
WorkCounters work_on_ways(const Pairing& pairing, const std::vector<Pose>& poses, double step) {
  Workspace workspace;
  WorkCounters work;
  for (Pose pose : poses) {
    PairingMemory memory(pairing);
    Velocity velocity = sliding();
    for (int k = 0; k < 12; ++k) {
      work += memory.evaluate(pose, velocity, kForce, workspace).work;
      if (k % 4 != 3) pose.r += step * Vector3d(0.5, -0.25, k % 4 - 1);
      velocity.w.x() += 0.25;
    }
  }
  return work;
}

struct Bodies {
  std::string name;
  TriangleMesh E, F;
  double distance;  ///< of F's poses, m
  double size;      ///< what steps are measured in, m
};

std::vector<Bodies> all_bodies() {
  return {{"bubbles", generate::bubble(), generate::bubble(), 0.25, 0.5},
          {"spheres", generate::icosphere(1, 3), generate::icosphere(1, 3), 1.875, 1},
          {"grids", generate::gridded_box(1, 4), generate::gridded_box(1, 3), 0.75, 1},
          {"plate and sphere", generate::plate(2, 2, 0.0625, 4, 4), generate::icosphere(0.5, 2), 0.5, 1},
          {"sheet and box", generate::rectangle(2, 2, 3, 3), generate::box({1, 1, 1}), 0.25, 1}};
}

std::vector<std::string> rows_of(const Bodies& bodies) {
  const Surface E(bodies.E), F(bodies.F);
  const std::vector<Pose> poses = poses_about(bodies.distance);
  const Pairing barycentric(E, F, test::rough(1e5)), clipped(E, F, test::rough(1e5), Mode::both, Scheme::clipped);
  const Wanted everything{.bound = true, .tangent = true};
  const auto row = [&](const char* question, const WorkCounters& work) { return row_of(bodies.name, question, work); };
  return {row("touch", work_at(barycentric, poses, kTouch)),
          row("force", work_at(barycentric, poses, kForce)),
          row("everything", work_at(barycentric, poses, everything)),
          row("clipped force", work_at(clipped, poses, kForce)),
          row("clipped everything", work_at(clipped, poses, everything)),
          row("steps of 2^-26", work_on_ways(barycentric, poses, 0x1p-26 * bodies.size)),
          row("steps of 2^-14", work_on_ways(barycentric, poses, 0x1p-14 * bodies.size)),
          row("steps of 2^-9", work_on_ways(barycentric, poses, 0x1p-9 * bodies.size)),
          row("steps of 2^-4", work_on_ways(barycentric, poses, 0x1p-4 * bodies.size)),
          row("clipped steps of 2^-14", work_on_ways(clipped, poses, 0x1p-14 * bodies.size))};
}

/// Boxes that fall on a plate, the first ones from within it: all pairings of twelve bodies at 40 steps.
SceneCounters work_of_falling_boxes() {
  const Surface box(generate::gridded_box(1, 2)), plate(generate::plate(8, 8, 0.5, 4, 4));
  Scene scene;
  scene.add_body(plate);
  for (int b = 1; b < 12; ++b) scene.add_body(box);
  for (Index E = 0; E < scene.bodies(); ++E)
    for (Index F = E + 1; F < scene.bodies(); ++F) scene.add_pairing(E, F, test::rough(1000), Mode::E);
  std::vector<BodyState> states(12);
  for (int b = 1; b < 12; ++b) {
    BodyState& state = states[static_cast<std::size_t>(b)];
    state.pose.A = compare::rotation_of({7, b % 3, 1, b % 5 - 2});
    const int row = b / 4, column = b % 4;
    state.pose.r = {0.75 * column - 1.5, 0.875 * row - 1, 0.625 + 0.0625 * b};
    state.velocity.v = {0, 0, -1};
  }
  SceneCounters total;
  for (int step = 0; step < 40; ++step) {
    for (std::size_t b = 1; b < states.size(); ++b) states[b].pose.r.z() -= 0x1p-9;
    scene.move(states);
    scene.evaluate_all();
    const SceneCounters counters = scene.counters();
    total.apart_by_boxes += counters.apart_by_boxes;
    total.apart_by_certificate += counters.apart_by_certificate;
    total.evaluated += counters.evaluated;
    total.certificates_sought += counters.certificates_sought;
    total.work += counters.work;
  }
  return total;
}

TEST(Work, IsWhatItWas) {
  std::vector<std::string> rows{kColumns};
  for (const Bodies& bodies : all_bodies())
    for (const std::string& row : rows_of(bodies)) rows.push_back(row);
  rows.push_back(row_of("falling boxes", "scene", work_of_falling_boxes().work));
  test::expect_kept(rows, "work.csv");
}

TEST(Work, OfAScenesPairingsIsWhatItWas) {
  const SceneCounters counters = work_of_falling_boxes();
  EXPECT_EQ(counters.apart_by_boxes, 1400);
  EXPECT_EQ(counters.apart_by_certificate, 156);
  EXPECT_EQ(counters.evaluated, 1084);
  EXPECT_EQ(counters.certificates_sought, 4);
}

}  // namespace
}  // namespace pcm::fast::work_test
