// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/contact_elements.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "fast/clipped_elements.h"
#include "fast/contact_force.h"
#include "fast/face_lanes.h"
#include "fast/force_bound.h"
#include "fast/geometry.h"
#include "fast/penetration.h"

namespace pcm::fast {

namespace {

/// Faces that cross one of the slave start there.
void list_slave_faces_nearby(Workspace::Data& workspace, Side master) {
  SideState& side = workspace.side(master);
  side.slave_nearby.start(side.surface().mesh.faces.size());
  for (const CrossingNode& crossing : workspace.crossings) {
    if (crossing.next < 0) continue;
    side.slave_nearby[crossing.segment_face[static_cast<std::size_t>(master)]] =
        crossing.segment_face[static_cast<std::size_t>(opposite(master))];
  }
}

/// Each element's bound is added beside it.
MasterForce sum_bounded_elements(Workspace::Data& workspace, Side master, const ForceProblem& problem,
                                 MasterBound& bound) {
  SideState& side = workspace.side(master);
  Contact& contact = workspace.contact;
  MasterForce total;
  for_each_active_face(side, [&](Index face) {
    const FaceGeometry geometry(side.posed.face_Me(face, contact.work));
    const Penetration penetration =
        find_penetration(workspace, master, face, geometry, bound.begin_face(face, geometry));
    if (penetration.outcome == Penetration::Outcome::too_deep) ++contact.too_deep;
    if (penetration.outcome != Penetration::Outcome::element) {
      bound.add_no_element(face, geometry, penetration.first_met);
      return;
    }
    Element element;
    element.master = master;
    element.master_face = face;
    element.slave_face = penetration.slave_face;
    element.area = geometry.area;
    element.penetration = std::min(penetration.depth, problem.law.max_penetration);
    element.normal_Me = -geometry.n_Me;
    add_element(contact, problem, penetration.depth, geometry.barycentre_Me(), element, total);
    bound.add_element(geometry, element, total);
  });
  bound.add_inactive_faces();
  return total;
}

void count_element(Contact& contact, const ForceProblem& problem, double greatest_penetration) {
  ++contact.element_count;
  ++contact.work.elements;
  contact.work.velocities += problem.with_velocities;
  contact.max_penetration = std::max(contact.max_penetration, greatest_penetration);
  if (greatest_penetration > problem.law.max_penetration) contact.penetration_exceeded = true;
}

/// `torque_Me` about Mf.
void sum_element(Contact& contact, const ForceProblem& problem, const Element& element,
                 const Eigen::Vector3d& torque_Me, MasterForce& total) {
  total.force_Me += element.force_Me;
  total.torque_Me += torque_Me;
  if (problem.keep_elements) contact.elements.push_back(element);
  if (problem.statistics != nullptr) problem.statistics->add(element);
}

/// The barycentric elements of active faces, formed kElementLanes at a time and summed in face-index order.
class ElementBatch {
 public:
  ElementBatch(Workspace::Data& workspace, Side master, const ForceProblem& problem)
      : workspace_(workspace), master_(master), problem_(problem), queue_(workspace, master, problem) {
    list_slave_faces_nearby(workspace, master);
  }

  void add(Index face) {
    faces_[count_++] = face;
    if (count_ == kElementLanes) form_elements();
  }
  /// After the last face.
  MasterForce total() {
    if (count_ > 0) form_elements();
    return queue_.total();
  }

 private:
  void form_elements() {
    ElementLanes& lanes = workspace_.element_lanes;
    find_geometry(workspace_, master_, faces_, count_);
    std::array<Penetration, kElementLanes> found;
    find_penetrations(workspace_, master_, faces_, count_, lanes, last_, found);
    LaneBits elements = 0;
    for (std::size_t lane = 0; lane < count_; ++lane) {
      if (found[lane].outcome == Penetration::Outcome::too_deep) ++workspace_.contact.too_deep;
      if (found[lane].outcome == Penetration::Outcome::element) elements |= 1U << lane;
      lanes.depth.value[lane] = std::min(found[lane].depth, problem_.law.max_penetration);
      queue_.set_faces(lane, faces_[lane], found[lane].slave_face, found[lane].depth);
    }
    queue_.add_lanes(elements);
    count_ = 0;
  }

