// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <map>
#include <optional>
#include <vector>

#include "reference/lines/visibility_lines.h"
#include "reference/pose/converted_pose.h"

/// What a master face sees along its penetration lines (PCM section 6, clipped scheme): lines in its plane, exactly.
namespace pcm::reference {

/// The side of a line in the master's plane on which sign * (a s + b t + c) >= 0.
struct HalfPlane {
  Index line = 0;  ///< in the MasterPlane
  int sign = 1;
};

inline HalfPlane opposite(HalfPlane h) {
  return {h.line, -h.sign};
}

/// A face as the master face sees it along N.
struct SeenFace {
  int facing = 0;                  ///< sign of N . N_g; 0: edge-on, never met, and the rest is not set
  std::array<HalfPlane, 3> sides;  ///< of its projection, inwards
  std::optional<HalfPlane> ahead;  ///< where its depth d_g >= 0; none where d_g = 0 throughout
};

/// The pose's points as enclosures, for both problems at once, and exactly; converted once for all master faces.
struct VisibilityPoints {
  explicit VisibilityPoints(const ExactPose& pose)
      : enclosed(ConvertedPose<Interval>::of_both_problems(pose)), exact(pose) {}
  ConvertedPose<Interval> enclosed;
  ConvertedPose<Exact> exact;
  /// Enclosures and connectivity decided all that was asked, or numbers of E alone: so it holds in both problems.
  bool robust = true;
};

/// The plane of one master face e with all lines asked for so far. A point of it is p0 + s (p1 - p0) + t (p2 - p0).
///
/// Signs are decided by intervals, then by exact numbers. Zeros that the meshes' connectivity explains are known
/// without either: a line that is the projection of an edge shared by two faces is one line, the planes of two faces
/// with a common edge meet in it, and three lines through the projection of one vertex meet there.
///
/// To be used while the rounding mode is upward (CGAL::Protect_FPU_rounding); exact numbers do not mind.
class MasterPlane {
 public:
  /// Pose and points must outlive this.
  MasterPlane(VisibilityPoints& points, Face master);

  Face master() const { return master_; }
  const MasterFrame<Interval>& frame() const { return enclosed_; }

  const SeenFace& see(Face g);

  /// Where d_f >= d_g, for two faces that are not seen edge-on; none where d_f = d_g throughout.
  std::optional<HalfPlane> deeper(Face f, Face g);

  /// Depth d_g as a fraction, numerator linear in (s, t, 1).
  Depth<Interval> depth(Face g);

  /// Where two lines meet that bound a convex polygon one after the other, counterclockwise: the last component of the
  /// homogeneous coordinates (s, t, 1) is positive.
  Vec3<Interval> corner(HalfPlane first, HalfPlane second) const;

  /// On which side of h that corner lies, `at` being its enclosure: 1 within, -1 without, 0 on the line.
  int side(HalfPlane h, HalfPlane first, HalfPlane second, const Vec3<Interval>& at);

  /// The same by enclosures and connectivity only: nothing where they do not tell.
  std::optional<int> quick_side(HalfPlane h, HalfPlane first, HalfPlane second, const Vec3<Interval>& at) const;

  const VisibilityLine& name(HalfPlane h) const { return lines_[h.line].name; }

 private:
  struct Line {
    VisibilityLine name;
    std::array<Vertex, 2> through;  ///< vertices whose projections lie on it; index kNone where there is none
    Vec3<Interval> enclosed;        ///< scaled by a power of two to about 1
    std::optional<Vec3<Exact>> exact;
  };

  Index find_line(const VisibilityLine& name, const std::array<Vertex, 2>& through);
  HalfPlane side_of(Face g, int facing, int corner);
  const Vec3<Exact>& exact_line(Index line);
  bool vanishes(Index line);
  bool of_E_only(Index line) const;
  Vec3<Interval> enclosed_line(HalfPlane h) const;

  VisibilityPoints& points_;
  Face master_;
  MasterFrame<Interval> enclosed_;
  std::optional<MasterFrame<Exact>> exact_;
  std::vector<Line> lines_;
  std::map<VisibilityLine, Index> known_lines_;
  std::map<Face, SeenFace> seen_;
};

}  // namespace pcm::reference
