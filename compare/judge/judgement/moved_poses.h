// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "pcm/inputs.h"

namespace pcm::compare {

/// The neighbours of a pose at which the oracle is asked whether an answer that is wrong would be right there: r moved
/// along each of the 26 directions whose components are -1, 0 or 1, by 1, 2, 4, ... ulps of `scale` and at last by
/// `most` of them, nearest ones first. A is not turned. `scale` is S of DESIGN section 3, the greatest coordinate: an
/// ulp of it is what any coordinate may be off by. None where `most` is 0.
std::vector<Pose> moved_poses(const Pose& pose, double scale, std::int64_t most);

}  // namespace pcm::compare
