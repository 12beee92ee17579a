// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// How many extremes there are of a pair.
inline constexpr std::size_t kExtremes = 18;

/// The surfaces of a pair taken to extreme number k: both, or one of them, made 2^240 times as large or as small;
/// flattened along an axis to aspects up to 2^50; moved away from the frame's origin by up to 2^52 sizes; coordinates
/// that are 0 replaced by denormal numbers and by -0. Each coordinate is a power of two times the one it was, or that
/// plus a power of two, without rounding: what coincides still does, and a surface is moved no farther than that holds.
/// Its name says what was done, e.g. "cube scaled by 2^-240".
std::array<TriangleMesh, 2> extreme_meshes(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, std::size_t k);

}  // namespace pcm::compare
