// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/part_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pcm::fast {

namespace {

using Eigen::Vector3d;

/// The depth of a face of the slave over the master's plane, and how it grows as the face moves; 0 where roundings
/// leave nothing of the angle between them.
struct FaceDepth {
  Vector3d by_motion_Me;  ///< N_h / (n_k . N_h)
  double per_s, per_t;    ///< m

  FaceDepth(const std::array<Vector3d, 3>& points_Me, const MasterPrism& prism) {
    const Vector3d N = (points_Me[1] - points_Me[0]).cross(points_Me[2] - points_Me[0]);
    by_motion_Me = N / -N.dot(prism.face().n_Me);
    if (!by_motion_Me.allFinite()) by_motion_Me.setZero();
    per_s = -by_motion_Me.dot(prism.edge_s_Me());
    per_t = -by_motion_Me.dot(prism.edge_t_Me());
  }
};

/// With which factor the side from a to b lies along the line on which a linear function is 0, turned by a right angle
/// from its gradient.
double along_level(const PrismPoint& a, const PrismPoint& b, double per_s, double per_t) {
  return std::abs(per_s) >= std::abs(per_t) ? (b[kT] - a[kT]) / per_s : (a[kS] - b[kS]) / per_t;
}

/// Depth of a face's edge at a place on it, or on the line that it is seen on.
double depth_on_edge(const ProjectedFace& h, std::size_t edge, const PrismPoint& at) {
  const PrismPoint& from = h.corners[edge];
  const PrismPoint along = h.corners[(edge + 1) % 3] - from;
  const int wider = std::abs(along[kS]) >= std::abs(along[kT]) ? kS : kT;
  return from[kDepth] + (at[wider] - from[wider]) / along[wider] * along[kDepth];
}

/// The four integrals, by the motion of the slave.
class IntegralSlopes {
 public:
  /// Integrands.
  enum { kOne, kDepths, kSDepths, kTDepths, kCount };

  explicit IntegralSlopes(const Vector3d& r_Me) : r_Me_(r_Me) {}

  /// Adds V . d(X), summed up with weights: the sum of these, and that of them times X.
  void add(int integral, const Vector3d& V, double weight, const Vector3d& weighted_X_Me) {
    MotionSlope& slope = slopes_[static_cast<std::size_t>(integral)];
    slope.by_position += weight * V;
    slope.by_rotation += (weighted_X_Me - weight * r_Me_).cross(V);
  }

  const MotionSlope& operator[](int integral) const { return slopes_[static_cast<std::size_t>(integral)]; }

 private:
  Vector3d r_Me_;
  std::array<MotionSlope, kCount> slopes_;
};

MotionSlope unless_too_large(const MotionSlope& slope) {
  return slope.by_position.allFinite() && slope.by_rotation.allFinite() ? slope : MotionSlope{};
}

/// Of a / b, where `quotient` is its value.
MotionSlope of_quotient(const MotionSlope& a, double b, const MotionSlope& by_b, double quotient) {
  return unless_too_large(
      {(a.by_position - quotient * by_b.by_position) / b, (a.by_rotation - quotient * by_b.by_rotation) / b});
}

/// Integrals over polygons of products of 1, s, t and the depth.
struct Products {
  double one = 0, s = 0, t = 0, depth = 0;
  double ss = 0, st = 0, tt = 0, s_depth = 0, t_depth = 0;

  void add(const ConvexPolygon& polygon) {
    for (int i = 1; i + 1 < polygon.count; ++i) add(polygon[0], polygon[i], polygon[i + 1]);
  }
  void add(const PrismPoint& a, const PrismPoint& b, const PrismPoint& c) {
    const double area = 0.5 * cross_st(a, b, c), third = area / 3, twelfth = area / 12;
    const PrismPoint sum = a + b + c;
    const auto product = [&](int x, int y) {
      return twelfth * (sum[x] * sum[y] + (a[x] * a[y] + b[x] * b[y] + c[x] * c[y]));
    };
    one += area;
    s += third * sum[kS];
    t += third * sum[kT];
    depth += third * sum[kDepth];
    ss += product(kS, kS);
    st += product(kS, kT);
    tt += product(kT, kT);
    s_depth += product(kS, kDepth);
    t_depth += product(kT, kDepth);
  }
};

class PartSlopes {
 public:
  PartSlopes(PosedPair& posed, const SeenPart& part)
      : posed_(posed), part_(part), depth_f_(depth_of(part.f)), sums_(posed.placement.r_Me) {
    add_inside();
    for (const ConvexPolygon& piece : part.pieces) {
      for (int i = 0; i < piece.count; ++i) {
        const SideLine line = piece.lines[static_cast<std::size_t>(i)];
        if (line != kNoLine) add_side(line, piece[i], piece[i + 1 == piece.count ? 0 : i + 1]);
      }
    }
  }

  const IntegralSlopes& sums() const { return sums_; }

 private:
  FaceDepth depth_of(const ProjectedFace& h) const {
    return {posed_.face_Me(h.of_master ? part_.master : opposite(part_.master), h.face), part_.prism};
  }

  Vector3d point_Me(const PrismPoint& at, double depth) const {
    const MasterPrism& prism = part_.prism;
    return prism.p0_Me() + ((at[kS] * prism.edge_s_Me() + at[kT] * prism.edge_t_Me()) - depth * prism.face().n_Me);
  }

