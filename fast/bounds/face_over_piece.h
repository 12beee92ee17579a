// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "fast/bounds/face_enclosure.h"
#include "fast/bounds/uncertain_function.h"
#include "fast/prism/convex_polygon.h"

/// What is certain, in the rounded problem and in the exact one, of a face of which only the enclosure is known, over a
/// convex piece of the master. Faces are counterclockwise in (s, t), their facing sure, but where it says otherwise.
namespace pcm::fast {

/// A face and the functions that pieces are looked at with, made once for many of them. Where the face's facing is not
/// sure they tell nothing: its depth is off by any amount.
struct FaceOverPieces {
  const FaceEnclosure* enclosure;
  /// Positive on the inner side of side k of a counterclockwise face. The engine reckons it from either end.
  std::array<UncertainFunction, 3> inside;
  UncertainFunction depth;

  /// The enclosure must outlive this.
  explicit FaceOverPieces(const FaceEnclosure& face);
};

/// Whether the face covers no point of the piece.
bool lies_outside(const FaceOverPieces& face, const ConvexPolygon& piece);

/// Whether side k may have a point over the piece.
bool side_may_meet(const FaceOverPieces& face, std::size_t k, const ConvexPolygon& piece);

/// Whether side k of a face of the master's body meets the master nowhere, or where the master ends: it is a side of
/// the master, or leads from a corner of it to a point that is certainly beyond a side through that corner.
bool leaves_master_alone(const FaceEnclosure& face, std::size_t k);

/// Whether the face lies deeper than 0 wherever it covers the points. One that hangs from the master's corners is at
/// depth 0 only there.
bool lies_deep(const FaceOverPieces& face, const ConvexPolygon& points);

/// How much farther f is than g.
UncertainFunction depth_beyond(const FaceEnclosure& f, const FaceEnclosure& g);

/// The two faces, which look the same way, have side k of the first in common.
bool goes_on(const FaceEnclosure& face, std::size_t k, const FaceEnclosure& other);

/// Whether side k of g has no point within f: both its ends lie beyond one side of f, or are ends of that.
bool surely_beside(const FaceEnclosure& g, std::size_t k, const FaceEnclosure& f);

/// Positive within a face, negative outside.
Sign sign_within(const FaceOverPieces& face, const PrismPoint& x);

/// All of the master that the face may cover.
ConvexPolygon part_covered(const FaceOverPieces& face);

}  // namespace pcm::fast
