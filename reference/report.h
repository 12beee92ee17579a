// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/answer.h"
#include "reference/crossing_points.h"
#include "reference/polygons.h"

namespace pcm::reference {

/// Writes polygons with correctly rounded positions, and the number of patches.
void report_polygons(const CrossingPoints& points, const std::vector<Chain>& chains, const std::vector<Index>& patches,
                     Answer& answer);

}  // namespace pcm::reference
