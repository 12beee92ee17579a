// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/full_json.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "compare/contact/contact_json.h"
#include "compare/io/names.h"
#include "compare/poses/crossing_pairs.h"

namespace pcm::compare {
namespace {

void add_faces(Json& side, const AreaRecord& active, const Knowledge& known) {
  side["intersected_faces"] = known.faces ? Json(active.intersected) : Json();
  side["inner_faces"] = known.faces ? Json(active.inner) : Json();
}

Json crossing_json(const fast::Crossing& x) {
  return {{"edge_of", name(x.edge_side)}, {"edge", x.edge}, {"face", x.face}};
}

/// The polygons are those of `json`, in their order.
void add_polygons(Json& json, const std::vector<PolygonRecord>& polygons, Index patches) {
  std::vector<Json> members(static_cast<std::size_t>(patches), Json::array());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    Json crossings = Json::array();
    for (const fast::Crossing& x : polygons[i].points) crossings.push_back(crossing_json(x));
    json["polygons"][i]["crossings"] = std::move(crossings);
    json["polygons"][i]["patch"] = polygons[i].patch;
    members[static_cast<std::size_t>(polygons[i].patch)].push_back(i);
  }
  json["patch_list"] = Json::array();
  for (Json& patch : members) json["patch_list"].push_back({{"polygons", std::move(patch)}});
}

std::vector<fast::Crossing> all_crossings(const std::vector<PolygonRecord>& polygons) {
  std::vector<fast::Crossing> crossings;
  for (const PolygonRecord& polygon : polygons)
    crossings.insert(crossings.end(), polygon.points.begin(), polygon.points.end());
  return crossings;
}

Json element_json(const fast::Element& e, const PlacedSurfaces& placed) {
  return {{"master", name(e.master)},
          {"master_face", e.master_face},
          {"slave_face", e.slave_face},
          {"face_centroid", json_vector(placed.centroid_Me(e.master, e.master_face))},
          {"position", json_vector(e.position_Me)},
          {"normal", json_vector(e.normal_Me)},
          {"area", e.area},
          {"penetration", e.penetration},
          {"pressure", pressure(e)},
          {"normal_velocity", e.normal_velocity},
          {"tangential_velocity", e.tangential_velocity},
          {"normal_force", e.normal_force},
          {"tangential_force", e.tangential_force},
          {"force", json_vector(e.force_Me)}};
}

Json state_json(const State& state) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(json_vector(state.pose.A.row(i).transpose()));
  return {{"A", std::move(rows)},
          {"r", json_vector(state.pose.r)},
          {"v", json_vector(state.velocity.v)},
          {"w", json_vector(state.velocity.w)},
          {"replaced_error", state.replaced_error}};
}

}  // namespace

FullJson::FullJson(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Json provenance)
    : E_(mesh_E), F_(mesh_F), provenance_(std::move(provenance)) {}

void FullJson::add_to(Json& json, const ContactRecord& record, const State& state) const {
  add_faces(json["E"], record.E, record.known);
  add_faces(json["F"], record.F, record.known);
  if (json["polygons"].is_array()) {
    add_polygons(json, record.polygons, record.patches);
    json["crossing_pairs"] = crossing_pairs(E_, F_, all_crossings(record.polygons));
  } else {
    json["patch_list"] = json["crossing_pairs"] = nullptr;
  }
  const PlacedSurfaces placed(E_.mesh, F_.mesh, state.pose);
  json["element_list"] = Json::array();
  for (const fast::Element& e : record.elements) json["element_list"].push_back(element_json(e, placed));
  json["statistics"] = statistics_json(record.statistics);
  json["pose"] = state_json(state);
  json["provenance"] = provenance_;
}

}  // namespace pcm::compare
