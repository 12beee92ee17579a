// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/lines/answer_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>
#include <utility>

#include "compare/io/json/question_json.h"
#include "compare/io/names.h"
#include "compare/judge/lines/json_lines.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// How many faces each surface has.
struct FaceCounts {
  std::size_t E = 0;
  std::size_t F = 0;

  std::size_t of(Side side) const { return side == Side::E ? E : F; }
};

/// Reads what stands under a key; nothing where the key is missing or null. What `read` throws gets the key's name.
template <class Read>
auto read_if_given(const Json& object, const char* key, const Read& read) -> std::optional<decltype(read(object))> {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return std::nullopt;
  return within(fmt::format("\"{}\"", key), [&] { return read(*found); });
}

const Json& array_from(const Json& json) {
  if (!json.is_array()) throw BadInput(in_quotes(json.dump()) + " is no list");
  return json;
}

bool truth_value(const Json& json) {
  if (!json.is_boolean()) throw BadInput(json.dump() + " is neither true nor false");
  return json.get<bool>();
}

/// A whole number from 0 on, as JSON Schema has them: 1.0 is one.
std::optional<std::int64_t> whole_number(const Json& json) {
  const double x = json.is_number() ? json.get<double>() : -1;
  if (!(x >= 0 && x < 0x1p53 && x == std::floor(x))) return std::nullopt;
  return static_cast<std::int64_t>(x);
}

std::int64_t count(const Json& json) {
  const std::optional<std::int64_t> number = whole_number(json);
  if (!number) throw BadInput(in_quotes(json.dump()) + " is no number of things");
  return *number;
}

Eigen::Vector3d vector(const Json& json) {
  if (array_from(json).size() != 3) throw BadInput(in_quotes(json.dump()) + " is no list of three numbers");
  Eigen::Vector3d x;
  for (std::size_t i = 0; i < 3; ++i) x[static_cast<Eigen::Index>(i)] = number_in_either_notation(json[i]);
  if (!x.allFinite()) throw BadInput("an infinite component");
  return x;
}

double finite(const Json& json) {
  const double x = number_in_either_notation(json);
  if (x > std::numeric_limits<double>::max()) throw BadInput("infinity is no answer");
  return x;
}

Index face(const Json& json, Side side, const FaceCounts& faces) {
  const auto last = static_cast<std::int64_t>(faces.of(side)) - 1;
  const std::optional<std::int64_t> number = whole_number(json);
  if (!number || *number > last)
    throw BadInput(
        fmt::format("{} is no face of {}, whose faces are 0 to {}", in_quotes(json.dump()), name(side), last));
  return static_cast<Index>(*number);
}

template <class T>
void sort_and_refuse_twins(std::vector<T>& list, const char* what) {
  std::sort(list.begin(), list.end());
  if (std::adjacent_find(list.begin(), list.end()) != list.end())
    throw BadInput(fmt::format("a {} is listed twice", what));
}

std::vector<Index> faces_from(const Json& json, Side side, const FaceCounts& faces) {
  std::vector<Index> list;
  for (const Json& item : array_from(json)) list.push_back(face(item, side, faces));
  sort_and_refuse_twins(list, "face");
  return list;
}

std::vector<FacePair> pairs_from(const Json& json, const FaceCounts& faces) {
  std::vector<FacePair> list;
  for (const Json& item : array_from(json)) {
    if (array_from(item).size() != 2)
      throw BadInput(in_quotes(item.dump()) + " is no pair of a face of E and one of F");
    list.push_back({face(item[0], Side::E, faces), face(item[1], Side::F, faces)});
  }
  sort_and_refuse_twins(list, "pair");
  return list;
}

Side master_of(const Json& json, Mode mode) {
  const auto found = json.find("master");
  if (found == json.end()) {
    if (mode == Mode::both) throw BadInput("in mode both an element says whose face is master: \"master\" is missing");
    return mode == Mode::E ? Side::E : Side::F;
  }
  if (*found == "E") return Side::E;
  if (*found == "F") return Side::F;
  throw BadInput("\"master\": " + in_quotes(found->dump()) + " is neither \"E\" nor \"F\"");
}

auto key(const GivenElement& e) {
  return std::tie(e.master, e.master_face, e.slave_face);
}

GivenElement element_from(const Json& json, Mode mode, const FaceCounts& faces) {
  if (!json.is_object()) throw BadInput(in_quotes(json.dump()) + " is no contact element");
  refuse_other_keys(json, {"master", "master_face", "slave_face", "area", "penetration"});
  GivenElement element;
  element.master = master_of(json, mode);
  const auto face_at = [&](const char* word, Side side) {
    const auto index = read_if_given(json, word, [&](const Json& value) { return face(value, side, faces); });
    if (!index) throw BadInput(fmt::format("\"{}\" of an element is missing", word));
    return *index;
  };
  element.master_face = face_at("master_face", element.master);
  element.slave_face = face_at("slave_face", opposite(element.master));
  element.area = read_if_given(json, "area", finite);
  element.penetration = read_if_given(json, "penetration", finite);
  return element;
}

std::vector<GivenElement> elements_from(const Json& json, Mode mode, const FaceCounts& faces) {
  std::vector<GivenElement> list;
  for (const Json& item : array_from(json)) list.push_back(element_from(item, mode, faces));
  std::sort(list.begin(), list.end(), [](const GivenElement& a, const GivenElement& b) { return key(a) < key(b); });
  const auto same = [](const GivenElement& a, const GivenElement& b) { return key(a) == key(b); };
  if (std::adjacent_find(list.begin(), list.end(), same) != list.end()) throw BadInput("an element is listed twice");
  return list;
}

