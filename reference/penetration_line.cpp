// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/penetration_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::reference {
namespace {

template <class T>
LineNumbers<T> make_line(const std::array<Vec3<T>, 3>& p) {
  LineNumbers<T> line;
  line.C3 = p[0] + p[1] + p[2];
  line.v1 = p[1] - p[0];
  line.v2 = p[2] - p[0];
  line.N = cross(line.v1, line.v2);
  line.N_x_v1 = cross(line.N, line.v1);
  line.N_x_v2 = cross(line.N, line.v2);
  return line;
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

/// D(C) = N . ((f_i - C) x (f_j - C)), nine times: on which side of the line the face's edge passes.
template <class T>
T side_of_edge(const LineNumbers<T>& line, const Vec3<T>& f_i, const Vec3<T>& f_j) {
  const T three(3);
  return determinant(line.N, three * f_i - line.C3, three * f_j - line.C3);
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

/// (q_a - q_b) * 3 slope_a slope_b.
template <class T>
T distance_between(const LineNumbers<T>& line, const FaceNumbers<T>& a, const FaceNumbers<T>& b) {
  return height(line, b) * slope(line, a) - height(line, a) * slope(line, b);
}

/// The same for the change of q_a - q_b when C moves by v: dq = (v . N_f) / slope.
template <class T>
T change_between(const LineNumbers<T>& line, const FaceNumbers<T>& a, const FaceNumbers<T>& b, const Vec3<T>& v) {
  return dot(v, a.normal) * slope(line, b) - dot(v, b.normal) * slope(line, a);
}

/// The side test with its tie rule.
int exact_side(const LineNumbers<Exact>& line, const Vec3<Exact>& f_i, const Vec3<Exact>& f_j) {
  if (const int sign = sign_of(side_of_edge(line, f_i, f_j)); sign != 0) return sign;
  if (const int sign = sign_of(dot(f_i - f_j, line.N_x_v1)); sign != 0) return sign;
  return sign_of(dot(f_i - f_j, line.N_x_v2));
}

Meeting exact_meeting(const LineNumbers<Exact>& line, const FaceNumbers<Exact>& f) {
  Meeting meeting;
  meeting.facing = sign_of(slope(line, f));
  if (meeting.facing == 0) return meeting;
  const int ahead = -meeting.facing * sign_of(height(line, f));
  if (ahead < 0) return meeting;
  const int side = exact_side(line, f.corners[0], f.corners[1]);
  meeting.met =
      exact_side(line, f.corners[1], f.corners[2]) == side && exact_side(line, f.corners[2], f.corners[0]) == side;
  meeting.ahead = ahead > 0;
  return meeting;
}

/// What holds for all vertices within their boxes; nothing where that is not one answer.
std::optional<Meeting> robust_meeting(const LineNumbers<Interval>& line, const FaceNumbers<Interval>& f) {
  Meeting meeting;
  const int s0 = certain_sign(side_of_edge(line, f.corners[0], f.corners[1]));
  const int s1 = certain_sign(side_of_edge(line, f.corners[1], f.corners[2]));
  if (s0 * s1 < 0) return meeting;
  const int s2 = certain_sign(side_of_edge(line, f.corners[2], f.corners[0]));
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

const LineNumbers<Exact>& PenetrationLine::exact() {
  if (!exact_) exact_ = make_line(pose_.corners<Exact>(master_, face_));
  return *exact_;
}

Meeting PenetrationLine::meets(Side side, Index face) {
  {
    const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
    if (const auto robust = robust_meeting(enclosed_, make_face(rounding_corners(pose_, side, face)))) return *robust;
  }
  certified_ = false;
  return exact_meeting(exact(), make_face(pose_.corners<Exact>(side, face)));
}

int PenetrationLine::compare(Side side_a, Index face_a, Side side_b, Index face_b) {
  {
    const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
    const auto a = make_face(rounding_corners(pose_, side_a, face_a));
    const auto b = make_face(rounding_corners(pose_, side_b, face_b));
    const int robust = certain_sign(slope(enclosed_, a)) * certain_sign(slope(enclosed_, b)) *
                       certain_sign(distance_between(enclosed_, a, b));
    if (robust != 0) return robust;
  }
  certified_ = false;
  const LineNumbers<Exact>& line = exact();
  const auto a = make_face(pose_.corners<Exact>(side_a, face_a));
  const auto b = make_face(pose_.corners<Exact>(side_b, face_b));
  const int slopes = sign_of(slope(line, a)) * sign_of(slope(line, b));
  if (const int sign = sign_of(distance_between(line, a, b)); sign != 0) return slopes * sign;
  if (const int sign = sign_of(change_between(line, a, b, line.v1)); sign != 0) return slopes * sign;
  return slopes * sign_of(change_between(line, a, b, line.v2));
}

double reach(const Vec3<Interval>& from, const Vec3<Interval>& N, const Box& box) {
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

double PenetrationLine::reach(const Box& box) const {
  const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
  return reference::reach(C_, enclosed_.N, box);
}

double PenetrationLine::farthest(Side side, Index face) const {
  const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
  const auto f = make_face(rounding_corners(pose_, side, face));
  const Interval q = -height(enclosed_, f) / (Interval(3) * slope(enclosed_, f));
  return q.sup() < std::numeric_limits<double>::infinity() ? q.sup() : std::numeric_limits<double>::infinity();
}

}  // namespace pcm::reference
