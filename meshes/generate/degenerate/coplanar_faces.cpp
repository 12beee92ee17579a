// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <utility>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/degenerate/catalogue.h"

namespace pcm::degenerate {
namespace {

/// The surface, scaled about the origin and then shifted.
TriangleMesh placed(TriangleMesh mesh, double scale, double shift) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = vertex * scale + Eigen::Vector3d::Constant(shift);
  return mesh;
}

/// Two copies of a body, the second moved by r.
Case copies(std::string name, std::string shows, const TriangleMesh& mesh, const Eigen::Vector3d& r, double volume) {
  return shifted_pair(std::move(name), std::move(shows), mesh, mesh, volume, r);
}

/// F turned about an axis by a multiple of a right angle.
Case turned(Case original, const Eigen::Matrix3d& A, std::string name, std::string shows) {
  original.name = std::move(name);
  original.shows = std::move(shows);
  original.A = A;
  return original;
}

Case with_F(Case original, TriangleMesh mesh_F) {
  original.F = std::move(mesh_F);
  return original;
}

}  // namespace

std::vector<Case> coplanar_faces() {
  const TriangleMesh cube = generate::box({0, 0, 0}, {2, 2, 2});
  const TriangleMesh centred = generate::box({2, 2, 2});
  Eigen::Matrix3d quarter_turn, half_turn;  // about z, about x
  quarter_turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  half_turn << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  const double tiny = std::ldexp(1.0, -100), huge = std::ldexp(1.0, 100), far = std::ldexp(1.0, 40);

  Case less_than_an_ulp =
      copies("identical_boxes_less_than_an_ulp_apart", "F moved by less than half an ulp of every coordinate",
             generate::box({1, 1, 1}, {2, 2, 2}), Eigen::Vector3d::Constant(std::ldexp(1.0, -60)), 1);
  less_than_an_ulp.exactly_representable = false;

  return {
      copies("stacked_boxes", "opposite faces coincide wholly", cube, {0, 0, 2}, 0),
      copies("stacked_boxes_partly", "opposite faces overlap in a quarter", cube, {1, 1, 2}, 0),
      copies("stacked_boxes_half", "opposite faces overlap in a half, flanks flush", cube, {1, 0, 2}, 0),
      with_F(copies("small_box_on_large", "a face of F lies in the interior of an opposite face of E",
                    generate::box({0, 0, 0}, {4, 4, 2}), {2.5, 0.5, 2}, 0),
             generate::box({0, 0, 0}, {1, 1, 1})),
      turned(copies("", "", centred, {0, 0, 2}, 0), quarter_turn, "stacked_boxes_quarter_turn",
             "opposite faces coincide, their diagonals cross"),
      turned(copies("", "", centred, {0, 0, 2}, 0), half_turn, "stacked_boxes_half_turn",
             "opposite faces coincide, F turned by 180 degrees about x"),
      copies("grids_a_third_apart", "faces in a grid on such faces, moved by a third of their spacing",
             generate::gridded_box(6, 2), {1, 2, 6}, 0),
      copies("stacked_boxes_tiny", "opposite faces coincide, size 2^-99", placed(cube, tiny, 0), {0, 0, 2 * tiny}, 0),
      copies("stacked_boxes_huge", "opposite faces coincide, size 2^101", placed(cube, huge, 0), {0, 0, 2 * huge}, 0),
      copies("stacked_boxes_far", "opposite faces coincide, 2^40 from the origin", placed(cube, 1, far), {0, 0, 2}, 0),
      copies("flush_flanks", "boxes that overlap by half with all flanks in common planes", cube, {0, 0, 1}, 4),
      with_F(copies("flush_flank_partly", "one flank of F in the interior of a flank of E", cube, {0, 0.5, 1}, 1),
             generate::box({0, 0, 0}, {1, 1, 2})),
      copies("identical_boxes", "the same body twice", cube, {0, 0, 0}, 8),
      copies("identical_tetrahedra", "the same body twice, no two faces parallel", ridge(), {0, 0, 0}, 2.0 / 3),
      turned(copies("", "", centred, {0, 0, 0}, 8), quarter_turn, "identical_boxes_quarter_turn",
             "the same body twice, diagonals crossing"),
      less_than_an_ulp,
      with_F(copies("sliver", "F is a box of aspect 2^27 stuck into E", generate::box({0, 0, 0}, {4, 4, 2}), {3, 1, 2},
                    std::ldexp(1.0, -28)),
             generate::box({1, std::ldexp(1.0, -27), 1})),
      with_F(copies("sliver_flush", "F is a box of aspect 2^27 with one end in the plane of E's flank",
                    generate::box({0, 0, 0}, {4, 4, 2}), {3.5, 1, 2}, std::ldexp(1.0, -28)),
             generate::box({1, std::ldexp(1.0, -27), 1})),
      with_F(copies("needle", "F is a box of aspect 2^50 stuck into E", generate::box({0, 0, 0}, {4, 4, 2}), {3, 1, 2},
                    std::ldexp(1.0, -51)),
             generate::box({1, std::ldexp(1.0, -50), 1})),
  };
}

}  // namespace pcm::degenerate
