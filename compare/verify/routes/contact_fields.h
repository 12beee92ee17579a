// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "compare/verify/verdict/disagreement_kind.h"
#include "pcm/contact.h"

/// Every field of the engine's answer and of its parts, in one place, with the check that holds it. The structs are
/// taken apart by structured bindings, so a field that joins one of them without a line here does not compile.
namespace pcm::compare {

/// What a caller has to ask for to be answered a field (Wanted).
enum class Asked : std::uint8_t {
  touch,       ///< nothing: always answered
  activity,    ///< anything beyond touch
  polygons,    ///< Wanted::polygons
  areas,       ///< Wanted::areas
  force,       ///< anything of forces
  elements,    ///< Wanted::elements
  statistics,  ///< Wanted::statistics or elements
  bound,       ///< Wanted::bound
  tangent,     ///< Wanted::tangent
  work,        ///< always answered, and never the same: it tells what the question cost
};

/// A field, and the kind of disagreement that a wrong value of it raises.
struct Field {
  std::string_view name;
  Asked asked;
  Kind held_by;
};

namespace fields {

template <class T, class Visit>
void visit_crossing(T& crossing, const Visit& visit) {
  auto& [edge_side, edge, face, position_Me] = crossing;
  visit(Field{"crossings.edge_side", Asked::polygons, Kind::polygon_cycle}, edge_side);
  visit(Field{"crossings.edge", Asked::polygons, Kind::polygon_cycle}, edge);
  visit(Field{"crossings.face", Asked::polygons, Kind::polygon_cycle}, face);
  visit(Field{"crossings.position_Me", Asked::polygons, Kind::crossing_position}, position_Me);
}

template <class T, class Visit>
void visit_polygon(T& polygon, const Visit& visit) {
  auto& [closed, first, count, patch] = polygon;
  visit(Field{"polygons.closed", Asked::polygons, Kind::polygon_cycle}, closed);
  visit(Field{"polygons.first", Asked::polygons, Kind::polygon_cycle}, first);
  visit(Field{"polygons.count", Asked::polygons, Kind::polygon_cycle}, count);
  visit(Field{"polygons.patch", Asked::polygons, Kind::patches}, patch);
}

template <class T, class Visit>
void visit_active_area(T& active, const Visit& visit) {
  auto& [intersected, inner, area, vector_area_Me] = active;
  visit(Field{"active.intersected", Asked::activity, Kind::intersected_faces}, intersected);
  visit(Field{"active.inner", Asked::activity, Kind::inner_faces}, inner);
  visit(Field{"active.area", Asked::areas, Kind::area}, area);
  visit(Field{"active.vector_area_Me", Asked::areas, Kind::vector_area}, vector_area_Me);
}

template <class T, class Visit>
void visit_element(T& element, const Visit& visit) {
  auto& [master, master_face, slave_face, area, penetration, normal_velocity, tangential_velocity, normal_force,
         tangential_force, normal_Me, position_Me, force_Me] = element;
  visit(Field{"elements.master", Asked::elements, Kind::elements}, master);
  visit(Field{"elements.master_face", Asked::elements, Kind::elements}, master_face);
  visit(Field{"elements.slave_face", Asked::elements, Kind::elements}, slave_face);
  visit(Field{"elements.area", Asked::elements, Kind::element_area}, area);
  visit(Field{"elements.penetration", Asked::elements, Kind::element_penetration}, penetration);
  visit(Field{"elements.normal_velocity", Asked::elements, Kind::element_velocity}, normal_velocity);
  visit(Field{"elements.tangential_velocity", Asked::elements, Kind::element_velocity}, tangential_velocity);
  visit(Field{"elements.normal_force", Asked::elements, Kind::element_force}, normal_force);
  visit(Field{"elements.tangential_force", Asked::elements, Kind::element_force}, tangential_force);
  visit(Field{"elements.normal_Me", Asked::elements, Kind::element_normal}, normal_Me);
  visit(Field{"elements.position_Me", Asked::elements, Kind::element_position}, position_Me);
  visit(Field{"elements.force_Me", Asked::elements, Kind::element_force}, force_Me);
}

template <class T, class Visit>
void visit_bound(T& bound, const Visit& visit) {
  auto& [force_Me, torque_Me, flipped, penetration_at_least, penetration_at_most] = bound;
  visit(Field{"bound.force_Me", Asked::bound, Kind::bound}, force_Me);
  visit(Field{"bound.torque_Me", Asked::bound, Kind::bound}, torque_Me);
  visit(Field{"bound.flipped", Asked::bound, Kind::bound}, flipped);
  visit(Field{"bound.penetration_at_least", Asked::bound, Kind::penetration_bound}, penetration_at_least);
  visit(Field{"bound.penetration_at_most", Asked::bound, Kind::penetration_bound}, penetration_at_most);
}

template <class T, class Visit>
void visit_statistics(T& statistics, const Visit& visit) {
  auto& [patch_area, mean_penetration, max_pressure, mean_pressure, max_normal_velocity, max_tangential_velocity,
         centre_of_pressure_Me] = statistics;
  visit(Field{"statistics.patch_area", Asked::statistics, Kind::statistics}, patch_area);
  visit(Field{"statistics.mean_penetration", Asked::statistics, Kind::statistics}, mean_penetration);
  visit(Field{"statistics.max_pressure", Asked::statistics, Kind::statistics}, max_pressure);
  visit(Field{"statistics.mean_pressure", Asked::statistics, Kind::statistics}, mean_pressure);
  visit(Field{"statistics.max_normal_velocity", Asked::statistics, Kind::statistics}, max_normal_velocity);
  visit(Field{"statistics.max_tangential_velocity", Asked::statistics, Kind::statistics}, max_tangential_velocity);
  visit(Field{"statistics.centre_of_pressure_Me", Asked::statistics, Kind::statistics}, centre_of_pressure_Me);
}

template <class T, class Visit>
void visit_work(T& work, const Visit& visit) {
  auto& [box_tests, node_pairs, face_rows, live_lanes, candidate_pairs, unsure_pairs, crossing_pairs,
         vertices_transformed, predicates, exact_predicates, tie_breaks, elements, velocities, law_only, lines,
         lines_settled, searches_unseen, searches_oblique, searches_slave, searches_master] = work;
  visit(Field{"work.box_tests", Asked::work, Kind::work}, box_tests);
  visit(Field{"work.node_pairs", Asked::work, Kind::work}, node_pairs);
  visit(Field{"work.face_rows", Asked::work, Kind::work}, face_rows);
  visit(Field{"work.live_lanes", Asked::work, Kind::work}, live_lanes);
  visit(Field{"work.candidate_pairs", Asked::work, Kind::work}, candidate_pairs);
  visit(Field{"work.unsure_pairs", Asked::work, Kind::work}, unsure_pairs);
  visit(Field{"work.crossing_pairs", Asked::work, Kind::work}, crossing_pairs);
  visit(Field{"work.vertices_transformed", Asked::work, Kind::work}, vertices_transformed);
  visit(Field{"work.predicates", Asked::work, Kind::work}, predicates);
  visit(Field{"work.exact_predicates", Asked::work, Kind::work}, exact_predicates);
  visit(Field{"work.tie_breaks", Asked::work, Kind::work}, tie_breaks);
  visit(Field{"work.elements", Asked::work, Kind::work}, elements);
  visit(Field{"work.velocities", Asked::work, Kind::work}, velocities);
  visit(Field{"work.law_only", Asked::work, Kind::work}, law_only);
  visit(Field{"work.lines", Asked::work, Kind::work}, lines);
  visit(Field{"work.lines_settled", Asked::work, Kind::work}, lines_settled);
  visit(Field{"work.searches_unseen", Asked::work, Kind::work}, searches_unseen);
  visit(Field{"work.searches_oblique", Asked::work, Kind::work}, searches_oblique);
  visit(Field{"work.searches_slave", Asked::work, Kind::work}, searches_slave);
  visit(Field{"work.searches_master", Asked::work, Kind::work}, searches_master);
}

}  // namespace fields

/// Calls visit(field, value) for every field, in lists once for each entry; `Answer` is fast::Contact, const or not.
/// Values are bool, whole numbers, Side, double, vectors of three doubles, a tangent, and arrays and lists of face and
/// vertex numbers.
template <class Answer, class Visit>
void for_each_field(Answer& contact, const Visit& visit) {
  auto& [touching, nested, ambiguous, crossings, polygons, patches, E, F, undefined_areas, has_volume, volume, elements,
         element_count, too_deep, max_penetration, penetration_exceeded, force_Me, torque_Me, bound, tangent,
         statistics, work] = contact;
  visit(Field{"touching", Asked::touch, Kind::touching}, touching);
  visit(Field{"nested", Asked::activity, Kind::nested}, nested);
  visit(Field{"ambiguous", Asked::activity, Kind::ambiguous}, ambiguous);
  for (auto& crossing : crossings) fields::visit_crossing(crossing, visit);
  for (auto& polygon : polygons) fields::visit_polygon(polygon, visit);
  visit(Field{"patches", Asked::polygons, Kind::patches}, patches);
  fields::visit_active_area(E, visit);
  fields::visit_active_area(F, visit);
  visit(Field{"undefined_areas", Asked::areas, Kind::undefined_areas}, undefined_areas);
  visit(Field{"has_volume", Asked::areas, Kind::has_volume}, has_volume);
  visit(Field{"volume", Asked::areas, Kind::volume}, volume);
  for (auto& element : elements) fields::visit_element(element, visit);
  visit(Field{"element_count", Asked::force, Kind::sums}, element_count);
  visit(Field{"too_deep", Asked::force, Kind::too_deep}, too_deep);
  visit(Field{"max_penetration", Asked::force, Kind::penetration}, max_penetration);
  visit(Field{"penetration_exceeded", Asked::force, Kind::exceeded}, penetration_exceeded);
  visit(Field{"force_Me", Asked::force, Kind::force}, force_Me);
  visit(Field{"torque_Me", Asked::force, Kind::torque}, torque_Me);
  if (bound) fields::visit_bound(*bound, visit);
  if (tangent) visit(Field{"tangent", Asked::tangent, Kind::tangent}, *tangent);
  fields::visit_statistics(statistics, visit);
  fields::visit_work(work, visit);
}

/// All fields, each once.
std::vector<Field> all_fields();

/// Whether the question brings an answer to the field.
bool is_answered(Asked asked, const Wanted& wanted);

/// What `partial`, answered to `wanted`, differs in from the whole answer to the same state: fields asked for by a bit,
/// others by not being empty. Empty text where it does not. Work is not compared, and bounds only where both have one.
std::string difference_in_bits(const fast::Contact& whole, const fast::Contact& partial, const Wanted& wanted);

}  // namespace pcm::compare
