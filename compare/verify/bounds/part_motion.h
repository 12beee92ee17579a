// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "compare/verify/bounds/clipped_bounds.h"

namespace pcm::compare {

/// How far off a right engine's derivatives of a clipped element's integrals may be, by r and by a turn of F about Mf,
/// resolved in Me: of the area, m^2, the integral of the clamped penetration u, m^3, and that of u times the way from
/// the oracle's centre of pressure, m^4. Infinite where nothing is known.
///
/// With q the integrand, such a derivative is the integral of dq over the part and of q times the speed of its border
/// along that (fast/clipped/part_motion.h). A right engine's border follows the same lines, each of them off by no more
/// than `SightLine::off`. It differs from the oracle's
///   - where two lines are nearer to each other than they are off, along a length L: there either may be the border, or
///     both, or neither, in each of the parts that end there. What lies on either side of both is sure, so that the
///     jumps across them add up to the same: the difference is one of their speeds, aligned, but for what lies at the
///     ends of L, no longer than they are off. As much again is where a piece of either line, along which the part was
///     cut, ends there: its ends are off, so its length and direction are, on both sides of the line;
///     A part is cut along sides first: where depths meet is a line no farther than over the face that has it;
///     Where one of the two is a side beyond which master or sheet goes on (SightLine::Continuation), what lies between
///     them is seen as a part that ends there or as one of the face beyond: sums over both do not hang on which;
///   - elsewhere by where the line lies, and by roundings. Each line is the border of pieces on both sides at most: of
///     two that it parts it moves both, and adds nothing but roundings.
struct PartMotionError {
  Eigen::Array<double, 1, 6> area, volume, moment;
};
/// An error of each element, or of what all add to sums that are linear in the integrals of volume and moment: there
/// parts that meet at a side beyond which master or sheet goes on make up for one another.
enum class ErrorOf { each, linear_sums };
PartMotionError part_motion_error(const Question& question, const reference::Element& element,
                                  const ClippedBounds::OfElement& bound, const MasterView& view, ErrorOf of);

/// How fast area, m^2, and the integral of the clamped penetration, m^3, may grow or shrink at most, of whatever of a
/// slave face a right engine sees: all lines in sight may be its border, on both sides and all along, but for what
/// parts make up for in linear sums. Infinite where nothing is known.
struct PartGrowth {
  Eigen::Array<double, 1, 6> area, volume;
};
PartGrowth greatest_part_growth(const Question& question, const reference::Element& element,
                                const ClippedBounds::OfElement& bound, const MasterView& view, ErrorOf of);

}  // namespace pcm::compare
