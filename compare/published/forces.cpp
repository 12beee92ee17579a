// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/forces.h"

#include <algorithm>

#include "fast/force/law_parameters.h"
#include "pcm/bad_input.h"

namespace pcm::compare::published {

void begin(const Surface& surface_E, const Surface& surface_F, const Pose& pose, const Velocity& velocity,
           const Wanted& wanted, Workspace& workspace) {
  fast::require_valid(pose, velocity);
  if (wanted.bound) throw BadInput("the published algorithms know no bounds on their rounding errors");
  workspace.record.take_back_list(workspace.contact);
  workspace.contact.clear();
  workspace.record.clear();
  workspace.faces_E.place(surface_E, nullptr);
  workspace.faces_F.place(surface_F, &pose);
}

void add_element(Side master, Index face, const fast::FaceGeometry& geometry, const FirstMet& first,
                 double max_penetration, fast::ElementSum& sum) {
  if (!first.leaves || !(first.depth > 0)) return;
  fast::Element element;
  element.master = master;
  element.master_face = face;
  element.slave_face = first.face;
  element.area = geometry.area;
  element.penetration = std::min(first.depth, max_penetration);
  element.normal_Me = -geometry.n_Me;
  sum.add(first.depth, geometry.barycentre_Me(), element);
}

void compute_force(Workspace& workspace, const ContactLaw& law, Mode mode, const Pose& pose, const Velocity& velocity,
                   const Wanted& wanted, const SumElements& sum_elements) {
  const fast::ForceProblem problem(law, pose, velocity, wanted);
  fast::MasterForce total = sum_elements(mode == Mode::F ? Side::F : Side::E, problem);
  if (mode == Mode::both) total = fast::mean(total, sum_elements(Side::F, problem));
  fast::require_finite(total);
  fast::report_elements(problem, total, workspace.record, workspace.contact);
}

}  // namespace pcm::compare::published
