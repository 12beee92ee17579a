// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle.h"

#include <utility>

#include "reference/active_areas.h"
#include "reference/ball.h"
#include "reference/candidates.h"
#include "reference/crossing_points.h"
#include "reference/crossings.h"
#include "reference/exact_pose.h"
#include "reference/orientation.h"
#include "reference/polygons.h"
#include "reference/report.h"
#include "reference/surface.h"
#include "reference/validate.h"

namespace pcm::reference {

struct Oracle::Data {
  Surface E;
  Surface F;
  ContactLaw law;
  Mode mode;
};

Oracle::Oracle(TriangleMesh mesh_E, TriangleMesh mesh_F, ContactLaw law, Mode mode) {
  require_fit(law);
  data_ =
      std::make_unique<const Data>(Data{make_surface(std::move(mesh_E)), make_surface(std::move(mesh_F)), law, mode});
}

Oracle::~Oracle() = default;

Answer Oracle::answer(Problem problem, const Pose& pose_doubles, const Velocity& velocity, const Wanted& wanted) const {
  require_fit(pose_doubles, velocity);
  const ExactPose pose(problem, data_->E, data_->F, pose_doubles);
  const Orientation orientation(pose);
  const FaceBoxes boxes_E = make_face_boxes(pose, Side::E), boxes_F = make_face_boxes(pose, Side::F);
  const std::vector<IndexPair> candidates = candidate_pairs(boxes_E, boxes_F);

  const Crossings crossings = find_crossings(orientation, candidates);
  const std::vector<Chain> chains = chain_polygons(crossings);

  const std::vector<IndexPair> columns_E = columns_above_vertices(pose, Side::E, boxes_F);
  const std::vector<IndexPair> columns_F = columns_above_vertices(pose, Side::F, boxes_E);
  const ActiveFaces active_E = find_active_faces(orientation, Side::E, crossings, columns_E);
  const ActiveFaces active_F = find_active_faces(orientation, Side::F, crossings, columns_F);

  Answer answer;
  answer.touching = !crossings.ids.empty();
  answer.nested = active_E.nested || active_F.nested;
  answer.ambiguous = active_E.ambiguous || active_F.ambiguous;
  answer.E.intersected = active_E.intersected;
  answer.E.inner = active_E.inner;
  answer.F.intersected = active_F.intersected;
  answer.F.inner = active_F.inner;
  if (wanted.polygons) {
    const CrossingPoints points(pose, crossings.ids);
    const std::vector<Index> patches = group_into_patches(pose, crossings, chains, active_E, active_F);
    report_polygons(points, chains, patches, answer);
  }
  return answer;
}

}  // namespace pcm::reference
