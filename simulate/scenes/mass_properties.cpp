// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/mass_properties.h"

#include <Eigen/Eigenvalues>

#include "meshes/generate/solid_moments.h"
#include "pcm/bad_input.h"

namespace pcm::simulate {

MassProperties solid_of_density_1(const std::vector<PlacedMesh>& surfaces) {
  MassProperties solid;
  std::vector<MassProperties> parts;
  for (const PlacedMesh& surface : surfaces) {
    const generate::SolidMoments moments = generate::solid_moments(*surface.mesh);
    const Eigen::Matrix3d& R = surface.at_B.R;
    parts.push_back({moments.volume, R * moments.centroid + surface.at_B.p,
                     moments.volume * (R * moments.unit_inertia * R.transpose())});
    solid.mass += parts.back().mass;
    solid.centre_B += parts.back().mass * parts.back().centre_B;
  }
  if (!(solid.mass > 0)) throw BadInput("no solid: the volume within the body's surfaces is not positive");
  solid.centre_B /= solid.mass;
  for (const MassProperties& part : parts) {
    const Eigen::Vector3d d = part.centre_B - solid.centre_B;
    solid.inertia_B +=
        part.inertia_B + part.mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());  // Steiner
  }
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
