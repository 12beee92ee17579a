// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pcm/triangle_mesh.h"

/// What the generators share: validation of their parameters and the connectivity of grids.
namespace pcm::generate {

/// Lengths that generators accept, m: areas and volumes of such sizes neither underflow nor overflow.
constexpr double kMinLength = 1e-50;
constexpr double kMaxLength = 1e50;

/// Greatest count of subdivisions a generator accepts, so that the number of faces fits an Index.
constexpr Index kMaxCount = 8192;

/// The shortest decimal that reads back as this double, for messages.
std::string shortest_decimal(double value);

/// Throws BadInput naming the parameter unless kMinLength <= value <= kMaxLength.
void require_length(std::string_view parameter, double value);

/// Throws BadInput naming the parameter unless smallest < value < largest (NaN is refused).
void require_between(std::string_view parameter, double value, double smallest, double largest);

/// Throws BadInput naming the parameter unless smallest <= value <= largest.
void require_count(std::string_view parameter, Index value, Index smallest, Index largest = kMaxCount);

/// The mesh under its name, after a check that rounding made no two vertices coincide and left no face without an area:
/// dimensions that differ by more than the precision of a double are bad input. O(n log n) in the number of vertices.
TriangleMesh finished(std::string_view name, std::vector<Eigen::Vector3d> vertices, std::vector<Triangle> faces);

/// Faces of a sphere-like grid: vertex 0 is the first pole, 1 + j segments + k is vertex k of ring j, the last vertex
/// is the other pole. Seen from outside, with the first pole below, the vertices of a ring run from left to right. 2
/// segments rings faces.
std::vector<Triangle> pole_to_pole_faces(Index rings, Index segments);

/// Faces of a torus-like grid: i segments + k is vertex k of ring i; after the last ring comes the first again. Seen
/// from outside, with ring i below ring i + 1, the vertices of a ring run from left to right. 2 segments rings faces.
std::vector<Triangle> ring_faces(Index rings, Index segments);

/// A point of the profile of a surface of revolution, m.
struct ProfilePoint {
  double radius = 0;
  double z = 0;
};

/// The closed surface that the profile describes when it turns about the z axis in `segments` equal steps. The profile
/// runs from a pole (radius 0) to a pole, all other radii positive, with the body on its left where the radius axis
/// points right and z up. 2 segments (profile size - 2) faces.
TriangleMesh surface_of_revolution(std::string_view name, const std::vector<ProfilePoint>& profile, Index segments);

}  // namespace pcm::generate
