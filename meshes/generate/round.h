// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pcm/triangle_mesh.h"

/// Inscribed polyhedra of smooth bodies: every vertex lies on the smooth surface (to rounding), so areas and volumes
/// are too small by an error of second order in the edge length. All closed, about the z axis where there is one,
/// normals outward, lengths in metres. Every generator throws BadInput naming the parameter that is out of range, and
/// gives the same bits on every machine.
namespace pcm::generate {

/// Icosahedron whose faces are split in four `level` times (0 to 10), each time with the new vertices pushed out to the
/// sphere about the origin: 20 * 4^level faces.
TriangleMesh icosphere(double radius, Index level);

/// Sphere of meridians and parallels about the origin, poles on the z axis; `bands` from pole to pole (at least 2):
/// 2 segments (bands - 1) faces.
TriangleMesh uv_sphere(double radius, Index segments, Index bands);

/// Cylinder between z = -length / 2 and length / 2; the side in `bands` bands, each cap in `cap_rings` rings (1: a fan
/// about its centre): 2 segments (bands + 2 cap_rings - 1) faces.
TriangleMesh cylinder(double radius, double length, Index segments, Index bands = 1, Index cap_rings = 1);

/// Cone with its base in z = 0 and its apex at z = height; the side in `bands` bands, the base in `cap_rings` rings:
/// 2 segments (bands + cap_rings - 1) faces.
TriangleMesh cone(double radius, double height, Index segments, Index bands = 1, Index cap_rings = 1);

/// Tube between z = -length / 2 and length / 2, the body between a bore and a coaxial outside, both in `bands` bands:
/// 4 segments (bands + 1) faces. inner_radius < outer_radius.
TriangleMesh tube(double inner_radius, double outer_radius, double length, Index segments, Index bands = 1);

/// Torus about the z axis in the plane z = 0; tube_radius < ring_radius. 2 segments tube_segments faces.
TriangleMesh torus(double ring_radius, double tube_radius, Index segments, Index tube_segments);

}  // namespace pcm::generate
