// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/penetration_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::reference {
namespace {

EnclosedLine make_line(const std::array<Vec3<Interval>, 3>& p) {
  const Vec3<Interval> v1 = p[1] - p[0], v2 = p[2] - p[0], N = cross(v1, v2);
  return {{p[0] + p[1] + p[2], N}, p[0], cross(v1 + v2, N)};
}

Vec3<Shifted> constant(const Vec3<Exact>& x) {
  return {{x.x, 0, 0}, {x.y, 0, 0}, {x.z, 0, 0}};
}

std::array<Vec3<Shifted>, 3> constant(const std::array<Vec3<Exact>, 3>& p) {
  return {constant(p[0]), constant(p[1]), constant(p[2])};
}

template <class T>
FaceNumbers<T> make_face(const std::array<Vec3<T>, 3>& p) {
  return {p, doubled_normal(p[0], p[1], p[2])};
}

std::array<Vec3<Interval>, 3> rounding_corners(const ExactPose& pose, Side side, Index face) {
  const Triangle& t = pose.face(side, face);
  return {interval_point(pose.rounding_box({side, t[0]})), interval_point(pose.rounding_box({side, t[1]})),
          interval_point(pose.rounding_box({side, t[2]}))};
}

/// The sign of the first coefficient that is not 0.
int sign_of(const Shifted& x) {
  if (const int sign = reference::sign_of(x.a); sign != 0) return sign;
  if (const int sign = reference::sign_of(x.b); sign != 0) return sign;
  return reference::sign_of(x.c);
}

/// The permuted inner product of the line and the directed edge, thrice: of one sign for all edges of a face that the
/// line passes through.
Interval inner_product(const EnclosedLine& line, const Vec3<Interval>& f_i, const Vec3<Interval>& f_j) {
  const Vec3<Interval> moment = cross(f_i - line.p0, f_j - line.p0);
  return Interval(3) * dot(line.N, moment) + dot(line.moment3, f_j - f_i);
}

/// q = -height / (3 slope).
template <class T>
T height(const LineNumbers<T>& line, const FaceNumbers<T>& f) {
  return dot(T(3) * f.corners[0] - line.C3, f.normal);
}
template <class T>
T slope(const LineNumbers<T>& line, const FaceNumbers<T>& f) {
  return dot(line.N, f.normal);
}

/// The point x at which the line meets the plane of a face that it is not parallel to.
template <class T>
struct PlanePoint {
  const LineNumbers<T>& line;
  T slope, height;
  /// 3 slope (x - a).
  Vec3<T> from(const Vec3<T>& a) const { return slope * (line.C3 - T(3) * a) + height * line.N; }
};

template <class T>
PlanePoint<T> point_in_plane(const LineNumbers<T>& line, const FaceNumbers<T>& f) {
  return {line, slope(line, f), height(line, f)};
}

/// (q_b - q_a) * 3 slope_a slope_b: the height, above the plane of b, of the point where the line meets that of a.
template <class T>
T height_above(const LineNumbers<T>& line, const FaceNumbers<T>& a, const FaceNumbers<T>& b) {
  return dot(point_in_plane(line, a).from(b.corners[0]), b.normal);
}

/// Whether the point lies in the face: its barycentric coordinates are positive.
bool is_within(const PlanePoint<Shifted>& x, const FaceNumbers<Shifted>& f) {
  const std::array<Vec3<Shifted>, 3> from{x.from(f.corners[0]), x.from(f.corners[1]), x.from(f.corners[2])};
  for (int i = 0; i < 3; ++i)
    if (sign_of(determinant(f.normal, from[i], from[(i + 1) % 3])) <= 0) return false;
  return true;
}

Meeting exact_meeting(const LineNumbers<Shifted>& line, const FaceNumbers<Shifted>& f) {
  Meeting meeting;
  meeting.facing = sign_of(slope(line, f));
  if (meeting.facing == 0) return meeting;
  const int ahead = -meeting.facing * reference::sign_of(height(line, f).a);
  if (ahead < 0) return meeting;
  meeting.met = is_within(point_in_plane(line, f), f);
  meeting.ahead = ahead > 0;
  return meeting;
}

/// What holds for all vertices within their boxes; nothing where that is not one answer.
std::optional<Meeting> robust_meeting(const EnclosedLine& line, const FaceNumbers<Interval>& f) {
  Meeting meeting;
  const int s0 = certain_sign(inner_product(line, f.corners[0], f.corners[1]));
  const int s1 = certain_sign(inner_product(line, f.corners[1], f.corners[2]));
  if (s0 * s1 < 0) return meeting;
  const int s2 = certain_sign(inner_product(line, f.corners[2], f.corners[0]));
  if (s1 * s2 < 0 || s2 * s0 < 0) return meeting;
  meeting.facing = certain_sign(slope(line, f));
  const int ahead = -meeting.facing * certain_sign(height(line, f));
  if (ahead < 0) return meeting;
  if (ahead == 0 || s0 == 0 || s1 == 0 || s2 == 0) return {};
  meeting.met = meeting.ahead = true;
  return meeting;
}

}  // namespace

