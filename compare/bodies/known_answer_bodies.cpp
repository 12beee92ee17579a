// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bodies/known_answer_bodies.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "compare/random/integer_quaternion.h"
#include "compare/random/random.h"

namespace pcm::compare {
namespace {

constexpr std::array<std::array<int, 4>, kOrientations> kQuaternions{
    {{9, 2, 5, 1},  {8, -3, 1, 6}, {7, 4, -6, 3},  {7, -1, -5, -4}, {6, 7, 2, -3},  {6, -5, 8, 1}, {5, 3, 7, -8},
     {5, -9, 2, 4}, {5, 1, -4, 9}, {4, 8, 7, 3},   {4, -6, -3, 7},  {4, 3, -9, -2}, {3, 9, -4, 5}, {3, -2, 8, 6},
     {3, 5, 1, -9}, {2, 7, -8, 1}, {2, -4, -7, 9}, {2, 6, 3, 8},    {1, -8, 5, -6}, {1, 4, -9, 7}}};

}  // namespace

Eigen::Matrix3d fixed_rotation(int i) {
  return rotation_of(kQuaternions[static_cast<std::size_t>(i)]);
}

Eigen::Matrix3d fixed_roll(int i) {
  // Turns by 2 atan(b / a), spread over a quarter turn and in no rational ratio to it.
  return rotation_of({97, 0, 0, 2 * i + 1});
}

Pose Placement::pose() const {
  Pose pose;
  pose.A = R.transpose();
  pose.r = -ordered_product(pose.A, p);
  return pose;
}

Load load(const fast::Pairing& pairing, const Placement& placement, fast::Workspace& workspace) {
  Wanted wanted;
  wanted.polygons = wanted.areas = wanted.elements = false;
  const fast::Contact& contact = fast::evaluate(pairing, placement.pose(), {}, wanted, workspace);
  return {ordered_product(placement.R, contact.force_Me), ordered_product(placement.R, contact.torque_Me)};
}

ContactLaw stiffness(double c_l) {
  ContactLaw law;
  law.stiffness = c_l;
  return law;
}

TriangleMesh turned(TriangleMesh mesh, const Eigen::Matrix3d& R) {
  for (Eigen::Vector3d& x : mesh.vertices) x = ordered_product(R, x);
  return mesh;
}

double mean_edge(const TriangleMesh& mesh) {
  long double weighted = 0, areas = 0;
  for (const Triangle& face : mesh.faces) {
    const Eigen::Vector3d &a = mesh.vertices[face[0]], &b = mesh.vertices[face[1]], &c = mesh.vertices[face[2]];
    const double area = (b - a).cross(c - a).norm() / 2;
    weighted += area * ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm()) / 3;
    areas += area;
  }
  return static_cast<double>(std::sqrt(weighted / areas));
}

std::int64_t faces_of(const fast::Surface& E, const fast::Surface& F) {
  return static_cast<std::int64_t>(E.mesh().faces.size() + F.mesh().faces.size());
}

}  // namespace pcm::compare
