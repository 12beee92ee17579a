// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "reference/combinatorics/combinatorics.h"
#include "reference/elements/barycentric_elements.h"
#include "reference/elements/element_source.h"
#include "reference/lines/visibility_lines.h"

/// Elements of the clipped scheme (PCM section 6): the lower envelope of the slave's sheets, and of the master's own
/// other faces, below each active master face e. Every depth d_g is linear in (s, t), so the part of e that belongs to
/// the slave face f is a polygon:
///
///   P_ef = e n proj(f) n {d_f >= 0}, N . N_f < 0 (the line leaves the slave's body there),
///     less, for each other slave face g:        proj(g) n {d_g >= 0} n {d_g <= d_f},
///     less, for each other face g of the master: the same.
///
/// Faces seen edge-on (N . N_g = 0) are never met. Where d_g = d_f throughout, the slave face of the smaller index is
/// first, and a face of the master is not before f. Where d_g = 0 throughout, g is met, at once.
namespace pcm::reference {

/// A convex polygon by the lines that bound it, counterclockwise in (s, t).
using PieceOutline = std::vector<VisibilityLine>;

/// An element {e, f}: P_ef has area and f does not lie in e's plane, so the mean penetration is positive.
struct ClippedElement {
  ElementPair faces;
  std::vector<PieceOutline> pieces;  ///< P_ef cut into convex pieces, without common area
};

struct ClippedFindings {
  std::vector<ClippedElement> elements;  ///< by master face, then slave face
  std::vector<Index>
      robust;  ///< master faces whose elements are the same in both problems, with or without any; ascending
};

/// The elements that one master carries. The cost of a master face grows with the slave's and its own faces below it,
/// each looked up in a tree of boxes. `other`: what was found for the other problem of the same pose, to be used where
/// it holds here too.
ClippedFindings find_clipped_elements(const ExactPose& pose, Side master, const Combinatorics& combinatorics,
                                      const ClippedFindings& other = {});

/// Their values by exact moments of a linear field over convex pieces: alpha = area of P_ef in (s, t), q = (integral of
/// d) / alpha, q_greatest = the greatest d_f at a corner, foot = (integral of x d) / (integral of d), where d =
/// min(d_f, max_penetration / |N|), the penetration clamped point by point (PCM section 6). A piece that the line d_f =
/// max_penetration / |N| passes through is cut in two there: d_f on one side, constant on the other.
class ClippedElements final : public ElementSource {
 public:
  /// The elements must outlive this. `max_penetration` in m.
  explicit ClippedElements(const std::vector<ClippedElement>& elements,
                           double max_penetration = std::numeric_limits<double>::infinity())
      : elements_(elements), max_penetration_(max_penetration) {}
  std::size_t size() const override { return elements_.size(); }
  ElementPair pair(std::size_t i) const override { return elements_[i].faces; }
  ElementGeometry<DoubleDouble> geometry(std::size_t i, ConvertedPose<DoubleDouble>& pose) const override;
  ElementGeometry<Ball> geometry(std::size_t i, ConvertedPose<Ball>& pose) const override;
  ElementGeometry<Quadratic> geometry(std::size_t i, ConvertedPose<Rational>& pose) const override;
  ElementGeometry<Dual<DoubleDouble>> geometry(std::size_t i, ConvertedPose<Dual<DoubleDouble>>& pose) const override;
  ElementGeometry<Dual<Ball>> geometry(std::size_t i, ConvertedPose<Dual<Ball>>& pose) const override;
  DoubleDouble perimeter(std::size_t i, ConvertedPose<DoubleDouble>& pose) const override;
  Ball perimeter(std::size_t i, ConvertedPose<Ball>& pose) const override;
  RadicalSum perimeter(std::size_t i, ConvertedPose<Rational>& pose) const override;

 private:
  const std::vector<ClippedElement>& elements_;
  double max_penetration_;
};

}  // namespace pcm::reference