PenetrationLine::PenetrationLine(const ExactPose& pose, Side master, Index face)
    : pose_(pose), master_(master), face_(face) {
  const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
  enclosed_ = make_line(rounding_corners(pose, master, face));
  C_ = Interval(Interval(1) / Interval(3)) * enclosed_.C3;
}

const LineNumbers<Shifted>& PenetrationLine::exact() {
  if (exact_) return *exact_;
  const std::array<Vec3<Exact>, 3> p = pose_.corners<Exact>(master_, face_);
  const Vec3<Shifted> v1 = constant(p[1] - p[0]), v2 = constant(p[2] - p[0]);
  const Vec3<Shifted> shift = Shifted(0, 1, 0) * v1 + Shifted(0, 0, 1) * v2;
  exact_ = {constant(p[0] + p[1] + p[2]) + Shifted(3) * shift, cross(v1, v2)};
  return *exact_;
}

Meeting PenetrationLine::meets(Side side, Index face) {
  {
    const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
    if (const auto robust = robust_meeting(enclosed_, make_face(rounding_corners(pose_, side, face)))) return *robust;
  }
  certified_ = false;
  return exact_meeting(exact(), make_face(constant(pose_.corners<Exact>(side, face))));
}

int PenetrationLine::compare(Side side_a, Index face_a, Side side_b, Index face_b) {
  {
    const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
    const auto a = make_face(rounding_corners(pose_, side_a, face_a));
    const auto b = make_face(rounding_corners(pose_, side_b, face_b));
    const int robust = -certain_sign(slope(enclosed_, a)) * certain_sign(slope(enclosed_, b)) *
                       certain_sign(height_above(enclosed_, a, b));
    if (robust != 0) return robust;
  }
  certified_ = false;
  const LineNumbers<Shifted>& line = exact();
  const auto a = make_face(constant(pose_.corners<Exact>(side_a, face_a)));
  const auto b = make_face(constant(pose_.corners<Exact>(side_b, face_b)));
  return -sign_of(slope(line, a)) * sign_of(slope(line, b)) * sign_of(height_above(line, a, b));
}

double begin_of(const Vec3<Interval>& from, const Vec3<Interval>& N, const Box& box) {
  // All comparisons are such that an overflow, which leaves no number, leaves the box in question.
  double least = 0, greatest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (certain_sign(N[i]) == 0) continue;
    const Interval q = (from[i] - Interval(box.lower[i], box.upper[i])) / N[i];
    if (q.inf() > least) least = q.inf();
    if (q.sup() < greatest) greatest = q.sup();
    if (greatest < least) return -1;
  }
  for (int i = 0; i < 3; ++i) {
    if (certain_sign(N[i]) != 0) continue;
    const Interval x = from[i] - Interval(least, greatest) * N[i];
    if (x.sup() < box.lower[i] || x.inf() > box.upper[i]) return -1;
  }
  return least;
}

double PenetrationLine::begin_of(const Box& box) const {
  const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
  return reference::begin_of(C_, enclosed_.N, box);
}

double PenetrationLine::farthest(Side side, Index face) const {
  const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
  const auto f = make_face(rounding_corners(pose_, side, face));
  const Interval q = -height(enclosed_, f) / (Interval(3) * slope(enclosed_, f));
  return q.sup() < std::numeric_limits<double>::infinity() ? q.sup() : std::numeric_limits<double>::infinity();
}

}  // namespace pcm::reference
