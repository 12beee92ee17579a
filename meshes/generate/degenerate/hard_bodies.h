// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pcm/triangle_mesh.h"

/// Surfaces that are hard on contact algorithms, about one metre large. All are fit for contact; folded ones cross
/// themselves, which checks warn of. Coordinates are small multiples of a power of two where the parameters are, so
/// that features can be made to coincide exactly. Normals point outward.
namespace pcm::degenerate {

/// Closed octagonal spike, tip down, one metre long and half a metre wide at its base in z = 0. Its tip is a fan of
/// eight faces of slope 1 and half-width `tip`, 0 < tip < 1/4. 32 faces.
TriangleMesh fan_tipped_spike(double tip);

/// Closed octahedron from z = -1/2 to 1/2, of half-width `half_width` in x and y. 8 faces.
TriangleMesh needle(double half_width);

/// Open box about the origin without its top. 10 faces.
TriangleMesh open_box(const Eigen::Vector3d& extents);

/// Open sheet folded up and down about z = 0, `folds` strips in a row along x, each `pitch` wide and rising or falling
/// by `height`, from y = -1/2 to 1/2: a straight edge passes through it several times. 2 faces a strip.
TriangleMesh folded_sheet(Index folds, double pitch, double height);

/// The same surface without that face.
TriangleMesh without_face(TriangleMesh mesh, Index face);

/// Closed cube about the origin, one metre along each edge, with a cubical cavity of edges `cavity`, 0 < cavity < 1. 24
/// faces.
TriangleMesh hollow_cube(double cavity);

/// Closed prism between z = -height / 2 and height / 2 over a polygon that may cross itself; each cap is a fan about
/// `centre`, whose neighbours in the polygon must not be in line with it. Its winding numbers are those of the polygon.
/// 4 faces a corner.
TriangleMesh prism_over(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& centre, double height);

/// Prism over a five-pointed star drawn in one line: the winding number is 1 in its points and 2 in its core. 20 faces.
TriangleMesh pentagram();

/// Prism over a figure of eight: the winding number is 1 in its larger loop and -1 in the smaller one. 16 faces.
TriangleMesh figure_of_eight();

/// `count` closed cubes in a row along x, the first one metre large with its lowest corner in the origin, each of the
/// others `halvings` times halved from the one before and as far from it as it is itself large. At most 50 halvings in
/// all. 12 faces a cube.
TriangleMesh shrinking_cubes(Index count, int halvings);

/// `count` closed plates over each other about z = 0, `gap` apart. Each is a truncated pyramid, flat on one side over a
/// triangle two metres wide, its other side three quarters as large: every second one is upside down. Seen from its
/// smaller side nothing of a plate is nearer than its other side. 8 faces a plate.
TriangleMesh plate_stack(Index count, double thickness, double gap);

/// Closed block four metres wide, its top in z = 0, and a closed body upon it that touches it with a keel on the x
/// axis, from -1/2 to 1/2; from there its two lower sides rise by `rise` within half a metre. However little the keel
/// is moved, it leaves the top or sinks beneath it. 22 faces.
TriangleMesh block_with_touching_keel(double rise);

/// Chain of `links` closed tori along x, each through the hole of the one before and turned by a right angle against
/// it. With tube_radius at most a quarter of ring_radius they do not touch. 2 segments tube_segments faces a link; with
/// four segments each way links are square rings with exact corners.
TriangleMesh torus_chain(Index links, double ring_radius, double tube_radius, Index segments, Index tube_segments);

}  // namespace pcm::degenerate
