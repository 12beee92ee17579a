// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/algorithm_2023.h"

#include <algorithm>

#include "compare/published/forces.h"
#include "fast/force/law_parameters.h"

namespace pcm::compare::published {
namespace {

/// The tree of a surface's penetration lines, in its own frame.
BoxTree tree_of_lines(const Surface& surface, double greatest_depth) {
  PosedFaces faces;
  faces.place(surface, nullptr);
  std::vector<Box> boxes;
  for (std::size_t f = 0; f < surface.mesh.faces.size(); ++f) {
    const fast::FaceGeometry geometry(faces[static_cast<Index>(f)].points_Me);
    const Eigen::Vector3d from = geometry.barycentre_Me();
    const std::array<Eigen::Vector3d, 2> ends{from, from - greatest_depth * geometry.n_Me};
    boxes.push_back(box_about(ends.data(), ends.data() + ends.size()));
  }
  return BoxTree(boxes);
}

}  // namespace

Algorithm2023::Algorithm2023(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode,
                             std::optional<double> greatest_depth)
    : E_(std::move(mesh_E)),
      F_(std::move(mesh_F)),
      greatest_depth_(greatest_depth ? *greatest_depth : std::min(E_.size, F_.size) / 2),
      law_(law),
      mode_(mode) {
  fast::require_valid(law_);
  if (mode != Mode::F) lines_E_ = tree_of_lines(E_, greatest_depth_);
  if (mode != Mode::E) lines_F_ = tree_of_lines(F_, greatest_depth_);
}

fast::MasterForce Algorithm2023::sum_elements(Side master, const fast::ForceProblem& problem,
                                              Workspace& workspace) const {
  const Surface& surface = master == Side::E ? E_ : F_;
  PosedFaces& masters = workspace.faces(master);
  PosedFaces& slaves = workspace.faces(opposite(master));
  workspace.line_of_face.start(surface.mesh.faces.size());
  workspace.lines.clear();
  const auto look = [&](Index e, Index f) {
    if (!workspace.line_of_face.contains(e)) {
      workspace.line_of_face[e] = static_cast<Index>(workspace.lines.size());
      const fast::FaceGeometry geometry(masters[e].points_Me);
      workspace.lines.push_back({e, geometry, PenetrationLine(geometry), {}});
    }
    MasterLine& master_line = workspace.lines[static_cast<std::size_t>(workspace.line_of_face[e])];
    look_for_first<Edges::included>(master_line.line, f, slaves[f], master_line.first);
  };
  fast::WorkCounters& work = workspace.contact.work;
  const Placement placement(problem.pose);
  work.box_tests += master == Side::E ? for_each_overlap(lines_E_, F_.tree, placement, workspace.open_boxes, look)
                                      : for_each_overlap(E_.tree, lines_F_, placement, workspace.open_boxes,
                                                         [&](Index f, Index e) { look(e, f); });

  std::sort(workspace.lines.begin(), workspace.lines.end(),
            [](const MasterLine& a, const MasterLine& b) { return a.face < b.face; });
  fast::ElementSum sum(problem, workspace.record, workspace.contact.work);
  for (const MasterLine& line : workspace.lines)
    if (line.first.depth <= greatest_depth_)
      add_element(master, line.face, line.geometry, line.first, problem.law.max_penetration, sum);
  return sum.total();
}

const fast::Contact& Algorithm2023::evaluate(const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                                             Workspace& workspace) const {
  begin(E_, F_, pose, velocity, wanted, workspace);
  compute_force(workspace, law_, mode_, pose, velocity, wanted, [&](Side master, const fast::ForceProblem& problem) {
    return sum_elements(master, problem, workspace);
  });
  workspace.contact.touching = workspace.contact.element_count > 0;
  return workspace.contact;
}

}  // namespace pcm::compare::published
