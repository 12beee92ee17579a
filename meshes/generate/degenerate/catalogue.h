// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "pcm/triangle_mesh.h"

/// Tiny named pairs of surfaces in positions that are hard on every decision of a contact computation. Tests run them
/// as they are and moved by 1 to 8 ulps. All surfaces are fit for contact.
namespace pcm::degenerate {

/// A pair in a pose: x_E = A x_F + r. Lengths in metres.
struct Case {
  std::string name;
  std::string shows;  ///< the degeneracy, in a few words
  TriangleMesh E;
  TriangleMesh F;
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  Eigen::Vector3d r = Eigen::Vector3d::Zero();
  /// Whether moving F's vertices into Me rounds nothing, so that the rounded problem is the exact one.
  bool exactly_representable = true;
  /// Volume of the intersection in the exact problem, worked out by hand, m^3; none where a surface is open or the
  /// figure is of no use.
  std::optional<double> volume;
};

/// E, and F shifted by r.
Case shifted_pair(std::string name, std::string shows, TriangleMesh mesh_E, TriangleMesh mesh_F,
                  std::optional<double> volume = std::nullopt, const Eigen::Vector3d& r = Eigen::Vector3d::Zero());

/// Vertices and edges of the two surfaces that meet exactly, also seen along penetration lines.
std::vector<Case> meeting_features();

/// Faces of the two surfaces in one plane, identical bodies, extreme sizes and places.
std::vector<Case> coplanar_faces();

/// Nested bodies, cavities, several patches, rings, open borders.
std::vector<Case> unusual_topologies();

/// All of them, in this order.
std::vector<Case> catalogue();

/// The case of that name. Throws BadInput, listing the names, where there is none.
Case find_case(const std::string& name);

}  // namespace pcm::degenerate
