// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/active/area_values.h"
#include "reference/active/inside_areas.h"
#include "reference/crossings/crossing_positions.h"
#include "reference/crossings/polygons.h"
#include "reference/vocabulary/answer.h"

/// From exact combinatorics to correctly rounded doubles: enclosures are refined until both ends round alike; where
/// they do not (as where a value equals a double or a midpoint of two), rational numbers and their roots decide.
namespace pcm::reference {

/// Writes polygons with the positions of their points, and the number of patches.
void report_polygons(const ExactPose& pose, const CrossingPositions& points, const std::vector<Chain>& chains,
                     const std::vector<Index>& patches, Answer& answer);

/// Writes areas, their intervals, vector areas, and the volume where `has_volume`. Vector areas and volume are
/// rational, areas are sums of shares of |N| (radical_sum.h): all are rounded correctly without exception.
void report_areas(const ExactPose& pose, const InsideAreas& areas, bool has_volume, Answer& answer);

}  // namespace pcm::reference
