// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcm::fast {

/// How far off points may be, in a master face's coordinates.
struct PrismPositionError {
  double s = 0;
  double t = 0;
  double depth = 0;  ///< m
};

/// Roundings of what a MasterPrism makes of a face's vertices: the greatest of the three in each coordinate.
struct PrismRounding {
  double s = 0, t = 0;
  double third = 0;  ///< of the weight of p0
  double depth = 0;  ///< m
};

}  // namespace pcm::fast
