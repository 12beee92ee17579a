// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/rounding_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "compare/verify/bounds/bound_arithmetic.h"

namespace pcm::compare {
namespace {

using roundoff::u;

using Face = RoundedFaces::Face;

/// A crossing as stored, a + t (b - a), is off its edge by a rounding of a coordinate and two of t (b - a), and the
/// oracle's by one of a coordinate: sqrt(3) of each for the length.
double off_edge(const Eigen::Vector3d& x_Me, const Eigen::Vector3d& edge_Me) {
  return 4 * u * (x_Me.cwiseAbs().maxCoeff() + edge_Me.cwiseAbs().maxCoeff());
}

}  // namespace

RoundingBounds::RoundingBounds(const Question& question, const reference::Answer& true_rounded)
    : question_(question), true_(true_rounded), faces_(question) {}

ElementBounds RoundingBounds::element(const reference::Element& e) const {
  const Face master = faces_.face(e.master, e.master_face), slave = faces_.face(opposite(e.master), e.slave_face);
  const Eigen::Vector3d C = (faces_.corner(e.master, e.master_face, 0) + faces_.corner(e.master, e.master_face, 1) +
                             faces_.corner(e.master, e.master_face, 2)) /
                            3;
  GeometryErrors errors;
  errors.area = master.area_error + u * e.area;
  errors.normal = master.normal_error;

  // Barycentre (8): two additions of at most 3 M, a division: |dC| <= (2 u 3 M) / 3 + u M = 3 u M a component, where
  // each corner is exact; sqrt(3) for the length.
  errors.foot = std::sqrt(3.0) * 3 * u * master.farthest;

  // Penetration (11), u_k = h / c with h = -(C_f - C) . n_f and c = |n_e . n_f|:
  // |dh| <= |dC| + D (|dn_f| + 4 u), D the distance from C to the point of f taken (a corner, at worst the farthest),
  // |dc| <= |dn_e| + |dn_f| + 4 u, |du| <= (|dh| + u_k |dc|) / (c - |dc|) and one rounding.
  double D = 0;
  for (std::size_t k = 0; k < 3; ++k)
    D = std::max(D, (faces_.corner(opposite(e.master), e.slave_face, k) - C).stableNorm());
  const double cosine_error = master.normal_error + slave.normal_error + 4 * u;
  const double height_error = errors.foot + D * (slave.normal_error + 5 * u);
  const double cosine = std::abs(e.cosine) - cosine_error;
  errors.penetration =
      cosine > 0 ? (height_error + e.greatest_penetration * cosine_error) / cosine + 2 * u * e.greatest_penetration
                 : std::numeric_limits<double>::infinity();

  return bounds_after_law(question_, e, errors);
}

// A sum of n terms, each in error by its own bound, adds at most n u times the sum of their sizes.
ForceBounds RoundingBounds::force() const {
  ForceBounds bounds;
  double force_size = 0, torque_size = 0;
  for (const reference::Element& e : true_.elements) {
    bounds.elements.push_back(element(e));
    bounds.force += bounds.elements.back().force;
    bounds.torque += bounds.elements.back().torque;
    bounds.penetration = std::max(bounds.penetration, bounds.elements.back().depth);
    force_size += e.force_Me.stableNorm();
    torque_size += (e.position_Me - question_.pose.r).stableNorm() * e.force_Me.stableNorm();
  }
  const double terms = kHigherOrder * u * static_cast<double>(true_.elements.size() + 2);
  bounds.force += terms * force_size;
  bounds.torque += terms * torque_size;
  if (question_.mode == Mode::both) {
    bounds.force /= 2;
    bounds.torque /= 2;
  }
  return bounds;
}

// x = a + t (b - a), t = d_a / (d_a - d_b), d the heights over the face. Where these are off by e_a and e_b, the true
// height at x is (e_a d_b - e_b d_a) / (d_a - d_b), d with its error in the denominator: no more than the greater of
// both errors, since d_a and d_b differ in sign, and the 4 roundings of t (b - a) make it 4 u |b - a| more. Along the
// edge x is off by that over the sine, n_f . (b - a) / |b - a|. Both true and computed crossing lie on the edge, which
// caps it; off the edge only the roundings of a + t (b - a) show (off_edge). Not yet doubled for terms of higher order,
// which the cap has none of.
RoundingBounds::PositionError RoundingBounds::position_error(const reference::Crossing& crossing) const {
  const Eigen::Vector3d& a = faces_.vertex(crossing.edge_side, crossing.edge[0]);
  const Eigen::Vector3d& b = faces_.vertex(crossing.edge_side, crossing.edge[1]);
  const Face crossed = faces_.face(opposite(crossing.edge_side), crossing.face);
  double D = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& f = faces_.corner(opposite(crossing.edge_side), crossing.face, k);
    D = std::max({D, (a - f).stableNorm(), (b - f).stableNorm()});
  }
  const double length = (b - a).stableNorm();
  const double height = D * crossed.plane_error + 4 * u * length;
  if (length == 0) return {0, height, 0};
  const double sine = std::abs(crossed.normal_Me.dot(b - a)) / length - (crossed.normal_error + 4 * u);
  const double along = sine > 0 ? height / sine : length;
  return {std::min(length, along), height, std::min(length, kHigherOrder * along)};
}

