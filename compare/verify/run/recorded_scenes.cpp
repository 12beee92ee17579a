// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/recorded_scenes.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "compare/io/json/question_json.h"
#include "meshes/generate/make.h"

namespace pcm::compare {

std::string_view recorded_scenes();  // the file, compiled in

std::vector<SurfacePair> recorded_pairs() {
  const Json json = Json::parse(recorded_scenes());
  const auto surface = [&json](const std::string& name) {
    const Json& made = json.at("surfaces").at(name);
    return make(made.at("make").get<std::string>(),
                made.at("parameters").get<std::map<std::string, double, std::less<>>>());
  };
  std::vector<SurfacePair> pairs;
  for (const Json& pairing : json.at("pairings")) {
    const std::string name_E = pairing.at("E"), name_F = pairing.at("F");
    SurfacePair& pair = pairs.emplace_back();
    pair.name = pair_name(name_E, name_F);
    pair.E = surface(name_E);
    pair.F = surface(name_F);
    pair.law = law_from(pairing.at("law"));
    pair.motion = pairing.at("stretches").get<std::vector<RecordedStretch>>();
  }
  return pairs;
}

}  // namespace pcm::compare
