// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/brute_force/elements.h"

#include <optional>

#include "tests/reference/brute_force/steps.h"

namespace pcm::brute_force {
namespace {

/// The penetration line of a master face (PCM section 6): from its barycentre C along -N, both taken exactly.
struct Line {
  Vector C;
  Vector N;
  std::array<Vector, 2> shifts;  ///< p1 - p0 and p2 - p0: C is moved by d, d^2 of them where it is not generic
};

/// A face met by the line: at C - q N. `order` is q with its derivatives along the shifts: hits compare by it.
struct Hit {
  Index face = 0;
  bool leaves = false;
  std::array<Rational, 3> order;
};

int first_sign(const Rational& value, const Rational& first, const Rational& second) {
  if (value != 0) return sgn(value);
  return first != 0 ? sgn(first) : sgn(second);
}

std::optional<Hit> hit(const Line& line, const Body& body, Index face) {
  const Vector& normal = body.normals[face];
  const Rational slope = dot(line.N, normal);
  if (slope == 0) return {};
  for (int i = 0; i < 3; ++i) {
    const Vector& a = body.corner(face, i);
    const Vector& b = body.corner(face, (i + 1) % 3);
    const Rational side = dot(line.N, cross(a - line.C, b - line.C));
    const int sign =
        first_sign(side, dot(a - b, cross(line.N, line.shifts[0])), dot(a - b, cross(line.N, line.shifts[1])));
    if (sign != sgn(slope)) return {};  // outside this edge: a face seen from its front winds counterclockwise
  }
  Hit result;
  result.face = face;
  result.leaves = slope < 0;
  result.order = {Rational(-dot(body.corner(face, 0) - line.C, normal) / slope),
                  Rational(dot(line.shifts[0], normal) / slope), Rational(dot(line.shifts[1], normal) / slope)};
  if (result.order[0] < 0) return {};
  return result;
}

void find_element(Answer& answer, Side master, Index face) {
  const Body& body = answer.scene.body(master);
  const Body& slave = answer.scene.body(other(master));
  const Vector& p = body.corner(face, 0);
  Line line;
  line.N = body.normals[face];
  if (line.N == Vector{}) return;
  line.C = Rational(1, 3) * (p + body.corner(face, 1) + body.corner(face, 2));
  line.shifts = {body.corner(face, 1) - p, body.corner(face, 2) - p};

  std::optional<Hit> first;
  for (Index f = 0; f < std::ssize(slave.faces); ++f) {
    const std::optional<Hit> met = hit(line, slave, f);
    if (met && (!first || met->order < first->order)) first = met;
  }
  if (!first || !first->leaves) return;
  for (Index e = 0; e < std::ssize(body.faces); ++e) {
    if (e == face) continue;
    const std::optional<Hit> met = hit(line, body, e);
    if (!met || !(met->order < first->order)) continue;
    ++answer.too_deep;
    return;
  }
  const Rational& q = first->order[0];
  if (q > 0) answer.elements.push_back({master, face, first->face, q, Rational(1, 2), q, line.C});
}

/// C_k (13) with equal layers.
Vector exact_position(const Scene& scene, const Element& element) {
  return element.foot - Rational(element.q / 2) * scene.body(element.master).normals[element.master_face];
}

Vector force_or_torque(const Scene& scene, const Element& element, bool torque, const Rational& stiffness) {
  const Vector& N = scene.body(element.master).normals[element.master_face];
  // c_l A u n_k with A = alpha |N|, u = q |N|, n_k = -N / |N|; what is left out here is the factor |N|.
  Vector force = Rational(-stiffness * element.alpha * element.q) * N;
  if (element.master == Side::F) force = Rational(-1) * force;
  if (!torque) return force;
  return cross(exact_position(scene, element) - scene.r_MeMf, force);
}

/// factor |N|, correctly rounded.
double times_normal(const Scene& scene, const Element& element, const Rational& factor) {
  const Vector& N = scene.body(element.master).normals[element.master_face];
  return rounded({Root{factor, dot(N, N)}});
}

}  // namespace

void find_elements(Answer& answer, const Steps& steps, Mode mode) {
  for (const Side master : {Side::E, Side::F}) {
    if (mode != Mode::both && (mode == Mode::E) != (master == Side::E)) continue;
    for (Index face = 0; face < std::ssize(answer.scene.body(master).faces); ++face)
      if (steps.active[index_of(master)][face]) find_element(answer, master, face);
  }
}

double penetration(const Scene& scene, const Element& element) {
  return times_normal(scene, element, element.q * scene.unit);
}

double greatest_penetration(const Scene& scene, const Element& element) {
  return times_normal(scene, element, element.q_greatest * scene.unit);
}

double element_area(const Scene& scene, const Element& element) {
  return times_normal(scene, element, element.alpha * scene.unit * scene.unit);
}

std::array<double, 3> element_position(const Scene& scene, const Element& element) {
  const Vector C = scene.unit * exact_position(scene, element);
  return {rounded(C[0]), rounded(C[1]), rounded(C[2])};
}

std::array<double, 3> element_force(const Scene& scene, const Element& element, const Rational& stiffness) {
  const Vector force =
      Rational(scene.unit * scene.unit * scene.unit) * force_or_torque(scene, element, false, stiffness);
  return {times_normal(scene, element, force[0]), times_normal(scene, element, force[1]),
          times_normal(scene, element, force[2])};
}

ForceAndTorque elastic_force(const Answer& answer, const Rational& stiffness, Mode mode) {
  const Rational weight = mode == Mode::both ? Rational(1, 2) : Rational(1);
  const Rational cube = answer.scene.unit * answer.scene.unit * answer.scene.unit;
  ForceAndTorque result;
  for (int i = 0; i < 3; ++i) {
    std::vector<Root> force;
    std::vector<Root> torque;
    for (const Element& element : answer.elements) {
      const Vector& N = answer.scene.body(element.master).normals[element.master_face];
      const Rational radicand = dot(N, N);
      force.push_back(
          {Rational(weight * cube * force_or_torque(answer.scene, element, false, stiffness)[i]), radicand});
      torque.push_back(
          {Rational(weight * cube * answer.scene.unit * force_or_torque(answer.scene, element, true, stiffness)[i]),
           radicand});
    }
    result.force[i] = rounded(force);
    result.torque[i] = rounded(torque);
  }
  return result;
}

}  // namespace pcm::brute_force
