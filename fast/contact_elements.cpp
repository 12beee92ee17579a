// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/contact_elements.h"

#include <algorithm>

#include "fast/clipped_elements.h"
#include "fast/contact_force.h"
#include "fast/force_bound.h"
#include "fast/geometry.h"
#include "fast/penetration.h"

namespace pcm::fast {

namespace {

/// Where a walk over the slave to a master face's penetration line may start: near that of a neighbour, or at `last`.
Index slave_face_near(const SideState& side, Index face, Index last) {
  const Index own = side.slave_nearby.get(face, -1);
  if (own >= 0) return own;
  for (const Index edge : side.surface().edges_of(face)) {
    for (const Index neighbour : side.surface().faces_at(edge)) {
      if (neighbour < 0) continue;
      const Index near = side.slave_nearby.get(neighbour, -1);
      if (near >= 0) return near;
    }
  }
  return last;
}

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

MasterForce sum_barycentric_elements(Workspace::Data& workspace, Side master, const ForceProblem& problem,
                                     MasterBound* bound) {
  SideState& side = workspace.side(master);
  Contact& contact = workspace.contact;
  MasterForce total;
  list_slave_faces_nearby(workspace, master);
  Index last = -1;
  for_each_active_face(side, [&](Index face) {
    const FaceGeometry geometry(side.posed.face_Me(face, contact.work));
    const Eigen::Vector3d barycentre_Me = geometry.barycentre_Me();
    LineTrace* const trace = bound != nullptr ? bound->begin_face(face, geometry) : nullptr;
    const Penetration penetration = trace != nullptr
                                        ? find_penetration(workspace, master, face, geometry, trace)
                                        : find_penetration_from(workspace, master, face, geometry, barycentre_Me,
                                                                slave_face_near(side, face, last));
    if (penetration.slave_face >= 0) side.slave_nearby[face] = last = penetration.slave_face;
    if (penetration.outcome == Penetration::Outcome::too_deep) ++contact.too_deep;
    if (penetration.outcome != Penetration::Outcome::element) {
      if (bound != nullptr) bound->add_no_element(face, geometry, penetration.first_met);
      return;
    }
    Element element;
    element.master = master;
    element.master_face = face;
    element.slave_face = penetration.slave_face;
    element.area = geometry.area;
    element.penetration = penetration.depth;
    element.normal_Me = -geometry.n_Me;
    add_element(contact, problem, penetration.depth, barycentre_Me, element, total);
    if (bound != nullptr) bound->add_element(geometry, element, total);
  });
  if (bound != nullptr) bound->add_inactive_faces();
  return total;
}

}  // namespace

void add_element(Contact& contact, const ForceProblem& problem, double greatest_penetration,
                 const Eigen::Vector3d& foot_Me, Element& element, MasterForce& total) {
  ++contact.element_count;
  contact.max_penetration = std::max(contact.max_penetration, greatest_penetration);
  if (greatest_penetration > problem.law.max_penetration) contact.penetration_exceeded = true;
  element.penetration = std::min(element.penetration, problem.law.max_penetration);
  apply_force(problem, foot_Me, element);
  total.force_Me += element.force_Me;
  total.torque_Me += (element.position_Me - problem.pose.r).cross(element.force_Me);
  if (problem.keep_elements) contact.elements.push_back(element);
}

MasterForce sum_elements(Workspace::Data& workspace, Side master, const ForceProblem& problem, MasterBound* bound) {
  if (problem.scheme == Scheme::barycentric) return sum_barycentric_elements(workspace, master, problem, bound);
  return sum_clipped_elements(workspace, master, problem, bound);
}

}  // namespace pcm::fast
