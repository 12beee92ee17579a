// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "compare/verify/bounds/rounded_faces.h"
#include "compare/verify/bounds/seen_polygon.h"

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
  double outline = 0;      ///< no longer is the border of what a right engine may see of it, m
  double parting = 0;      ///< lines at which faces that hide some of it end, within it, m
  double mistaken = 0;   ///< where roundings may hide it, or not: a hider has its depth, or depth 0, but for them, m^2
  double surfacing = 0;  ///< where they may see it or not: its own depth is 0 but for them, m^2
  double width = 0;      ///< no two points of what a right engine may see are farther apart, m
  double deepest = 0;    ///< there, m
  double at_tip = 0;     ///< the depth of its deepest corner, m
  double at_lowest = 0;  ///< and of its least deep one, m
  double tip_error = 0;  ///< what strips may take from that, m
};

/// A line, to either side as far as it may lie over both faces, at which what a right engine sees of a slave face may
/// end.
struct SightLine {
  /// As deep as the slave face is there, or 0 where that lies above the master.
  SeenPoint from = SeenPoint::Zero(), to = SeenPoint::Zero();
  /// Where on it, as ways from `from`, something may begin to hide the slave face, m: elsewhere, or all along where the
  /// first is beyond the last, it parts nothing but pieces of what is seen.
  double first = 0, last = 0;
  double off = 0;  ///< it may lie as far beside, m; infinite: nothing is known
  /// As the slave's surface moves by d, seen from the master, the line moves by pull . d(X) along its normal, the
  /// direction from `from` to `to` turned by a right angle; X lies on it, this deep at either end.
  SeenPoint pull = SeenPoint::Zero();
  double pull_error = 0;
  double from_depth = 0, to_depth = 0;  ///< m
  double depth_error = 0;               ///< of these, m
  /// A side of a face, where it may begin to hide something surely before the slave face; or the master's.
  bool surely_before = false;
  /// A side beyond which the same is seen to go on: the master, in its plane, or the slave's sheet. What is summed over
  /// both faces that end there does not hang on where it lies.
  struct Continuation {
    enum class Of { nothing, master, slave } of = Of::nothing;
    /// The side's length over how far the face beyond reaches from it: near its ends that face is narrower than a
    /// width over as many widths.
    double taper = std::numeric_limits<double>::infinity();
    double turn = 0;  ///< of a right engine's lines from one master face to the other, rad
  } continuation;
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
  /// How much deeper than anywhere over the master roundings of the cuts by its sides may leave the slave face, m;
  /// `strip` is that of its sight. That the engine sees its corners a little off is not counted.
  double overshoot(Index slave_face, double strip) const;
  /// All lines at which what a right engine sees of the slave face may end. O(n) in the faces that the master's lines
  /// meet.
  std::vector<SightLine> lines_in_sight(Index slave_face) const;
  /// A point of the slave face that moves by d, seen from the master, is deeper by pull . d.
  struct DepthGrowth {
    SeenPoint pull = SeenPoint::Zero();
    double error = 0;
  };
  DepthGrowth depth_growth(Index slave_face) const;
  /// Where the slave face is that deep but for the error, m^2.
  double area_about_depth(Index slave_face, double depth, double error) const;
  double longest_side() const { return face_.longest; }
  double max_coordinate() const { return faces_.placed_max_coordinate(); }
  Eigen::Vector3d direction_Me(const SeenPoint& direction) const { return seen_from_Me_.transpose() * direction; }
  Eigen::Vector3d point_Me(const SeenPoint& point) const {
    return faces_.corner(master_, master_face_, 0) + direction_Me(point);
  }

 private:
  struct Extent {
    Eigen::Array3d low, high;  ///< m
  };

  /// A face that the lines of the master may meet.
  struct NearFace {
    Side side;
    Index face;
    Extent extent;
  };

  /// A side of faces that may hide something.
  struct HidingSide {
    SeenPoint from, to;
    bool joins;  ///< two of these faces, surely on either side of it: nothing can be seen between them
  };
  /// Faces that may hide something of a slave face.
  struct Hiders {
    std::vector<const NearFace*> faces;
    std::vector<HidingSide> sides;  ///< each once
    /// Of lines where their depth is 0, and where they pass through the slave face, m: these may part it as well.
    double folds = 0;
    double mistaken = 0;  ///< where roundings may mistake a depth of theirs for 0 or that of the slave face, m^2
    double distance = 0;  ///< no corner of theirs is farther from one of the master, m
    double place = 0;     ///< nor worse placed, m
  };
  /// Collects the lines of sight.
  class LineList;

  /// A face's depth as a linear function of the point.
  struct DepthField {
    SeenPoint corner;
    SeenPoint normal;    ///< of the face, unit
    double turn;         ///< how far off its angle to the master's may be, rad
    double plane_error;  ///< RoundedFaces::Face
    Eigen::Vector2d slope;
    double reach;               ///< no corner of the face is farther from one of the master, m
    double error;               ///< of the depth between its corners, m
    double error_per_distance;  ///< and from a corner on, through the direction of its plane

