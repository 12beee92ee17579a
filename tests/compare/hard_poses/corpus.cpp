// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/compare/hard_poses/corpus.h"

#include <algorithm>

#include "compare/io/json/json_file.h"
#include "compare/io/json/question_json.h"
#include "compare/io/names.h"

namespace pcm::compare::hard_poses_test {

const std::vector<std::string>& searched_pairs() {
  static const std::vector<std::string> names{"cube-cube",        "slab-gridded cube",  "wedges",
                                              "small icospheres", "lattice tetrahedra", "spike-thin plate",
                                              "thin plate-spike", "cube-tray",          "beam-folded sheet"};
  return names;
}

CorpusPairs::CorpusPairs() {
  std::vector<std::string> missing;
  for (const SurfacePair& pair : built_in_pairs("", missing)) {
    if (std::ranges::find(searched_pairs(), pair.name) == searched_pairs().end()) continue;
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
      held_[{pair.name, scheme}] = std::make_unique<HeldPairing>(pair.E, pair.F, ContactLaw{}, Mode::E, scheme);
  }
}

const HeldPairing& CorpusPairs::held(const std::string& pair, Scheme scheme) const {
  return *held_.at({pair, scheme});
}

std::string corpus_text(const std::vector<CorpusPose>& poses) {
  std::string text = "[\n";
  for (const CorpusPose& pose : poses) {
    Json json;
    json["pair"] = pose.pair;
    json["scheme"] = std::string(name(pose.scheme));
    json["hard_for"] = pose.hard_for;
    json["A"] = matrix_json(pose.pose.A);
    json["r"] = vector_json(pose.pose.r);
    json["force"] = vector_json(pose.true_force_Me);
    json["torque"] = vector_json(pose.true_torque_Me);
    json["margin"] = hexadecimal(pose.margin);
    json["error_over_bound"] = hexadecimal(pose.error_over_bound);
    text += json_line(json) + (&pose == &poses.back() ? "\n" : ",\n");
  }
  return text + "]\n";
}

std::vector<CorpusPose> corpus_from(const std::string& text) {
  std::vector<CorpusPose> poses;
  for (const Json& json : Json::parse(text)) {
    CorpusPose& pose = poses.emplace_back();
    pose.pair = json.at("pair");
    pose.scheme = scheme_from(json.at("scheme"));
    pose.hard_for = json.at("hard_for");
    pose.pose = {matrix_from(json.at("A")), vector_from(json.at("r"))};
    pose.true_force_Me = vector_from(json.at("force"));
    pose.true_torque_Me = vector_from(json.at("torque"));
    pose.margin = number_from(json.at("margin"));
    pose.error_over_bound = number_from(json.at("error_over_bound"));
  }
  return poses;
}

}  // namespace pcm::compare::hard_poses_test
