// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "fast/base/geometry.h"
#include "fast/posed/posed_pair.h"
#include "fast/prism/line_trace.h"
#include "fast/search/line_search.h"
#include "fast/search/line_walk.h"

namespace pcm::fast {

/// What the penetration line of a master face finds (PCM section 6, barycentric scheme).
struct Penetration {
  enum class Outcome : std::uint8_t {
    none,      ///< it meets no face of the slave, or enters it first, or leaves it at distance 0
    too_deep,  ///< it would leave the slave, but meets another face of the master before
    element,   ///< it leaves the slave through `slave_face` at distance `depth`
  };
  Outcome outcome = Outcome::none;
  Index slave_face = -1;
  double depth = 0;      ///< u (11), m; not negative
  Index first_met = -1;  ///< the first face of the slave that the line meets, whatever comes of it; -1 where none
};

/// Follows the penetration line of face `face` of side `master`. Every decision is exact on the rounded problem; the
/// depth is off by a few ulps of the distance between the faces over |n_e . n_f|. Near O(log n). `open` is scratch.
/// Fills `trace` where one is given, without any change of the result. `left`: a face that the line surely leaves the
/// slave through, at a distance greater than 0; or -1.
Penetration find_penetration(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, LineNodes& open,
                             LineTrace* trace = nullptr, Index left = -1);

/// All faces that a line may meet up to a distance along it, m.
struct FacesAlongLine {
  std::span<const Index> faces;
  double searched = 0;
};

/// All faces that a line may meet, as far as they are known.
struct KnownFaces {
  FacesAlongLine slave, own;
};

/// The same result but for `first_met`, without a search; nothing where what is known of the faces does not suffice.
std::optional<Penetration> find_penetration_among(PosedPair& posed, Side master, Index face,
                                                  const FaceGeometry& geometry, const KnownFaces& known);

/// Whether the thickness of the face already says that the face's penetration line meets no other face of the
/// master as near as `distance`, in the rounded problem and in the exact one alike.
bool thicker_than(const PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, double distance);

}  // namespace pcm::fast
