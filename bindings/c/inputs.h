// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "pcm/inputs.h"
#include "pcm/pcm.h"
#include "pcm/triangle_mesh.h"

/// From what C programs say to what the engine is asked. Nothing is checked here that the engine checks.
namespace pcm::c {

/// Throws BadInput where a number of vertices or faces is greater than an Index.
TriangleMesh mesh_from(const double* vertices, std::size_t vertex_count, const std::int32_t* faces,
                       std::size_t face_count);

pcm_law default_law();
/// These throw BadCall where an enumeration has no such value.
ContactLaw law_from(const pcm_law& law);
Mode mode_from(std::int32_t mode);
Scheme scheme_from(std::int32_t scheme);
Side side_from(std::int32_t side);
Wanted wanted_from(std::uint32_t flags);

/// `A` by rows. Neither may be NULL.
Pose pose_from(const double* A, const double* r);
/// Either may be NULL, for 0.
Velocity velocity_from(const double* v, const double* w);

}  // namespace pcm::c