  /// Where the depth is not clamped it grows as f moves.
  void add_inside() {
    Products p;
    for (const ConvexPolygon& piece : part_.pieces) {
      ConvexPolygon shallow = piece;
      Heights above{};
      bool any_above = false;
      for (int i = 0; i < piece.count; ++i) {
        above[static_cast<std::size_t>(i)] = part_.most - piece[i][kDepth];
        any_above = any_above || above[static_cast<std::size_t>(i)] > 0;
      }
      if (!any_above) continue;
      keep_where_not_negative(shallow, above);
      p.add(shallow);
    }
    const MasterPrism& prism = part_.prism;
    const Vector3d& p0 = prism.p0_Me();
    const Vector3d &s = prism.edge_s_Me(), &t = prism.edge_t_Me(), &n = prism.face().n_Me;
    const Vector3d& g = depth_f_.by_motion_Me;
    sums_.add(IntegralSlopes::kDepths, g, p.one, (p.one * p0 + p.s * s) + (p.t * t - p.depth * n));
    sums_.add(IntegralSlopes::kSDepths, g, p.s, (p.s * p0 + p.ss * s) + (p.st * t - p.s_depth * n));
    sums_.add(IntegralSlopes::kTDepths, g, p.t, (p.t * p0 + p.st * s) + (p.tt * t - p.t_depth * n));
  }

  void add_side(SideLine line, const PrismPoint& a, const PrismPoint& b) {
    const auto number = static_cast<std::size_t>((line - 1) / kLinesOfAFace);
    const int kind = (line - 1) % kLinesOfAFace;
    const ProjectedFace& h = part_.faces[number];
    const MasterPrism& prism = part_.prism;
    if (kind == kCrossing && h.of_master) {
      const FaceDepth depth_h = depth_of(h);
      const double l = along_level(a, b, depth_h.per_s - depth_f_.per_s, depth_h.per_t - depth_f_.per_t);
      add_parts(l * depth_f_.by_motion_Me, a, a[kDepth], b, b[kDepth]);
    } else if (h.of_master) {
      return;
    } else if (kind == kAtDepth0) {
      const FaceDepth depth_h = depth_of(h);
      add_parts(-along_level(a, b, depth_h.per_s, depth_h.per_t) * depth_h.by_motion_Me, a, 0, b, 0);
    } else {
      const Vector3d V = (b[kT] - a[kT]) * prism.inward_Me(2) - (b[kS] - a[kS]) * prism.inward_Me(0);
      if (kind == kCrossing || &h == &part_.f) {
        add_parts(V, a, a[kDepth], b, b[kDepth]);
      } else {
        const auto edge = static_cast<std::size_t>(kind);
        add_parts(V, a, depth_on_edge(h, edge, a), b, depth_on_edge(h, edge, b));
      }
    }
  }

  /// A side that moves by V . d(X), X at depths below a and b that may not be f's: in two parts where f's is clamped on
  /// one of them.
  void add_parts(const Vector3d& V, const PrismPoint& a, double depth_a, const PrismPoint& b, double depth_b) {
    if (!(V.allFinite() && std::isfinite(depth_a) && std::isfinite(depth_b))) return;
    const double above_a = part_.most - a[kDepth], above_b = part_.most - b[kDepth];
    if (!(std::min(above_a, above_b) < 0 && std::max(above_a, above_b) > 0)) {
      add_part(V, a, depth_a, b, depth_b);
      return;
    }
    const double share = above_a / (above_a - above_b);
    const PrismPoint between = a + share * (b - a);
    const double depth = depth_a + share * (depth_b - depth_a);
    add_part(share * V, a, depth_a, between, depth);
    add_part((1 - share) * V, between, depth, b, depth_b);
  }

  /// By Simpson's rule, exact for products of three linear functions.
  void add_part(const Vector3d& V, const PrismPoint& a, double depth_a, const PrismPoint& b, double depth_b) {
    const auto integrands = [this](const PrismPoint& x) {
      const double depth = std::min(x[kDepth], part_.most);
      return Eigen::Vector4d(1, depth, x[kS] * depth, x[kT] * depth);
    };
    const Eigen::Vector4d twice_middle = 2 * integrands(0.5 * (a + b));
    const Eigen::Vector4d at_a = (integrands(a) + twice_middle) / 6, at_b = (integrands(b) + twice_middle) / 6;
    const Vector3d X_a = point_Me(a, depth_a), X_b = point_Me(b, depth_b);
    for (int i = 0; i < IntegralSlopes::kCount; ++i) sums_.add(i, V, at_a[i] + at_b[i], at_a[i] * X_a + at_b[i] * X_b);
  }

  PosedPair& posed_;
  const SeenPart& part_;
  FaceDepth depth_f_;
  IntegralSlopes sums_;
};

}  // namespace

ElementMotion motion_of_part(PosedPair& posed, const SeenPart& part) {
  const PartSlopes slopes(posed, part);
  const IntegralSlopes& by = slopes.sums();
  const Moments& m = part.moments;
  const MotionSlope &one = by[IntegralSlopes::kOne], &depths = by[IntegralSlopes::kDepths];
  const double twice_area = 2 * part.prism.face().area;
  ElementMotion motion;
  motion.area = unless_too_large({twice_area * one.by_position, twice_area * one.by_rotation});
  motion.depth = of_quotient(depths, m.area, one, m.depth / m.area);
  motion.s = of_quotient(by[IntegralSlopes::kSDepths], m.depth, depths, m.s_depth / m.depth);
  motion.t = of_quotient(by[IntegralSlopes::kTDepths], m.depth, depths, m.t_depth / m.depth);
  motion.edge_s_Me = part.prism.edge_s_Me();
  motion.edge_t_Me = part.prism.edge_t_Me();
  return motion;
}

}  // namespace pcm::fast
