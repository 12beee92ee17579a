// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/degenerate/lattice_tetrahedra.h"

#include <string>
#include <utility>

#include "meshes/exact/exact_signs.h"
#include "meshes/generate/degenerate/bodies.h"

namespace pcm::degenerate {
namespace {

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers on every machine.
std::uint64_t next(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

double draw_coordinate(std::uint64_t& state) {
  return static_cast<double>(next(state) % 5) - 2;
}

TriangleMesh draw_tetrahedron(std::uint64_t& state) {
  for (;;) {
    std::array<Eigen::Vector3d, 4> corners;
    for (Eigen::Vector3d& x : corners)
      for (int j = 0; j < 3; ++j) x[j] = draw_coordinate(state);
    if (side_sign(corners[0], corners[1], corners[2], corners[3]) != 0) return tetrahedron(corners);
  }
}

}  // namespace

std::array<TriangleMesh, 2> lattice_tetrahedra(std::uint64_t number) {
  std::uint64_t state = number / 2;
  TriangleMesh first = draw_tetrahedron(state);
  TriangleMesh second = draw_tetrahedron(state);
  first.name = "first lattice tetrahedron " + std::to_string(number / 2);
  second.name = "second lattice tetrahedron " + std::to_string(number / 2);
  if (number % 2 == 1) std::swap(first, second);
  return {std::move(first), std::move(second)};
}

}  // namespace pcm::degenerate
