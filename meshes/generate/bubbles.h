// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pcm/triangle_mesh.h"

/// The two surfaces of the paper's scene of bouncing bubbles (PCM section 8).
namespace pcm::generate {

/// A bubble: closed, rotationally symmetric about z, centred at the origin, with a concave waist, so that multiple and
/// conforming contacts occur. Its distance from the origin at the angle t from the axis is
/// (length / 2) (1 + cos(2 t) / 2) / (3 / 2); any factor above 1/5 before cos(2 t) makes the waist concave. Exactly 950
/// faces: 25 segments, 18 bands of quadrilaterals and two polar caps. `length` in metres, 0.40 in the paper. `finer`
/// times as many segments and bands, 1 to 100, approximate the same smooth body: 50 finer (20 finer - 1) faces.
/// Throws BadInput where a parameter is out of range.
TriangleMesh bubble(double length = 0.40, Index finer = 1);

/// The open container of four triangles: an upside-down pyramid without its base, apex at the origin, rim at z = depth.
/// Normals point into the cavity, where the bubbles fall: out of the container's material. Lengths in metres.
/// Throws BadInput where a length is out of range.
TriangleMesh pyramid(double width = 2.0, double depth = 0.6);

}  // namespace pcm::generate
