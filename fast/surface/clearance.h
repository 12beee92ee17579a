// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "fast/surface/prepared_surface.h"

namespace pcm::fast {

/// A line lies within a face's cone where the cosine of its angle with the face's normal exceeds this: within the
/// narrow one, whose clearance is greater, or else the wide one.
inline constexpr std::array<double, 2> kConeCosine{0.79, 0.652};

/// How far any coordinate of a surface's vertices may be moved, relative to its greatest one, with its clearances still
/// true.
inline constexpr double kClearanceTolerance = 0x1p-30;

Clearance find_clearance(const PreparedSurface& surface, Index face);

/// The face's clearance. A steep line through a face stays within a cone about the normal, over all of the face's
/// points: in the region K of the points at a depth h >= 0 whose feet are at most T h from the face, T somewhat greater
/// than the tangent of the steepest angle. The least depth at which another face reaches into K bounds how near it may
/// be met. Nothing is known of needles; infinite where no face is beneath. Computed when first asked for.
inline Clearance clearance(const PreparedSurface& surface, Index face) {
  return surface.known_clearance.get(face, [&] { return find_clearance(surface, face); });
}

}  // namespace pcm::fast