GivenArea area_from(const Json& json, Side side, const FaceCounts& faces) {
  if (!json.is_object()) throw BadInput(in_quotes(json.dump()) + " is no object");
  refuse_other_keys(json, {"intersected", "inner", "active", "area"});
  const auto read_faces = [&](const Json& value) { return faces_from(value, side, faces); };
  GivenArea given;
  given.intersected = read_if_given(json, "intersected", read_faces);
  given.inner = read_if_given(json, "inner", read_faces);
  given.active = read_if_given(json, "active", read_faces);
  given.area = read_if_given(json, "area", finite);
  return given;
}

Json area_json(const GivenArea& given, Notation notation) {
  Json json = Json::object();
  if (given.intersected) json["intersected"] = *given.intersected;
  if (given.inner) json["inner"] = *given.inner;
  if (given.active) json["active"] = *given.active;
  if (given.area) json["area"] = number_json(*given.area, notation);
  return json;
}

Json elements_json(const std::vector<GivenElement>& elements, Notation notation) {
  Json list = Json::array();
  for (const GivenElement& e : elements) {
    Json json{{"master", name(e.master)}, {"master_face", e.master_face}, {"slave_face", e.slave_face}};
    if (e.area) json["area"] = number_json(*e.area, notation);
    if (e.penetration) json["penetration"] = number_json(*e.penetration, notation);
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

GivenAnswer answer_from(const Json& json, const PosedQuestions& posed, const PosedQuestion& question) {
  refuse_other_keys(json, {"id", "touching", "crossing_pairs", "E", "F", "polygons", "closed_polygons", "volume",
                           "elements", "force", "torque", "comment"});
  const FaceCounts faces{posed.surfaces[question.E].mesh.faces.size(), posed.surfaces[question.F].mesh.faces.size()};
  GivenAnswer answer;
  answer.touching = read_if_given(json, "touching", truth_value);
  answer.crossing_pairs =
      read_if_given(json, "crossing_pairs", [&](const Json& value) { return pairs_from(value, faces); });
  const auto side = [&](Side which) {
    return read_if_given(json, which == Side::E ? "E" : "F",
                         [&](const Json& value) { return area_from(value, which, faces); })
        .value_or(GivenArea{});
  };
  answer.E = side(Side::E);
  answer.F = side(Side::F);
  answer.polygons = read_if_given(json, "polygons", count);
  answer.closed_polygons = read_if_given(json, "closed_polygons", count);
  answer.volume = read_if_given(json, "volume", finite);
  const auto elements = json.find("elements");
  if (elements != json.end() && elements->is_number())
    answer.element_count = read_if_given(json, "elements", count);
  else
    answer.elements =
        read_if_given(json, "elements", [&](const Json& value) { return elements_from(value, question.mode, faces); });
  answer.force_Me = read_if_given(json, "force", vector);
  answer.torque_Me = read_if_given(json, "torque", vector);
  return answer;
}

Json answer_json(const std::string& id, const GivenAnswer& answer, Notation notation) {
  Json json;
  json["id"] = id;
  if (answer.touching) json["touching"] = *answer.touching;
  if (answer.crossing_pairs) json["crossing_pairs"] = *answer.crossing_pairs;
  for (const auto& [word, given] : {std::pair("E", &answer.E), std::pair("F", &answer.F)})
    if (Json area = area_json(*given, notation); !area.empty()) json[word] = std::move(area);
  if (answer.polygons) json["polygons"] = *answer.polygons;
  if (answer.closed_polygons) json["closed_polygons"] = *answer.closed_polygons;
  if (answer.volume) json["volume"] = number_json(*answer.volume, notation);
  if (answer.element_count) json["elements"] = *answer.element_count;
  if (answer.elements) json["elements"] = elements_json(*answer.elements, notation);
  if (answer.force_Me) json["force"] = vector_json(*answer.force_Me, notation);
  if (answer.torque_Me) json["torque"] = vector_json(*answer.torque_Me, notation);
  return json;
}

void check_answers_header(const Json& json, const PosedQuestions& posed) {
  refuse_other_keys(json, {"format", "engine", "surfaces", "comment"});
  if (const std::string format = text_at(json, "format"); format != kAnswersFormat)
    throw BadInput(fmt::format("these are answers of another format, {}; this program reads \"{}\"", in_quotes(format),
                               kAnswersFormat));
  const auto surfaces = json.find("surfaces");
  if (surfaces == json.end()) return;
  if (!surfaces->is_object()) throw BadInput("\"surfaces\" is no object of a SHA-256 by each name");
  for (const auto& [word, hash] : surfaces->items()) {
    const auto known = std::find_if(posed.surfaces.begin(), posed.surfaces.end(),
                                    [&, &named = word](const PosedSurface& surface) { return surface.name == named; });
    if (known == posed.surfaces.end()) throw BadInput("no surface is called " + in_quotes(word));
    if (hash != known->sha256)
      throw BadInput(fmt::format("the engine has read another surface '{}': its SHA-256 is {}, that of {} is {}", word,
                                 in_quotes(hash.dump()), known->file, known->sha256));
  }
}

}  // namespace pcm::compare
