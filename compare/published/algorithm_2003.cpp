// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/algorithm_2003.h"

#include <numeric>

#include "compare/published/forces.h"
#include "compare/published/report_polygons.h"
#include "fast/force/law_parameters.h"

namespace pcm::compare::published {

Algorithm2003::Algorithm2003(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode)
    : E_(std::move(mesh_E)), F_(std::move(mesh_F)), law_(law), mode_(mode) {
  fast::require_valid(law_);
}

/// Collision detection (3.1).
void Algorithm2003::find_segments(const Pose& pose, Workspace& workspace) const {
  workspace.segments.clear();
  fast::WorkCounters& work = workspace.contact.work;
  work.box_tests = for_each_overlap(E_.tree, F_.tree, Placement(pose), workspace.open_boxes, [&](Index e, Index f) {
    ++work.candidate_pairs;
    if (auto segment = intersect(E_, e, workspace.faces_E[e], F_, f, workspace.faces_F[f]))
      workspace.segments.push_back(*segment);
  });
  work.crossing_pairs = static_cast<std::int64_t>(workspace.segments.size());
  workspace.contact.touching = !workspace.segments.empty();
}

/// Step 3 for one master.
fast::MasterForce Algorithm2003::sum_elements(Side master, const fast::ForceProblem& problem,
                                              Workspace& workspace) const {
  const Side slave = opposite(master);
  const std::vector<Index>& slave_faces = workspace.active(slave).active();
  workspace.slaves.clear();
  for (const Index f : slave_faces) workspace.slaves.push_back(workspace.faces(slave)[f]);
  fast::ElementSum sum(problem, workspace.record, workspace.contact.work);
  for (const Index e : workspace.active(master).active()) {
    const fast::FaceGeometry geometry(workspace.faces(master)[e].points_Me);
    const PenetrationLine line(geometry);
    FirstMet first;
    for (std::size_t k = 0; k < slave_faces.size(); ++k)
      look_for_first<Edges::excluded>(line, slave_faces[k], workspace.slaves[k], first);
    add_element(master, e, geometry, first, problem.law.max_penetration, sum);
  }
  return sum.total();
}

const fast::Contact& Algorithm2003::evaluate(const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                                             Workspace& workspace) const {
  begin(E_, F_, pose, velocity, wanted, workspace);
  fast::Contact& contact = workspace.contact;
  find_segments(pose, workspace);
  if (!contact.touching) return contact;

  chain_segments(workspace.segments, workspace.chains);
  workspace.patch_of.resize(workspace.chains.size());
  std::iota(workspace.patch_of.begin(), workspace.patch_of.end(), Index{0});
  workspace.active_E.find(E_, Side::E, workspace.segments, workspace.chains, workspace.patch_of);
  workspace.active_F.find(F_, Side::F, workspace.segments, workspace.chains, workspace.patch_of);
  for (const Side side : {Side::E, Side::F}) {
    fast::ActiveArea& area = side == Side::E ? contact.E : contact.F;
    area.intersected = workspace.active(side).intersected();
    area.inner = workspace.active(side).inner();
  }
  if (wanted.polygons) report_polygons(E_, F_, workspace);
  if (wanted.force || wanted.elements)
    compute_force(workspace, law_, mode_, pose, velocity, wanted, [&](Side master, const fast::ForceProblem& problem) {
      return sum_elements(master, problem, workspace);
    });
  return contact;
}

}  // namespace pcm::compare::published
