// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "tests/reference/brute_force/steps.h"

namespace pcm::brute_force {
namespace {

std::vector<Vector> corners(const Body& body, Index face) {
  return {body.corner(face, 0), body.corner(face, 1), body.corner(face, 2)};
}

/// The part of a polygon below the face (in -z) and within the face's shadow.
std::vector<Vector> below_face(std::vector<Vector> polygon, const Body& body, Index face, const Vector& inward) {
  const Vector& normal = body.normals[face];
  const bool upwards = normal[2] > 0;
  for (int i = 0; i < 3 && !polygon.empty(); ++i) {
    const Vector& a = body.corner(face, i);
    const Vector edge = body.corner(face, (i + 1) % 3) - a;
    // The vertical wall through the edge; seen from above the face winds the other way where its normal looks down.
    const Vector to_left{Rational(-edge[1]), edge[0], 0};
    const Vector into_shadow = upwards ? to_left : Rational(-1) * to_left;
    polygon = clipped(polygon, into_shadow, dot(into_shadow, a), inward);
  }
  const Vector down = upwards ? Rational(-1) * normal : normal;
  return clipped(polygon, down, dot(down, body.corner(face, 0)), inward);
}

bool coplanar(const Body& body, Index face, const Vector& normal, const Vector& point) {
  return std::ranges::all_of(corners(body, face), [&](const Vector& x) { return dot(normal, x - point) == 0; });
}

/// The part of a polygon in the face's plane that the face covers.
std::vector<Vector> within_face(std::vector<Vector> polygon, const Body& body, Index face) {
  for (int i = 0; i < 3 && !polygon.empty(); ++i) {
    const Vector& a = body.corner(face, i);
    const Vector to_left = cross(body.normals[face], body.corner(face, (i + 1) % 3) - a);
    polygon = clipped(polygon, to_left, dot(to_left, a), to_left);
  }
  return polygon;
}

}  // namespace

std::vector<Vector> clipped(const std::vector<Vector>& polygon, const Vector& gradient, const Rational& level,
                            const Vector& inward) {
  std::vector<Rational> height;
  for (const Vector& x : polygon) height.push_back(dot(gradient, x) - level);
  if (std::ranges::all_of(height, [](const Rational& h) { return h == 0; }))
    return dot(gradient, inward) > 0 ? polygon : std::vector<Vector>{};
  std::vector<Vector> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (height[i] >= 0) kept.push_back(polygon[i]);
    if (sgn(height[i]) * sgn(height[j]) < 0)
      kept.push_back(polygon[i] + Rational(height[i] / (height[i] - height[j])) * (polygon[j] - polygon[i]));
  }
  return kept;
}

Measure measure(const std::vector<Vector>& polygon, const Vector& normal) {
  Measure result;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector doubled = cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    const Rational fraction = dot(doubled, normal) / dot(normal, normal);
    result.fraction += fraction;
    result.moment = result.moment + Rational(fraction / 3) * (polygon[0] + polygon[i - 1] + polygon[i]);
  }
  return result;
}

/// A point is inside F as often as the upward ray from it leaves F more than it enters: the sum of +1 for every face
/// above it that looks up, -1 for one that looks down. So the area of e inside F is the sum of its areas below the
/// faces. e is moved into its own body by a vanishing distance: then nothing of the other surface lies in its plane.
void clip_by_prisms(Answer& answer) {
  for (const Side side : {Side::E, Side::F}) {
    const Body& body = answer.scene.body(side);
    const Body& surface = answer.scene.body(other(side));
    ActiveArea& active = side == Side::E ? answer.E : answer.F;
    active.shares.resize(body.faces.size());
    for (Index e = 0; e < std::ssize(body.faces); ++e) {
      const Vector& normal = body.normals[e];
      if (normal == Vector{}) continue;
      const Vector inward = Rational(-1) * normal;
      Share& share = active.shares[e];
      for (Index f = 0; f < std::ssize(surface.faces); ++f) {
        const Vector& surface_normal = surface.normals[f];
        if (surface_normal == Vector{}) continue;
        if (surface.closed && surface_normal[2] != 0) {
          const Measure part = measure(below_face(corners(body, e), surface, f, inward), normal);
          const Rational sign = sgn(surface_normal[2]);
          share.below += sign * part.fraction;
          share.moment = share.moment + sign * part.moment;
        }
        if (!coplanar(surface, f, normal, body.corner(e, 0))) continue;
        const Measure covered = measure(within_face(corners(body, e), surface, f), normal);
        if (dot(normal, surface_normal) > 0) {
          share.equal += covered.fraction;
          share.equal_moment = share.equal_moment + covered.moment;
        } else {
          share.opposite += covered.fraction;
        }
      }
    }
  }
}

}  // namespace pcm::brute_force
