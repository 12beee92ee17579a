// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/contact_target.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <vector>

#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/verdict/case_file.h"
#include "pcm/check.h"
#include "tests/compare/tetrahedron.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/target.h"

namespace pcm::fuzz {

namespace {

TriangleMesh tetrahedron() {
  return compare::tetrahedron({Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
}

TriangleMesh octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
          "octahedron"};
}

TriangleMesh cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  mesh.name = "cube";
  return mesh;
}

/// Open: two triangles that share an edge.
TriangleMesh sheet() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, "sheet"};
}

/// Any faces over up to eight vertices.
TriangleMesh any_mesh(ByteSource& source) {
  TriangleMesh mesh;
  const int vertices = 3 + source.below(6), faces = 1 + source.below(12);
  for (int i = 0; i < vertices; ++i) mesh.vertices.push_back(source.vector());
  for (int i = 0; i < faces; ++i) {
    const int a = source.below(vertices), b = source.below(vertices), c = source.below(vertices);
    mesh.faces.push_back({a, b, c});
  }
  mesh.name = "any";
  return mesh;
}

/// A shape, some of whose vertices are moved, or any mesh at all.
TriangleMesh draw_mesh(ByteSource& source) {
  const int shape = source.below(5);
  if (shape == 4) return any_mesh(source);
  TriangleMesh mesh = shape == 0 ? tetrahedron() : shape == 1 ? cube() : shape == 2 ? octahedron() : sheet();
  for (int moved = source.below(5); moved > 0; --moved) {
    const auto vertex = static_cast<std::size_t>(source.below(static_cast<int>(mesh.vertices.size())));
    mesh.vertices[vertex] = source.vector();
  }
  return mesh;
}

/// One of the 24 rotations of a cube in half of the draws, else that of a quaternion of small integers.
Eigen::Matrix3d draw_rotation(ByteSource& source) {
  const int choice = source.below(48);
  if (choice < 24) {
    // A signed permutation of the axes: the first axis' image, the second's of those left, the third by the right hand.
    const int first = choice % 3, second = (first + 1 + choice / 3 % 2) % 3;
    Eigen::Vector3d x = Eigen::Vector3d::Zero(), y = Eigen::Vector3d::Zero();
    x[first] = (choice / 6 & 1) != 0 ? -1 : 1;
    y[second] = (choice / 12 & 1) != 0 ? -1 : 1;
    Eigen::Matrix3d A;
    A << x, y, x.cross(y);
    return A;
  }
  Eigen::Vector4d q;
  for (int i = 0; i < 4; ++i) q[i] = source.below(33) - 16;
  if (q.isZero()) q[0] = 1;
  const double w = q[0], a = q[1], b = q[2], c = q[3];
  Eigen::Matrix3d A;
  A << w * w + a * a - b * b - c * c, 2 * (a * b - w * c), 2 * (a * c + w * b),  //
      2 * (a * b + w * c), w * w - a * a + b * b - c * c, 2 * (b * c - w * a),   //
      2 * (a * c - w * b), 2 * (b * c + w * a), w * w - a * a - b * b + c * c;
  return A / q.squaredNorm();
}

ContactLaw draw_law(ByteSource& source) {
  ContactLaw law;
  law.stiffness = source.positive();
  const int terms = source.byte();
  if ((terms & 1) != 0) law.damping = source.positive();
  if ((terms & 2) != 0) law.transition_depth = source.positive();
  if ((terms & 4) != 0) law.friction = source.positive();
  if ((terms & 8) != 0) law.slip_velocity = source.positive();
  if ((terms & 16) != 0) law.max_penetration = source.positive();
  if ((terms & 32) != 0) {
    const double c_E = source.positive(), c_F = source.positive();
    law.layers = LayerStiffness{c_E, c_F};
  }
  law.damping_mode = static_cast<DampingMode>((terms >> 6) % 3);
  return law;
}

compare::Case draw_case(std::string_view bytes) {
  ByteSource source(bytes);
  compare::Case posed;
  posed.origin = "fuzz";
  const int choice = source.byte();
  posed.mode = static_cast<Mode>(choice % 3);
  posed.scheme = static_cast<Scheme>(choice / 3 % 2);
  posed.pose.A = draw_rotation(source);
  posed.pose.r = source.vector();
  posed.E = draw_mesh(source);
  posed.F = draw_mesh(source);
  posed.law = draw_law(source);
  posed.velocity.v = source.vector();
  posed.velocity.w = source.vector();
  return posed;
}

}  // namespace

void compare_contact_through(std::string_view bytes, const compare::EngineSeam& seam) {
  const compare::Case posed = draw_case(bytes);
  if (!check(posed.E).fit() || !check(posed.F).fit()) return;
  const compare::HeldPairing held(posed.E, posed.F, posed.law, posed.mode, posed.scheme);
  fast::Workspace workspace;
  const compare::PoseOutcome outcome = held.hold(posed.pose, posed.velocity, workspace, seam).front();
  if (outcome.disagreements.empty()) return;
  compare::Case wrong = posed;
  wrong.disagreements = in_words(outcome.disagreements);
  throw Found("engine and oracle disagree; the case:\n" +
              format_case(wrong, nlohmann::ordered_json::object(), nlohmann::ordered_json::object()));
}

void compare_contact(std::string_view bytes) {
  compare_contact_through(bytes, compare::EngineSeam::none());
}

}  // namespace pcm::fuzz
