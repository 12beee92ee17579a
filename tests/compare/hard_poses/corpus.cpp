// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/compare/hard_poses/corpus.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "compare/hard_poses/search.h"
#include "compare/io/json/json_file.h"
#include "compare/io/json/question_json.h"
#include "compare/io/names.h"

namespace pcm::compare::hard_poses_test {
namespace {

Json moved_json(const std::vector<MovedVertex>& moved) {
  Json json = Json::array();
  for (const MovedVertex& v : moved)
    json.push_back(Json::array({std::string(name(v.side)), v.vertex, vector_json(v.x)}));
  return json;
}

std::vector<MovedVertex> moved_from(const Json& json) {
  std::vector<MovedVertex> moved;
  for (const Json& v : json)
    moved.push_back({v.at(0) == "E" ? Side::E : Side::F, v.at(1).get<Index>(), vector_from(v.at(2))});
  return moved;
}

Goal goal_named(const std::string& word) {
  const auto* const goal = std::ranges::find_if(kGoals, [&](Goal one) { return name(one) == word; });
  if (goal == kGoals.end()) throw std::runtime_error(word + " is no goal");
  return *goal;
}

}  // namespace

CorpusPairs::CorpusPairs()
    : names_{"cube-cube",        "slab-gridded cube", "wedges",    "small icospheres", "lattice tetrahedra",
             "spike-thin plate", "thin plate-spike",  "cube-tray", "beam-folded sheet"} {
  for (SurfacePair& pair : searched_pairs()) pairs_.emplace(pair.name, std::move(pair));
}

HardState CorpusPairs::hard(const CorpusState& state) const {
  const SurfacePair& pair = surfaces(state.pair);
  TriangleMesh E = pair.E, F = pair.F;
  for (const MovedVertex& v : state.moved)
    (v.side == Side::E ? E : F).vertices.at(static_cast<std::size_t>(v.vertex)) = v.x;
  HardState hard{held_in_all_modes(E, F, state.state.law, state.state.scheme), 0, state.state};
  hard.ask_in(state.mode);
  return hard;
}

std::vector<MovedVertex> moved_vertices(const SurfacePair& pair, const HardState& hard) {
  std::vector<MovedVertex> moved;
  const auto add = [&moved](Side side, const TriangleMesh& own, const TriangleMesh& now) {
    for (std::size_t v = 0; v < own.vertices.size(); ++v)
      if (own.vertices[v] != now.vertices[v]) moved.push_back({side, static_cast<Index>(v), now.vertices[v]});
  };
  add(Side::E, pair.E, hard.held->features().E.mesh);
  add(Side::F, pair.F, hard.held->features().F.mesh);
  return moved;
}

std::string corpus_text(const std::vector<CorpusState>& states) {
  std::string text = "[\n";
  for (const CorpusState& hard : states) {
    Json json;
    json["goal"] = std::string(name(hard.goal));
    json["hardness"] = hexadecimal(hard.hardness);
    json["pair"] = hard.pair;
    json["moved"] = moved_json(hard.moved);
    json["mode"] = std::string(name(hard.mode));
    json["scheme"] = std::string(name(hard.state.scheme));
    json["A"] = matrix_json(hard.state.pose.A);
    json["r"] = vector_json(hard.state.pose.r);
    json["v"] = vector_json(hard.state.velocity.v);
    json["w"] = vector_json(hard.state.velocity.w);
    json["law"] = law_json(hard.state.law);
    json["force"] = vector_json(hard.true_force_Me);
    json["torque"] = vector_json(hard.true_torque_Me);
    text += json_line(json) + (&hard == &states.back() ? "\n" : ",\n");
  }
  return text + "]\n";
}

std::vector<CorpusState> corpus_from(const std::string& text) {
  std::vector<CorpusState> states;
  for (const Json& json : Json::parse(text)) {
    CorpusState& hard = states.emplace_back();
    hard.goal = goal_named(json.at("goal").get<std::string>());
    hard.hardness = number_from(json.at("hardness"));
    hard.pair = json.at("pair");
    hard.moved = moved_from(json.at("moved"));
    hard.mode = mode_from(json.at("mode"));
    hard.state.scheme = scheme_from(json.at("scheme"));
    hard.state.pose = {matrix_from(json.at("A")), vector_from(json.at("r"))};
    hard.state.velocity = {vector_from(json.at("v")), vector_from(json.at("w"))};
    hard.state.law = law_from(json.at("law"));
    hard.true_force_Me = vector_from(json.at("force"));
    hard.true_torque_Me = vector_from(json.at("torque"));
  }
  return states;
}

}  // namespace pcm::compare::hard_poses_test
