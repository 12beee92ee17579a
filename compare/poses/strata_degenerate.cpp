// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The strata degenerate and near-degenerate: features made to coincide exactly in doubles, then moved by ulps; and for
// the stratum extreme the same with rotations that have drifted.
//
// Two families of rotations keep the arithmetic exact. The 24 rotations of the cube permute and negate coordinates, so
// A x is exact, and with an exact r = x_E - A x_F the features coincide in the rounded and in the exact problem.
// Rotations from integer quaternions have rational entries; rounded to doubles they bring a *vertex* of F exactly onto
// a feature of E in the rounded problem, which is the one the tie rule is about.
//
// Every draw stands in a statement of its own: the order in which a compiler evaluates arguments and operands is its
// own choice, and the poses must be the same bits everywhere.
#include <array>
#include <cmath>
#include <optional>

#include "compare/poses/exact_arithmetic.h"
#include "compare/poses/rotation.h"
#include "compare/poses/rounded_vertices.h"
#include "compare/poses/strata.h"

namespace pcm::compare::detail {
namespace {

using Attempt = std::optional<DrawnPose>;

/// A rotation of the cube that takes the F axis `from` to the E axis `to`, with the sign given.
Eigen::Matrix3d cube_rotation(int from, int to, int sign, PoseRandom& random) {
  const bool even = random.coin();
  const int second = (from + 1) % 3, third = (from + 2) % 3;
  const int to_second = (to + (even ? 1 : 2)) % 3, to_third = (to + (even ? 2 : 1)) % 3;
  const int sign_second = random.coin() ? 1 : -1;
  // The determinant is the parity of the permutation times the three signs.
  const int sign_third = (even ? 1 : -1) * sign * sign_second;
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  A(to, from) = sign;
  A(to_second, second) = sign_second;
  A(to_third, third) = sign_third;
  return A;
}

Eigen::Matrix3d cube_rotation(PoseRandom& random) {
  const int sign = random.coin() ? 1 : -1;
  const auto to = static_cast<int>(random.below(3));
  return cube_rotation(0, to, sign, random);
}

/// A rotation with rational entries (w, x, y, z integers of at most 3, not all 0), each entry rounded once.
Eigen::Matrix3d pythagorean_rotation(PoseRandom& random) {
  for (;;) {
    const double w = static_cast<double>(random.below(7)) - 3, x = static_cast<double>(random.below(7)) - 3;
    const double y = static_cast<double>(random.below(7)) - 3, z = static_cast<double>(random.below(7)) - 3;
    const double square = w * w + x * x + y * y + z * z;
    if (square == 0) continue;
    Eigen::Matrix3d A;
    A << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
        2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
        2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
    for (int k = 0; k < 9; ++k) A(k / 3, k % 3) /= square;
    return A;
  }
}

Eigen::Vector3d draw_vertex(const SurfaceFeatures& surface, PoseRandom& random) {
  return vertex(surface, surface.used_vertices[random.below(surface.used_vertices.size())]);
}

/// A quarter, a half or three quarters of the way along the edge.
Eigen::Vector3d point_of_edge(const SurfaceFeatures& surface, const FeatureEdge& edge, PoseRandom& random,
                              WatchedArithmetic& arithmetic) {
  const Eigen::Vector3d& a = vertex(surface, edge.ends[0]);
  const double part = 0.25 * static_cast<double>(1 + random.below(3));
  return arithmetic.plus(a, arithmetic.times(arithmetic.minus(vertex(surface, edge.ends[1]), a), part));
}

/// The point with weights (1/2, 1/4, 1/4) in some order.
Eigen::Vector3d point_of_face(const SurfaceFeatures& surface, Index face, PoseRandom& random,
                              WatchedArithmetic& arithmetic) {
  const Triangle& corners = surface.mesh.faces[static_cast<std::size_t>(face)];
  const std::uint64_t k = random.below(3);
  const Eigen::Vector3d& p = vertex(surface, corners[k]);
  const Eigen::Vector3d& q = vertex(surface, corners[(k + 1) % 3]);
  const Eigen::Vector3d& s = vertex(surface, corners[(k + 2) % 3]);
  const Eigen::Vector3d sides = arithmetic.plus(arithmetic.minus(q, p), arithmetic.minus(s, p));
  return arithmetic.plus(p, arithmetic.times(sides, 0.25));
}

/// A vertex of the face, a point of its plane's interior, or a point of one of its sides.
Eigen::Vector3d point_on_face(const SurfaceFeatures& surface, Index face, PoseRandom& random,
                              WatchedArithmetic& arithmetic) {
  const Triangle& corners = surface.mesh.faces[static_cast<std::size_t>(face)];
  const std::uint64_t k = random.below(3);
  switch (random.below(3)) {
    case 0:
      return vertex(surface, corners[k]);
    case 1:
      return point_of_edge(surface, {{corners[k], corners[(k + 1) % 3]}, {}}, random, arithmetic);
    default:
      return point_of_face(surface, face, random, arithmetic);
  }
}

const FeatureEdge& draw_edge(const SurfaceFeatures& surface, PoseRandom& random) {
  return surface.edges[random.below(surface.edges.size())];
}

/// Of a surface that has one.
const AxisFace& draw_axis_face(const SurfaceFeatures& surface, PoseRandom& random) {
  return surface.axis_faces[random.below(surface.axis_faces.size())];
}

/// The coordinate along its axis, the same at all of the face's points.
double height_of(const SurfaceFeatures& surface, const AxisFace& face) {
  return vertex(surface, surface.mesh.faces[static_cast<std::size_t>(face.face)][0])[face.axis];
}

Index draw_face(const SurfaceFeatures& surface, PoseRandom& random) {
  return static_cast<Index>(random.below(surface.mesh.faces.size()));
}

/// Brings x_F onto x_E: r = x_E - A x_F. Nothing where any step so far was rounded; the product by a rational rotation
/// may be, for then the rounded problem's vertex is the rounded product.
Attempt placed(const Eigen::Matrix3d& A, const Eigen::Vector3d& x_E, const Eigen::Vector3d& x_F,
               WatchedArithmetic arithmetic, std::string_view construction) {
  DrawnPose drawn;
  drawn.pose.A = A;
  drawn.pose.r = arithmetic.minus(x_E, ordered_product(A, x_F));
  drawn.construction = construction;
  drawn.exact = arithmetic.exact();
  return drawn.exact ? Attempt(drawn) : std::nullopt;
}

Eigen::Matrix3d draw_rotation(PoseRandom& random) {
  return random.coin() ? cube_rotation(random) : pythagorean_rotation(random);
}

Attempt vertex_on_vertex(const FeaturePair& pair, PoseRandom& random) {
  const Eigen::Matrix3d A = draw_rotation(random);
  const Eigen::Vector3d x_F = draw_vertex(pair.F, random);
  const Eigen::Vector3d x_E = draw_vertex(pair.E, random);
  return placed(A, x_E, x_F, {}, "vertex on vertex");
}

/// A vertex of either body on a point that `point_of(surface, arithmetic)` draws on the other one.
template <typename PointOf>
Attempt vertex_on(PointOf point_of, const FeaturePair& pair, PoseRandom& random, std::string_view construction) {
  WatchedArithmetic arithmetic;
  if (random.coin()) {
    const Eigen::Vector3d x_F = point_of(pair.F, arithmetic);
    const Eigen::Vector3d x_E = draw_vertex(pair.E, random);
    return placed(cube_rotation(random), x_E, x_F, arithmetic, construction);
  }
  const Eigen::Matrix3d A = draw_rotation(random);
  const Eigen::Vector3d x_E = point_of(pair.E, arithmetic);
  return placed(A, x_E, draw_vertex(pair.F, random), arithmetic, construction);
}

Attempt vertex_on_edge(const FeaturePair& pair, PoseRandom& random) {
  const auto point = [&](const SurfaceFeatures& surface, WatchedArithmetic& arithmetic) {
    return point_of_edge(surface, draw_edge(surface, random), random, arithmetic);
  };
  return vertex_on(point, pair, random, "vertex on edge");
}

Attempt vertex_on_face(const FeaturePair& pair, PoseRandom& random) {
  const auto point = [&](const SurfaceFeatures& surface, WatchedArithmetic& arithmetic) {
    return point_of_face(surface, draw_face(surface, random), random, arithmetic);
  };
  return vertex_on(point, pair, random, "vertex on face");
}

Attempt edge_across_edge(const FeaturePair& pair, PoseRandom& random) {
  WatchedArithmetic arithmetic;
  const Eigen::Vector3d x_E = point_of_edge(pair.E, draw_edge(pair.E, random), random, arithmetic);
  const Eigen::Vector3d x_F = point_of_edge(pair.F, draw_edge(pair.F, random), random, arithmetic);
  return placed(cube_rotation(random), x_E, x_F, arithmetic, "edge across edge");
}

/// An edge of F that keeps one coordinate is laid into an axis-aligned face of E.
Attempt edge_in_face(const FeaturePair& pair, PoseRandom& random) {
  if (pair.E.axis_faces.empty()) return std::nullopt;
  const AxisFace& face = draw_axis_face(pair.E, random);
  const FeatureEdge& edge = draw_edge(pair.F, random);
  const auto axis = static_cast<int>(random.below(3));
  if (vertex(pair.F, edge.ends[0])[axis] != vertex(pair.F, edge.ends[1])[axis]) return std::nullopt;
  WatchedArithmetic arithmetic;
  const Eigen::Vector3d x_E = point_on_face(pair.E, face.face, random, arithmetic);
  const Eigen::Vector3d x_F = point_of_edge(pair.F, edge, random, arithmetic);
  return placed(cube_rotation(axis, face.axis, random.coin() ? 1 : -1, random), x_E, x_F, arithmetic, "edge in face");
}

/// Two axis-aligned faces in one plane, sharing a point: normals opposed (a resting body) or equal (flush flanks).
Attempt coplanar_faces(const FeaturePair& pair, PoseRandom& random) {
  if (pair.E.axis_faces.empty() || pair.F.axis_faces.empty()) return std::nullopt;
  const AxisFace& on_E = draw_axis_face(pair.E, random);
  const AxisFace& on_F = draw_axis_face(pair.F, random);
  const bool opposed = random.below(4) != 0;
  const int sign = on_E.sign * on_F.sign * (opposed ? -1 : 1);
  WatchedArithmetic arithmetic;
  const Eigen::Vector3d x_E = point_on_face(pair.E, on_E.face, random, arithmetic);
  const Eigen::Vector3d x_F = point_on_face(pair.F, on_F.face, random, arithmetic);
  return placed(cube_rotation(on_F.axis, on_E.axis, sign, random), x_E, x_F, arithmetic,
                opposed ? "coplanar faces, opposed" : "coplanar faces, flush");
}

bool same_mesh(const FeaturePair& pair) {
  return pair.E.mesh.faces == pair.F.mesh.faces && pair.E.mesh.vertices == pair.F.mesh.vertices;
}

Attempt identical_bodies(const FeaturePair& pair, PoseRandom& random) {
  if (!same_mesh(pair) || random.below(8) != 0) return std::nullopt;
  DrawnPose drawn;
  drawn.construction = "identical bodies";
  drawn.exact = true;
  return drawn;
}

/// Identical bodies, one slid along one of its own edges by a dyadic part of it: coplanar faces, collinear edges.
Attempt slid_along_an_edge(const FeaturePair& pair, PoseRandom& random) {
  if (!same_mesh(pair)) return std::nullopt;
  const FeatureEdge& edge = draw_edge(pair.E, random);
  WatchedArithmetic arithmetic;
  const std::uint64_t quarters = 1 + random.below(4);
  const double part = 0.25 * static_cast<double>(quarters) * (random.coin() ? 1 : -1);
  DrawnPose drawn;
  drawn.pose.r = arithmetic.times(arithmetic.minus(vertex(pair.E, edge.ends[1]), vertex(pair.E, edge.ends[0])), part);
  drawn.construction = "slid along an edge";
  drawn.exact = arithmetic.exact();
  return drawn.exact ? Attempt(drawn) : std::nullopt;
}

/// The bounding boxes stacked along one axis; along the others flush on one side, or shifted by half the extent.
Attempt stacked(const FeaturePair& pair, PoseRandom& random) {
  DrawnPose drawn;
  drawn.pose.A = cube_rotation(random);
  const Eigen::Vector3d corner_1 = ordered_product(drawn.pose.A, pair.F.box_min);
  const Eigen::Vector3d corner_2 = ordered_product(drawn.pose.A, pair.F.box_max);
  const Eigen::Vector3d low = corner_1.cwiseMin(corner_2), high = corner_1.cwiseMax(corner_2);
  const auto axis = static_cast<int>(random.below(3));
  WatchedArithmetic arithmetic;
  for (int j = 0; j < 3; ++j) {
    const bool from_above = random.coin();
    if (j == axis) {
      drawn.pose.r[j] =
          from_above ? arithmetic.plus(pair.E.box_max[j], -low[j]) : arithmetic.plus(pair.E.box_min[j], -high[j]);
    } else {
      const double flush =
          from_above ? arithmetic.plus(pair.E.box_max[j], -high[j]) : arithmetic.plus(pair.E.box_min[j], -low[j]);
      const double extent = arithmetic.plus(pair.E.box_max[j], -pair.E.box_min[j]);
      drawn.pose.r[j] =
          random.coin() ? flush : arithmetic.plus(flush, arithmetic.times(extent, from_above ? -0.5 : 0.5));
    }
  }
  drawn.construction = "stacked";
  drawn.exact = arithmetic.exact();
  return drawn.exact ? Attempt(drawn) : std::nullopt;
}

// Coordinates that fill all 53 bits make most differences round; some feature of a large surface then still fits.
constexpr int kMostAttempts = 256;

/// More than the engine takes, so that what is left of it often comes close to that.
constexpr double kGreatestDrift = 0x1p-30;

/// In each entry another drift, up to the greatest.
Eigen::Matrix3d draw_drift(PoseRandom& random, double greatest) {
  Eigen::Matrix3d D;
  for (int k = 0; k < 9; ++k) {
    const double step = random.log_uniform(0x1p-52, greatest);
    D(k / 3, k % 3) = random.coin() ? step : -step;
  }
  return D;
}

/// Off by that, or by a half or a quarter of it, so that the engine still takes it: max |A^T A - I| is at most 1e-9.
Eigen::Matrix3d drifted(const Eigen::Matrix3d& A, Eigen::Matrix3d D) {
  while (!is_rotation(A + D)) D *= 0.5;
  return A + D;
}

/// Coplanar faces whose coordinate along their axis the drift only stretches, by the same amount at every vertex.
Attempt drifted_coplanar_faces(const FeaturePair& pair, PoseRandom& random) {
  if (pair.E.axis_faces.empty() || pair.F.axis_faces.empty()) return std::nullopt;
  const AxisFace& on_E = draw_axis_face(pair.E, random);
  const AxisFace& on_F = draw_axis_face(pair.F, random);
  const int sign = on_E.sign * on_F.sign * (random.coin() ? 1 : -1);
  const Eigen::Matrix3d exact = cube_rotation(on_F.axis, on_E.axis, sign, random);
  Eigen::Matrix3d D = draw_drift(random, kGreatestDrift);
  for (int j = 0; j < 3; ++j)
    if (j != on_F.axis) D(on_E.axis, j) = 0;
  WatchedArithmetic unwatched;
  const Eigen::Vector3d x_E = point_on_face(pair.E, on_E.face, random, unwatched);
  const Eigen::Vector3d x_F = point_on_face(pair.F, on_F.face, random, unwatched);
  DrawnPose drawn;
  drawn.pose.A = drifted(exact, D);
  drawn.pose.r = x_E - ordered_product(drawn.pose.A, x_F);
  WatchedArithmetic arithmetic;
  const double height_F = drawn.pose.A(on_E.axis, on_F.axis) * height_of(pair.F, on_F);
  drawn.pose.r[on_E.axis] = arithmetic.plus(height_of(pair.E, on_E), -height_F);
  drawn.construction = "drifted, coplanar faces";
  drawn.exact = arithmetic.exact();
  return drawn.exact ? Attempt(drawn) : std::nullopt;
}

Attempt drifted_onto_feature(const FeaturePair& pair, PoseRandom& random) {
  const Eigen::Matrix3d exact = draw_rotation(random);
  const Eigen::Matrix3d A = drifted(exact, draw_drift(random, kGreatestDrift));
  const Eigen::Vector3d x_F = draw_vertex(pair.F, random);
  WatchedArithmetic arithmetic;
  switch (random.below(3)) {
    case 0:
      return placed(A, draw_vertex(pair.E, random), x_F, arithmetic, "drifted, vertex on vertex");
    case 1: {
      const Eigen::Vector3d x_E = point_of_edge(pair.E, draw_edge(pair.E, random), random, arithmetic);
      return placed(A, x_E, x_F, arithmetic, "drifted, vertex on edge");
    }
    default: {
      const Eigen::Vector3d x_E = point_of_face(pair.E, draw_face(pair.E, random), random, arithmetic);
      return placed(A, x_E, x_F, arithmetic, "drifted, vertex on face");
    }
  }
}

}  // namespace

DrawnPose draw_drifted(const FeaturePair& pair, PoseRandom& random) {
  const bool coplanar = random.below(4) == 0;
  for (int attempt = 0; attempt < kMostAttempts; ++attempt)
    if (const Attempt drawn = coplanar ? drifted_coplanar_faces(pair, random) : drifted_onto_feature(pair, random))
      return *drawn;
  DrawnPose nearly = draw_degenerate(pair, random);
  nearly.pose.A = drifted(nearly.pose.A, draw_drift(random, kGreatestDrift));
  nearly.construction = "drifted";
  nearly.exact = false;
  return nearly;
}

DrawnPose draw_degenerate(const FeaturePair& pair, PoseRandom& random) {
  constexpr std::array kConstructions = {vertex_on_vertex, vertex_on_edge,     vertex_on_face,
                                         edge_across_edge, edge_in_face,       coplanar_faces,
                                         identical_bodies, slid_along_an_edge, stacked};
  for (int attempt = 0; attempt < kMostAttempts; ++attempt)
    if (const Attempt drawn = kConstructions[random.below(kConstructions.size())](pair, random)) return *drawn;
  DrawnPose nearly;
  nearly.pose.A = cube_rotation(random);
  const Eigen::Vector3d x_E = draw_vertex(pair.E, random);
  nearly.pose.r = x_E - ordered_product(nearly.pose.A, draw_vertex(pair.F, random));
  nearly.construction = "vertex on vertex, rounded";
  return nearly;
}

void move_by_ulps(const FeaturePair& pair, PoseRandom& random, DrawnPose& drawn) {
  // r by 1 to 8 of its own ulps or of those of E's coordinates (an ulp of a tiny r would vanish in r + A x) along a
  // drawn set of axes; in one pose of four the entries of A as well.
  const std::uint64_t axes = 1 + random.below(7);
  const bool own_ulps = random.coin();
  for (int j = 0; j < 3; ++j) {
    const std::uint64_t magnitude = 1 + random.below(8);
    const double steps = static_cast<double>(magnitude) * (random.coin() ? 1 : -1);
    if ((axes >> j & 1) == 0) continue;
    const double scale = std::max(std::abs(pair.E.box_min[j]), std::abs(pair.E.box_max[j]));
    double& r = drawn.pose.r[j];
    r += steps * ulp_of(own_ulps && r != 0 ? r : std::max(std::abs(r), scale));
  }
  if (random.below(4) == 0) drawn.pose.A = drifted(drawn.pose.A, draw_drift(random, 0x1p-33));
  drawn.exact = false;
}

}  // namespace pcm::compare::detail
