// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "compare/verify/bounds/question.h"

namespace pcm::compare {

/// The rounded problem's faces, and what rounding may do to what is computed of them.
class RoundedFaces {
 public:
  struct Face {
    Eigen::Vector3d normal_Me = Eigen::Vector3d::Zero();  ///< unit, null where the area is 0
    double area = 0;
    double area_error = 0;    ///< m^2
    double normal_error = 0;  ///< of the unit normal, at most 2
    double plane_error = 0;   ///< of the height of a point over the face's plane, over its distance from a corner
    double longest = 0;       ///< longest side, m
    double farthest = 0;      ///< greatest |coordinate|, m
  };

  /// O(n) in the vertices and faces. The question's surfaces must outlive this.
  explicit RoundedFaces(const Question& question);

  const SurfaceFeatures& surface(Side side) const { return side == Side::E ? E_ : F_; }
  const Eigen::Vector3d& vertex(Side side, Index v) const {
    const auto i = static_cast<std::size_t>(v);
    return side == Side::E ? E_.mesh.vertices[i] : vertices_F_Me_[i];
  }
  const Eigen::Vector3d& corner(Side side, Index face, std::size_t k) const {
    return vertex(side, surface(side).mesh.faces[static_cast<std::size_t>(face)][k]);
  }
  Face face(Side side, Index face) const;
  /// How many corners of face b lie above the plane of face a, on it and below it, exactly.
  struct Corners {
    int above = 0, on = 0, below = 0;

    bool straddle() const { return above > 0 && below > 0; }
    /// The plane has a line in common with the face's, and that a point with the face.
    bool meet() const { return straddle() || on == 1 || on == 2; }
  };
  Corners corners_by_plane(Side side_a, Index a, Side side_b, Index b) const;
  bool straddles(Side side_a, Index a, Side side_b, Index b) const {
    return corners_by_plane(side_a, a, side_b, b).straddle();
  }
  /// Greatest |coordinate| of either surface in Me, m.
  double max_coordinate() const { return max_coordinate_; }
  /// Bound of the same that the engine makes of both surfaces' boxes, m: |A| x_F + |r| component by component.
  double placed_max_coordinate() const { return placed_max_coordinate_; }
  /// Longest side of any face of either surface, m.
  double longest_side() const { return longest_side_; }

 private:
  const SurfaceFeatures& E_;
  const SurfaceFeatures& F_;
  std::vector<Eigen::Vector3d> vertices_F_Me_;
  double max_coordinate_ = 0;
  double placed_max_coordinate_ = 0;
  double longest_side_ = 0;
};

}  // namespace pcm::compare
