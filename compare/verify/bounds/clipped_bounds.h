// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/verify/bounds/element_law.h"
#include "compare/verify/bounds/master_view.h"
#include "compare/verify/bounds/question.h"
#include "compare/verify/bounds/rounded_faces.h"
#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// How far a right engine's clipped elements may be from the oracle's on the same rounded problem.
///
/// Which slave face a point of a master face sees depends on where projected edges and folds run. A right engine places
/// projected edges to within a strip of width `strip`: the roundings of both weights, which a skew master face makes
/// long ways along its sides, and what a turn of the lines by the error of their direction moves points by. So an
/// element's part is right but for strips along its outline, and along that of all the master face would see of the
/// slave face if nothing hid it; an element no larger than that is a sliver: it may be missing, and the engine may have
/// one of its own.
///
/// Where other faces may hide some of the slave face, three things are added; nothing where surely none does. Their
/// edges may end far away, so that the strips are wider. Parts that are not certain to have area
/// (MasterPrism::uncertainty) are dropped, or kept though they are hidden, at each cut (MasterView). And strips may be
/// seen between two of them that meet, but not at a side they share.
///
/// Where the slave face and another one, of either surface, pass through each other, or either through the master's
/// plane, the height that tells which is first is off by its roundings, so that what is seen is unsure wherever it is
/// no greater, be that on the border of what is truly seen or beside it. Only where they do pass through: which side of
/// a face's plane a vertex lies on is decided exactly, so what lies flush hides, or does not, without any error.
///
/// A depth is off by its own roundings, which count 1 / |cos| across a slanting face. Where it is unsure whether it is
/// 0 it carries nothing.
class ClippedBounds {
 public:
  struct OfElement {
    ElementBounds bounds;
    SlaveInView sight;
    bool sliver = false;           ///< may be missing
    bool may_underflow = false;    ///< and be missing for that
    bool may_keep_hidden = false;  ///< where other faces hide strips of rounding's width
    /// The greatest penetration of a right engine's element, where it has it, lies between these, m.
    double greatest_at_least = 0;
    double greatest_at_most = 0;
  };

  /// Question and answer must outlive this. O(n) in the vertices of F and the elements.
  ClippedBounds(const Question& question, const reference::Answer& true_rounded);

  /// By the oracle's elements, in their order.
  const std::vector<OfElement>& elements() const { return elements_; }
  /// Greatest |coordinate|, m.
  double max_coordinate() const { return faces_.max_coordinate(); }
  const RoundedFaces& faces() const { return faces_; }
  /// What an element that the engine alone has may be at most, and where.
  struct Sliver {
    double area = 0;          ///< m^2
    double depth = 0;         ///< m, nowhere deeper
    double normal_error = 0;  ///< of the master face's normal, that of `face` included
    double foot_error = 0;    ///< off the master face's plane and border, m
    RoundedFaces::Face face;  ///< the master
  };
  Sliver sliver(const fast::Element& element) const;
  /// How much deeper than it is a right engine may see one of the oracle's elements beyond its master's sides, m
  /// (MasterView::overshoot).
  double overshoot(const reference::Element& element) const;

 private:
  OfElement of_element(const reference::Element& element, const MasterView& view) const;

  const Question& question_;
  RoundedFaces faces_;
  std::vector<OfElement> elements_;
};

}  // namespace pcm::compare
