// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/force/element_sum.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>

#include "fast/simd/element_sets.h"
#include "pcm/bad_input.h"

namespace pcm::fast {

namespace {

/// About Mf.
Eigen::Vector3d torque_Me(const ForceProblem& problem, const Element& element) {
  return (element.position_Me - problem.pose.r).cross(element.force_Me);
}

}  // namespace

void ElementRecord::note_depth(double greatest_penetration, const ContactLaw& law) {
  max_penetration = std::max(max_penetration, greatest_penetration);
  if (greatest_penetration > law.max_penetration) penetration_exceeded = true;
}

void ElementRecord::clear() {
  elements.clear();
  element_count = too_deep = 0;
  max_penetration = 0;
  penetration_exceeded = false;
  statistics = {};
  found.clear();
}

void ElementRecord::take_back_list(Contact& contact) {
  if (contact.elements.capacity() > elements.capacity()) elements.swap(contact.elements);
}

MasterForce mean(const MasterForce& on_E, const MasterForce& on_F) {
  MasterForce mean{0.5 * (on_E.force_Me + on_F.force_Me), 0.5 * (on_E.torque_Me + on_F.torque_Me), std::nullopt};
  if (on_E.tangent) mean.tangent = 0.5 * (*on_E.tangent + *on_F.tangent);
  return mean;
}

void require_finite(const MasterForce& total) {
  const bool finite = total.force_Me.allFinite() && total.torque_Me.allFinite();
  if (finite && total.tangent && !total.tangent->allFinite())
    throw BadInput("a tangent exceeds the range of doubles; choose units in which the numbers are smaller");
  if (finite) return;
  throw BadInput("force or torque exceeds the range of doubles; choose units in which the numbers are smaller");
}

void report_forces(const ForceProblem& problem, const MasterForce& total, ElementRecord& record, Contact& contact) {
  contact.force_Me = total.force_Me;
  contact.torque_Me = total.torque_Me;
  contact.tangent = total.tangent;
  contact.elements.swap(record.elements);
  if (problem.with_statistics) contact.statistics = record.statistics.result();
}

void report_elements(const ForceProblem& problem, const MasterForce& total, ElementRecord& record, Contact& contact) {
  report_forces(problem, total, record, contact);
  contact.element_count = record.element_count;
  contact.too_deep = record.too_deep;
  contact.max_penetration = record.max_penetration;
  contact.penetration_exceeded = record.penetration_exceeded;
}

void ElementSum::count(double greatest_penetration) {
  ++record_.element_count;
  ++work_.elements;
  work_.velocities += problem_.with_velocities;
  record_.note_depth(greatest_penetration, problem_.law);
}

void ElementSum::add_forced(const Element& element, const Eigen::Vector3d& torque) {
  total_.force_Me += element.force_Me;
  total_.torque_Me += torque;
  if (problem_.keep_elements) record_.elements.push_back(element);
  if (problem_.with_statistics) record_.statistics.add(element);
}

void ElementSum::add(double greatest_penetration, const Eigen::Vector3d& foot_Me, Element& element) {
  count(greatest_penetration);
  apply_force(problem_, foot_Me, element);
  add_forced(element, torque_Me(problem_, element));
}

ElementQueue::ElementQueue(const ForceProblem& problem, Side master, ElementRecord& record, WorkCounters& work,
                           ElementLanes& lanes)
    : problem_(problem),
      master_(master),
      lanes_(lanes),
      limits_(force_limits(problem, master)),
      kept_(problem.keep_found ? &record.found.of(master) : nullptr),
      sum_(problem, record, work) {
  if (problem.with_tangent) tangent_.emplace();
}

void ElementQueue::add(const ElementFaces& faces, double area, double penetration, const Eigen::Vector3d& n_Me,
                       const Eigen::Vector3d& foot_Me, const ElementMotion* motion) {
  const std::size_t lane = waiting_++;
  faces_[lane] = faces;
  lanes_.area.value[lane] = area;
  lanes_.depth.value[lane] = penetration;
  lanes_.n_Me.set(lane, n_Me);
  lanes_.barycentre_Me.set(lane, foot_Me);
  if (tangent_) tangent_->set_motion(lane, *motion);
  if (waiting_ == kElementLanes) form_waiting();
}

void ElementQueue::add_lanes(LaneBits which) {
  assert(waiting_ == 0);
  if (kept_ != nullptr && which != 0) kept_->push_back({lanes_, faces_, which});
  const LaneBits forced = which != 0 ? fastest_wide_elements().force(lanes_, limits_) : 0;
  for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
    if (!has_lane(which, lane)) continue;
    sum_.count(faces_[lane].greatest_penetration);
    add_lane(lane, has_lane(forced, lane));
  }
  if (tangent_ && which != 0) tangent_->add(lanes_, limits_, which);
}

MasterForce ElementQueue::total() {
  form_waiting();
  MasterForce total = sum_.total();
  if (tangent_) total.tangent = tangent_->total(limits_, total.force_Me, total.torque_Me);
  return total;
}

void ElementQueue::form_waiting() {
  const LaneBits all = (1U << waiting_) - 1;
  waiting_ = 0;
  add_lanes(all);
}

void ElementQueue::add_lane(std::size_t lane, bool forced) {
  Element element;
  element.master = master_;
  element.master_face = faces_[lane].master;
  element.slave_face = faces_[lane].slave;
  element.area = lanes_.area.value[lane];
  element.penetration = lanes_.depth.value[lane];
  element.normal_Me = -lanes_.n_Me[lane];
  if (forced) {
    element.normal_velocity = lanes_.normal_velocity.value[lane];
    element.tangential_velocity = lanes_.tangential_velocity.value[lane];
    element.normal_force = lanes_.normal_force.value[lane];
    element.tangential_force = lanes_.tangential_force.value[lane];
    element.position_Me = lanes_.position_Me[lane];
    element.force_Me = lanes_.force_Me[lane];
    sum_.add_forced(element, lanes_.torque_Me[lane]);
  } else {
    apply_force(problem_, lanes_.barycentre_Me[lane], element);
    sum_.add_forced(element, torque_Me(problem_, element));
    lanes_.normal_velocity.value[lane] = element.normal_velocity;
    lanes_.tangential_velocity.value[lane] = element.tangential_velocity;
    lanes_.position_Me.set(lane, element.position_Me);
    lanes_.force_Me.set(lane, element.force_Me);
  }
}

}  // namespace pcm::fast
