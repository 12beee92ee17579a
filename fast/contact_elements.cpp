// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/contact_elements.h"

#include <algorithm>

#include "fast/contact_force.h"
#include "fast/force_bound.h"
#include "fast/geometry.h"
#include "fast/penetration.h"

namespace pcm::fast {

MasterForce sum_elements(Workspace::Data& workspace, Side master, const ForceProblem& problem, MasterBound* bound) {
  SideState& side = workspace.side(master);
  Contact& contact = workspace.contact;
  MasterForce total;
  std::size_t i = 0, j = 0;
  while (i < side.intersected.size() || j < side.inner.size()) {
    const bool inner = i == side.intersected.size() || (j < side.inner.size() && side.inner[j] < side.intersected[i]);
    const Index face = inner ? side.inner[j++] : side.intersected[i++];
    const FaceGeometry geometry(side.posed.face_Me(face, contact.work));
    LineTrace* const trace = bound != nullptr ? bound->begin_face(face, geometry) : nullptr;
    const Penetration penetration = find_penetration(workspace, master, face, geometry, trace);
    if (penetration.outcome == Penetration::Outcome::too_deep) ++contact.too_deep;
    if (penetration.outcome != Penetration::Outcome::element) {
      if (bound != nullptr) bound->add_no_element(face, geometry, penetration.first_met);
      continue;
    }

    ++contact.element_count;
    contact.max_penetration = std::max(contact.max_penetration, penetration.depth);
    Element element;
    element.master = master;
    element.master_face = face;
    element.slave_face = penetration.slave_face;
    element.area = geometry.area;
    element.penetration = penetration.depth;
    if (element.penetration > problem.law.max_penetration) {
      element.penetration = problem.law.max_penetration;
      contact.penetration_exceeded = true;
    }
    element.normal_Me = -geometry.n_Me;
    apply_force(problem, geometry.barycentre_Me(), element);
    total.force_Me += element.force_Me;
    total.torque_Me += (element.position_Me - problem.pose.r).cross(element.force_Me);
    if (bound != nullptr) bound->add_element(geometry, element, total);
    if (problem.keep_elements) contact.elements.push_back(element);
  }
  if (bound != nullptr) bound->add_inactive_faces();
  return total;
}

}  // namespace pcm::fast
