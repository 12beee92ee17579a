// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/prism/convex_polygon.h"

namespace pcm::fast {

/// A cut of a polygon has parted nothing from it but a sliver, which is dropped. Returns the line of the border that
/// the cut runs along and did not quite reach: that of the longest side, other than the cut's own, of the sliver and of
/// what lies on its side of the cut. A border on several lines is told as one; `cut` where all sides have no length.
///
/// `heights`: of the polygon, positive on the other side of the cut, some of them negative. Those at the border's ends
/// are roundings, of either sign. So what is found on the one side of the cut and on the other need not be all of the
/// polygon together, and the border may be the sliver's, or missing there and taken from the rest all the same.
SideLine line_beside_cut(const ConvexPolygon& sliver, const ConvexPolygon& polygon, const Heights& heights,
                         SideLine cut);

}  // namespace pcm::fast
