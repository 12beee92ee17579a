// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reference/crossings/crossings.h"

/// The plane of a face e = (p_0, p_1, p_2) in barycentric coordinates: (x_0, x_1, x_2) stands for the point
/// sum x_i p_i / sum x_i, and (h_0, h_1, h_2) for the line of all x with h . x = 0. No division: with [a b c d] =
/// det[b - a, c - a, d - a], indices of corners modulo 3,
///   the plane of a face f = (f_0, f_1, f_2) meets that of e where h_i = [f_0 f_1 f_2 p_i], its height above f, is 0;
///   the line through q and r meets the plane of e in x_i = [q r p_i+1 p_i+2];
///   the line through p_k and x has h_k = 0, h_k+1 = x_k+2, h_k+2 = -x_k+1.
namespace pcm::reference {

template <class T>
Vec3<T> line_of_plane(const std::array<Vec3<T>, 3>& f, const std::array<Vec3<T>, 3>& p) {
  const Vec3<T> normal = doubled_normal(f[0], f[1], f[2]);
  return {dot(normal, p[0] - f[0]), dot(normal, p[1] - f[0]), dot(normal, p[2] - f[0])};
}

template <class T>
Vec3<T> point_of_line(const Vec3<T>& q, const Vec3<T>& r, const std::array<Vec3<T>, 3>& p) {
  const Vec3<T> along = r - q;
  const std::array<Vec3<T>, 3> from{p[0] - q, p[1] - q, p[2] - q};
  return {determinant(along, from[1], from[2]), determinant(along, from[2], from[0]),
          determinant(along, from[0], from[1])};
}

template <class T>
Vec3<T> line_through_corner(int k, const Vec3<T>& x, const T& zero) {
  if (k == 0) return {zero, x.z, zero - x.y};
  if (k == 1) return {zero - x.z, zero, x.x};
  return {x.y, zero - x.x, zero};
}

/// e's own lines: i is where x_i = 0.
template <class T>
Vec3<T> own_line(Index i, const T& zero, const T& one) {
  return {i == 0 ? one : zero, i == 1 ? one : zero, i == 2 ? one : zero};
}

/// Which of a triangle's own lines holds one of its edges.
int own_line_of_edge(const Triangle& t, const std::array<Index, 2>& edge);

/// What a face f of the other surface has in common with e: a segment between two crossings.
struct FaceSegment {
  Index face = 0;
  std::array<CrossingId, 2> ends;
};

/// A point of the plane by name: where two lines meet, or where a == b, the crossing on that ray.
struct LineMeeting {
  Index a = 0, b = 0;
};

/// Lines and points of one face that is crossed, enclosed and exactly: signs are decided by enclosures, and by exact
/// numbers where these do not tell. Lines are numbered: 0 to 2 e's own, then one for each segment, the trace of its
/// face's plane, then a ray for each crossing, from one corner of e, the apex.
///
/// To be used while the rounding mode is upward (CGAL::Protect_FPU_rounding); exact numbers do not mind.
class FaceLines {
 public:
  /// The pose must outlive this. e has area.
  FaceLines(const ExactPose& pose, Side side, Index face, const std::vector<FaceSegment>& segments);

  /// The first corner that surely lies in no plane of a segment; the first of all where there is none.
  int apex() const { return apex_; }
  Index segment_count() const { return static_cast<Index>(faces_.size()); }
  Index face_of(Index segment) const { return faces_[segment]; }
  Index line_of(Index segment) const { return 3 + segment; }
  const std::array<Index, 2>& ends_of(Index segment) const { return ends_[segment]; }
  const std::vector<Index>& faces() const { return faces_; }
  const std::vector<CrossingId>& crossings() const { return crossings_; }
  Index ray_of(Index crossing) const { return 3 + segment_count() + crossing; }

  const Vec3<Interval>& line(Index i) const { return lines_[i]; }
  LineMeeting meeting(Index a, Index b) const;
  /// x_0, x_1, x_2 of one sign.
  Vec3<Interval> point(LineMeeting m) const;
  Vec3<Exact> exact_point(LineMeeting m);

  /// On which side of the segment's line the apex lies; 0 where that is not certain.
  int apex_side(Index segment) const { return certain_sign(lines_[line_of(segment)][apex_]); }
  /// Whether the segment's face has no plane or e's.
  bool is_without_line(Index segment);
  /// On which side of the line the point lies, 0 on it.
  int side(Index line, LineMeeting m);
  /// Sign of a crossing's coordinate x_i, all three being of one sign otherwise.
  int coordinate_sign(Index crossing, int i);
  /// 1 where seen from the apex, e being counterclockwise, the ray of b lies left of that of a, 0 where they are one.
  int turn(Index a, Index b);

  /// The point of e's plane on the line of an edge of the other surface.
  Vec3<Interval> point_on(Index q, Index r) const;

 private:
  std::array<Vec3<Interval>, 3> enclosed_corners(Side side, Index face) const;
  void enter_crossings(const std::vector<FaceSegment>& segments);
  Vec3<Interval> enclosed_crossing(Index crossing) const;
  const Vec3<Exact>& exact_crossing(Index crossing);
  const Vec3<Exact>& exact_line(Index i);
  Index segment_through(const CrossingId& id) const;
  int weight_sign(Index crossing);
  bool holds(Index line, Index crossing) const;
  bool is_ray(Index line) const { return line >= ray_of(0); }
  bool is_through_apex(Index line) const { return is_ray(line) || (line < 3 && line != apex_); }

  const ExactPose& pose_;
  Side side_;
  Index face_;
  std::array<Vec3<Interval>, 3> p_;
  int apex_ = 0;
  std::vector<Index> faces_;
  std::vector<std::array<Index, 2>> ends_;
  std::vector<CrossingId> crossings_;   ///< each once, ascending
  std::vector<Vec3<Interval>> places_;  ///< of crossings
  std::vector<std::optional<Vec3<Exact>>> exact_places_;
  std::vector<Vec3<Interval>> lines_;
  std::vector<std::optional<Vec3<Exact>>> exact_lines_;
};

}  // namespace pcm::reference
