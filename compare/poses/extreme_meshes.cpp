// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/extreme_meshes.h"

#include <cmath>
#include <limits>
#include <string>

#include "compare/poses/exact_arithmetic.h"
#include "compare/poses/greatest_extent.h"

namespace pcm::compare {
namespace {

/// What is done to one surface; 0: nothing.
struct Extreme {
  int scale = 0;     ///< exponent of the power of two
  int flatness = 0;  ///< the axis is scaled by 2^-flatness besides
  int axis = 0;
  int offset = 0;         ///< moved by 2^offset sizes along each axis, or by less where that would round
  bool denormal = false;  ///< zeros become denormal numbers
};

/// Of E and of F.
constexpr std::array<std::array<Extreme, 2>, kExtremes> kTable = {{
    {{{.scale = -240}, {.scale = -240}}},
    {{{.scale = 240}, {.scale = 240}}},
    {{{.scale = -40}, {.scale = -40}}},
    {{{.scale = 40}, {.scale = 40}}},
    {{{.scale = -120}, {.scale = 120}}},
    {{{.scale = 120}, {.scale = -120}}},
    {{{.scale = 20}, {}}},
    {{{}, {.scale = 20}}},
    {{{.offset = 20}, {}}},
    {{{}, {.offset = 20}}},
    {{{.offset = 30}, {.offset = 35}}},
    {{{.offset = 52}, {.offset = 52}}},
    {{{.flatness = 20, .axis = 2}, {}}},
    {{{}, {.flatness = 50, .axis = 0}}},
    {{{.flatness = 50, .axis = 1}, {.flatness = 50, .axis = 1}}},
    {{{.flatness = 30, .axis = 0, .offset = 10}, {.scale = -30}}},
    {{{.denormal = true}, {}}},
    {{{.denormal = true}, {.denormal = true}}},
}};

void scale(const Extreme& extreme, TriangleMesh& mesh) {
  if (extreme.scale == 0 && extreme.flatness == 0) return;
  for (Eigen::Vector3d& x : mesh.vertices) {
    for (int j = 0; j < 3; ++j) x[j] = std::ldexp(x[j], extreme.scale - (j == extreme.axis ? extreme.flatness : 0));
  }
  if (extreme.scale != 0) mesh.name += " scaled by 2^" + std::to_string(extreme.scale);
  if (extreme.flatness != 0)
    mesh.name += std::string(" ") + "xyz"[extreme.axis] + " by 2^-" + std::to_string(extreme.flatness);
}

/// False where a coordinate would be rounded.
bool move(double offset, TriangleMesh& mesh) {
  WatchedArithmetic arithmetic;
  for (Eigen::Vector3d& x : mesh.vertices) {
    for (double& coordinate : x) coordinate = arithmetic.plus(coordinate, offset);
  }
  return arithmetic.exact();
}

void move_far(const Extreme& extreme, TriangleMesh& mesh) {
  const int size = std::ilogb(greatest_extent(mesh));
  for (int exponent = extreme.offset; exponent > 0; --exponent) {
    TriangleMesh moved = mesh;
    if (!move(std::ldexp(1, size + exponent), moved)) continue;
    mesh = std::move(moved);
    mesh.name += " moved by 2^" + std::to_string(exponent) + " sizes";
    return;
  }
}

void make_zeros_denormal(TriangleMesh& mesh) {
  constexpr double kDenormal = std::numeric_limits<double>::denorm_min();
  constexpr std::array kPlaces = {kDenormal, -0.0, -3 * kDenormal, 0.0, 0x1p20 * kDenormal, -kDenormal};
  std::size_t place = 0;
  for (Eigen::Vector3d& x : mesh.vertices) {
    for (double& coordinate : x) {
      if (coordinate == 0) coordinate = kPlaces[place++ % kPlaces.size()];
    }
  }
  mesh.name += " with denormal zeros";
}

TriangleMesh taken_to(const Extreme& extreme, TriangleMesh mesh) {
  scale(extreme, mesh);
  move_far(extreme, mesh);
  if (extreme.denormal) make_zeros_denormal(mesh);
  return mesh;
}

}  // namespace

std::array<TriangleMesh, 2> extreme_meshes(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, std::size_t k) {
  return {taken_to(kTable[k][0], mesh_E), taken_to(kTable[k][1], mesh_F)};
}

}  // namespace pcm::compare
