// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "pcm/triangle_mesh.h"
#include "tests/fast/exact_numbers.h"

/// What faces of a mesh are to each other, exactly, in rational numbers.
namespace pcm::fast {

inline std::array<RationalVector, 3> exact_points_of(const TriangleMesh& mesh, Index face) {
  const Triangle& t = mesh.faces[static_cast<std::size_t>(face)];
  const auto x = [&](std::size_t k) { return rational(mesh.vertices[static_cast<std::size_t>(t[k])]); };
  return {x(0), x(1), x(2)};
}

/// (p1 - p0) x (p2 - p0)
inline RationalVector exact_normal(const std::array<RationalVector, 3>& p) {
  return cross(minus(p[1], p[0]), minus(p[2], p[0]));
}

inline bool no_face_has_area_0(const TriangleMesh& mesh) {
  for (Index face = 0; face < static_cast<Index>(mesh.faces.size()); ++face) {
    const RationalVector N = exact_normal(exact_points_of(mesh, face));
    if (dot(N, N) == 0) return false;
  }
  return true;
}

/// Where the line of the point p0 + s (p1 - p0) + t (p2 - p0) of a face, along its inward normal, first passes through
/// another one, m; infinite where it passes through none. Borders of faces count not.
inline double exact_first_met(const TriangleMesh& mesh, Index face, const mpq_class& s, const mpq_class& t) {
  const std::array<RationalVector, 3> p = exact_points_of(mesh, face);
  const RationalVector a = minus(p[1], p[0]), b = minus(p[2], p[0]), N = exact_normal(p);
  RationalVector x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = p[0][k] + s * a[k] + t * b[k];
  std::optional<mpq_class> least;
  for (Index other = 0; other < static_cast<Index>(mesh.faces.size()); ++other) {
    if (other == face) continue;
    const std::array<RationalVector, 3> g = exact_points_of(mesh, other);
    const std::array<RationalVector, 3> c{minus(g[0], x), minus(g[1], x), minus(g[2], x)};
    const int side = sgn(dot(N, cross(c[0], c[1])));
    if (side == 0 || sgn(dot(N, cross(c[1], c[2]))) != side || sgn(dot(N, cross(c[2], c[0]))) != side) continue;
    const RationalVector N_g = exact_normal(g);
    const mpq_class share = -dot(N_g, c[0]) / dot(N_g, N);  // of -N
    if (share >= 0 && !(least && *least <= share)) least = share;
  }
  return least ? mpf_class(sqrt(mpf_class(dot(N, N), 400)) * mpf_class(*least, 400)).get_d()
               : std::numeric_limits<double>::infinity();
}

}  // namespace pcm::fast
