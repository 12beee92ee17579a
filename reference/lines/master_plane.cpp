// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/master_plane.h"

#include <algorithm>
#include <cmath>

#include "reference/predicates/orientation.h"

namespace pcm::reference {
namespace {

constexpr std::array<Vertex, 2> kThroughNone{Vertex{Side::E, kNone}, Vertex{Side::E, kNone}};

/// The same line with coefficients of about 1, so that products of several neither overflow nor underflow.
Vec3<Interval> scaled(const Vec3<Interval>& line) {
  double size = 0;
  for (int i = 0; i < 3; ++i) size = std::max({size, std::abs(line[i].inf()), std::abs(line[i].sup())});
  if (!std::isnormal(size)) return line;
  return Interval(std::ldexp(1.0, -std::ilogb(size))) * line;
}

/// Vertices that two faces have in common.
std::array<Vertex, 2> common_vertices(const ExactPose& pose, Face f, Face g) {
  std::array<Vertex, 2> common = kThroughNone;
  if (f.side != g.side) return common;
  int count = 0;
  const Triangle& other_face = pose.face(g.side, g.index);
  for (const Index v : pose.face(f.side, f.index))
    if (std::find(other_face.begin(), other_face.end(), v) != other_face.end() && count < 2)
      common[count++] = {f.side, v};
  return common;
}

/// -1, 0 or 1: on which side of the face's plane the vertex lies, 1 where the normal points to.
int side_of_plane(VisibilityPoints& points, Face g, Index vertex) {
  const ExactPose& pose = points.enclosed.pose();
  const Triangle& t = pose.face(g.side, g.index);
  const auto box = [&](Index v) { return pose.rounding_box({g.side, v}); };
  if (const int robust = certain_orientation(box(t[0]), box(t[1]), box(t[2]), box(vertex)); robust != 0) return robust;
  points.robust = points.robust && g.side == Side::E;
  return Orientation(pose).exact_orientation({g.side, t[0]}, {g.side, t[1]}, {g.side, t[2]}, {g.side, vertex});
}

}  // namespace

MasterPlane::MasterPlane(VisibilityPoints& points, Face master)
    : points_(points), master_(master), enclosed_(make_frame(points.enclosed, master)) {}

Depth<Interval> MasterPlane::depth(Face g) {
  return depth_of(points_.enclosed, enclosed_, g);
}

Index MasterPlane::find_line(const VisibilityLine& name, const std::array<Vertex, 2>& through) {
  const auto [found, added] = known_lines_.try_emplace(name, static_cast<Index>(lines_.size()));
  if (added) lines_.push_back({name, through, scaled(coefficients(points_.enclosed, enclosed_, master_, name)), {}});
  return found->second;
}

bool MasterPlane::of_E_only(Index line) const {
  const VisibilityLine& name = lines_[line].name;
  return master_.side == Side::E && name.side_a == Side::E && name.side_b == Side::E;
}

const Vec3<Exact>& MasterPlane::exact_line(Index line) {
  points_.robust = points_.robust && of_E_only(line);
  if (!exact_) exact_ = make_frame(points_.exact, master_);
  Line& l = lines_[line];
  if (!l.exact) l.exact = coefficients(points_.exact, *exact_, master_, l.name);
  return *l.exact;
}

bool MasterPlane::vanishes(Index line) {
  const Vec3<Interval>& enclosed = lines_[line].enclosed;
  for (int i = 0; i < 3; ++i)
    if (certain_sign(enclosed[i]) != 0) return false;
  const Vec3<Exact>& exact = exact_line(line);
  return sign_of(exact.x) == 0 && sign_of(exact.y) == 0 && sign_of(exact.z) == 0;
}

HalfPlane MasterPlane::side_of(Face g, int facing, int corner) {
  const Triangle& t = points_.enclosed.pose().face(g.side, g.index);
  const Index from = t[corner], to = t[(corner + 1) % 3];
  const auto [a, b] = std::minmax(from, to);
  const Index line =
      find_line({VisibilityLine::Kind::edge, g.side, a, g.side, b}, {Vertex{g.side, a}, Vertex{g.side, b}});
  return {line, from < to ? facing : -facing};
}

const SeenFace& MasterPlane::see(Face g) {
  const auto [found, added] = seen_.try_emplace(g);
  SeenFace& seen = found->second;
  if (!added) return seen;
  seen.facing = certain_sign(depth(g).denominator);
  if (seen.facing == 0) {
    points_.robust = points_.robust && master_.side == Side::E && g.side == Side::E;
    if (!exact_) exact_ = make_frame(points_.exact, master_);
    seen.facing = sign_of(depth_of(points_.exact, *exact_, g).denominator);
  }
  if (seen.facing == 0) return seen;
  for (int i = 0; i < 3; ++i) seen.sides[i] = side_of(g, seen.facing, i);
  if (g != master_) seen.ahead = deeper(g, master_);
  return seen;
}

std::optional<HalfPlane> MasterPlane::deeper(Face f, Face g) {
  const ExactPose& pose = points_.enclosed.pose();
  const int facing_f = see(f).facing, facing_g = see(g).facing;
  const std::array<Vertex, 2> common = common_vertices(pose, f, g);
  if (common[1].index != kNone) {
    // Both planes meet in the common edge. At f's corner c beyond it, d_f - d_g = -((c - g0) . N_g) / (N . N_g).
    const Triangle& t = pose.face(f.side, f.index);
    int apex = 0;
    while (t[apex] == common[0].index || t[apex] == common[1].index) ++apex;
    const int sign = -side_of_plane(points_, g, t[apex]) * facing_g;
    if (sign == 0) return {};
    const HalfPlane inwards = see(f).sides[(apex + 1) % 3];
    return HalfPlane{inwards.line, sign * inwards.sign};
  }
  // The plane of e comes last in the name, otherwise the smaller face first.
  const bool in_order = g == master_ || (f != master_ && f < g);
  const Face a = in_order ? f : g, b = in_order ? g : f;
  const Index line = find_line({VisibilityLine::Kind::fold, a.side, a.index, b.side, b.index}, common);
  if (vanishes(line)) return {};
  return HalfPlane{line, (in_order ? 1 : -1) * facing_f * facing_g};
}

Vec3<Interval> MasterPlane::enclosed_line(HalfPlane h) const {
  const Vec3<Interval>& line = lines_[h.line].enclosed;
  return h.sign > 0 ? line : Vec3<Interval>{-line.x, -line.y, -line.z};
}

Vec3<Interval> MasterPlane::corner(HalfPlane first, HalfPlane second) const {
  return cross(enclosed_line(first), enclosed_line(second));
}

std::optional<int> MasterPlane::quick_side(HalfPlane h, HalfPlane first, HalfPlane second,
                                           const Vec3<Interval>& at) const {
  if (h.line == first.line || h.line == second.line) return 0;
  const auto passes = [this](Index line, Vertex v) {
    const std::array<Vertex, 2>& through = lines_[line].through;
    return through[0] == v || through[1] == v;
  };
  for (const Vertex v : lines_[h.line].through)
    if (v.index != kNone && passes(first.line, v) && passes(second.line, v)) return 0;
  const int sign = certain_sign(dot(lines_[h.line].enclosed, at));
  return sign == 0 ? std::nullopt : std::optional(h.sign * sign);
}

int MasterPlane::side(HalfPlane h, HalfPlane first, HalfPlane second, const Vec3<Interval>& at) {
  if (const std::optional<int> quick = quick_side(h, first, second, at)) return *quick;
  const int sign = sign_of(determinant(exact_line(h.line), exact_line(first.line), exact_line(second.line)));
  return h.sign * first.sign * second.sign * sign;
}

}  // namespace pcm::reference
