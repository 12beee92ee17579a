// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "tests/reference/brute_force/clipped_strips.h"
#include "tests/reference/brute_force/steps.h"

namespace pcm::brute_force {
namespace {

/// A face as seen along -N from the points p0 + s (p1 - p0) + t (p2 - p0) of a master face.
struct SeenFace {
  Side side = Side::E;
  Index index = 0;
  bool leaves = false;          ///< the line leaves the face's body there
  std::array<Linear, 3> sides;  ///< none negative: the point's line passes through the face ...
  Linear distance;              ///< ... at x - q N, q = distance

  bool met_at(const Rational& s, const Rational& t) const {
    return distance.at(s, t) >= 0 &&
           std::ranges::all_of(sides, [&](const Linear& side_of) { return side_of.at(s, t) >= 0; });
  }
};

/// A master face and all that its lines may meet.
struct View {
  std::array<Vector, 3> p;
  Vector N;
  std::vector<SeenFace> faces;

  /// The linear function of x that is f(x), as a function of s and t.
  template <class F>
  Linear linear(const F& f) const {
    const Rational at_origin = f(p[0]);
    return {at_origin, Rational(f(p[1])) - at_origin, Rational(f(p[2])) - at_origin};
  }
};

/// Whether the part of the triangle where f >= 0 has no area.
bool negative_nearly_everywhere(const Linear& f) {
  const bool zero = f.at_origin == 0 && f.along_s == 0 && f.along_t == 0;
  return !zero && f.at_origin <= 0 && f.at_origin + f.along_s <= 0 && f.at_origin + f.along_t <= 0;
}

void add_face(View& view, const Body& body, Side side, Index index) {
  const Vector& normal = body.normals[index];
  const Rational slope = dot(view.N, normal);
  if (slope == 0) return;
  SeenFace face{side, index, slope < 0, {}, {}};
  for (int i = 0; i < 3; ++i) {
    const Vector& a = body.corner(index, i);
    const Vector& b = body.corner(index, (i + 1) % 3);
    face.sides[i] =
        view.linear([&](const Vector& x) -> Rational { return sgn(slope) * dot(view.N, cross(a - x, b - x)); });
    if (negative_nearly_everywhere(face.sides[i])) return;
  }
  face.distance =
      view.linear([&](const Vector& x) -> Rational { return dot(x - body.corner(index, 0), normal) / slope; });
  if (negative_nearly_everywhere(face.distance)) return;
  view.faces.push_back(std::move(face));
}

View view_of(const Scene& scene, Side master, Index index) {
  const Body& body = scene.body(master);
  const Body& slave = scene.body(other(master));
  View view{{body.corner(index, 0), body.corner(index, 1), body.corner(index, 2)}, body.normals[index], {}};
  for (Index g = 0; g < std::ssize(body.faces); ++g)
    if (g != index) add_face(view, body, master, g);
  for (Index f = 0; f < std::ssize(slave.faces); ++f) add_face(view, slave, other(master), f);
  return view;
}

/// The slave face that the line of a point leaves the slave through, where it is the first it meets and no other face
/// of the master comes before.
std::optional<Index> seen_from(const View& view, Side master, const Rational& s, const Rational& t) {
  const SeenFace* first = nullptr;
  Rational q;
  for (const SeenFace& f : view.faces) {
    if (f.side == master || !f.met_at(s, t)) continue;
    const Rational distance = f.distance.at(s, t);
    if (first && distance >= q) continue;
    first = &f;
    q = distance;
  }
  if (!first || !first->leaves) return {};
  for (const SeenFace& g : view.faces)
    if (g.side == master && g.met_at(s, t) && g.distance.at(s, t) < q) return {};
  return first->index;
}

/// Wherever `seen_from` may change: a face begins or ends, or two change their order; the order of the master's own
/// faces among themselves means nothing.
std::vector<Boundary> boundaries_of(const View& view, Side master) {
  std::vector<Boundary> result;
  for (auto g = view.faces.begin(); g != view.faces.end(); ++g) {
    for (const Linear& side : g->sides) result.push_back({side, {g->sides[0], g->sides[1], g->sides[2], g->distance}});
    result.push_back({g->distance, {g->sides[0], g->sides[1], g->sides[2]}});
    for (auto h = std::next(g); h != view.faces.end(); ++h)
      if (g->side != master || h->side != master)
        result.push_back({g->distance - h->distance,
                          {g->sides[0], g->sides[1], g->sides[2], h->sides[0], h->sides[1], h->sides[2], g->distance}});
  }
  return result;
}

/// Integrals over a part of the triangle.
struct Integrals {
  Rational area;
  Rational distance;
  Rational s_distance;
  Rational t_distance;
  Rational greatest;
};

/// A point (s, t).
using Corner = std::array<Rational, 2>;

/// `clamped`: the distance as it counts there, linear too.
void add_triangle(Integrals& sum, const std::array<Corner, 3>& x, const Linear& distance, const Linear& clamped) {
  const Rational doubled = (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[2][0] - x[0][0]) * (x[1][1] - x[0][1]);
  if (doubled == 0) return;
  std::array<Rational, 3> d;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = clamped.at(x[i][0], x[i][1]);
    sum.greatest = std::max(sum.greatest, distance.at(x[i][0], x[i][1]));
  }
  const Rational d_sum = d[0] + d[1] + d[2];
  sum.area += doubled / 2;
  sum.distance += doubled * d_sum / 6;
  // The integral of a product of linear functions a, b is area / 12 (sum of a_i b_i + sum of a_i sum of b_i).
  const auto product = [&](std::size_t k) -> Rational {
    const Rational products = x[0][k] * d[0] + x[1][k] * d[1] + x[2][k] * d[2];
    return doubled * (products + (x[0][k] + x[1][k] + x[2][k]) * d_sum) / 24;
  };
  sum.s_distance += product(0);
  sum.t_distance += product(1);
}

/// The strips' sides less what two of them have in common, in units.
Rational perimeter_of(const View& view, const std::vector<Strip>& strips) {
  const auto length = [&](const Rational& s, const Rational& t) -> Rational {
    const Vector x = s * (view.p[1] - view.p[0]) + t * (view.p[2] - view.p[0]);
    return Rational(mpf_class(sqrt(mpf_class(dot(x, x), 128))));
  };
  const auto along = [&](const Line& line, const Rational& from, const Rational& to) {
    return from < to ? length(to - from, line.at(to) - line.at(from)) : Rational(0);
  };
  const auto across = [&](const Rational& low, const Rational& high) {
    return low < high ? length(0, high - low) : Rational(0);
  };
  Rational sum = 0;
  for (const Strip& a : strips) {
    sum += along(a.lower, a.from, a.to) + along(a.upper, a.from, a.to);
    for (const Rational& s : {a.from, a.to}) sum += across(a.lower.at(s), a.upper.at(s));
    for (const Strip& b : strips) {
      if (a.upper == b.lower) sum -= 2 * along(a.upper, std::max(a.from, b.from), std::min(a.to, b.to));
      if (a.to == b.from)
        sum -= 2 * across(std::max(a.lower.at(a.to), b.lower.at(a.to)), std::min(a.upper.at(a.to), b.upper.at(a.to)));
    }
  }
  return sum;
}

/// The length of a vector of integers, to 2^-700.
Rational length_of(const Vector& N) {
  const mpz_class square(dot(N, N).get_num() << 1400);
  return Rational(sqrt(square)) / Rational(mpz_class(1) << 700);
}

/// A slave face that a point sees, and whether it does from beyond the clamp, in one number.
Index sight_of(Index face, bool beyond) {
  return 2 * face + (beyond ? 1 : 0);
}

void find_elements_of(Answer& answer, Side master, Index face, const std::optional<Rational>& q_max) {
  const View view = view_of(answer.scene, master, face);
  if (view.N == Vector{}) return;
  const auto face_of = [&](Index f) {
    return *std::ranges::find_if(view.faces, [&](const SeenFace& g) { return g.side != master && g.index == f; });
  };
  const auto question = [&](const Rational& s, const Rational& t) -> std::optional<Index> {
    const std::optional<Index> f = seen_from(view, master, s, t);
    if (!f) return {};
    return sight_of(*f, q_max && face_of(*f).distance.at(s, t) > *q_max);
  };
  std::vector<Boundary> boundaries = boundaries_of(view, master);
  if (q_max)
    for (const SeenFace& f : view.faces)
      if (f.side != master && f.leaves)
        boundaries.push_back({f.distance - Linear{*q_max, 0, 0}, {f.sides[0], f.sides[1], f.sides[2]}});
  std::map<Index, Integrals> parts;
  std::map<Index, std::vector<Strip>> strips;
  for (const Strip& strip : strips_of(boundaries, question)) {
    const Index f = strip.answer / 2;
    const Linear distance = face_of(f).distance;
    const Linear clamped = strip.answer == sight_of(f, true) ? Linear{*q_max, 0, 0} : distance;
    strips[f].push_back(strip);
    const Corner a{strip.from, strip.lower.at(strip.from)};
    const Corner b{strip.to, strip.lower.at(strip.to)};
    const Corner c{strip.to, strip.upper.at(strip.to)};
    const Corner d{strip.from, strip.upper.at(strip.from)};
    add_triangle(parts[f], {a, b, c}, distance, clamped);
    add_triangle(parts[f], {a, c, d}, distance, clamped);
  }
  for (const auto& [f, part] : parts) {
    if (part.distance == 0) continue;
    const Vector foot = view.p[0] + Rational(part.s_distance / part.distance) * (view.p[1] - view.p[0]) +
                        Rational(part.t_distance / part.distance) * (view.p[2] - view.p[0]);
    answer.elements.push_back({master, face, f, Rational(part.distance / part.area), part.area, part.greatest, foot,
                               perimeter_of(view, strips[f])});
  }
}

}  // namespace

void find_clipped_elements(Answer& answer, Mode mode, double max_penetration) {
  answer.elements.clear();
  for (const Side master : {Side::E, Side::F}) {
    if (mode != Mode::both && (mode == Mode::E) != (master == Side::E)) continue;
    const ActiveArea& active = answer.active(master);
    std::set<Index> faces(active.intersected.begin(), active.intersected.end());
    faces.insert(active.inner.begin(), active.inner.end());
    for (const Index face : faces) {
      std::optional<Rational> q_max;
      const Vector& N = answer.scene.body(master).normals[face];
      if (!std::isinf(max_penetration) && N != Vector{})
        q_max = Rational(max_penetration) / answer.scene.unit / length_of(N);
      find_elements_of(answer, master, face, q_max);
    }
  }
}

}  // namespace pcm::brute_force
