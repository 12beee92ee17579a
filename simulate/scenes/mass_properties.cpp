// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/mass_properties.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "meshes/generate/solid_moments.h"
#include "pcm/bad_input.h"

namespace pcm::simulate {

namespace {

/// Steiner's term: of a mass at a point, about the origin.
Eigen::Matrix3d inertia_of_point(double mass, const Eigen::Vector3d& at) {
  return mass * (at.squaredNorm() * Eigen::Matrix3d::Identity() - at * at.transpose());
}

}  // namespace

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
  for (const MassProperties& part : parts)
    solid.inertia_B += part.inertia_B + inertia_of_point(part.mass, part.centre_B - solid.centre_B);
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

std::string flaw_of_mass(const MassProperties& body) {
  const Eigen::Matrix3d about_B = body.inertia_B + inertia_of_point(body.mass, body.centre_B);
  const auto is_normal = [](double x) { return std::isnormal(x); };
  const Eigen::Vector3d moments = about_B.diagonal(), of_unit_mass = moments / body.mass;
  if (is_normal(body.mass) && std::all_of(moments.begin(), moments.end(), is_normal) &&
      std::all_of(of_unit_mass.begin(), of_unit_mass.end(), is_normal) && (about_B / body.mass).allFinite())
    return {};
  return "its mass, its inertia about B's origin or their ratio is no number that a double holds with all its digits";
}

}  // namespace pcm::simulate
