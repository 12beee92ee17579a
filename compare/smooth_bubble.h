// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "compare/known_answer_bodies.h"

/// The smooth body that the meshes of the paper's bubble approximate: its distance from the origin is
/// (length / 3) (1/2 + cos^2 t) at the angle t from the z axis.
namespace pcm::compare {

/// Its volume, (2 pi / 3) (length / 3)^3 229 / 140: the integral of the cube of the distance.
double smooth_bubble_volume(double length);

/// Force on the bubble E placed in another one, F, with E as master and stiffness 1, resolved in F: minus the integral
/// of n u over E's surface, where u is the way along -n from a point inside F to F's surface. By the midpoint rule over
/// `cells` angles from pole to pole and twice as many around; the error is of the order of the square of a cell's share
/// of the contact. An oracle of its own: it knows no mesh.
Eigen::Vector3d smooth_bubble_force(double length, const Placement& placement, int cells = 1500);

}  // namespace pcm::compare
