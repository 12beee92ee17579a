// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/answer.h"
#include "reference/area_values.h"
#include "reference/clipped_areas.h"
#include "reference/polygons.h"

/// From exact combinatorics to correctly rounded doubles: enclosures are refined until both ends round alike; where
/// they never do (a rational number that a double or a midpoint of two doubles equals), rational numbers decide.
namespace pcm::reference {

/// Writes polygons with the positions of their points, and the number of patches.
void report_polygons(const ExactPose& pose, const CrossingPoints& points, const std::vector<Chain>& chains,
                     const std::vector<Index>& patches, Answer& answer);

/// Writes areas, their intervals, vector areas, and the volume where `has_volume`. Vector areas and volume are rational
/// and rounded correctly without exception; areas are sums of shares of |N|, zero is proven by the shares, and the
/// refinement ends at 4096 bits: an area that equals a midpoint of two doubles to that many bits is not told from it.
void report_areas(const ExactPose& pose, const ClippedAreas& areas, bool has_volume, Answer& answer);

}  // namespace pcm::reference
