// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle.h"

#include <optional>
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

Answer Oracle::answer(Problem problem, const Pose& pose, const Velocity& velocity, const Wanted& wanted) const {
  return Inquiry(*this, pose, velocity, wanted).answer(problem);
}

/// What was found for one problem and holds in the other one too.
struct Inquiry::Shared {
  const Oracle::Data& oracle;
  Pose pose;
  Velocity velocity;
  Wanted wanted;
  std::shared_ptr<Proximity> near;
  std::optional<ElementPairs> pairs;  ///< certified ones only
  ClippedFindings clipped;

  ElementPairs find_pairs(const ExactPose& exact_pose, const Combinatorics& found) {
    if (pairs) return *pairs;
    ElementPairs elements = find_elements(exact_pose, oracle.mode, found);
    if (elements.certified) pairs = elements;
    return elements;
  }

  const std::vector<ClippedElement>& find_clipped(const ExactPose& exact_pose, const Combinatorics& found) {
    clipped = find_clipped_elements(exact_pose, oracle.mode, found, clipped);
    return clipped.elements;
  }
};

Inquiry::Inquiry(const Oracle& oracle, const Pose& pose, const Velocity& velocity, const Wanted& wanted)
    : shared_(std::make_unique<Shared>(Shared{*oracle.data_, pose, velocity, wanted, {}, {}, {}})) {
  require_fit(pose, velocity);
}

Inquiry::~Inquiry() = default;

Answer Inquiry::answer(Problem problem) {
  const Oracle::Data& oracle = shared_->oracle;
  const Wanted& wanted = shared_->wanted;
  const ExactPose pose(problem, oracle.E, oracle.F, shared_->pose);
  if (!shared_->near) shared_->near = std::make_shared<Proximity>(pose);
  const Combinatorics found = find_combinatorics(pose, shared_->near);

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
    report_areas(pose, found.clip(pose), oracle.E.closed && oracle.F.closed && !answer.ambiguous, answer);
  if (wanted.force) {
    const ElementPairs elements = shared_->find_pairs(pose, found);
    answer.too_deep = elements.too_deep;  // by the barycentres' lines in either scheme
    if (oracle.scheme == Scheme::barycentric) {
      answer.certified = elements.certified;
      report_force({pose, BarycentricElements(elements.pairs), oracle.law, oracle.mode, shared_->velocity}, wanted,
                   answer);
    } else {
      const ClippedElements clipped(shared_->find_clipped(pose, found));
      report_force({pose, clipped, oracle.law, oracle.mode, shared_->velocity}, wanted, answer);
    }
  }
  return answer;
}

}  // namespace pcm::reference
