// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/barycentric/penetration_line.h"
#include "fast/bounds/element_error.h"

namespace pcm::fast {

/// What the penetration line of a master face finds in the exact problem (PCM section 1).
struct VerifiedLine {
  enum class Finding : std::uint8_t {
    no_element,  ///< surely none
    element,     ///< surely one, with the slave face that the engine found
    unknown,     ///< one or none, no deeper than `greatest_depth`
  };
  Finding finding = Finding::unknown;
  double greatest_depth = 0;  ///< m
};

/// No two points of the surfaces are farther apart, given that their root boxes touch, as they do where a face is
/// active or undecided, m.
double extent_of(const PosedPair& posed);

/// How far from the computed line the exact problem's line and faces may be, m, wherever any surface reaches: what the
/// search has to be traced with.
double tube_radius(const PosedPair& posed, const FaceError& error, const Eigen::Vector3d& rounding_Me);

/// Decides what every choice of F's vertices within their rounding boxes leaves of the engine's decisions about a line
/// (which slave face it meets first, in which direction, at q > 0, and that no other face of the master comes before).
/// Floating point only, one-sided: `element` and `no_element` are certain, `unknown` may be too careful.
/// `first_met` is the slave face that the engine met first, -1 where it met none. `rounding_Me` bounds the rounding of
/// F's vertices. What the engine's search came upon, traced with the tube's radius, mostly saves the search; an empty
/// trace will do. At most O(log n). `open` is scratch.
VerifiedLine follow_certainly(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry,
                              const FaceError& error, Index first_met, const LineTrace& trace,
                              const Eigen::Vector3d& rounding_Me, std::vector<Index>& open);

}  // namespace pcm::fast
