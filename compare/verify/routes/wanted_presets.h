// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pcm/inputs.h"

/// What benchmarks ask for, beside everything.
namespace pcm::compare {

inline constexpr Wanted kTouchOnly{.polygons = false, .areas = false, .force = false, .elements = false};
inline constexpr Wanted kPolygonsOnly{.polygons = true, .areas = false, .force = false, .elements = false};
inline constexpr Wanted kForceOnly{.polygons = false, .areas = false, .force = true, .elements = false};
inline constexpr Wanted kForceAndTangent{
    .polygons = false, .areas = false, .force = true, .elements = false, .tangent = true};

}  // namespace pcm::compare
