// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/engine.h"

#include <utility>

#include "fast/active/active_areas.h"
#include "fast/crossings/crossings.h"
#include "fast/crossings/polygons.h"
#include "fast/engine/engine.h"
#include "fast/engine/force_by_scheme.h"
#include "fast/engine/workspace.h"
#include "fast/force/law_parameters.h"
#include "fast/surface/prepare_surface.h"
#include "meshes/base/floating_point_environment.h"

namespace pcm::fast {

namespace {

/// Writes the polygons and their points into the answer.
void report_polygons(const Intersection& found, const PolygonChains& chains, const Patches& patches, Contact& contact) {
  for (const Index c : chains.crossing_order) {
    const CrossingNode& node = found.crossings[c];
    Crossing crossing;
    crossing.edge_side = node.edge_side;
    crossing.edge = found.posed.surface(node.edge_side).edge(node.edge);
    crossing.face = node.face;
    crossing.position_Me = node.position_Me;
    contact.crossings.push_back(crossing);
  }
  contact.polygons.assign(chains.polygons.begin(), chains.polygons.end());
  for (std::size_t p = 0; p < contact.polygons.size(); ++p) contact.polygons[p].patch = patches.of_polygon[p];
  contact.patches = patches.count;
}

void report_active_areas(const Intersection& found, Contact& contact) {
  contact.nested = found.active.nested;
  contact.ambiguous = found.active.ambiguous;
  for (const Side side : {Side::E, Side::F}) {
    ActiveArea& area = side == Side::E ? contact.E : contact.F;
    const std::vector<Index>& intersected = found.crossings.of(side).intersected;
    const std::vector<Index>& inner = found.active.of(side).inner;
    area.intersected.assign(intersected.begin(), intersected.end());
    area.inner.assign(inner.begin(), inner.end());
  }
}

void report_inside_areas(const InsideAreas& areas, Contact& contact) {
  contact.E.area = areas.area[0];
  contact.F.area = areas.area[1];
  contact.E.vector_area_Me = areas.vector_area_Me[0];
  contact.F.vector_area_Me = areas.vector_area_Me[1];
  contact.undefined_areas = areas.undefined;
  contact.has_volume = areas.has_volume;
  contact.volume = areas.volume;
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
  if (!wanted.tangent) contact.tangent.reset();
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

Surface::Surface(TriangleMesh mesh) {
  const DefaultFloatingPoint environment;
  data_ = std::make_shared<const PreparedSurface>(prepare_surface(std::move(mesh)));
}

const TriangleMesh& Surface::mesh() const {
  return data_->mesh;
}

bool Surface::closed() const {
  return data_->closed;
}

void Surface::prepare_all_faces() const {
  const DefaultFloatingPoint environment;
  look_around_all_faces(*data_);
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

namespace {

/// Finds crossings, polygons where they are wanted, and active faces.
void find_active_faces(const Wanted& wanted, Tracking::Known known, Tracking* tracking, const Savings& savings,
                       Workspace::Data& data) {
  if (known == Tracking::Known::nothing) {
    find_crossings(data.posed, {false, wanted.bound, savings.filters}, data.team, data.crossing_scratch,
                   data.crossings);
  } else {
    find_crossings_among(tracking->pairs(), data.posed, data.crossing_scratch, data.crossings);
  }
  data.polygons.clear();
  if (wanted.polygons || wanted.areas) {
    chain_polygons(data.crossings, data.polygon_scratch, data.polygons);
    locate_crossings(data.posed, data.crossings);
  }
  list_crossings_by_edge(data.posed, data.polygons.crossing_order, data.crossings);
  find_active_areas(data.posed, data.crossings, data.team, data.active_scratch, data.active);
  if (known != Tracking::Known::nothing) tracking->keep_active_faces(data.crossings, data.active);
}

/// The steps, in their order.
void evaluate_wanted(const Pairing& pairing, const Pose& pose, double orthogonality_error, const Velocity& velocity,
                     const Wanted& wanted, const Savings& savings, const Kept& kept, Workspace::Data& data) {
  Contact& contact = data.contact;
  data.elements.take_back_list(contact);
  contact.clear();
  const PreparedSurface& surface_E = pairing.surface_E().data();
  const PreparedSurface& surface_F = pairing.surface_F().data();
  // The barycentric scheme's bound asks no vertex of its rounding.
  data.posed.place(surface_E, surface_F, pose, orthogonality_error,
                   wanted.bound && pairing.scheme() == Scheme::clipped);
  data.team.start();
  if (!savings.lazy_vertices) data.posed[Side::F].transform_all(data.posed.work);

  if (wants_only_touch(wanted)) {
    contact.touching = find_crossings(data.posed, {savings.first_crossing, wanted.bound, savings.filters}, data.team,
                                      data.crossing_scratch, data.crossings);
    return;
  }
  const Tracking::Known known = kept.tracking == nullptr
                                    ? Tracking::Known::nothing
                                    : kept.tracking->move_to(pose, data.posed, data.crossing_scratch.open);
  if (known == Tracking::Known::active_faces && !wanted.polygons && !wanted.areas) {
    kept.tracking->restore_active_faces(data.crossings, data.active);
  } else {
    find_active_faces(wanted, known, kept.tracking, savings, data);
  }
  contact.touching = !data.crossings.of(Side::E).intersected.empty();
  const Intersection found{data.posed, data.crossings, data.active};
  report_active_areas(found, contact);
  if (wanted.polygons) {
    group_patches(data.posed, data.crossings, data.polygons, data.active, data.patch_scratch, data.patches);
    report_polygons(found, data.polygons, data.patches, contact);
  }
  if (wanted.areas) {
    report_inside_areas(measure_inside_areas(data.posed, data.crossings, data.polygons, data.active, data.area_scratch),
                        contact);
  }
  if (wants_force(wanted)) {
    ForceProblem problem = force_problem(pairing, pose, velocity, wanted, savings);
    problem.keep_found = kept.found;
    LineMemories* const memories = known == Tracking::Known::nothing ? nullptr : &kept.tracking->lines();
    if (!savings.one_sided) {
      form_elements_of_slave(found, pairing.scheme(), pairing.mode(), problem, data.team, data.force_scratch);
    }
    const PairingForce force = compute_force(found, pairing.scheme(), pairing.mode(), problem, wanted.bound, data.team,
                                             data.force_scratch, memories, data.elements);
    report_elements(problem, force.total, data.elements, contact);
    contact.bound = force.bound;
  }
}

[[gnu::noinline]] Contact& evaluate_in_default_environment(const Pairing& pairing, const Pose& pose,
                                                           const Velocity& velocity, const Wanted& wanted,
                                                           Workspace& workspace, const Savings& savings,
                                                           const Kept& kept) {
  if (!savings.only_wanted) {
    Savings others = savings;
    others.only_wanted = true;
    Wanted all;
    all.bound = wanted.bound;  // a promise of its own, and all of its cost
    all.tangent = wanted.tangent;
    evaluate_in_default_environment(pairing, pose, velocity, all, workspace, others, kept);
    keep_only(wanted, workspace.data().contact);
    return workspace.data().contact;
  }
  const double orthogonality_error = require_valid(pose, velocity);
  Workspace::Data& data = workspace.data();
  evaluate_wanted(pairing, pose, orthogonality_error, velocity, wanted, savings, kept, data);
  data.contact.work = data.posed.work;
  return data.contact;
}

}  // namespace

ForceProblem force_problem(const Pairing& pairing, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                           const Savings& savings) {
  ForceProblem problem(pairing.law(), pose, velocity, wanted);
  if (!savings.velocities) problem.with_velocities = true;
  return problem;
}

Contact& evaluate_and_keep(const Pairing& pairing, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                           Workspace& workspace, const Savings& savings, const Kept& kept) {
  return evaluate_in_default_environment(pairing, pose, velocity, wanted, workspace, savings, kept);
}

const Contact& evaluate(const Pairing& pairing, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                        Workspace& workspace, const Savings& savings) {
  const DefaultFloatingPoint environment;
  return evaluate_in_default_environment(pairing, pose, velocity, wanted, workspace, savings, {});
}

}  // namespace pcm::fast
