// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/clipped_bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/verify/bounds/bound_arithmetic.h"

namespace pcm::compare {
namespace {

using roundoff::u;

/// An outline that is moved by no more than the strip's width changes the area by no more.
double strips_along(double length, double strip) {
  return strip * (length + 4 * strip);
}

/// The greatest depth is that of a corner. Where nothing hides it, strips take no more from it than the angle there
/// allows. Elsewhere a right engine sees all but an area H of the convex polygon of area A that nothing but its border
/// limits. The lengths of lines of one depth across it are concave in the depth, so no less than the share (h / d)^2 of
/// it lies within h of its greatest depth, d the difference of its depths: within h = d sqrt(H / A) something is seen.
double tip_at_least(const reference::Element& e, const SlaveInView& seen, double area_error) {
  const double all = std::abs(seen.area);
  const double missing = std::max(0.0, all - e.area) + kHigherOrder * area_error;
  const double beside = missing < all ? std::sqrt(missing / all) : 1;
  const double loss = kHigherOrder * seen.depth_error + beside * (seen.at_tip - seen.at_lowest);
  const double where_hidden = seen.at_tip - kHigherOrder * loss;
  return seen.hiders == 0 ? std::max(where_hidden, e.greatest_penetration - kHigherOrder * seen.tip_error)
                          : where_hidden;
}

/// The engine integrates the depth over the share of the master face, triangle by triangle, each of which loses up to
/// 2^-1075 m to underflow: of an integral as great as this less than a rounding, were there 2^50 of them. A smaller one
/// may be lost, and the element with it (PCM section 6).
constexpr double kLeastIntegral = 0x1p-970;

}  // namespace

ClippedBounds::ClippedBounds(const Question& question, const reference::Answer& true_rounded)
    : question_(question), faces_(question) {
  std::optional<MasterView> view;
  for (const reference::Element& e : true_rounded.elements) {
    if (!view || view->master() != e.master || view->master_face() != e.master_face)
      view.emplace(faces_, e.master, e.master_face);
    elements_.push_back(of_element(e, *view));
  }
}

ClippedBounds::OfElement ClippedBounds::of_element(const reference::Element& e, const MasterView& view) const {
  const SlaveInView seen = view.sight(e.slave_face);
  GeometryErrors errors;
  errors.normal = view.turn();
  // Its own outline is part of these lines, but for roundings.
  const double around = std::max(e.perimeter, seen.outline + seen.parting);
  // Both sides of a face that is seen nearly edgewise are projected onto almost one line: moving them apart by the
  // strip's width moves where they meet by that over the face's cosine (fast/clipped/visible_parts.h).
  const double edgewise = 4 * seen.strip * seen.strip / std::abs(e.cosine);
  const double outline_error = strips_along(around, seen.strip) + edgewise + (16 * u + view.turn()) * e.area;
  const double strips = outline_error + (seen.hiders == 0 ? 0 : seen.mistaken + seen.neglected);
  // Neither has more than the face.
  errors.area = no_more(strips + seen.surfacing, e.area + view.greatest_area());

  // Of the depth at a point: what a shift by the strip's width makes along the slave's slope counts as well. Clamped
  // point by point, no depth counts more than the clamp.
  const double deepest = std::max(seen.deepest, e.greatest_penetration);
  const double counted = std::min(deepest, question_.law.max_penetration);
  const double depth_error = no_more(seen.depth_error + times(seen.slope, seen.strip), counted);
  const double volume_error =
      (e.area + errors.area) * depth_error + no_more(strips, e.area + view.greatest_area()) * counted;

  OfElement result;
  result.sight = seen;
  result.may_underflow = (e.area / view.greatest_area()) * e.penetration < kLeastIntegral;
  result.sliver = result.may_underflow || !(e.area > 2 * (errors.area + seen.uncertain));
  result.may_keep_hidden = seen.hiders > 0;
  errors.penetration = counted;
  // The centroid of u moves within the face; where the volume is known, by no more than its relative error.
  const double volume = e.area * e.penetration;
  const double share = volume > 2 * volume_error ? 2 * volume_error / (volume - volume_error) : 1;
  errors.foot = std::min(1.0, share) * seen.width + 16 * u * faces_.max_coordinate();
  if (!result.sliver) {
    errors.volume = volume_error;
    errors.penetration = std::min(counted, (volume_error + errors.area * e.penetration) / (e.area - errors.area));
  }
  result.bounds = bounds_after_law(question_, e, errors);
  if (!result.sliver)
    result.greatest_at_least = std::max(e.penetration - result.bounds.penetration, tip_at_least(e, seen, errors.area));
  result.greatest_at_most = e.greatest_penetration + kHigherOrder * (deepest - e.greatest_penetration);
  return result;
}

// Along either side of what could be seen if nothing hid it, and of what hides that. The normal computed here and the
// engine's are off by their own errors each; a foot has the roundings of one place on a face (above).
ClippedBounds::Sliver ClippedBounds::sliver(const fast::Element& e) const {
  const MasterView view(faces_, e.master, e.master_face);
  const SlaveInView seen = view.sight(e.slave_face);
  Sliver sliver;
  const double strips =
      strips_along(4 * seen.outline + seen.parting, seen.strip) + seen.neglected + seen.mistaken + seen.surfacing;
  sliver.area = kHigherOrder * no_more(strips, view.greatest_area());
  sliver.depth = std::max(0.0, seen.deepest + std::max(seen.deepest - seen.at_tip, 0.0));
  sliver.face = faces_.face(e.master, e.master_face);
  sliver.normal_error = std::min(2.0, kHigherOrder * (view.turn() + sliver.face.normal_error));
  sliver.foot_error = kHigherOrder * 16 * u * faces_.max_coordinate();
  return sliver;
}

double ClippedBounds::overshoot(const reference::Element& e) const {
  const MasterView view(faces_, e.master, e.master_face);
  return view.overshoot(e.slave_face, view.sight(e.slave_face).strip);
}

}  // namespace pcm::compare