bool RoundingBounds::may_be_wound(Side side, Index vertex) const {
  const reference::ActiveArea& active = side == Side::E ? true_.E : true_.F;
  return !faces_.surface(opposite(side)).closed || std::binary_search(active.wound.begin(), active.wound.end(), vertex);
}

std::map<std::pair<Side, std::array<Index, 2>>, double> RoundingBounds::lengths_inside() const {
  std::map<std::pair<Side, std::array<Index, 2>>, std::pair<double, double>> spans;  // distances from the first vertex
  for (const reference::Polygon& polygon : true_.polygons)
    for (const reference::Crossing& x : polygon.points) {
      const Eigen::Vector3d& from = faces_.vertex(x.edge_side, x.edge[0]);
      const Eigen::Vector3d& to = faces_.vertex(x.edge_side, x.edge[1]);
      const double at = (x.position_Me - from).stableNorm();
      const double low = may_be_wound(x.edge_side, x.edge[0]) ? 0 : at;
      const double high = may_be_wound(x.edge_side, x.edge[1]) ? std::max(at, (to - from).stableNorm()) : at;
      const auto [found, is_first] = spans.try_emplace({x.edge_side, x.edge}, low, high);
      if (!is_first) found->second = {std::min(found->second.first, low), std::max(found->second.second, high)};
    }
  std::map<std::pair<Side, std::array<Index, 2>>, double> lengths;
  for (const auto& [edge, span] : spans) lengths[edge] = span.second - span.first;
  return lengths;
}

// The corners that the other surface does not wind about bound nothing; all do where it is open.
double RoundingBounds::width_of(Part part, Side side, Index face) const {
  for (const Index v : faces_.surface(side).mesh.faces[static_cast<std::size_t>(face)])
    if (may_be_wound(side, v)) part.add(faces_.vertex(side, v), 0, 0);
  return part.terms > 0 ? part.width() : std::numeric_limits<double>::infinity();
}