    /// How much deeper it is for a motion of its points of length 1.
    SeenPoint growth() const { return normal / normal.z(); }
    double at(const SeenPoint& x) const { return corner.z() + slope.dot((x - corner).head<2>()); }
    /// Of depths told by this plane and another face's corners, m.
    double error_between(const DepthField& other) const {
      return error + times(error_per_distance, reach + other.reach);
    }
  };

  SeenFace seen(Side side, Index face) const;
  DepthField depth_field(Side side, Index face, double strip) const;
  bool is_sliver(Side side, Index face, double strip) const;
  /// Whether the master is wider than a strip, so that strips along its sides leave something of it.
  bool is_wider_than(double strip) const { return 2 * face_.area / face_.longest > strip; }
  /// Where the master, a and b, each grown by `margin`, lie over one another: a convex polygon. `margin` must be less
  /// than twice the master's width.
  std::vector<SeenPoint> overlap(const SeenFace& a, const SeenFace& b, double margin) const;
  void find_near_faces();
  static Extent extent(std::span<const SeenPoint> polygon);
  /// What the master, grown by `margin`, sees of a face no more than `rise` above its plane, m.
  std::vector<SeenPoint> seen_part(const SeenFace& slave, double margin, double rise) const;
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
  /// `slivers`: also faces that are seen no wider than a strip and have a corner in common with the slave face, on
  /// whichever side of that they lie. They hide no more than a strip does, but may be all that ends there.
  Hiders find_hiders(Index slave_face, const std::vector<SeenPoint>& part, double strip, bool slivers = false) const;
  /// Whether the hider begins at an edge of the slave face to hide the face beyond it, which is level with the hider
  /// but not in its plane, while the slave face is either not level with it or in its plane.
  bool hides_level_face_beyond(Index slave_face, const NearFace& hider, double strip) const;
  /// The lines at which the face begins to hide something of the slave face, rather than end: no more than `most` each.
  void add_folds(Index slave_face, const NearFace& hider, double strip, double most, Hiders& hiders) const;
  /// What goes on beyond side k of the master or of the slave face.
  SightLine::Continuation continuation_beyond(Side side, Index face, std::size_t k) const;
  /// The sides of these faces of E and F, each once.
  std::vector<HidingSide> hiding_sides(const std::vector<const NearFace*>& hiders, double strip) const;
  /// What of the side, or of the line that it lies on, may lie over the master as well as over the slave face, where
  /// both may reach farther by `margin`, m.
  double length_within(const HidingSide& side, bool whole_line, const SeenFace& slave, double margin) const;
  /// What of the line through a point, along a direction of length 1, may lie over the master as well as over the slave
  /// face: from here to there, m. Nothing where the first is beyond the second.
  std::pair<double, double> span_within(const SeenPoint& through, const SeenPoint& along, const SeenFace& slave,
                                        double margin) const;
  /// Along whole lines of the hiders' sides, m: no more than `most` each, where they are off by `strip` at their ends.
  double cuts_within(const Hiders& hiders, const SeenFace& slave, const std::vector<SeenPoint>& part, double strip,
                     double width, double most) const;
  /// The greatest depth at which a right engine may see the slave face, but for the error of a depth, m.
  double deepest_over_master(Index slave_face, double strip) const;
  void limit(SlaveInView& sight) const;
  /// Of the corner farthest away, from one of which each weight is taken, m.
  double distance_from_corners(const SeenPoint& point) const;
  /// s and t of a point.
  Eigen::Array2d weights(const SeenPoint& point) const;
  /// How far off a point may be seen by MasterPrism::uncertainty, m.
  double place_error(const SeenPoint& point) const;
  void add_uncertain_areas(const SeenFace& slave, const std::vector<SeenPoint>& part, double place,
                           const Hiders& hiders, SlaveInView& sight) const;
  double strip(double distance, double depth) const;
  /// For whatever may hide something of the slave face as well.
  double most_strip(const SeenFace& slave) const;

  const RoundedFaces& faces_;
  Side master_;
  Index master_face_;
  RoundedFaces::Face face_;
  double turn_;                   ///< rad
  double tilt_;                   ///< as MasterPrism::tilt, rad
  double skew_;                   ///< |p1 - p0| |p2 - p0| over twice the area
  Eigen::Matrix3d seen_from_Me_;  ///< a direction's components along both and as a depth
  SeenFace own_;
  SeenPoint side_s_, side_t_;                       ///< p1 - p0 and p2 - p0
  double length_s_, length_t_;                      ///< m
  std::array<std::vector<SeenPoint>, 2> vertices_;  ///< of E and F
  std::vector<NearFace> near_;
};

}  // namespace pcm::compare
