// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

#include "compare/published/surface.h"
#include "fast/base/geometry.h"

namespace pcm::compare::published {

/// The normal of a master face through its barycentre, and the plane of the face in a basis of its own (8), (9).
struct PenetrationLine {
  Eigen::Vector3d C_Me;          ///< C_e, m
  Eigen::Vector3d n_Me;          ///< n_k = -n_e, along which penetration counts (7)
  Eigen::Vector3d b1_Me, b2_Me;  ///< with n_k right-handed

  explicit PenetrationLine(const fast::FaceGeometry& master)
      : C_Me(master.barycentre_Me()),
        n_Me(-master.n_Me),
        b1_Me((master.points_Me[1] - master.points_Me[0]).normalized()),
        b2_Me(n_Me.cross(b1_Me)) {}
};

/// The face of the slave that the line meets first.
struct FirstMet {
  Index face = -1;
  double depth = std::numeric_limits<double>::infinity();  ///< u (11), m
  bool leaves = false;                                     ///< the line leaves the slave there
};

/// Whether a line through an edge of a face meets it: not by (10), which is strict.
enum class Edges : std::uint8_t { excluded, included };

/// (9) to (11): projects the face on the plane of the line's basis. It is met, and left by the line, where the
/// barycentre lies on the inside of all edges (10); a face that the line enters is run round the other way. `first` is
/// replaced by what is met nearer, at u >= 0. The paper looks for a face to leave alone; where the slave is entered
/// before, that would be a penetration of a point outside.
template <Edges edges>
void look_for_first(const PenetrationLine& line, Index f, const PosedFace& face, FirstMet& first) {
  std::array<std::array<double, 2>, 3> r;
  const auto project = [&](std::size_t k) {
    const Eigen::Vector3d from_C = face.points_Me[k] - line.C_Me;
    r[k] = {line.b1_Me.dot(from_C), line.b2_Me.dot(from_C)};
  };
  // Whether edge (i, j) runs round C in one sense or the other: det[r_j - r_i, -r_i] = r_i x r_j.
  bool leaves = true, enters = true;
  const auto pass = [&](std::size_t i, std::size_t j) {
    const double det = r[i][0] * r[j][1] - r[i][1] * r[j][0];
    leaves = leaves && (edges == Edges::included ? det >= 0 : det > 0);
    enters = enters && (edges == Edges::included ? det <= 0 : det < 0);
    return leaves || enters;
  };
  project(0);
  project(1);
  if (!pass(0, 1)) return;
  project(2);
  if (!pass(1, 2) || !pass(2, 0)) return;
  const double u = (face.points_Me[0] - line.C_Me).dot(face.N_Me) / line.n_Me.dot(face.N_Me);  // (11)
  if (u >= 0 && u < first.depth) first = {f, u, leaves};
}

}  // namespace pcm::compare::published
