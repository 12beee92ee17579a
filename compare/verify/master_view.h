// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "compare/verify/rounded_faces.h"

namespace pcm::compare {

/// What a master face sees of a slave face, in double precision, and how far off a right engine may see it.
struct SlaveInView {
  int hiders = 0;          ///< no more other faces may hide any of it
  double strip = 0;        ///< an edge may be off by as much, m
  double uncertain = 0;    ///< a part of no more area may be dropped, m^2
  double neglected = 0;    ///< parts that are dropped, or kept though hidden, have in all no more, m^2
  double area = 0;         ///< of what nothing but the border of both and depth 0 limits, m^2
  double depth_error = 0;  ///< at a point of the plane, without any shift of it, m
  double slope = 0;        ///< of the depth
  double outline = 0;      ///< its border, m
  double fold = 0;         ///< the part of that where the depth is 0, m
  double width = 0;        ///< no two points of it are farther apart, m
  double deepest = 0;      ///< there, m
  double at_tip = 0;       ///< the depth of its deepest corner, m
  double at_lowest = 0;    ///< and of its least deep one, m
  double tip_error = 0;    ///< what strips may take from that, m
};

/// The rounded problem as one master face sees it: every vertex by two lengths in the master's plane and its depth.
class MasterView {
 public:
  /// Only for a master of area > 0. O(n) in vertices and faces. The faces must outlive this.
  MasterView(const RoundedFaces& faces, Side master, Index master_face);

  Side master() const { return master_; }
  Index master_face() const { return master_face_; }
  /// How far off the direction of the penetration lines may be, as an angle.
  double turn() const { return turn_; }
  /// No more than this has the face, whatever is seen of it, m^2.
  double greatest_area() const { return face_.area + face_.area_error; }
  /// O(n) in the faces that the master's lines meet.
  SlaveInView sight(Index slave_face) const;

 private:
  /// A point of the master's plane in lengths along two directions at right angles, m, and a depth, m.
  using SeenPoint = Eigen::Vector3d;
  using SeenFace = std::array<SeenPoint, 3>;
  /// Faces that may hide something of a slave face.
  struct Hiders {
    int count = 0;
    /// Their sides, where their depth is 0, and where they pass through the slave face: that may part what is seen.
    int lines = 0;
    int loose = 0;        ///< those of them on which no two of these faces meet
    double distance = 0;  ///< no corner of theirs is farther from p0, m
    double place = 0;     ///< nor worse placed, m
  };
  struct Extent {
    Eigen::Array3d low, high;  ///< m
  };

  /// A face that the lines of the master may meet.
  struct NearFace {
    Side side;
    Index face;
    Extent extent;
  };

  SeenFace seen(Side side, Index face) const;
  void find_near_faces();
  static Extent extent(std::span<const SeenPoint> polygon);
  /// What the master sees of a face at a depth >= 0.
  std::vector<SeenPoint> seen_part(const SeenFace& slave) const;
  /// Whether a side of a has all corners of b on its far side, by more than `strip` or shared with it: no right engine
  /// takes these faces to overlap.
  bool side_parts(Side side_a, Index a, Side side_b, Index b, double strip) const;
  /// Whether a side of the face has all of the polygon on its far side, by more than `strip`.
  bool side_parts(Side side, Index face, const std::vector<SeenPoint>& polygon, double strip) const;
  /// How the lines meet b and a, by the plane of either: 1 surely b only after a, -1 surely b first, 0 neither is sure.
  int order(Side side_b, Index b, Side side_a, Index a) const;
  /// Which side of a's plane all corners of b lie on that a has not, as the lines run: 1 beyond it, -1 before it, 0
  /// where roundings can't tell or on both.
  int side_of_plane(Side side_a, Index a, Side side_b, Index b) const;
  Hiders find_hiders(Index slave_face, const std::vector<SeenPoint>& part, double strip) const;
  /// s and t of a point.
  void limit(SlaveInView& sight) const;
  Eigen::Array2d weights(const SeenPoint& point) const;
  /// How far off a point may be seen by MasterPrism::uncertainty, m.
  double place_error(const SeenPoint& point) const;
  void add_uncertain_areas(const std::vector<SeenPoint>& part, double place, const Hiders& hiders,
                           SlaveInView& sight) const;
  double strip(double distance, double depth) const;

  const RoundedFaces& faces_;
  Side master_;
  Index master_face_;
  RoundedFaces::Face face_;
  double turn_;  ///< rad
  double tilt_;  ///< as MasterPrism::tilt, rad
  double skew_;  ///< |p1 - p0| |p2 - p0| over twice the area
  SeenFace own_;
  SeenPoint side_s_, side_t_;                       ///< p1 - p0 and p2 - p0
  double length_s_, length_t_;                      ///< m
  std::array<std::vector<SeenPoint>, 2> vertices_;  ///< of E and F
  std::vector<NearFace> near_;
};

}  // namespace pcm::compare
