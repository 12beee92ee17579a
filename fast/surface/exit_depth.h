// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/surface/prepared_surface.h"

namespace pcm::fast {

double upper_bound_of_exit_depth(const PreparedSurface& surface, Index face);

/// By which depth all penetration lines of a face, but for some of no area, have met another face of the same closed
/// surface, m: no element of the clipped scheme lies deeper (PCM section 6). Infinite where that is not known. Holds
/// wherever the bounds of the face's thickness hold (fast/surface/thickness.h), of the rounded problem and the exact
/// one. Computed when first asked for.
inline double exit_depth(const PreparedSurface& surface, Index face) {
  return surface.known_exit_depth.get(face, [&] { return upper_bound_of_exit_depth(surface, face); });
}

}  // namespace pcm::fast
