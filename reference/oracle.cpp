// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle.h"

#include <utility>
#include <vector>

#include "meshes/check.h"
#include "reference/clipped_elements.h"
#include "reference/combinatorics.h"
#include "reference/contact_elements.h"
#include "reference/contact_force.h"
#include "reference/exact_pose.h"
#include "reference/report.h"
#include "reference/surface.h"
#include "reference/validate.h"

namespace pcm::reference {

struct Oracle::Data {
  Surface E;
  Surface F;
  ContactLaw law;
  Mode mode;
  Scheme scheme;
};

Oracle::Oracle(TriangleMesh mesh_E, TriangleMesh mesh_F, ContactLaw law, Mode mode, Scheme scheme) {
  require_fit(law);
  require_fit(mesh_E);
  require_fit(mesh_F);
  data_ = std::make_unique<const Data>(
      Data{make_surface(std::move(mesh_E)), make_surface(std::move(mesh_F)), law, mode, scheme});
}

Oracle::~Oracle() = default;

Answer Oracle::answer(Problem problem, const Pose& pose_doubles, const Velocity& velocity, const Wanted& wanted) const {
  require_fit(pose_doubles, velocity);
  const ExactPose pose(problem, data_->E, data_->F, pose_doubles);
  const Combinatorics found = find_combinatorics(pose);

  Answer answer;
  answer.touching = !found.crossings.ids.empty();
  answer.nested = found.E.nested || found.F.nested;
  answer.ambiguous = found.E.ambiguous || found.F.ambiguous;
  answer.E.intersected = found.E.intersected;
  answer.E.inner = found.E.inner;
  answer.F.intersected = found.F.intersected;
  answer.F.inner = found.F.inner;
  if (wanted.polygons) {
    const std::vector<Index> patches = group_into_patches(pose, found.crossings, found.polygons, found.E, found.F);
    report_polygons(pose, CrossingPoints(pose, found.crossings.ids), found.polygons, patches, answer);
  }
  if (wanted.areas)
    report_areas(pose, found.clip(pose), data_->E.closed && data_->F.closed && !answer.ambiguous, answer);
  if (wanted.force) {
    const ElementPairs elements = find_elements(pose, data_->mode, found);
    answer.too_deep = elements.too_deep;  // by the barycentres' lines in either scheme
    if (data_->scheme == Scheme::barycentric) {
      answer.certified = elements.certified;
      report_force({pose, BarycentricElements(elements.pairs), data_->law, data_->mode, velocity}, wanted, answer);
    } else {
      const std::vector<ClippedElement> clipped = find_clipped_elements(pose, data_->mode, found);
      report_force({pose, ClippedElements(clipped), data_->law, data_->mode, velocity}, wanted, answer);
    }
  }
  return answer;
}

}  // namespace pcm::reference
