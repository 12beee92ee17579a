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
#include "meshes/floating_point_environment.h"

namespace pcm::fast {

namespace {

bool wants_force(const Wanted& wanted) {
  return wanted.force || wanted.elements || wanted.bound || wanted.statistics;
}

bool wants_only_touch(const Wanted& wanted) {
  return !wanted.polygons && !wanted.areas && !wants_force(wanted);
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

/// Takes out of a whole answer what was not asked for.
void keep_only(const Wanted& wanted, Contact& contact) {
  const bool force = wants_force(wanted);
  if (!wanted.polygons) {
    contact.crossings.clear();
    contact.polygons.clear();
    contact.patches = 0;
  }
  if (!wanted.areas) {
    for (ActiveArea* area : {&contact.E, &contact.F}) {
      area->area = 0;
      area->vector_area_Me.setZero();
    }
    contact.undefined_areas = 0;
    contact.has_volume = false;
    contact.volume = 0;
  }
  if (!wanted.elements) contact.elements.clear();
  if (!wanted.elements && !wanted.statistics) contact.statistics = {};
  if (!wanted.bound) contact.bound.reset();
  if (!force) {
    contact.element_count = contact.too_deep = 0;
    contact.max_penetration = 0;
    contact.penetration_exceeded = false;
    contact.force_Me.setZero();
    contact.torque_Me.setZero();
  }
  if (wants_only_touch(wanted)) {
    contact.nested = contact.ambiguous = false;
    for (ActiveArea* area : {&contact.E, &contact.F}) {
      area->intersected.clear();
      area->inner.clear();
    }
  }
}

}  // namespace

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

Pairing::Pairing(Surface surface_E, Surface surface_F, ContactLaw law, Mode mode, Scheme scheme)
    : surface_E_(std::move(surface_E)),
      surface_F_(std::move(surface_F)),
      law_(std::move(law)),
      mode_(mode),
      scheme_(scheme) {
  const DefaultFloatingPoint environment;
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

namespace {

[[gnu::noinline]] const Contact& evaluate_in_default_environment(const Pairing& pairing, const Pose& pose,
                                                                 const Velocity& velocity, const Wanted& wanted,
                                                                 Workspace& workspace, const Savings& savings) {
  if (!savings.only_wanted) {
    Savings others = savings;
    others.only_wanted = true;
    Wanted all;
    all.bound = wanted.bound;  // a promise of its own, and all of its cost
    evaluate_in_default_environment(pairing, pose, velocity, all, workspace, others);
    keep_only(wanted, workspace.data().contact);
    return workspace.data().contact;
  }
  require_valid(pose, velocity);
  Workspace::Data& data = workspace.data();
  Contact& contact = data.contact;
  clear(contact);
  const Surface::Data& surface_E = pairing.surface_E().data();
  const Surface::Data& surface_F = pairing.surface_F().data();
  data.placement = Placement(surface_E, surface_F, pose);
  data.side(Side::E).posed.place_E(surface_E);
  // The barycentric scheme's bound asks no vertex of its rounding.
  const bool with_roundings = wanted.bound && pairing.scheme() == Scheme::clipped;
  data.side(Side::F).posed.place_F(surface_F, pose, surface_E.mesh.vertices.size(), with_roundings);
  if (!savings.lazy_vertices) data.side(Side::F).posed.transform_all(contact.work);

  const bool force = wants_force(wanted);
  const bool only_touch = wants_only_touch(wanted);
  contact.touching = find_crossings(data, only_touch && savings.first_crossing, wanted.bound, savings.filters);
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
    StatisticsSum statistics;
    ForceProblem problem = force_problem(pairing.scheme(), pairing.law(), pose, velocity, wanted, statistics);
    if (!savings.velocities) problem.with_velocities = true;
    if (!savings.one_sided) form_elements_of_slave(data, pairing.mode(), problem);
    compute_force(data, pairing.mode(), problem);
    require_finite_force(contact);
  }
  return contact;
}

}  // namespace

const Contact& evaluate(const Pairing& pairing, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                        Workspace& workspace, const Savings& savings) {
  const DefaultFloatingPoint environment;
  return evaluate_in_default_environment(pairing, pose, velocity, wanted, workspace, savings);
}

}  // namespace pcm::fast
