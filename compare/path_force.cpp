// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/path_force.h"

#include <fmt/format.h>

#include <algorithm>

#include "fast/geometry.h"
#include "fast/penetration.h"
#include "fast/workspace.h"
#include "meshes/bad_input.h"

namespace pcm::compare {

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
    load.clamped = load.clamped || element.penetration == pairing_.law().max_penetration;
    load.force_Me += weight * element.force_Me;
    load.torque_Me += weight * (element.position_Me - sample.pose.r).cross(element.force_Me);
  }
  return sample;
}

IdleFace PathForce::why_idle(Side master, Index face) {
  fast::Workspace::Data& data = workspace_.data();
  fast::SideState& side = data.side(master);
  const fast::FaceGeometry geometry(side.posed.face_Me(face, data.contact.work));
  const fast::Penetration line = fast::find_penetration(data, master, face, geometry);
  IdleFace idle;
  idle.first_met = line.first_met;
  for (const std::vector<Index>* active : {&side.intersected, &side.inner})
    if (std::binary_search(active->begin(), active->end(), face))
      idle.why =
          line.outcome == fast::Penetration::Outcome::too_deep ? IdleFace::Why::too_deep : IdleFace::Why::outside;
  return idle;
}

}  // namespace pcm::compare
