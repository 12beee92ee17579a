// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "fast/bounds/face_enclosure.h"
#include "fast/bounds/face_over_piece.h"

namespace pcm::fast {

/// Bounds of the greatest depth that one master face sees in the exact problem (PCM section 6, clipped scheme). What
/// the engine computes is no less than `at_least`, either, where it has the element that is seen there.
struct DepthRange {
  double at_least = 0;  ///< m; 0: nothing is known
  double at_most = 0;   ///< m
};

/// Scratch memory of find_visible_depth.
struct VisibleDepthScratch {
  /// A slave face that may be seen, and which of `others` may cover some of it.
  struct Carrier {
    const FaceOverPieces* face;
    bool has_others;
    std::size_t first, last;
  };
  /// `after`: it certainly hides nothing of the carrier.
  struct Other {
    const FaceOverPieces* face;
    bool compared;
    CertainOrder order;
  };
  /// A convex piece of the master, looked at for one carrier.
  struct Piece {
    ConvexPolygon polygon;
    std::size_t carrier;
    double deepest;  ///< the carrier is nowhere deeper on it, m
  };
  std::vector<FaceOverPieces> faces;  ///< by sight
  std::vector<Carrier> carriers;
  std::vector<Other> others;
  std::vector<Piece> pieces;                    ///< a heap: where a face may be seen for certain
  std::vector<Piece> unsettled;                 ///< a heap: where it may be seen, but not for certain
  std::vector<const FaceOverPieces*> hiders;    ///< certainly before the carrier wherever they cover the piece at hand
  std::vector<const FaceOverPieces*> covering;  ///< those of them whose common border does not meet it
};

/// Bounds the depth of the deepest point that a master face sees in the exact problem, from what its lines may meet.
///
/// A search by branch and bound over pieces of the master, the deepest first. A piece on which a slave face f may be
/// seen is
///
///   - hidden, where faces that certainly lie before f, deeper than 0, cover it. How many of them lie over a point
///     changes only at their outer sides, beyond which no other one of them goes on. These are known but for their
///     position errors. Where none passes over the piece, one point decides for all of it. Sides that two of them
///     share, however they are rounded, do not count.
///   - visible, where f certainly covers all of it and no other face may lie before: its depth there is a lower bound.
///   - parted otherwise along a line that leaves this open, into what lies on either side of the line's uncertainty and
///     what lies within. What can't be parted any more is counted as seen, and as not seen.
///
/// Pieces lose a few roundings with each cut; every test holds for the piece enlarged by as much.
///
/// `leant_weights`: near the master's sides, where a weight is less than that (of p0, p1, p2), other faces of the
/// master that were not entered may hide what is seen. `computed`: the deepest point that the engine sees, m. Where
/// that is no deeper than `floor`, m, no lower bound is looked for; and an upper one only where it is greater than
/// `floor`.
DepthRange find_visible_depth(const std::vector<FaceInView>& sights, const std::array<double, 3>& leant_weights,
                              double computed, double floor, VisibleDepthScratch& scratch);

}  // namespace pcm::fast
