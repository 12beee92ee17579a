// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/known_answer_bodies.h"
#include "meshes/triangle_mesh.h"

/// The pairs of smooth bodies whose errors are told apart.
namespace pcm::compare {

/// Two bodies in contact. E is the master; F stands still and E is placed.
struct BudgetMeshes {
  TriangleMesh E;
  TriangleMesh F;
};

/// A pair of bodies over resolutions.
struct BudgetCase {
  std::string title;    ///< in a few words, the master first
  std::string problem;  ///< bodies and pose, in a sentence
  std::size_t levels = 0;
  std::function<BudgetMeshes(std::size_t level)> meshes;
  /// The same bodies scaled until they enclose what the smooth ones do; none where no smooth body is known.
  std::function<BudgetMeshes(std::size_t level)> equal_volume;
  std::function<Placement(int orientation)> placement;
  /// Direction of the force on E between the smooth bodies, in F; absent where it is not known.
  std::function<Eigen::Vector3d(int orientation)> axis_F;
  std::optional<long double> reference;  ///< size of the force between the smooth bodies at stiffness 1, N
  double width = 0;                      ///< of the contact of the smooth bodies, m; 0 where it is not known
};

/// Sphere on plane, sphere on sphere, ball in a near-conforming socket, bubble on bubble; the first `levels`
/// resolutions of each, at most four.
std::vector<BudgetCase> budget_cases(std::size_t levels);

}  // namespace pcm::compare
