// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "tests/reference/brute_force/steps.h"

namespace pcm::brute_force {
namespace {

/// A face with two of Me's axes u, v such that it winds counterclockwise in (u, v): coordinates of its plane.
struct Chart {
  std::vector<Vector> polygon;
  Vector normal;
  Vector u{};
  Vector v{};
};

Chart chart_of(const Body& body, Index face) {
  Chart chart;
  for (int i = 0; i < 3; ++i) chart.polygon.push_back(body.corner(face, i));
  chart.normal = body.normals[face];
  const int k = chart.normal[0] != 0 ? 0 : chart.normal[1] != 0 ? 1 : 2;
  const bool positive = chart.normal[k] > 0;
  chart.u[(k + (positive ? 1 : 2)) % 3] = 1;
  chart.v[(k + (positive ? 2 : 1)) % 3] = 1;
  return chart;
}

/// What passing the directed segment p -> q in the direction of u adds to the integral of the winding number over the
/// face, if the winding number is one higher on the segment's left: the fraction of the face beyond the segment,
/// positive for a segment running down in v.
Rational swept(const Chart& chart, const Vector& p, const Vector& q) {
  const Vector along = q - p;
  const Rational du = dot(chart.u, along);
  const Rational dv = dot(chart.v, along);
  if (dv == 0) return 0;
  const Rational up = sgn(dv);
  const Vector beyond = up * (dv * chart.u - du * chart.v);
  const Vector nowhere{};
  auto part = clipped(chart.polygon, up * chart.v, dot(up * chart.v, p), nowhere);
  part = clipped(part, -up * chart.v, dot(-up * chart.v, q), nowhere);
  part = clipped(part, beyond, dot(beyond, p), nowhere);
  return -up * measure(part, chart.normal).fraction;
}

bool border_ends_in(const Answer& answer, const Steps& steps, Side side, Index face) {
  return std::ranges::any_of(steps.passages, [&](const auto& entry) {
    const Crossing& crossing = entry.first;
    return crossing.edge_side == other(side) && crossing.face == face &&
           answer.scene.body(other(side)).faces_of_edge.at(crossing.edge).size() == 1;
  });
}

/// Winding numbers of the face's corners; about an open surface the smallest is 0, or 1 where all labels say inside.
std::array<int, 3> corner_windings(const Answer& answer, const Steps& steps, Side side, Index face) {
  const Triangle& t = answer.scene.body(side).faces[face];
  const int s = index_of(side);
  if (answer.scene.body(other(side)).closed)
    return {steps.winding[s][t[0]], steps.winding[s][t[1]], steps.winding[s][t[2]]};
  std::array<int, 3> w{};
  w[1] = w[0] + change_along(steps, side, t[0], t[1]);
  w[2] = w[1] + change_along(steps, side, t[1], t[2]);
  const int least = *std::ranges::min_element(w);
  const bool inside = std::ranges::any_of(t, [&](Index v) { return steps.vertex_inside[s][v]; });
  const bool outside = std::ranges::any_of(t, [&](Index v) { return steps.vertex_outside[s][v]; });
  const int base = w[0] == w[1] && w[1] == w[2] && inside && !outside ? 1 : 0;
  for (int& x : w) x += base - least;
  return w;
}

/// Integral of the winding number over the face, the winding number being carried from the face's boundary in the
/// direction of u.
Rational swept_share(const Answer& answer, const Steps& steps, Side side, Index face) {
  const Body& body = answer.scene.body(side);
  const Chart chart = chart_of(body, face);
  const std::array<int, 3> w = corner_windings(answer, steps, side, face);
  Rational share = 0;
  for (int i = 0; i < 3; ++i) {
    const Index a = body.faces[face][i];
    const Index b = body.faces[face][(i + 1) % 3];
    if (dot(chart.v, body.vertices[b] - body.vertices[a]) >= 0) continue;  // seen against u, not part of the boundary
    share += w[i] * swept(chart, body.vertices[a], body.vertices[b]);
    for (const auto& [crossing, passes] : steps.passages) {
      if (crossing.edge_side != side || crossing.edge != edge_between(a, b)) continue;
      const int change = crossing.edge[0] == a ? passes : -passes;
      share += change * swept(chart, answer.positions.at(crossing), body.vertices[b]);
    }
  }
  for (const auto& [pair, segment] : steps.segments) {
    if (pair[index_of(side)] != face) continue;
    const Vector& start = answer.positions.at(segment[0]);
    const Vector& end = answer.positions.at(segment[1]);
    share += side == Side::E ? swept(chart, start, end) : swept(chart, end, start);
  }
  if (answer.scene.body(other(side)).closed) return share;
  return std::clamp(share, Rational(0), Rational(1));
}

/// How often the other surface winds about all of a face that is not crossed; an open one counts an inner face once.
int uncrossed_share(const Answer& answer, const Steps& steps, Side side, Index face) {
  if (answer.scene.body(other(side)).closed)
    return steps.winding[index_of(side)][answer.scene.body(side).faces[face][0]];
  return steps.active[index_of(side)][face] ? 1 : 0;
}

}  // namespace

void sweep_perturbed_areas(Answer& answer, const Steps& steps) {
  for (const Side side : {Side::E, Side::F}) {
    ActiveArea& active = side == Side::E ? answer.E : answer.F;
    for (Index face = 0; face < std::ssize(answer.scene.body(side).faces); ++face)
      if (!steps.intersected[index_of(side)][face])
        active.shares[face].perturbed = uncrossed_share(answer, steps, side, face);
    for (const Index face : active.intersected) {
      if (border_ends_in(answer, steps, side, face)) {
        ++answer.undefined_areas;
      } else if (answer.scene.body(side).normals[face] != Vector{}) {
        active.shares[face].perturbed = swept_share(answer, steps, side, face);
      }
    }
  }
}

}  // namespace pcm::brute_force
