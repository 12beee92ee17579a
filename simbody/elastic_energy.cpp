// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "fast/force/law_parameters.h"
#include "pcm/simbody.h"

namespace pcm::simbody {
namespace {

std::array<Eigen::Vector3d, 3> corners_Me(const TriangleMesh& mesh, Index face, Side side, const Pose& pose) {
  std::array<Eigen::Vector3d, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& vertex =
        mesh.vertices[static_cast<std::size_t>(mesh.faces[static_cast<std::size_t>(face)][k])];
    corners[k] = side == Side::E ? vertex : Eigen::Vector3d(pose.A * vertex + pose.r);
  }
  return corners;
}

/// Depth at a point of the master face: how far the plane of the slave face is along n_k (11).
double depth_at(const Eigen::Vector3d& x_Me, const fast::Element& e, const fast::Pairing& pairing, const Pose& pose) {
  const Side slave = opposite(e.master);
  const TriangleMesh& mesh = (slave == Side::E ? pairing.surface_E() : pairing.surface_F()).mesh();
  const std::array<Eigen::Vector3d, 3> c = corners_Me(mesh, e.slave_face, slave, pose);
  const Eigen::Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]);
  return (c[0] - x_Me).dot(normal) / e.normal_Me.dot(normal);
}

}  // namespace

double elastic_force(const fast::Pairing& pairing, const fast::Element& element) {
  return fast::SeriesStiffness(pairing.law()).c_l * element.area * element.penetration;
}

double elastic_energy(const fast::Pairing& pairing, const Pose& pose, const fast::Contact& contact) {
  const fast::SeriesStiffness stiffness(pairing.law());
  double sum = 0;
  for (const fast::Element& e : contact.elements) {
    double depth = e.penetration;
    if (pairing.scheme() == Scheme::clipped && !contact.penetration_exceeded) {
      const Eigen::Vector3d centroid_Me =
          e.position_Me -
          (e.master == Side::E ? stiffness.shift_from_E : stiffness.shift_from_F) * e.penetration * e.normal_Me;
      const double at_centroid = depth_at(centroid_Me, e, pairing, pose);
      // A face met nearly edgewise: by roundings anything, but never less than the mean, nor more than the greatest.
      if (at_centroid > depth) depth = std::min(at_centroid, contact.max_penetration);
    }
    sum += e.area * e.penetration * depth;
  }
  const double energy = stiffness.c_l * sum / 2;
  return pairing.mode() == Mode::both ? energy / 2 : energy;
}

}  // namespace pcm::simbody
