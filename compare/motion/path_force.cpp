// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/path_force.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "fast/barycentric/penetration_line.h"
#include "fast/base/geometry.h"
#include "fast/engine/workspace.h"
#include "pcm/bad_input.h"

namespace pcm::compare {

PathForce::PathForce(const fast::Pairing& pairing, const PosePath& path) : pairing_(pairing), path_(path) {
  ContactLaw law = pairing.law();
  if (law.max_penetration == std::numeric_limits<double>::infinity()) return;
  law.max_penetration = std::numeric_limits<double>::infinity();
  unclamped_.emplace(pairing.surface_E(), pairing.surface_F(), law, pairing.mode(), pairing.scheme());
}

PathSample PathForce::at(const PathPoint& point) {
  PathSample sample;
  sample.where = point;
  sample.pose = path_.at(point);
  Wanted wanted;
  wanted.polygons = wanted.areas = false;
  const fast::Contact* contact = nullptr;
  try {
    contact = &fast::evaluate(pairing_, sample.pose, {}, wanted, workspace_);
  } catch (const BadInput& error) {
    throw BadInput(fmt::format("path, at {}: {}", point.position(), error.what()));
  }
  ++evaluations_;
  sample.force_Me = contact->force_Me;
  sample.torque_Me = contact->torque_Me;
  sample.too_deep = contact->too_deep;
  const double weight = pairing_.mode() == Mode::both ? 0.5 : 1;
  for (const fast::Element& element : contact->elements) {
    const bool next = sample.loads.empty() || sample.loads.back().master != element.master ||
                      sample.loads.back().face != element.master_face;
    FaceLoad& load = next ? sample.loads.emplace_back() : sample.loads.back();
    load.master = element.master;
    load.face = element.master_face;
    load.slave_faces.push_back(element.slave_face);
    load.depth = std::max(load.depth, element.penetration);
    load.force_Me += weight * element.force_Me;
    load.torque_Me += weight * (element.position_Me - sample.pose.r).cross(element.force_Me);
  }
  if (unclamped_) mark_clamped(sample, *contact);
  return sample;
}

// Clamping is done point by point (PCM section 6): the mean penetration of an element tells nothing of how deep it is
// where it is deepest. But clamping takes something from the mean where some of the element lies deeper, if that is
// more than a rounding; and an element nowhere so deep is computed by the same operations under either law. Both
// answers have the same elements, for the law has no say in which slave face a point of the master sees.
void PathForce::mark_clamped(PathSample& sample, const fast::Contact& contact) {
  Wanted wanted;
  wanted.polygons = wanted.areas = false;
  const fast::Contact& free = fast::evaluate(*unclamped_, sample.pose, {}, wanted, unclamped_workspace_);
  auto load = sample.loads.begin();
  for (std::size_t i = 0; i < contact.elements.size(); ++i) {
    const fast::Element& element = contact.elements[i];
    while (load->master != element.master || load->face != element.master_face) ++load;
    load->clamped = load->clamped || element.penetration != free.elements.at(i).penetration;
  }
}

IdleFace PathForce::why_idle(Side master, Index face) {
  fast::Workspace::Data& data = workspace_.data();
  const fast::FaceGeometry geometry(data.posed.face_Me(master, face));
  const fast::Penetration line =
      fast::find_penetration(data.posed, master, face, geometry, data.force_scratch.barycentric.search.walks.open);
  IdleFace idle;
  idle.first_met = line.first_met;
  if (fast::Intersection{data.posed, data.crossings, data.active}.is_active(master, face)) {
    idle.why = line.outcome == fast::Penetration::Outcome::too_deep ? IdleFace::Why::too_deep : IdleFace::Why::outside;
  }
  return idle;
}

}  // namespace pcm::compare
