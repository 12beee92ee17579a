// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/face_lines.h"

#include <algorithm>

namespace pcm::reference {
namespace {

template <class T>
T weight(const Vec3<T>& x) {
  return x.x + x.y + x.z;
}

int exact_side(const Vec3<Exact>& line, const Vec3<Exact>& x) {
  return sign_of(dot(line, x)) * sign_of(weight(x));
}

bool has_vertex(const Triangle& t, Index v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}

}  // namespace

int own_line_of_edge(const Triangle& t, const std::array<Index, 2>& edge) {
  int i = 0;
  while (t[i] == edge[0] || t[i] == edge[1]) ++i;
  return i;
}

FaceLines::FaceLines(const ExactPose& pose, Side side, Index face, const std::vector<FaceSegment>& segments)
    : pose_(pose), side_(side), face_(face), p_(enclosed_corners(side, face)) {
  for (Index i = 0; i < 3; ++i) lines_.push_back(own_line<Interval>(i, 0, 1));
  for (const FaceSegment& segment : segments) {
    faces_.push_back(segment.face);
    lines_.push_back(line_of_plane(enclosed_corners(other(side), segment.face), p_));
  }
  const auto lies_in_no_plane = [this](int corner) {
    return std::all_of(lines_.begin() + 3, lines_.end(),
                       [corner](const Vec3<Interval>& line) { return certain_sign(line[corner]) != 0; });
  };
  while (apex_ < 3 && !lies_in_no_plane(apex_)) ++apex_;
  apex_ %= 3;
  enter_crossings(segments);
  exact_places_.resize(places_.size());
  exact_lines_.resize(lines_.size());
}

void FaceLines::enter_crossings(const std::vector<FaceSegment>& segments) {
  for (const FaceSegment& segment : segments)
    crossings_.insert(crossings_.end(), segment.ends.begin(), segment.ends.end());
  std::sort(crossings_.begin(), crossings_.end());
  crossings_.erase(std::unique(crossings_.begin(), crossings_.end()), crossings_.end());
  const auto number_of = [this](const CrossingId& id) {
    return static_cast<Index>(std::lower_bound(crossings_.begin(), crossings_.end(), id) - crossings_.begin());
  };
  for (const FaceSegment& segment : segments) ends_.push_back({number_of(segment.ends[0]), number_of(segment.ends[1])});
  for (Index i = 0; i < static_cast<Index>(crossings_.size()); ++i) {
    places_.push_back(enclosed_crossing(i));
    lines_.push_back(line_through_corner<Interval>(apex_, places_.back(), 0));
  }
}

std::array<Vec3<Interval>, 3> FaceLines::enclosed_corners(Side side, Index face) const {
  const Triangle& t = pose_.face(side, face);
  return {interval_point(pose_.enclosure({side, t[0]})), interval_point(pose_.enclosure({side, t[1]})),
          interval_point(pose_.enclosure({side, t[2]}))};
}

/// The segment of the face that one of e's own edges crosses.
Index FaceLines::segment_through(const CrossingId& id) const {
  return static_cast<Index>(std::find(faces_.begin(), faces_.end(), id.face) - faces_.begin());
}

Vec3<Interval> FaceLines::point_on(Index q, Index r) const {
  return point_of_line(interval_point(pose_.enclosure({other(side_), q})),
                       interval_point(pose_.enclosure({other(side_), r})), p_);
}

Vec3<Interval> FaceLines::enclosed_crossing(Index crossing) const {
  const CrossingId& id = crossings_[crossing];
  if (id.edge_side != side_) return point_on(id.edge[0], id.edge[1]);
  return cross(lines_[own_line_of_edge(pose_.face(side_, face_), id.edge)], lines_[line_of(segment_through(id))]);
}

const Vec3<Exact>& FaceLines::exact_crossing(Index crossing) {
  std::optional<Vec3<Exact>>& exact = exact_places_[crossing];
  if (exact) return *exact;
  const CrossingId& id = crossings_[crossing];
  if (id.edge_side == side_)
    exact = cross(exact_line(own_line_of_edge(pose_.face(side_, face_), id.edge)),
                  exact_line(line_of(segment_through(id))));
  else
    exact = point_of_line(pose_.point<Exact>({other(side_), id.edge[0]}),
                          pose_.point<Exact>({other(side_), id.edge[1]}), pose_.corners<Exact>(side_, face_));
  return *exact;
}

const Vec3<Exact>& FaceLines::exact_line(Index i) {
  std::optional<Vec3<Exact>>& exact = exact_lines_[i];
  if (exact) return *exact;
  if (i < 3)
    exact = own_line<Exact>(i, 0, 1);
  else if (is_ray(i))
    exact = line_through_corner<Exact>(apex_, exact_crossing(i - ray_of(0)), 0);
  else
    exact = line_of_plane(pose_.corners<Exact>(other(side_), faces_[i - 3]), pose_.corners<Exact>(side_, face_));
  return *exact;
}

/// Whether the crossing lies on the line for what it is.
bool FaceLines::holds(Index line, Index crossing) const {
  const CrossingId& id = crossings_[crossing];
  const bool on_own_edge = id.edge_side == side_;
  if (line < 3) return on_own_edge && own_line_of_edge(pose_.face(side_, face_), id.edge) == line;
  if (is_ray(line)) return line == ray_of(crossing);
  const Index face = faces_[line - 3];
  if (on_own_edge) return id.face == face;
  const Triangle& t = pose_.face(other(side_), face);
  return has_vertex(t, id.edge[0]) && has_vertex(t, id.edge[1]);
}

LineMeeting FaceLines::meeting(Index a, Index b) const {
  if (is_through_apex(a) && is_through_apex(b)) return {(apex_ + 1) % 3, (apex_ + 2) % 3};
  if (is_ray(a) && holds(b, a - ray_of(0))) return {a, a};
  if (is_ray(b) && holds(a, b - ray_of(0))) return {b, b};
  return {a, b};
}

Vec3<Interval> FaceLines::point(LineMeeting m) const {
  return m.a == m.b ? places_[m.a - ray_of(0)] : cross(lines_[m.a], lines_[m.b]);
}

Vec3<Exact> FaceLines::exact_point(LineMeeting m) {
  return m.a == m.b ? exact_crossing(m.a - ray_of(0)) : cross(exact_line(m.a), exact_line(m.b));
}

int FaceLines::side(Index line, LineMeeting m) {
  if (line == m.a || line == m.b || (m.a == m.b && holds(line, m.a - ray_of(0)))) return 0;
  const Vec3<Interval> x = point(m);
  const int sign = certain_sign(dot(lines_[line], x)) * certain_sign(weight(x));
  return sign != 0 ? sign : exact_side(exact_line(line), exact_point(m));
}

bool FaceLines::is_without_line(Index segment) {
  const Vec3<Interval>& line = lines_[line_of(segment)];
  for (int i = 0; i < 3; ++i)
    if (certain_sign(line[i]) != 0) return false;
  const Vec3<Exact>& exact = exact_line(line_of(segment));
  return sign_of(exact.x) == 0 && sign_of(exact.y) == 0 && sign_of(exact.z) == 0;
}

int FaceLines::coordinate_sign(Index crossing, int i) {
  return side(i, {ray_of(crossing), ray_of(crossing)});
}

int FaceLines::weight_sign(Index crossing) {
  const int sign = certain_sign(weight(places_[crossing]));
  return sign != 0 ? sign : sign_of(weight(exact_crossing(crossing)));
}

int FaceLines::turn(Index a, Index b) {
  return a == b ? 0 : -side(ray_of(a), {ray_of(b), ray_of(b)}) * weight_sign(a);
}

}  // namespace pcm::reference
