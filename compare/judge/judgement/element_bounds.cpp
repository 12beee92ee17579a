// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/element_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "compare/verify/bounds/clipped_bounds.h"
#include "compare/verify/bounds/element_law.h"
#include "compare/verify/bounds/rounding_bounds.h"
#include "pcm/contact.h"

namespace pcm::compare {
namespace {

template <class Element>
auto key(const Element& e) {
  return std::tuple(e.master, e.master_face, e.slave_face);
}

/// The elements of both lists in their order, nullptr where one side has none; with the oracle's number.
template <class Visit>
void for_each_pair(const std::vector<GivenElement>& given, const std::vector<reference::Element>& truth,
                   const Visit& visit) {
  std::size_t i = 0, k = 0;
  while (i < given.size() || k < truth.size()) {
    const bool has_given = i < given.size() && (k == truth.size() || key(given[i]) <= key(truth[k]));
    const bool has_truth = k < truth.size() && (i == given.size() || key(truth[k]) <= key(given[i]));
    visit(has_given ? &given[i] : nullptr, has_truth ? &truth[k] : nullptr, k);
    i += has_given;
    k += has_truth;
  }
}

ElementsHeld hold_barycentric(const Question& question, const std::vector<GivenElement>& given,
                              const reference::Answer& truth) {
  const ForceBounds bounds = RoundingBounds(question, truth).force();
  ElementsHeld held;
  held.force_bound = bounds.force;
  held.torque_bound = bounds.torque;
  for_each_pair(given, truth.elements, [&](const GivenElement* ours, const reference::Element* theirs, std::size_t k) {
    if (theirs == nullptr)
      held.spurious.push_back(ours);
    else if (ours == nullptr)
      held.missing.push_back(theirs);
    else
      held.common.push_back({ours, theirs, bounds.elements[k].area, bounds.elements[k].penetration});
  });
  return held;
}

/// What an element may bring to the totals at most.
struct Share {
  double force = 0;
  double torque = 0;
};

/// |v_k| <= |v| + |w| |C_k - r|, with C_k no farther from r than the farthest corner of the master face and the
/// penetration.
Share most_of(const Question& question, const GivenElement& e, const ClippedBounds& bounds, double depth) {
  const double u = e.penetration.value_or(depth);
  double arm = 0;
  for (std::size_t k = 0; k < 3; ++k)
    arm = std::max(arm, (bounds.faces().corner(e.master, e.master_face, k) - question.pose.r).stableNorm() + u);
  const double speed = question.velocity.v.stableNorm() + question.velocity.w.stableNorm() * arm;
  const double force = greatest_force(question.law, *e.area, u, speed);
  return {force, arm * force};
}

ElementsHeld hold_clipped(const Question& question, const std::vector<GivenElement>& given,
                          const reference::Answer& truth) {
  const ClippedBounds bounds(question, truth);
  ElementsHeld held;
  Share sizes;
  for_each_pair(given, truth.elements, [&](const GivenElement* ours, const reference::Element* theirs, std::size_t k) {
    if (theirs == nullptr) {
      fast::Element alone;
      alone.master = ours->master;
      alone.master_face = ours->master_face;
      alone.slave_face = ours->slave_face;
      const ClippedBounds::Sliver sliver = bounds.sliver(alone);
      const double penetration = ours->penetration.value_or(0);
      if (!(*ours->area >= 0 && *ours->area <= sliver.area && penetration >= 0 && penetration <= sliver.depth)) {
        held.spurious.push_back(ours);
        return;
      }
      const Share most = most_of(question, *ours, bounds, sliver.depth);
      held.force_bound += most.force;
      held.torque_bound += most.torque;
      sizes.force += most.force;
      sizes.torque += most.torque;
      return;
    }
    const ClippedBounds::OfElement& bound = bounds.elements()[k];
    held.force_bound += bound.bounds.force;
    held.torque_bound += bound.bounds.torque;
    sizes.force += theirs->force_Me.stableNorm();
    sizes.torque += (theirs->position_Me - question.pose.r).stableNorm() * theirs->force_Me.stableNorm();
    if (ours != nullptr)
      held.common.push_back({ours, theirs, bound.bounds.area, bound.bounds.penetration});
    else if (!bound.sliver)
      held.missing.push_back(theirs);
  });
  const double terms = kHigherOrder * kRoundoff * static_cast<double>(given.size() + truth.elements.size() + 2);
  held.force_bound += terms * sizes.force;
  held.torque_bound += terms * sizes.torque;
  if (question.mode == Mode::both) {
    held.force_bound /= 2;
    held.torque_bound /= 2;
  }
  return held;
}

}  // namespace

ElementsHeld hold_elements(const Question& question, const std::vector<GivenElement>& given,
                           const reference::Answer& truth) {
  return question.scheme == Scheme::clipped ? hold_clipped(question, given, truth)
                                            : hold_barycentric(question, given, truth);
}

}  // namespace pcm::compare
