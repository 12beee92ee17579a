// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "fast/crossings/pair_signs.h"

namespace pcm::fast {

/// How far points of f may move, m, so that a pair of faces goes on to cross through the same edges, or not to cross; 0
/// or less where that can't be told. e stands still.
///
/// Faces that do not cross are apart by a gap along some direction: before they touch, a point of f must move by as
/// much. Asked are the normals of both and the directions across two edges. Where an edge passes through the other
/// face it goes on to until one of its ends lies in that face, or it meets a side of it: then the two have a point of f
/// in common, which has moved by at least the distance between them. It is no less than that of an end from the face's
/// plane, and that between the lines of two edges. While both edges that bound the segment pass, no others do.
///
/// `signs`: those of the pair.
double pair_margin(const std::array<Eigen::Vector3d, 3>& e, const std::array<Eigen::Vector3d, 3>& f,
                   const PairSigns& signs);

}  // namespace pcm::fast
