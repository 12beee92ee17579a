// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pcm/triangle_mesh.h"

/// Non-convex generators: machine parts and shapes that are hard on contact algorithms. All closed, normals outward,
/// lengths in metres. Every generator throws BadInput naming the parameter that is out of range, and gives the same
/// bits on every machine.
namespace pcm::generate {

/// Round block with a hemispherical hollow in its top, for a ball that nearly conforms: the hollow's centre is the
/// origin, its vertices lie at `radius` from it, the rim and the block's top lie in z = 0; beside and below the hollow
/// the block is `wall` thick. `bands` from the rim to the hollow's lowest point: 2 segments (bands + 2) faces.
TriangleMesh socket(double radius, double wall, Index segments, Index bands);

/// Sphere of meridians and parallels about the origin whose radius varies by the factor
/// 1 + amplitude sin(t) sin(bumps t) cos(bumps p) at the angle t from the axis and p around it; not convex where
/// amplitude bumps^2 is well above 1. 0 < amplitude < 0.5. 2 segments (bands - 1) faces: 20,000 by default.
TriangleMesh bumpy_sphere(double radius = 1, double amplitude = 0.1, Index bumps = 6, Index segments = 125,
                          Index bands = 81);

/// Tube along a trefoil knot, genus 1: the knot winds twice around the z axis on a torus of ring radius `ring_radius`
/// and half that as tube radius. 0 < tube_radius < 0.4 ring_radius (at 0.415 the tube would touch itself);
/// `segments` (at least 48) along the knot: 2 segments tube_segments faces.
TriangleMesh knotted_tube(double ring_radius, double tube_radius, Index segments, Index tube_segments);

/// Spur gear about the z axis between z = -width / 2 and width / 2, a tooth centred on the x axis: involute flanks of
/// 20 degrees pressure angle, pitch radius teeth module / 2, tips one module above it, roots 1.25 modules below. Each
/// flank has `flank_points` points, equally spaced in roll angle, from the base circle (or one module below the pitch
/// circle where that is farther out) to the tip; a straight fillet joins it to the root. At least 6 teeth. 2 teeth (2
/// flank_points + 2) (bands + 1) faces.
TriangleMesh spur_gear(Index teeth, double module, double width, Index flank_points = 4, Index bands = 1);

}  // namespace pcm::generate
