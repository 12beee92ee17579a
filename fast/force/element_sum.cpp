// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/force/element_sum.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
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

void ElementRecord::add(const ElementRecord& other) {
  element_count += other.element_count;
  too_deep += other.too_deep;
  max_penetration = std::max(max_penetration, other.max_penetration);
  penetration_exceeded = penetration_exceeded || other.penetration_exceeded;
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

namespace {

bool is_finite(const Statistics& s) {
  return std::isfinite(s.patch_area) && std::isfinite(s.mean_penetration) && std::isfinite(s.max_pressure) &&
         std::isfinite(s.mean_pressure) && std::isfinite(s.max_normal_velocity) &&
         std::isfinite(s.max_tangential_velocity) && s.centre_of_pressure_Me.allFinite();
}

}  // namespace

void report_forces(const ForceProblem& problem, const MasterForce& total, ElementRecord& record, Contact& contact) {
  contact.force_Me = total.force_Me;
  contact.torque_Me = total.torque_Me;
  contact.tangent = total.tangent;
  contact.elements.swap(record.elements);
  if (!problem.with_statistics) return;
  contact.statistics = record.statistics.result();
  if (!is_finite(contact.statistics))
    throw BadInput(
        "the summary over the elements exceeds the range of doubles; choose units in which the numbers are smaller");
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

LawForLanes::LawForLanes(const ForceProblem& problem, Side master)
    : problem_(problem), master_(master), limits_(force_limits(problem, master)) {}

void LawForLanes::apply(const std::array<ElementFaces, kElementLanes>& faces, LaneBits which,
                        ElementLanes& lanes) const {
  const LaneBits forced = fastest_wide_elements().force(lanes, limits_);
  for (LaneBits left = which & ~forced; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    Element element = unforced(faces[lane], lanes, lane);
    apply_force(problem_, lanes.barycentre_Me[lane], element);
    lanes.normal_velocity.value[lane] = element.normal_velocity;
    lanes.tangential_velocity.value[lane] = element.tangential_velocity;
    lanes.normal_force.value[lane] = element.normal_force;
    lanes.tangential_force.value[lane] = element.tangential_force;
    lanes.position_Me.set(lane, element.position_Me);
    lanes.force_Me.set(lane, element.force_Me);
    lanes.torque_Me.set(lane, torque_Me(problem_, element));
  }
}

Element LawForLanes::unforced(const ElementFaces& faces, const ElementLanes& lanes, std::size_t lane) const {
  Element element;
  element.master = master_;
  element.master_face = faces.master;
  element.slave_face = faces.slave;
  element.area = lanes.area.value[lane];
  element.penetration = lanes.depth.value[lane];
  element.normal_Me = -lanes.n_Me[lane];
  return element;
}

Element LawForLanes::element(const ElementFaces& faces, const ElementLanes& lanes, std::size_t lane) const {
  Element element = unforced(faces, lanes, lane);
  element.normal_velocity = lanes.normal_velocity.value[lane];
  element.tangential_velocity = lanes.tangential_velocity.value[lane];
  element.normal_force = lanes.normal_force.value[lane];
  element.tangential_force = lanes.tangential_force.value[lane];
  element.position_Me = lanes.position_Me[lane];
  element.force_Me = lanes.force_Me[lane];
  return element;
}

ElementQueue::ElementQueue(const ForceProblem& problem, Side master, ElementRecord& record, WorkCounters& work,
                           ElementLanes& lanes)
    : law_(problem, master),
      loads_alone_(wants_loads_alone(problem)),
      lanes_(lanes),
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
  if (which == 0) return;
  if (kept_ != nullptr) kept_->push_back({lanes_, faces_, which});
  law_.apply(faces_, which, lanes_);
  for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
    if (!has_lane(which, lane)) continue;
    sum_.count(faces_[lane].greatest_penetration);
    if (loads_alone_) {
      sum_.add_load(lanes_.force_Me[lane], lanes_.torque_Me[lane]);
    } else {
      sum_.add_forced(law_.element(faces_[lane], lanes_, lane), lanes_.torque_Me[lane]);
    }
  }
  if (tangent_) tangent_->add(lanes_, law_.limits(), which);
}

MasterForce ElementQueue::total() {
  form_waiting();
  MasterForce total = sum_.total();
  if (tangent_) total.tangent = tangent_->total(law_.limits(), total.force_Me, total.torque_Me);
  return total;
}

void ElementQueue::form_waiting() {
  const LaneBits all = (1U << waiting_) - 1;
  waiting_ = 0;
  add_lanes(all);
}

}  // namespace pcm::fast
