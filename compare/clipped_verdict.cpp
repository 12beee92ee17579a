// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/clipped_verdict.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

#include "compare/clipped_bounds.h"

namespace pcm::compare {
namespace {

template <class Element>
std::string describe(const Element& e) {
  return fmt::format("{} face {} on {}", e.master == Side::E ? 'E' : 'F', e.master_face, e.slave_face);
}

template <class Element>
auto key(const Element& e) {
  return std::tuple(e.master, e.master_face, e.slave_face);
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

}  // namespace

void check_element(const Question& question, const fast::Element& subj, const reference::Element& truth,
                   const ElementBounds& bound, double reach, Checks& checks) {
  const std::string who = describe(truth);
  const Eigen::Vector3d arm = truth.position_Me - question.pose.r;
  const double speed = (question.velocity.v + question.velocity.w.cross(arm)).stableNorm();
  const double force = truth.force_Me.stableNorm();
  checks.check_value(Kind::element_area, who + ": area", subj.area, truth.area, bound.area, truth.area);
  checks.check_value(Kind::element_penetration, who + ": penetration", subj.penetration, truth.penetration,
                     bound.penetration, truth.penetration);
  checks.check_vector(Kind::element_position, who + ": position", subj.position_Me, truth.position_Me, bound.position,
                      reach);
  checks.check_vector(Kind::element_normal, who + ": normal", subj.normal_Me, truth.normal_Me, bound.normal, 1);
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

ClippedTotals check_clipped_elements(const Question& question, const fast::Contact& subj,
                                     const reference::Answer& truth, Checks& checks) {
  const ClippedBounds bounds(question, truth);
  ClippedTotals totals;
  double sizes = 0, torque_sizes = 0, greatest_at_least = 0, greatest_at_most = 0;
  for_each_pair(subj.elements, truth.elements,
                [&](const fast::Element* ours, const reference::Element* theirs, std::size_t k) {
                  if (theirs == nullptr) {
                    const ClippedBounds::Sliver sliver = bounds.sliver(*ours);
                    checks.checked(Kind::elements, sliver.area, ours->area);
                    if (!(ours->area <= sliver.area))
                      checks.add(Kind::elements, "{}: engine has an area of {}, oracle none; slivers go up to {:.2g}",
                                 describe(*ours), ours->area, sliver.area);
                    const double force = ours->force_Me.stableNorm();
                    const double torque = (ours->position_Me - question.pose.r).stableNorm() * force;
                    totals.force += force;
                    totals.torque += torque;
                    sizes += force;
                    torque_sizes += torque;
                    greatest_at_most = std::max(greatest_at_most, sliver.depth);
                    return;
                  }
                  const ClippedBounds::OfElement& bound = bounds.elements()[k];
                  totals.force += bound.bounds.force;
                  totals.torque += bound.bounds.torque;
                  greatest_at_least = std::max(greatest_at_least, bound.greatest_at_least);
                  greatest_at_most = std::max(greatest_at_most, bound.greatest_at_most);
                  sizes += theirs->force_Me.stableNorm();
                  torque_sizes += (theirs->position_Me - question.pose.r).stableNorm() * theirs->force_Me.stableNorm();
                  if (ours != nullptr) {
                    checks.checked(Kind::elements);
                    check_element(question, *ours, *theirs, bound.bounds, bounds.reach(), checks);
                    return;
                  }
                  checks.checked(Kind::elements, bound.bounds.area, theirs->area);
                  if (!bound.sliver)
                    checks.add(Kind::elements, "{}: oracle has an area of {}, engine none; slivers go up to {:.2g}",
                               describe(*theirs), theirs->area, bound.bounds.area);
                });
  totals.penetration = std::max(greatest_at_most - truth.max_penetration, truth.max_penetration - greatest_at_least);
  const double terms = kHigherOrder * kRoundoff * static_cast<double>(subj.elements.size() + truth.elements.size() + 2);
  totals.force += terms * sizes;
  totals.torque += terms * torque_sizes;
  if (question.mode == Mode::both) {
    totals.force /= 2;
    totals.torque /= 2;
  }
  return totals;
}

}  // namespace pcm::compare
