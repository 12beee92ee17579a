// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "compare/law_bounds.h"
#include "compare/rounded_faces.h"
#include "fast/contact.h"
#include "reference/answer.h"

namespace pcm::compare {

/// How far a right engine's clipped elements may be from the oracle's on the same rounded problem.
///
/// Which slave face a point of a master face sees hangs on where projected edges and folds run. A right engine places
/// projected edges to within a strip of width `strip`: 64 u R, R the greatest |coordinate|, for what it takes to be
/// certain, 16 u of the distance from the master face for the roundings of a projection, and what a turn of the lines
/// by the error of their direction moves points by. So an element's part is right but for strips along its outline, and
/// along that of all the master face would see of the slave face if nothing hid it; an element no larger than that is a
/// sliver: it may be missing, and the engine may have one of its own. Parts that are not certain to have area are
/// dropped as well: certain to 64 u R, R the greatest |coordinate|, in the master face's own skew coordinates
/// (fast/convex_polygon.h), so that on a needle they are wider than the strips. That may be a whole element, or what
/// faces that hide some of it leave of it.
///
/// Where the slave face and another one, of either surface, pass through each other, the line on which they lie at the
/// same depth is off by what a vertex's height over a face is, over the slope of the difference of both depths.
///
/// A depth is off by its own roundings, which count 1 / |cos| across a slanting face. So is the line where it is 0, by
/// these roundings over the slope; but there it carries nothing. Which side of a face's plane a vertex lies on is
/// decided exactly, so what lies flush hides, or does not, without any error.
class ClippedBounds {
 public:
  struct OfElement {
    ElementBounds bounds;
    bool sliver = false;  ///< may be missing
    /// The greatest penetration of a right engine's element, where it has it, lies between these, m.
    double greatest_at_least = 0;
    double greatest_at_most = 0;
  };

  /// Question and answer must outlive this. O(n) in the vertices of F and the elements.
  ClippedBounds(const Question& question, const reference::Answer& true_rounded);

  /// By the oracle's elements, in their order.
  const std::vector<OfElement>& elements() const { return elements_; }
  /// Greatest |coordinate|, m.
  double reach() const { return faces_.reach(); }
  /// An element that the engine alone has may be as large, m^2.
  double sliver_area(const fast::Element& element) const;
  /// Nothing of such an element lies deeper, m.
  double sliver_depth(const fast::Element& element) const;

 private:
  /// What a master face sees of a slave face.
  struct Sight {
    RoundedFaces::Face master;
    double turn = 0;         ///< of the lines, by the error of their direction
    double strip = 0;        ///< m
    double uncertain = 0;    ///< a part of no more area may be dropped, m^2
    double area = 0;         ///< of what nothing but the border of both and depth 0 limits, m^2
    double depth_error = 0;  ///< at a point of the plane, without any shift of it, m
    double slope = 0;        ///< of the depth
    double outline = 0;      ///< its border, m
    double fold = 0;         ///< the part of that where the depth is 0, m
    double width = 0;        ///< no two points of it are farther apart, m
    double deepest = 0;      ///< there, m
    double at_tip = 0;       ///< the depth of its deepest corner in double precision, m
    double tip_error = 0;    ///< what strips may take from that, m
  };
  Sight sight(Side master, Index master_face, Index slave_face) const;
  OfElement of_element(const reference::Element& element) const;

  const Question& question_;
  RoundedFaces faces_;
  std::vector<OfElement> elements_;
};

}  // namespace pcm::compare
