// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "simulate/scenes/scene.h"

namespace pcm::simulate {

/// A closed surface in its body.
struct PlacedMesh {
  const TriangleMesh* mesh;
  Placement at_B;
};

/// Mass properties of the solid of density 1 that closed, outward oriented surfaces bound, as if none overlapped.
/// Throws BadInput where the volume is not positive.
MassProperties solid_of_density_1(const std::vector<PlacedMesh>& surfaces);

/// Why no rigid body has these principal moments of inertia; empty if one may: all positive, none greater than the
/// other two together, beyond roundings.
std::string flaw_of_inertia(const Eigen::Matrix3d& inertia);

/// Why equations of motion can't be set up with these; empty if they can: the mass, the moments of inertia about B's
/// origin and their ratios are normal doubles.
std::string flaw_of_mass(const MassProperties& body);

}  // namespace pcm::simulate
