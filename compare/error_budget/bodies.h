// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/known_answers.h"
#include "pcm/triangle_mesh.h"

/// The pairs of smooth bodies whose errors are told apart, and what each error must be.
namespace pcm::compare {

/// Two bodies in contact. E is the master; F stands still and E is placed.
struct BudgetMeshes {
  TriangleMesh E;
  TriangleMesh F;
};

/// What one kind of error must be, relative to the force between the smooth bodies, on the mean over the orientations.
struct Expectation {
  Band finest;                ///< at the finest level
  std::optional<Band> order;  ///< in edge length
  std::string reason;         ///< why, in a few words
};

/// A pair of bodies over resolutions.
struct BudgetCase {
  std::string id;         ///< a file name
  std::string title;      ///< in a few words, the master first
  std::string problem;    ///< bodies and pose, in a sentence
  std::string reference;  ///< where the smooth bodies' force comes from
  std::size_t levels = 0;
  double width = 0;                                        ///< of the contact of the smooth bodies, m
  std::function<std::string(std::size_t level)> in_words;  ///< the meshes
  std::function<double(std::size_t level)> edge;           ///< root mean square edge length of the master, m
  std::function<BudgetMeshes(std::size_t level)> meshes;
  /// The same bodies made larger until they enclose what the smooth ones do.
  std::function<BudgetMeshes(std::size_t level)> equal_volume;
  std::function<Placement(int orientation)> placement;
  std::function<Eigen::Vector3d(int orientation)> force_F;  ///< on E, between the smooth bodies at stiffness 1, N
  Expectation discretisation;
  Expectation one_pose;  ///< length of the difference, without regard to its sign
  Expectation geometry;
  Expectation geometry_equal_volume;
};

/// An expectation from the leading term of an error of second order: within `off` of it at the finest level of the full
/// extent, four times that where coarser meshes are the finest and fewer orientations are averaged over.
Expectation second_order(double leading, double off, Extent extent, const std::string& reason);

/// Second order alone, where the leading term is not known.
Expectation second_order(Extent extent, const std::string& reason);

/// Within `bound` at the finest level: what has no leading term of second order, or scatters.
Expectation no_more_than(double bound, const std::string& reason);

/// Levels of refinement of every case; each halves the edges of the one before.
inline std::size_t budget_levels(Extent extent) {
  return extent == Extent::full ? 4 : 3;
}

/// Over which the means are taken.
inline int budget_orientations(Extent extent) {
  return extent == Extent::full ? kOrientations : 5;
}

/// Pairs of spheres and planes, of cylinders, and the paper's bubbles; one file each.
std::vector<BudgetCase> budget_of_spheres(Extent extent);
std::vector<BudgetCase> budget_of_cylinders(Extent extent);
std::vector<BudgetCase> budget_of_bubbles(Extent extent);

/// The mesh made larger about the origin, until a volume that is `now` has become `wanted`.
TriangleMesh scaled_to_volume(TriangleMesh mesh, double now, double wanted);

/// Volume enclosed by a closed surface, m^3.
double enclosed_volume(const TriangleMesh& mesh);

}  // namespace pcm::compare
