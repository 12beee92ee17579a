// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/face_over_piece.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;

/// How far the border of a face may be off over the master, in both problems and as the engine cuts it.
PrismPositionError border_error(const FaceEnclosure& face) {
  return {face.position_error.s + face.cut_error.s, face.position_error.t + face.cut_error.t, 0};
}

UncertainFunction inside_of_side(const FaceEnclosure& face, std::size_t k) {
  const PrismPoint& a = face.corners[k];
  const PrismPoint& b = face.corners[(k + 1) % 3];
  const double side_s = b[kS] - a[kS], side_t = b[kT] - a[kT];
  const PrismPositionError off = border_error(face);
  const double roundings = 8 * u * (std::abs(side_t * b[kS]) + std::abs(side_s * b[kT]));
  return {-side_t, a[kS], side_s, a[kT], 0, std::abs(side_t) * off.s + std::abs(side_s) * off.t + roundings};
}

}  // namespace

FaceOverPieces::FaceOverPieces(const FaceEnclosure& face)
    : enclosure(&face),
      inside{inside_of_side(face, 0), inside_of_side(face, 1), inside_of_side(face, 2)},
      depth(face.depth, face.depth_error) {}

bool lies_outside(const FaceOverPieces& face, const ConvexPolygon& piece) {
  return std::any_of(face.inside.begin(), face.inside.end(),
                     [&piece](const UncertainFunction& inside) { return inside.sign_over(piece) == Sign::negative; });
}

bool side_may_meet(const FaceOverPieces& face, std::size_t k, const ConvexPolygon& piece) {
  if (face.inside[k].sign_over(piece) != Sign::unsure) return false;
  const PrismPoint& a = face.enclosure->corners[k];
  const PrismPoint& b = face.enclosure->corners[(k + 1) % 3];
  const double side_s = b[kS] - a[kS], side_t = b[kT] - a[kT];
  const PrismPositionError off = border_error(*face.enclosure);
  const double error = std::abs(side_s) * off.s + std::abs(side_t) * off.t;
  return UncertainFunction(side_s, a[kS], side_t, a[kT], 0, error).sign_over(piece) != Sign::negative &&
         UncertainFunction(-side_s, b[kS], -side_t, b[kT], 0, error).sign_over(piece) != Sign::negative;
}

bool leaves_master_alone(const FaceEnclosure& face, std::size_t k) {
  const std::size_t next = (k + 1) % 3;
  if (!face.fixed[k] && !face.fixed[next]) return false;
  if (face.fixed[k] && face.fixed[next]) return true;
  const PrismPoint& corner = face.corners[face.fixed[k] ? k : next];
  const PrismPoint& end = face.corners[face.fixed[k] ? next : k];
  const std::array<double, 3> weight_error = weight_errors(face.hinge_error, face.rounding.third);
  for (int weight = 0; weight < 3; ++weight) {
    if (corner[weight] == 0 && end[weight] < -weight_error[static_cast<std::size_t>(weight)]) return true;
  }
  return false;
}

bool lies_deep(const FaceOverPieces& face, const ConvexPolygon& points) {
  return face.enclosure->only_hangs || face.depth.sign_over(points) == Sign::positive;
}

UncertainFunction depth_beyond(const FaceEnclosure& f, const FaceEnclosure& g) {
  const double s_0 = f.depth.s_0, t_0 = f.depth.t_0;
  const double apart = std::abs(g.depth.per_s) * (std::abs(s_0) + std::abs(g.depth.s_0)) +
                       std::abs(g.depth.per_t) * (std::abs(t_0) + std::abs(g.depth.t_0)) + std::abs(g.depth.value);
  return {f.depth.per_s - g.depth.per_s,        s_0,
          f.depth.per_t - g.depth.per_t,        t_0,
          f.depth.value - g.depth.at(s_0, t_0), f.depth_error + g.depth_error + 8 * u * apart};
}

bool goes_on(const FaceEnclosure& face, std::size_t k, const FaceEnclosure& other) {
  if (face.of_master != other.of_master || face.facing != other.facing) return false;
  for (std::size_t j = 0; j < 3; ++j) {
    if (other.vertices[j] == face.vertices[(k + 1) % 3] && other.vertices[(j + 1) % 3] == face.vertices[k]) return true;
  }
  return false;
}

bool surely_beside(const FaceEnclosure& g, std::size_t k, const FaceEnclosure& f) {
  const double s = f.corner_error.s + g.corner_error.s, t = f.corner_error.t + g.corner_error.t;
  const auto beyond = [&](std::size_t end, std::size_t side) {
    const std::size_t next = (side + 1) % 3;
    if (f.of_master == g.of_master && (g.vertices[end] == f.vertices[side] || g.vertices[end] == f.vertices[next]))
      return true;
    const PrismPoint& from = f.corners[side];
    const double side_s = f.corners[next][kS] - from[kS], side_t = f.corners[next][kT] - from[kT];
    const double to_s = g.corners[end][kS] - from[kS], to_t = g.corners[end][kT] - from[kT];
    // Twice what position errors make pays for the roundings as well.
    const double error =
        2 * s * (std::abs(side_t) + std::abs(to_t) + 4 * t) + 2 * t * (std::abs(side_s) + std::abs(to_s));
    return side_t * to_s - side_s * to_t > error;
  };
  for (std::size_t side = 0; side < 3; ++side) {
    if (beyond(k, side) && beyond((k + 1) % 3, side)) return true;
  }
  return false;
}

Sign sign_within(const FaceOverPieces& face, const PrismPoint& x) {
  Sign sign = Sign::positive;
  for (const UncertainFunction& inside : face.inside) {
    const Sign of_side = inside.sign_at(x);
    if (of_side == Sign::negative) return of_side;
    if (of_side == Sign::unsure) sign = of_side;
  }
  return sign;
}

ConvexPolygon part_covered(const FaceOverPieces& face) {
  ConvexPolygon part;
  part.add({1, 0, 0, 0});
  part.add({0, 1, 0, 0});
  part.add({0, 0, 1, 0});
  for (const UncertainFunction& inside : face.inside) keep_above(part, inside, 1, -inside.parted_at());
  return part;
}

}  // namespace pcm::fast