// The clipped area of a face is a sum of (p - o) x (q - o) / 2 over a closed boundary, linear in each boundary point. A
// crossing x moved by s along its edge's direction d, its neighbours p and q on the polygon unmoved, changes
// - the area of the face it passes through, whose boundary runs p, x, q, by s |d x (q - p)| / 2;
// - those of its edge's two faces, whose boundaries leave x along the edge, by s |d x (p - x)| / 2 and the same with q;
// two neighbours moved together by s s' |d x d'| / 2 more. Where an edge may lie in the plane of the face, s is as long
// as the edge but d is parallel to the boundary: the area does not feel it.
//
// The volume feels less: both areas change along the same boundary, and stay the surface of a body. Moving x to a
// height h over the plane of the face it passes through changes that body by h |(p - x) x (q - x)| / 6, for the other
// faces at x hold its edge; and it leaves a gap between both areas. Along a segment of the boundary that is as wide as
// its ends are off the two planes, so that its area is no more than half of what either end is off times the segment.
// Through it flows no more than its area times the distance from the origin, a third of it counted.
AreaBounds RoundingBounds::area() const {
  AreaBounds bounds;
  std::array<double, 2> crossing_area_error{};  // area errors by side, from crossings moved
  double crossing_volume_error = 0, gaps = 0;   // three times the volume, and the gaps' area
  std::array<std::map<Index, Part>, 2> parts;   // by side and face
  Part patch_points;
  const auto lengths = lengths_inside();
  for (const reference::Polygon& polygon : true_.polygons) {
    const std::size_t n = polygon.points.size();
    std::vector<double>& bounds_of_polygon = bounds.positions.emplace_back();
    std::vector<Eigen::Vector3d> d;
    std::vector<double> along, length_inside, height, stored;
    for (const reference::Crossing& x : polygon.points) {
      const PositionError error = position_error(x);
      bounds_of_polygon.push_back(error.bound);
      along.push_back(error.along);
      height.push_back(error.height);
      const Eigen::Vector3d edge = faces_.vertex(x.edge_side, x.edge[1]) - faces_.vertex(x.edge_side, x.edge[0]);
      length_inside.push_back(lengths.at({x.edge_side, x.edge}));
      d.push_back(edge.stableNorm() > 0 ? (edge / edge.stableNorm()).eval() : edge);
      stored.push_back(off_edge(x.position_Me, edge));
      const Eigen::Vector3d moved = along.back() * d.back();
      for (const double sign : {-1.0, 1.0}) patch_points.add(x.position_Me + sign * moved, stored.back(), 0);
    }
    const double farthest_off = *std::max_element(stored.begin(), stored.end());
    for (std::size_t k = 0; k < n; ++k) {
      const reference::Crossing& x = polygon.points[k];
      const auto own = static_cast<std::size_t>(x.edge_side == Side::E ? 0 : 1), crossed = 1 - own;
      const bool has_p = polygon.closed || k > 0, has_q = polygon.closed || k + 1 < n;
      const Eigen::Vector3d p = has_p ? polygon.points[(k + n - 1) % n].position_Me : x.position_Me;
      const Eigen::Vector3d q = has_q ? polygon.points[(k + 1) % n].position_Me : x.position_Me;
      crossing_area_error[crossed] += along[k] * d[k].cross(q - p).stableNorm() / 2;
      crossing_area_error[own] +=
          along[k] * (d[k].cross(p - x.position_Me).stableNorm() + d[k].cross(q - x.position_Me).stableNorm()) / 2;
      const double perimeter =
          (q - p).stableNorm() + (p - x.position_Me).stableNorm() + (q - x.position_Me).stableNorm();
      // The neighbours may have moved along their edges as well.
      const double to_p = (p - x.position_Me).stableNorm() + along[k] + (has_p ? along[(k + n - 1) % n] : 0);
      const double to_q = (q - x.position_Me).stableNorm() + along[k] + (has_q ? along[(k + 1) % n] : 0);
      crossing_volume_error += height[k] * to_p * to_q / 2;
      const double wound = std::max(1, (own == 0 ? true_.E : true_.F).most_wound);
      gaps += (height[k] + 2 * stored[k]) * (to_p + to_q) / 2 + wound * stored[k] * (length_inside[k] + 2 * along[k]);
      // The neighbours as stored are off as well, and move with it.
      for (double& m : crossing_area_error) m += stored[k] * (perimeter + 4 * (farthest_off + along[k]));
      // Beside the edge rather than on it, it bends the boundary along the edge: s (b - x) / 2 on both faces, as often
      // as the other surface winds about that.
      crossing_area_error[own] += wound * stored[k] * (length_inside[k] + 2 * along[k]);
      if (has_q) {
        const std::size_t next = (k + 1) % n;
        for (double& m : crossing_area_error) m += along[k] * along[next] * d[k].cross(d[next]).stableNorm() / 2;
      }
      bounds_of_polygon[k] += kHigherOrder * stored[k];
      const auto add_to = [&](Part& part, double terms) {
        part.add(x.position_Me - along[k] * d[k], stored[k], 0);
        part.add(x.position_Me + along[k] * d[k], stored[k], terms);
      };
      add_to(parts[crossed][x.face], 2);
      const SurfaceFeatures& edges = faces_.surface(x.edge_side);
      for (const Index f : edges.faces_at(x.edge)) add_to(parts[own][f], 3);
    }
  }
  for (const Side side : {Side::E, Side::F}) {
    const reference::ActiveArea& active = side == Side::E ? true_.E : true_.F;
    for (const std::vector<Index>* uncrossed : {&active.inner, &active.pockets})
      for (const Index f : *uncrossed)
        for (std::size_t k = 0; k < 3; ++k) patch_points.add(faces_.corner(side, f, k), 0, 0);
  }
  const double patch = patch_points.width();

  // The part of an intersected face is summed about a point of its own: each cross product has 4 roundings of
  // |p - o| |q - o|, no more than the square of the part's width, and so has the normal's length; the normal's
  // direction tells in the vector area alone. Face after face is then added up. The volume is the sum of (x_e - o) .
  // n_e area_e / 3 with x_e and o in the patch, x_e off the face by no more than a corner's roundings or a crossing's.
  for (const Side side : {Side::E, Side::F}) {
    const auto i = static_cast<std::size_t>(side == Side::E ? 0 : 1);
    const reference::ActiveArea& active = side == Side::E ? true_.E : true_.F;
    const double wound = std::max(1, active.most_wound);
    double area_error = crossing_area_error[i], normal_error = 0, volume_error = 0, size = 0;
    const auto add = [&](const Face& e, double area, double value_error, double off) {
      // A sliver's normal may be wrong altogether; its area is then no larger than its error.
      const double turned = std::min(area * e.normal_error, wound * (2 * e.area_error + 6 * u * e.longest * e.longest));
      size += area;
      area_error += value_error;
      normal_error += turned;
      volume_error += patch * (value_error + turned + 6 * u * area) + 2 * std::max(4 * u * e.farthest, off) * area;
    };
    for (const std::vector<Index>* uncrossed : {&active.inner, &active.pockets})
      for (const Index f : *uncrossed) {
        const Face e = faces_.face(side, f);
        add(e, wound * e.area, wound * e.area_error, 0);
      }
    for (const Index f : active.intersected) {
      const Face e = faces_.face(side, f);
      const auto found = parts[i].find(f);
      const Part part = found == parts[i].end() ? Part{} : found->second;
      const double width = std::min(e.longest, width_of(part, side, f));
      const double sum_terms = part.terms + 3 * wound;
      add(e, wound * std::min(e.area, width * width), 4 * u * (sum_terms + 2) * width * width, part.off);
    }
    const double summing =
        u * static_cast<double>(active.inner.size() + active.pockets.size() + active.intersected.size() + 1) * size;
    (side == Side::E ? bounds.area_E : bounds.area_F) = kHigherOrder * (area_error + summing);
    (side == Side::E ? bounds.vector_area_E : bounds.vector_area_F) =
        kHigherOrder * (area_error + normal_error + 2 * summing);
    bounds.volume += kHigherOrder * (volume_error + 2 * patch * summing) / 3;
  }
  bounds.volume += kHigherOrder * (crossing_volume_error + patch * gaps) / 3;
  return bounds;
}

}  // namespace pcm::compare
