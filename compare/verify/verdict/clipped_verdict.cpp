// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/clipped_verdict.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "compare/verify/bounds/clipped_bounds.h"
#include "compare/verify/bounds/element_law.h"
#include "compare/verify/verdict/element_key.h"

namespace pcm::compare {
namespace {

template <class Element>
std::string describe(const Element& e) {
  return fmt::format("{} face {} on {}", e.master == Side::E ? 'E' : 'F', e.master_face, e.slave_face);
}

/// The pairs of elements in the order of both lists, nullptr where one side has none.
template <class Visit>
void for_each_pair(const std::vector<fast::Element>& subj, const std::vector<reference::Element>& truth,
                   const Visit& visit) {
  std::size_t i = 0, k = 0;
  while (i < subj.size() || k < truth.size()) {
    const bool has_subj = i < subj.size() && (k == truth.size() || key(subj[i]) <= key(truth[k]));
    const bool has_truth = k < truth.size() && (i == subj.size() || key(truth[k]) <= key(subj[i]));
    visit(has_subj ? &subj[i] : nullptr, has_truth ? &truth[k] : nullptr, k);
    i += has_subj;
    k += has_truth;
  }
}

/// What the law makes of an element's geometry.
void check_law(const Question& question, const std::string& who, const fast::Element& subj,
               const reference::Element& truth, const ElementBounds& bound, Checks& checks) {
  const Eigen::Vector3d arm = truth.position_Me - question.pose.r;
  const double speed = (question.velocity.v + question.velocity.w.cross(arm)).stableNorm();
  const double force = truth.force_Me.stableNorm();
  checks.check_value(Kind::element_velocity, who + ": normal velocity", subj.normal_velocity, truth.normal_velocity,
                     bound.normal_velocity, speed);
  checks.check_value(Kind::element_velocity, who + ": tangential velocity", subj.tangential_velocity,
                     truth.tangential_velocity, bound.tangential_velocity, speed);
  checks.check_value(Kind::element_force, who + ": normal force", subj.normal_force, truth.normal_force,
                     bound.normal_force, force);
  checks.check_value(Kind::element_force, who + ": tangential force", subj.tangential_force, truth.tangential_force,
                     bound.tangential_force, force);
  checks.check_vector(Kind::element_force, who + ": force", subj.force_Me, truth.force_Me, bound.force, force);
}

/// Pairs are told by the order: an element out of it, or twice there, would be no pair's.
void check_order(const std::vector<fast::Element>& elements, Checks& checks) {
  for (std::size_t i = 1; i < elements.size(); ++i)
    if (!(key(elements[i - 1]) < key(elements[i])))
      checks.add(Kind::elements, "{} comes after {}", describe(elements[i]), describe(elements[i - 1]));
}

/// What an element may bring to the totals at most.
struct Share {
  double force = 0;   ///< N
  double torque = 0;  ///< N m
  double depth = 0;   ///< m
};

/// A centroid of a part of the master face lies in its plane, and no farther from any corner than the longest side; so
/// does the foot, but for its error and, along the plane, that of the normal computed here. `foot_Me` is C_k without
/// its share of the penetration along n_k (13), off by the roundings of that: 3 u of the penetration, the length of n_k
/// included, and u of each coordinate of C_k, taken twice for both sides.
void check_foot(const std::string& who, const fast::Element& subj, const Eigen::Vector3d& foot_Me,
                const ClippedBounds::Sliver& sliver, const ClippedBounds& bounds, Checks& checks) {
  const double error =
      sliver.foot_error +
      kHigherOrder * 2 * kRoundoff * (3 * subj.penetration + std::sqrt(3.0) * subj.position_Me.cwiseAbs().maxCoeff());
  const double off = sliver.face.longest + error;
  checks.checked(Kind::element_position, off, bounds.max_coordinate());
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d arm = foot_Me - bounds.faces().corner(subj.master, subj.master_face, k);
    const double height = std::abs(sliver.face.normal_Me.dot(arm));
    if (!arm.hasNaN() && arm.stableNorm() <= off && height <= error + sliver.normal_error * off) continue;
    checks.add(Kind::element_position, "{}: engine's sliver at ({}, {}, {}), which is not on the face", who,
               subj.position_Me.x(), subj.position_Me.y(), subj.position_Me.z());
  }
}

/// An element that the engine alone has. Its area and penetration are held by themselves; the rest by the law, which is
/// applied here to the nearest area, penetration and unit normal that a sliver may have and to the engine's position.
/// Both evaluations round, so that the bounds count twice. Only what passes these checks enters the totals.
Share check_sliver(const Question& question, const fast::Element& subj, const ClippedBounds& bounds, Checks& checks) {
  const std::string who = describe(subj);
  const ClippedBounds::Sliver sliver = bounds.sliver(subj);
  checks.checked(Kind::elements, sliver.area, subj.area);
  if (!(subj.area > 0 && subj.area <= sliver.area))
    checks.add(Kind::elements, "{}: engine has an area of {}, oracle none; slivers go up to {:.2g}", who, subj.area,
               sliver.area);
  // A mean of clamped depths is none greater than any of them.
  const double deepest = std::min(sliver.depth, question.law.max_penetration);
  checks.checked(Kind::element_penetration, deepest, subj.penetration);
  if (!(subj.penetration > 0 && subj.penetration <= deepest))
    checks.add(Kind::element_penetration, "{}: engine has a penetration of {}, oracle none; slivers go down to {:.2g}",
               who, subj.penetration, deepest);
  checks.check_vector(Kind::element_normal, who + ": normal", subj.normal_Me, -sliver.face.normal_Me,
                      sliver.normal_error, 1);

  reference::Element held;
  held.master = subj.master;
  held.master_face = subj.master_face;
  held.slave_face = subj.slave_face;
  held.area = std::clamp(subj.area, 0.0, sliver.area);
  held.penetration = std::clamp(subj.penetration, 0.0, deepest);
  held.normal_Me = subj.normal_Me.stableNormalized();
  held.position_Me = subj.position_Me;
  check_foot(who, subj,
             subj.position_Me - share_of_penetration(question.law, subj.master) * held.penetration * held.normal_Me,
             sliver, bounds, checks);
  held = after_law(question, held);
  const ElementBounds rounding = twice(bounds_after_law(question, held, {}));
  checks.check_vector(Kind::element_normal, who + ": length of the normal", subj.normal_Me, held.normal_Me,
                      rounding.normal, 1);
  check_law(question, who, subj, held, rounding, checks);
  Share most;
  most.force = held.force_Me.stableNorm() + rounding.force;
  most.torque = (held.position_Me - question.pose.r).stableNorm() * most.force;
  most.depth = sliver.depth;
  return most;
}

}  // namespace

