// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/forces.h"

#include "fast/contact_force.h"
#include "fast/law.h"
#include "meshes/bad_input.h"

namespace pcm::compare::published {

void begin(const Surface& surface_E, const Surface& surface_F, const Pose& pose, const Velocity& velocity,
           const Wanted& wanted, Workspace& workspace) {
  fast::require_valid(pose, velocity);
  if (wanted.bound) throw BadInput("the published algorithms know no bounds on their rounding errors");
  fast::clear(workspace.contact);
  workspace.faces_E.place(surface_E, nullptr);
  workspace.faces_F.place(surface_F, &pose);
}

void add_element(Workspace& workspace, Side master, Index face, const fast::FaceGeometry& geometry,
                 const FirstMet& first, const fast::ForceProblem& problem, fast::MasterForce& total) {
  if (!first.leaves || !(first.depth > 0)) return;
  fast::Element element;
  element.master = master;
  element.master_face = face;
  element.slave_face = first.face;
  element.area = geometry.area;
  element.penetration = first.depth;
  element.normal_Me = -geometry.n_Me;
  fast::add_element(workspace.contact, problem, first.depth, geometry.barycentre_Me(), element, total);
}

void compute_force(Workspace& workspace, const ContactLaw& law, Mode mode, const Pose& pose, const Velocity& velocity,
                   const Wanted& wanted, const SumElements& sum_elements) {
  fast::Contact& contact = workspace.contact;
  fast::StatisticsSum statistics;
  const fast::ForceProblem problem = fast::force_problem(Scheme::barycentric, law, pose, velocity, wanted, statistics);
  if (mode == Mode::both) {
    const fast::MasterForce on_E = sum_elements(Side::E, problem);
    const fast::MasterForce on_F = sum_elements(Side::F, problem);
    contact.force_Me = 0.5 * (on_E.force_Me + on_F.force_Me);
    contact.torque_Me = 0.5 * (on_E.torque_Me + on_F.torque_Me);
  } else {
    const fast::MasterForce total = sum_elements(mode == Mode::E ? Side::E : Side::F, problem);
    contact.force_Me = total.force_Me;
    contact.torque_Me = total.torque_Me;
  }
  if (problem.statistics != nullptr) contact.statistics = statistics.result();
  fast::require_finite_force(contact);
}

}  // namespace pcm::compare::published
