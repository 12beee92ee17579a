// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/brute_force/scene.h"

#include <algorithm>
#include <cassert>

namespace pcm::brute_force {
namespace {

Vector exact(const Eigen::Vector3d& x) {
  return {Rational(x[0]), Rational(x[1]), Rational(x[2])};
}

/// x_E = A x_F + r over the reals, or rounded.
Vector posed(const Eigen::Vector3d& x, const Pose& pose, reference::Problem problem) {
  if (problem == reference::Problem::rounded) return exact(rounded_point(x, pose));
  Vector result = exact(pose.r);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result[i] += Rational(pose.A(i, j)) * Rational(x[j]);
  return result;
}

void derive(Body& body) {
  for (Index f = 0; f < std::ssize(body.faces); ++f) {
    body.normals.push_back(cross(body.corner(f, 1) - body.corner(f, 0), body.corner(f, 2) - body.corner(f, 0)));
    for (int i = 0; i < 3; ++i)
      body.faces_of_edge[edge_between(body.faces[f][i], body.faces[f][(i + 1) % 3])].push_back(f);
  }
  body.closed = std::ranges::all_of(body.faces_of_edge, [](const auto& entry) { return entry.second.size() == 2; });
}

/// A polynomial in eps: exponent -> coefficient.
using Polynomial = std::map<int, Rational>;

Polynomial difference(const Polynomial& a, const Polynomial& b) {
  Polynomial result = a;
  for (const auto& [exponent, coefficient] : b) result[exponent] -= coefficient;
  return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [i, x] : a)
    for (const auto& [j, y] : b) result[i + j] += x * y;
  return result;
}

using PolynomialVector = std::array<Polynomial, 3>;

/// The point moved by (eps^(2^(3 rank - 1)), eps^(2^(3 rank - 2)), eps^(2^(3 rank - 3))), rank 1 to 4.
PolynomialVector moved(const Vector& x, int rank) {
  PolynomialVector result;
  for (int j = 1; j <= 3; ++j) {
    result[j - 1][0] = x[j - 1];
    result[j - 1][1 << (3 * rank - j)] = 1;
  }
  return result;
}

/// Sign, for all small eps > 0, of the determinant of the moved points.
///
/// The exponents are 2^(3 i - j) of the four vertices' true ranks i in the tie rule, astronomically large; ranks 1 to 4
/// in the same order give the same sign. For each term of the determinant is a coefficient times a product of moves of
/// different coordinates, so its exponent is a sum of *different* powers of two; two such sums compare as binary
/// numbers do, by the highest place in which they differ, and that depends on the order of the (i, j) only. The lowest
/// term with a coefficient that is not zero is therefore the same one.
int perturbed_sign(const std::array<RankedPoint, 4>& points) {
  std::array<PolynomialVector, 4> x;
  for (int i = 0; i < 4; ++i) {
    int rank = 1;
    for (const RankedPoint& p : points) rank += p.rank < points[i].rank ? 1 : 0;
    x[i] = moved(*points[i].x, rank);
  }
  std::array<PolynomialVector, 3> row;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) row[i][j] = difference(x[i + 1][j], x[0][j]);
  Polynomial determinant;
  for (int j = 0; j < 3; ++j) {
    const Polynomial minor = difference(product(row[0][(j + 1) % 3], row[1][(j + 2) % 3]),
                                        product(row[0][(j + 2) % 3], row[1][(j + 1) % 3]));
    for (const auto& [exponent, coefficient] : product(minor, row[2][j])) determinant[exponent] += coefficient;
  }
  for (const auto& [exponent, coefficient] : determinant)
    if (coefficient != 0) return sgn(coefficient);
  assert(false && "two of the four points have the same rank");
  return 0;
}

}  // namespace

Eigen::Vector3d rounded_point(const Eigen::Vector3d& x, const Pose& pose) {
  Eigen::Vector3d result;
  for (int i = 0; i < 3; ++i) {
    const double first = pose.A(i, 0) * x[0];
    const double second = pose.A(i, 1) * x[1];
    const double third = pose.A(i, 2) * x[2];
    result[i] = ((first + second) + third) + pose.r[i];
  }
  return result;
}

Scene scene_of(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Pose& pose, reference::Problem problem) {
  Scene scene;
  scene.E.faces = mesh_E.faces;
  scene.F.faces = mesh_F.faces;
  for (const auto& x : mesh_E.vertices) scene.E.vertices.push_back(exact(x));
  for (const auto& x : mesh_F.vertices) scene.F.vertices.push_back(posed(x, pose, problem));
  scene.F.first_rank = static_cast<Index>(scene.E.vertices.size());
  scene.rank_count = scene.F.first_rank + static_cast<Index>(scene.F.vertices.size());
  scene.r_MeMf = exact(pose.r);

  // All denominators are powers of two, so the greatest is a common one.
  mpz_class denominator = 1;
  const auto widen = [&](const Vector& x) {
    for (const Rational& c : x) denominator = std::max(denominator, mpz_class(c.get_den()));
  };
  for (const Vector& x : scene.E.vertices) widen(x);
  for (const Vector& x : scene.F.vertices) widen(x);
  const Rational scale(denominator);
  for (Vector& x : scene.E.vertices) x = scale * x;
  for (Vector& x : scene.F.vertices) x = scale * x;
  scene.r_MeMf = scale * scene.r_MeMf;
  scene.unit = 1 / scale;
  derive(scene.E);
  derive(scene.F);
  return scene;
}

int orientation(const RankedPoint& a, const RankedPoint& b, const RankedPoint& c, const RankedPoint& d) {
  const int sign = sgn(dot(cross(*b.x - *a.x, *c.x - *a.x), *d.x - *a.x));
  return sign != 0 ? sign : perturbed_sign({a, b, c, d});
}

int passage(const RankedPoint& a, const RankedPoint& b, const std::array<RankedPoint, 3>& triangle) {
  const auto& [p, q, s] = triangle;
  const int side_a = orientation(p, q, s, a);
  if (side_a == orientation(p, q, s, b)) return 0;
  const int around = orientation(a, b, p, q);
  if (orientation(a, b, q, s) != around || orientation(a, b, s, p) != around) return 0;
  return side_a;
}

RankedPoint ranked(const Body& body, Index vertex) {
  return {&body.vertices[vertex], body.first_rank + vertex};
}

std::array<RankedPoint, 3> ranked_face(const Body& body, Index face) {
  const Triangle& t = body.faces[face];
  return {ranked(body, t[0]), ranked(body, t[1]), ranked(body, t[2])};
}

}  // namespace pcm::brute_force
