// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/mass_properties.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "pcm/bad_input.h"

namespace pcm::simulate {

// Of the tetrahedron (0, a, b, c) with volume V = det(a, b, c) / 6: the integral of x is V (a + b + c) / 4, that of x
// x^T is V / 20 (a a^T + b b^T + c c^T + s s^T), s = a + b + c.
MassProperties solid_of_density_1(const std::vector<PlacedMesh>& surfaces) {
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Eigen::Vector3d apex = Eigen::Vector3d::Zero();
  bool has_apex = false;
  for (const PlacedMesh& surface : surfaces) {
    const auto corner = [&surface](Index vertex) -> Eigen::Vector3d {
      return surface.at_B.R * surface.mesh->vertices[static_cast<std::size_t>(vertex)] + surface.at_B.p;
    };
    // Near the surfaces, so that little cancels.
    if (!has_apex) apex = corner(surface.mesh->faces.front()[0]);
    has_apex = true;
    for (const auto& face : surface.mesh->faces) {
      const Eigen::Vector3d a = corner(face[0]) - apex, b = corner(face[1]) - apex, c = corner(face[2]) - apex;
      const Eigen::Vector3d s = a + b + c;
      const double V = a.dot(b.cross(c)) / 6;
      volume += V;
      first += V / 4 * s;
      second += V / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
  }
  if (!(volume > 0)) throw BadInput("no solid: the volume within the body's surfaces is not positive");
  const Eigen::Vector3d centre = first / volume;
  const Eigen::Matrix3d about_centre = second - volume * centre * centre.transpose();
  MassProperties solid;
  solid.mass = volume;
  solid.centre_B = apex + centre;
  solid.inertia_B = about_centre.trace() * Eigen::Matrix3d::Identity() - about_centre;
  return solid;
}

std::string flaw_of_inertia(const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(moments[0] > 0)) return "a principal moment of inertia is not positive";
  // Ascending. A thin plate has equality, so that roundings decide there.
  if (moments[2] > (moments[0] + moments[1]) * (1 + 1e-9))
    return "a principal moment of inertia exceeds the other two together, as no body's does";
  return {};
}

}  // namespace pcm::simulate
