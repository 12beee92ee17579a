// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "meshes/generate/round.h"

namespace pcm::degenerate {
namespace {

/// An upright open rectangle, one metre along x, whose lower border is the x axis and which is two metres high.
Case pierced_by_rectangle(std::string name, std::string shows, const Eigen::Vector3d& lower_middle) {
  Case result = shifted_pair(std::move(name), std::move(shows), generate::box({0, 0, 0}, {4, 4, 2}),
                             generate::rectangle(1, 2), std::nullopt, lower_middle + Eigen::Vector3d(0, 0, 1));
  result.A << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return result;
}

/// Five by three metres and one metre thick, with two square holes.
TriangleMesh plate_with_two_holes() {
  std::vector<std::array<int, 3>> cubes;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 3; ++j)
      if (j != 1 || i % 2 == 0) cubes.push_back({i, j, 0});
  return union_of_cubes(cubes);
}

}  // namespace

std::vector<Case> unusual_topologies() {
  const TriangleMesh large = generate::box({0, 0, 0}, {4, 4, 4});
  const TriangleMesh hollow = joined(large, inverted(generate::box({1, 1, 1}, {3, 3, 3})));
  // With four segments each way a torus is a square ring of square cross-section with integer vertices:
  // | |x| + |y| - 2 | + |z| <= 1.
  const TriangleMesh square_ring = generate::torus(2, 1, 4, 4);
  const TriangleMesh plate = generate::box({-4, -4, -1}, {4, 4, 0});
  const TriangleMesh pins = joined(generate::box({-3, 1, -1}, {-2, 2, 0.5}), generate::box({-1, 2, -1}, {0, 3, 0.5}));

  Case bubble_in_container =
      shifted_pair("bubble_in_open_container", "a closed body against an open container, four patches",
                   generate::pyramid(), generate::bubble(), std::nullopt, {0, 0, 0.2109375});
  bubble_in_container.exactly_representable = false;

  return {
      shifted_pair("nested_box", "F inside E without a crossing", large, generate::box({1, 1, 1}, {2, 2, 2}), 1),
      shifted_pair("nested_in_box", "E inside F without a crossing", generate::box({1, 1, 1}, {2, 2, 2}), large, 1),
      shifted_pair("box_in_cavity", "F in the cavity of E, outside its material", hollow,
                   generate::box({1.5, 1.5, 1.5}, {2.5, 2.5, 2.5}), 0),
      shifted_pair("box_filling_cavity", "F fills the cavity of E: every face against an opposite one", hollow,
                   generate::box({1, 1, 1}, {3, 3, 3}), 0),
      shifted_pair("box_through_cavity_wall", "F reaches from the material of E into its cavity", hollow,
                   generate::box({0.5, 0.5, 0.5}, {2, 2, 2}), 2.375),
      shifted_pair("nested_in_cavity_wall", "F inside the material of E between surface and cavity", hollow,
                   generate::box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}), 0.125),
      shifted_pair("ring_on_plate", "a patch in the shape of a ring", plate, square_ring, 2, {0, 0, 0.5}),
      shifted_pair("ring_resting_on_plate", "a closed chain of edges in the plane of a face", plate, square_ring, 0,
                   {0, 0, 1}),
      shifted_pair("holed_plate_in_plate", "a patch with two holes", generate::box({-1, -1, -1}, {6, 4, 0}),
                   plate_with_two_holes(), 6.5, {0, 0, -0.5}),
      shifted_pair("holed_plate_resting_on_plate", "a face of E touched in an area with two holes",
                   generate::box({-1, -1, -1}, {6, 4, 0}), plate_with_two_holes(), 0),
      shifted_pair("two_pins_under_plate", "two patches on one face of E, F of two components",
                   generate::box({-4, -4, 0}, {4, 4, 1}), pins, 1),
      pierced_by_rectangle("open_border_inside_patch", "an open surface ends inside E", {3, 1, 1}),
      pierced_by_rectangle("open_border_on_face", "an open surface ends exactly in a face of E", {3, 1, 2}),
      pierced_by_rectangle("open_border_across_edge", "an open surface, its side borders outside and inside E",
                           {4, 1, 1}),
      bubble_in_container,
  };
}

}  // namespace pcm::degenerate
