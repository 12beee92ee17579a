// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/contact_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace pcm::compare {
namespace {

Json polygons_json(const fast::Contact& contact) {
  Json polygons = Json::array();
  for (const fast::Polygon& polygon : contact.polygons) {
    Json points = Json::array();
    for (Index i = polygon.first; i < polygon.first + polygon.count; ++i)
      points.push_back(json_vector(contact.crossings[static_cast<std::size_t>(i)].position_Me));
    polygons.push_back({{"closed", polygon.closed}, {"points", std::move(points)}});
  }
  return polygons;
}

Json polygons_json(const reference::Answer& answer) {
  Json polygons = Json::array();
  for (const reference::Polygon& polygon : answer.polygons) {
    Json points = Json::array();
    for (const reference::Crossing& crossing : polygon.points) points.push_back(json_vector(crossing.position_Me));
    polygons.push_back({{"closed", polygon.closed}, {"points", std::move(points)}});
  }
  return polygons;
}

template <typename ActiveArea>
Json area_json(const ActiveArea& area) {
  return {{"intersected", area.intersected.size()},
          {"inner", area.inner.size()},
          {"area", area.area},
          {"vector_area", json_vector(area.vector_area_Me)}};
}

Json interval_json(const reference::AreaInterval& interval) {
  return Json::array({interval.open, interval.closed});
}

Json work_json(const fast::WorkCounters& work) {
  return {{"box_tests", work.box_tests},
          {"node_pairs", work.node_pairs},
          {"face_rows", work.face_rows},
          {"live_lanes", work.live_lanes},
          {"candidate_pairs", work.candidate_pairs},
          {"unsure_pairs", work.unsure_pairs},
          {"crossing_pairs", work.crossing_pairs},
          {"vertices_transformed", work.vertices_transformed},
          {"predicates", work.predicates},
          {"exact_predicates", work.exact_predicates},
          {"tie_breaks", work.tie_breaks},
          {"elements", work.elements},
          {"velocities", work.velocities},
          {"law_only", work.law_only},
          {"lines", work.lines},
          {"lines_settled", work.lines_settled},
          {"searches_unseen", work.searches_unseen},
          {"searches_oblique", work.searches_oblique},
          {"searches_slave", work.searches_slave},
          {"searches_master", work.searches_master}};
}

/// JSON has no infinity: where nothing can be promised stands null.
Json finite_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json();
}

Json bound_json(const Eigen::Vector3d& bound) {
  Json json = Json::array();
  for (int i = 0; i < 3; ++i) json.push_back(finite_or_null(bound[i]));
  return json;
}

/// The keys that both answers share; what their types spell differently comes as arguments.
template <typename Result>
Json common_json(const Result& result, Json volume, std::size_t elements, Json work) {
  Json json;
  json["touching"] = result.touching;
  json["nested"] = result.nested;
  json["ambiguous"] = result.ambiguous;
  json["polygons"] = polygons_json(result);
  json["E"] = area_json(result.E);
  json["F"] = area_json(result.F);
  json["volume"] = std::move(volume);
  json["elements"] = elements;
  json["force"] = json_vector(result.force_Me);
  json["torque"] = json_vector(result.torque_Me);
  json["max_penetration"] = result.max_penetration;
  json["penetration_exceeded"] = result.penetration_exceeded;
  json["too_deep"] = result.too_deep;
  json["patches"] = result.patches;
  json["work"] = std::move(work);
  json["undefined_areas"] = result.undefined_areas;
  return json;
}

}  // namespace

Json statistics_json(const fast::Statistics& statistics) {
  return {{"patch_area", statistics.patch_area},
          {"mean_penetration", statistics.mean_penetration},
          {"max_pressure", statistics.max_pressure},
          {"mean_pressure", statistics.mean_pressure},
          {"max_normal_velocity", statistics.max_normal_velocity},
          {"max_tangential_velocity", statistics.max_tangential_velocity},
          {"centre_of_pressure", json_vector(statistics.centre_of_pressure_Me)}};
}

Json contact_json(const fast::Contact& contact) {
  Json volume = contact.has_volume ? Json(contact.volume) : Json();
  Json json =
      common_json(contact, std::move(volume), static_cast<std::size_t>(contact.element_count), work_json(contact.work));
  json["statistics"] = statistics_json(contact.statistics);
  if (contact.bound)
    json["bound"] = {
        {"force", bound_json(contact.bound->force_Me)},
        {"torque", bound_json(contact.bound->torque_Me)},
        {"flipped", contact.bound->flipped},
        {"max_penetration", {contact.bound->penetration_at_least, finite_or_null(contact.bound->penetration_at_most)}}};
  return json;
}

Json contact_json(const reference::Answer& answer) {
  Json volume = answer.volume ? Json(*answer.volume) : Json();
  Json json = common_json(answer, std::move(volume), answer.elements.size(), Json::object());
  for (const auto& [name, active] : {std::pair("E", &answer.E), std::pair("F", &answer.F)}) {
    json[name]["area_interval"] = interval_json(active->area_interval);
    json[name]["limit_area"] = active->limit_area;
    json[name]["limit_vector_area"] = json_vector(active->limit_vector_area_Me);
  }
  json["certified"] = answer.certified;
  return json;
}

}  // namespace pcm::compare
