// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/engine.h"

#include <utility>

#include "fast/active_areas.h"
#include "fast/contact_force.h"
#include "fast/crossings.h"
#include "fast/law.h"
#include "fast/polygons.h"
#include "fast/surface.h"
#include "fast/workspace.h"
#include "meshes/bad_input.h"

namespace pcm::fast {

namespace {

/// Empties the answer and keeps its memory.
void clear(Contact& contact) {
  Contact empty;
  std::swap(empty.crossings, contact.crossings);
  std::swap(empty.polygons, contact.polygons);
  std::swap(empty.elements, contact.elements);
  std::swap(empty.E.intersected, contact.E.intersected);
  std::swap(empty.E.inner, contact.E.inner);
  std::swap(empty.F.intersected, contact.F.intersected);
  std::swap(empty.F.inner, contact.F.inner);
  contact = std::move(empty);
  contact.crossings.clear();
  contact.polygons.clear();
  contact.elements.clear();
  for (ActiveArea* area : {&contact.E, &contact.F}) {
    area->intersected.clear();
    area->inner.clear();
  }
}

/// Writes the polygons and their points into the answer.
void report_polygons(Workspace::Data& workspace) {
  Contact& contact = workspace.contact;
  for (const Index c : workspace.crossing_order) {
    const CrossingNode& node = workspace.crossings[static_cast<std::size_t>(c)];
    Crossing crossing;
    crossing.edge_side = node.edge_side;
    crossing.edge = workspace.side(node.edge_side).surface().edge(node.edge);
    crossing.face = node.face;
    crossing.position_Me = node.position_Me;
    contact.crossings.push_back(crossing);
  }
  contact.polygons.assign(workspace.polygons.begin(), workspace.polygons.end());
}

void report_active_area(const SideState& side, ActiveArea& area) {
  area.intersected.assign(side.intersected.begin(), side.intersected.end());
  area.inner.assign(side.inner.begin(), side.inner.end());
}

}  // namespace

Pairing::Pairing(Surface surface_E, Surface surface_F, ContactLaw law, Mode mode, Scheme scheme)
    : surface_E_(std::move(surface_E)),
      surface_F_(std::move(surface_F)),
      law_(std::move(law)),
      mode_(mode),
      scheme_(scheme) {
  require_valid(law_);
}

Workspace::Workspace() : data_(std::make_unique<Data>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

Workspace::Data& Workspace::data() {
  if (!data_) data_ = std::make_unique<Data>();
  return *data_;
}

const Contact& evaluate(const Pairing& pairing, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                        Workspace& workspace) {
  require_valid(pose, velocity);
  Workspace::Data& data = workspace.data();
  Contact& contact = data.contact;
  clear(contact);
  const Surface::Data& surface_E = pairing.surface_E().data();
  const Surface::Data& surface_F = pairing.surface_F().data();
  data.placement = Placement(surface_E, surface_F, pose);
  data.side(Side::E).posed.place_E(surface_E);
  data.side(Side::F).posed.place_F(surface_F, pose, surface_E.mesh.vertices.size());

  const bool force = wanted.force || wanted.elements || wanted.bound;
  const bool only_touch = !wanted.polygons && !wanted.areas && !force;
  contact.touching = find_crossings(data, only_touch, wanted.bound);
  if (only_touch) return contact;

  const bool polygons = wanted.polygons || wanted.areas;
  data.crossing_order.clear();
  if (polygons) {
    chain_polygons(data);
    locate_crossings(data);
  }
  list_crossings_by_edge(data);
  find_active_area(data, Side::E);
  find_active_area(data, Side::F);
  report_active_area(data.side(Side::E), contact.E);
  report_active_area(data.side(Side::F), contact.F);
  if (wanted.polygons) {
    group_patches(data);
    report_polygons(data);
  }
  if (wanted.areas) measure_clipped_areas(data);
  if (force) {
    const ContactLaw& law = pairing.law();
    const bool with_velocities = law.damping != 0 || law.friction != 0 || wanted.elements;
    compute_force(
        data, pairing.mode(),
        {pairing.scheme(), law, SeriesStiffness(law), pose, velocity, with_velocities, wanted.elements, wanted.bound});
    if (!contact.force_Me.allFinite() || !contact.torque_Me.allFinite()) {
      throw BadInput("force or torque exceeds the range of doubles; choose units in which the numbers are smaller");
    }
  }
  return contact;
}

}  // namespace pcm::fast
