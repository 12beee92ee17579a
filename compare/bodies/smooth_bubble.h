// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "compare/bodies/known_answer_bodies.h"

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

/// How the meshes of a bubble stand for the smooth one.
struct BubbleMesh {
  Index finer = 1;            ///< as in generate::bubble
  bool equal_volume = false;  ///< made larger until it encloses the smooth one's volume
};

/// What both bubbles being such meshes takes from that force, to leading order in the edge length. Their rectangles of
/// sides a along a meridian and b across, cut in two, lie (k_a a^2 + k_b b^2) / 12 inside the surface of curvatures
/// k_a, k_b on the mean; what is made larger lies outside by its part of x . n. E's share counts as it is, F's divided
/// by the cosine between the surfaces.
Eigen::Vector3d force_lost_to_meshes(double length, const Placement& placement, const BubbleMesh& mesh,
                                     int cells = 500);

}  // namespace pcm::compare