void check_element(const Question& question, const fast::Element& subj, const reference::Element& truth,
                   const ElementBounds& bound, double max_coordinate, Checks& checks) {
  const std::string who = describe(truth);
  checks.check_value(Kind::element_area, who + ": area", subj.area, truth.area, bound.area, truth.area);
  checks.check_value(Kind::element_penetration, who + ": penetration", subj.penetration, truth.penetration,
                     bound.penetration, truth.penetration);
  checks.check_vector(Kind::element_position, who + ": position", subj.position_Me, truth.position_Me, bound.position,
                      max_coordinate);
  checks.check_vector(Kind::element_normal, who + ": normal", subj.normal_Me, truth.normal_Me, bound.normal, 1);
  check_law(question, who, subj, truth, bound, checks);
}

ClippedTotals check_clipped_elements(const Question& question, const fast::Contact& subj,
                                     const reference::Answer& truth, Checks& checks) {
  const ClippedBounds bounds(question, truth);
  check_order(subj.elements, checks);
  ClippedTotals totals;
  double sizes = 0, torque_sizes = 0;
  for_each_pair(subj.elements, truth.elements,
                [&](const fast::Element* ours, const reference::Element* theirs, std::size_t k) {
                  if (theirs == nullptr) {
                    const Share most = check_sliver(question, *ours, bounds, checks);
                    totals.force += most.force;
                    totals.torque += most.torque;
                    sizes += most.force;
                    torque_sizes += most.torque;
                    totals.greatest_at_most = std::max(totals.greatest_at_most, most.depth);
                    return;
                  }
                  const ClippedBounds::OfElement& bound = bounds.elements()[k];
                  totals.force += bound.bounds.force;
                  totals.torque += bound.bounds.torque;
                  totals.greatest_at_least = std::max(totals.greatest_at_least, bound.greatest_at_least);
                  totals.greatest_at_most = std::max(totals.greatest_at_most, bound.greatest_at_most);
                  sizes += theirs->force_Me.stableNorm();
                  torque_sizes += (theirs->position_Me - question.pose.r).stableNorm() * theirs->force_Me.stableNorm();
                  if (ours != nullptr) {
                    checks.checked(Kind::elements);
                    check_element(question, *ours, *theirs, bound.bounds, bounds.max_coordinate(), checks);
                    return;
                  }
                  checks.checked(Kind::elements, bound.bounds.area, theirs->area);
                  if (!bound.sliver)
                    checks.add(Kind::elements, "{}: oracle has an area of {}, engine none; slivers go up to {:.2g}",
                               describe(*theirs), theirs->area, bound.bounds.area);
                });
  const double terms = kHigherOrder * kRoundoff * static_cast<double>(subj.elements.size() + truth.elements.size() + 2);
  totals.force += terms * sizes;
  totals.torque += terms * torque_sizes;
  if (question.mode == Mode::both) {
    totals.force /= 2;
    totals.torque /= 2;
  }
  return totals;
}

bool may_lie_outside(const Question& question, const fast::Contact& subj, const reference::Answer& true_rounded,
                     const reference::Answer& true_exact) {
  const ClippedBounds bounds(question, true_rounded);
  std::set<ElementKey> certain;  // The engine has these.
  for (std::size_t k = 0; k < true_rounded.elements.size(); ++k) {
    if (!bounds.elements()[k].sliver) certain.insert(key(true_rounded.elements[k]));
  }
  if (subj.max_penetration < subj.bound->penetration_at_least) {
    const double deep = (1 - 4 * kRoundoff) * subj.bound->penetration_at_least;
    return std::none_of(true_exact.elements.begin(), true_exact.elements.end(), [&](const reference::Element& e) {
      return e.greatest_penetration >= deep && certain.contains(key(e));
    });
  }
  bool may = false;
  for_each_pair(subj.elements, true_rounded.elements,
                [&](const fast::Element* ours, const reference::Element* theirs, std::size_t k) {
                  if (ours == nullptr) return;
                  if (theirs == nullptr || bounds.elements()[k].sliver) {
                    may = may || bounds.sliver(*ours).depth >= subj.max_penetration;
                    return;
                  }
                  const ClippedBounds::OfElement& bound = bounds.elements()[k];
                  const double own = subj.max_penetration, beyond = subj.bound->penetration_at_most;
                  may = may || (own <= bound.greatest_at_most &&
                                (bound.may_keep_hidden || own <= beyond + bounds.overshoot(*theirs)));
                });
  return may;
}

}  // namespace pcm::compare
