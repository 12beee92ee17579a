// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/explanation_json.h"

#include <nlohmann/json.hpp>

#include "compare/explain/words.h"
#include "compare/io/names.h"

namespace pcm::compare {
namespace {

Json feature_json(const Feature& feature) {
  Json json{{"body", name(feature.side)}};
  if (feature.kind == FeatureKind::edge)
    json["edge"] = feature.index;
  else
    json[std::string(key(feature.kind))] = feature.index[0];
  return json;
}

Json features_json(const auto& features) {
  Json json = Json::array();
  for (const Feature& feature : features) json.push_back(feature_json(feature));
  return json;
}

Json term_json(const std::vector<MovedCoordinate>& term) {
  Json json = Json::array();
  for (const MovedCoordinate& moved : term)
    json.push_back({{"body", name(moved.side)},
                    {"vertex", moved.vertex},
                    {"coordinate", std::string(1, "xyz"[moved.coordinate])}});
  return json;
}

Json sign_json(const Sign& sign) {
  Json json{{"predicate", key(sign.predicate)},
            {"of", features_json(sign.of)},
            {"exact", sign.exact},
            {"decided_by", key(sign.stage)},
            {"decided", sign.decided}};
  if (!sign.term.empty()) json["term"] = term_json(sign.term);
  if (sign.shift != 0) json["shift"] = sign.shift;
  return json;
}

Json pair_json(const Coincidence& c, double ulp) {
  return {{"kind", words(c.kind).key},
          {"features", features_json(c.features)},
          {"exact", c.exact()},
          {"margin", c.margin},
          {"margin_ulps", c.margin / ulp},
          {"position", json_vector(c.position_Me)},
          {"apart", json_vector(c.apart_Me)}};
}

Json listed_json(const ListedCoincidence& listed, double ulp) {
  Json json = pair_json(listed.coincidence, ulp);
  if (listed.coincidence.equal_normals) json["normals"] = *listed.coincidence.equal_normals ? "equal" : "opposite";
  json["signs"] = Json::array();
  for (const Sign& sign : listed.signs) json["signs"].push_back(sign_json(sign));
  return json;
}

Json answer_json(const DiscreteAnswer& answer) {
  Json json{{"touching", answer.touching},
            {"nested", answer.nested},
            {"ambiguous", answer.ambiguous},
            {"crossings", answer.crossings.size()}};
  for (const Side side : {Side::E, Side::F}) {
    const auto k = static_cast<std::size_t>(side);
    json[std::string(name(side))] = {{"intersected", answer.intersected[k].size()}, {"inner", answer.inner[k].size()}};
  }
  return json;
}

Json counts_json(const Explanation& explanation) {
  Json json = Json::object();
  for (std::size_t k = 0; k < kCoincidenceKinds; ++k)
    json[std::string(words(static_cast<CoincidenceKind>(k)).key)] = {{"exact", explanation.counts[k].exact},
                                                                     {"near", explanation.counts[k].near}};
  return json;
}

Json part_json(const AnswerPart& part) {
  Json json{{"crossings", Json::array()}, {"inner_E", part.inner[0]}, {"inner_F", part.inner[1]}};
  for (const auto& [side, from, to, face] : part.crossings)
    json["crossings"].push_back(
        {{"edge_of", side == 0 ? "E" : "F"}, {"edge", Json::array({from, to})}, {"face", face}});
  return json;
}

Json next_json(const DiscreteAnswer& answer, const std::optional<NextAnswer>& next, double ulp) {
  if (!next) return {};
  return {{"distance", next->distance},
          {"ulps", next->distance / ulp},
          {"direction", json_vector(next->direction)},
          {"r", json_vector(next->pose.r)},
          {"answer", answer_json(next->answer)},
          {"gone", part_json(only_in(answer, next->answer))},
          {"new", part_json(only_in(next->answer, answer))}};
}

Json surface_json(const TriangleMesh& mesh) {
  return {{"name", mesh.name}, {"vertices", mesh.vertices.size()}, {"faces", mesh.faces.size()}};
}

Json pose_json(const Pose& pose) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(json_vector(pose.A.row(i).transpose()));
  return {{"A", std::move(rows)}, {"r", json_vector(pose.r)}};
}

}  // namespace

Json explanation_json(const Explanation& explanation, const Explainer& surfaces, const ExplainOptions& options,
                      const std::string& origin) {
  const double ulp = explanation.ulp;
  Json json{{"format", "pcm explanation 1"},
            {"origin", origin},
            {"E", surface_json(surfaces.mesh(Side::E))},
            {"F", surface_json(surfaces.mesh(Side::F))},
            {"mode", name(surfaces.mode())},
            {"scheme", name(surfaces.scheme())},
            {"pose", pose_json(explanation.pose)},
            {"scale", explanation.scale},
            {"ulp", ulp},
            {"near_ulps", options.near_ulps},
            {"answer", answer_json(explanation.answer)},
            {"elements", explanation.elements},
            {"oracle_agrees", explanation.oracle_agrees}};
  json["work"] = {{"predicates", explanation.work.predicates},
                  {"exact_predicates", explanation.work.exact_predicates},
                  {"tie_breaks", explanation.work.tie_breaks}};
  json["coincident"] = explanation.total().exact > 0;
  json["counts"] = counts_json(explanation);
  json["coincidences"] = Json::array();
  for (const ListedCoincidence& listed : explanation.listed) json["coincidences"].push_back(listed_json(listed, ulp));
  json["left_out"] = explanation.left_out;
  json["nearest"] = explanation.nearest ? pair_json(*explanation.nearest, ulp) : Json();
  json["searched"] = explanation.searched;
  json["next_answer"] = next_json(explanation.answer, explanation.next, ulp);
  json["free_distance"] = explanation.free_distance;
  json["free_ulps"] = explanation.free_distance / ulp;
  return json;
}

}  // namespace pcm::compare