  Workspace::Data& workspace_;
  Side master_;
  const ForceProblem& problem_;
  ElementQueue queue_;
  FaceBatch faces_{};
  std::size_t count_ = 0;
  Index last_ = -1;  ///< face of the slave near the last penetration line
};

MasterForce sum_barycentric_elements(Workspace::Data& workspace, Side master, const ForceProblem& problem) {
  ElementBatch batch(workspace, master, problem);
  for_each_active_face(workspace.side(master), [&batch](Index face) { batch.add(face); });
  return batch.total();
}

}  // namespace

ElementQueue::ElementQueue(Workspace::Data& workspace, Side master, const ForceProblem& problem)
    : workspace_(workspace), master_(master), problem_(problem), limits_(force_limits(problem, master)) {}

void ElementQueue::add(const Element& element, double greatest_penetration, const Eigen::Vector3d& foot_Me) {
  ElementLanes& lanes = workspace_.element_lanes;
  const std::size_t lane = waiting_++;
  set_faces(lane, element.master_face, element.slave_face, greatest_penetration);
  lanes.area.value[lane] = element.area;
  lanes.depth.value[lane] = element.penetration;
  lanes.n_Me.set(lane, -element.normal_Me);
  lanes.barycentre_Me.set(lane, foot_Me);
  if (waiting_ == kElementLanes) form_waiting();
}

void ElementQueue::add_lanes(LaneBits which) {
  assert(waiting_ == 0);
  const LaneBits forced = which != 0 ? workspace_.wide_elements.force(workspace_.element_lanes, limits_) : 0;
  for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
    if (!has_lane(which, lane)) continue;
    count_element(workspace_.contact, problem_, faces_[lane].greatest_penetration);
    add_lane(lane, has_lane(forced, lane));
  }
}

void ElementQueue::form_waiting() {
  const LaneBits all = (1U << waiting_) - 1;
  waiting_ = 0;
  add_lanes(all);
}

void ElementQueue::add_lane(std::size_t lane, bool forced) {
  const ElementLanes& lanes = workspace_.element_lanes;
  Element element;
  element.master = master_;
  element.master_face = faces_[lane].master;
  element.slave_face = faces_[lane].slave;
  element.area = lanes.area.value[lane];
  element.penetration = lanes.depth.value[lane];
  element.normal_Me = -lanes.n_Me[lane];
  if (forced) {
    element.normal_velocity = lanes.normal_velocity.value[lane];
    element.tangential_velocity = lanes.tangential_velocity.value[lane];
    element.normal_force = lanes.normal_force.value[lane];
    element.tangential_force = lanes.tangential_force.value[lane];
    element.position_Me = lanes.position_Me[lane];
    element.force_Me = lanes.force_Me[lane];
    sum_element(workspace_.contact, problem_, element, lanes.torque_Me[lane], total_);
  } else {
    apply_force(problem_, lanes.barycentre_Me[lane], element);
    sum_element(workspace_.contact, problem_, element, (element.position_Me - problem_.pose.r).cross(element.force_Me),
                total_);
  }
}

void add_element(Contact& contact, const ForceProblem& problem, double greatest_penetration,
                 const Eigen::Vector3d& foot_Me, Element& element, MasterForce& total) {
  count_element(contact, problem, greatest_penetration);
  apply_force(problem, foot_Me, element);
  sum_element(contact, problem, element, (element.position_Me - problem.pose.r).cross(element.force_Me), total);
}

MasterForce sum_elements(Workspace::Data& workspace, Side master, const ForceProblem& problem, MasterBound* bound) {
  if (problem.scheme == Scheme::clipped) return sum_clipped_elements(workspace, master, problem, bound);
  if (bound != nullptr) return sum_bounded_elements(workspace, master, problem, *bound);
  return sum_barycentric_elements(workspace, master, problem);
}

}  // namespace pcm::fast
