// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/case_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <vector>

#include "compare/io/json/json_file.h"
#include "compare/io/json/question_json.h"
#include "compare/io/json/strict_json.h"
#include "compare/io/names.h"
#include "compare/io/provenance/sha256.h"
#include "compare/verify/verdict/question_range.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

constexpr std::string_view kNoCase = "this is no case file of pcm";

Json to_json(const MovingPose& state) {
  Json json;
  json["A"] = matrix_json(state.pose.A);
  json["r"] = vector_json(state.pose.r);
  json["v"] = vector_json(state.velocity.v);
  json["w"] = vector_json(state.velocity.w);
  return json;
}

MovingPose moving_pose(const Json& json) {
  MovingPose state;
  state.pose = {read_at(json, "A", matrix_from), read_at(json, "r", vector_from)};
  state.velocity = {read_at(json, "v", vector_from), read_at(json, "w", vector_from)};
  refuse_other_keys(json, {"A", "r", "v", "w"});
  require_in_range(state.pose, state.velocity);
  return state;
}

std::string hash_of_mesh(const std::filesystem::path& file) {
  if (const std::optional<std::string> hash = sha256_of_file(file)) return *hash;
  throw BadInput("cannot read the mesh " + file.string() +
                 "; put it there, or give its path from the case file's folder");
}

Json to_json(const TriangleMesh& mesh, const std::filesystem::path& file) {
  Json json;
  json["name"] = mesh.name;
  if (!file.empty()) {
    json["path"] = std::filesystem::absolute(file).string();
    json["sha256"] = hash_of_mesh(file);
    return json;
  }
  json["vertices"] = Json::array();
  for (const Eigen::Vector3d& x : mesh.vertices) json["vertices"].push_back({x.x(), x.y(), x.z()});
  json["faces"] = mesh.faces;
  return json;
}

TriangleMesh mesh_of_file(const Json& json, const std::filesystem::path& file) {
  refuse_other_keys(json, {"name", "path", "sha256"});
  if (hash_of_mesh(file) != text_at(json, "sha256"))
    throw BadInput("the mesh " + file.string() + " has changed since (its SHA-256 is another)");
  return read_mesh(file);
}

Eigen::Vector3d vertex_from(const Json& json) {
  if (!json.is_array() || json.size() != 3 || !json[0].is_number() || !json[1].is_number() || !json[2].is_number())
    throw BadInput(in_quotes(json.dump()) + " is no list of three coordinates");
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

Triangle face_from(const Json& json, std::size_t vertices) {
  if (!json.is_array() || json.size() != 3) throw BadInput(in_quotes(json.dump()) + " is no list of three vertices");
  Triangle face{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto v = json[k].is_number_integer() ? json[k].get<std::int64_t>() : -1;
    if (v < 0 || v >= static_cast<std::int64_t>(vertices))
      throw BadInput(fmt::format("{} is no vertex; there are {}, from 0", in_quotes(json[k].dump()), vertices));
    face[k] = static_cast<Index>(v);
  }
  return face;
}

/// What `read` makes of each element of the list under a key; what it throws names key and number.
template <class Read>
void read_each(const Json& object, const char* key, const Read& read) {
  std::size_t number = 0;
  for (const Json& element : list_at(object, key)) within(fmt::format("{}[{}]", key, number++), [&] { read(element); });
}

TriangleMesh mesh_inline(const Json& json) {
  refuse_other_keys(json, {"name", "vertices", "faces"});
  TriangleMesh mesh;
  mesh.name = text_at(json, "name");
  read_each(json, "vertices", [&](const Json& x) { mesh.vertices.push_back(vertex_from(x)); });
  read_each(json, "faces", [&](const Json& face) { mesh.faces.push_back(face_from(face, mesh.vertices.size())); });
  return mesh;
}

TriangleMesh mesh_from(const Json& json, const std::filesystem::path& folder, std::filesystem::path& file) {
  const bool by_path = json.is_object() && json.contains("path");
  if (by_path) file = folder / text_at(json, "path");
  TriangleMesh mesh = by_path ? mesh_of_file(json, file) : mesh_inline(json);
  require_fit(mesh);
  return mesh;
}

std::array<std::string, 2> pair_of_words(const Json& json) {
  if (!json.is_array() || json.size() != 2 || !json[0].is_string() || !json[1].is_string())
    throw BadInput(in_quotes(json.dump()) + " is no pair of words");
  return {json[0].get<std::string>(), json[1].get<std::string>()};
}

Case case_from(const Json& json, const std::filesystem::path& folder) {
  refuse_other_keys(json, {"format", "origin", "pose", "before", "law", "scheme", "mode", "disagreements", "engine",
                           "oracle", "E", "F"});
  Case posed;
  posed.origin = text_at(json, "origin");
  const MovingPose state = read_at(json, "pose", moving_pose);
  posed.pose = state.pose;
  posed.velocity = state.velocity;
  if (json.contains("before"))
    read_each(json, "before", [&](const Json& earlier) { posed.before.push_back(moving_pose(earlier)); });
  posed.law = read_at(json, "law", [](const Json& law) { return law_from(law); });
  within("law", [&] { require_in_range(posed.law); });
  posed.scheme = read_at(json, "scheme", scheme_from);
  posed.mode = read_at(json, "mode", mode_from);
  if (json.contains("disagreements"))
    read_each(json, "disagreements", [&](const Json& words) { posed.disagreements.push_back(pair_of_words(words)); });
  posed.E = read_at(json, "E", [&](const Json& mesh) { return mesh_from(mesh, folder, posed.file_E); });
  posed.F = read_at(json, "F", [&](const Json& mesh) { return mesh_from(mesh, folder, posed.file_F); });
  return posed;
}

template <typename Crossing>
Json crossing_json(const Crossing& x) {
  return {x.edge_side == Side::E ? "E" : "F", x.edge[0], x.edge[1], x.face, vector_json(x.position_Me)};
}

/// What both result types name alike.
template <typename Answer>
Json common_facts(const Answer& answer) {
  Json json;
  json["touching"] = answer.touching;
  json["nested"] = answer.nested;
  json["ambiguous"] = answer.ambiguous;
  json["patches"] = answer.patches;
  const auto active = [](const auto& area) {
    Json side;
    side["intersected"] = area.intersected;
    side["inner"] = area.inner;
    side["area"] = hexadecimal(area.area);
    side["vector_area"] = vector_json(area.vector_area_Me);
    return side;
  };
  json["E"] = active(answer.E);
  json["F"] = active(answer.F);
  json["elements"] = Json::array();
  for (const auto& e : answer.elements)
    json["elements"].push_back({e.master == Side::E ? "E" : "F", e.master_face, e.slave_face, hexadecimal(e.area),
                                hexadecimal(e.penetration), vector_json(e.position_Me), vector_json(e.force_Me)});
  json["too_deep"] = answer.too_deep;
  json["max_penetration"] = hexadecimal(answer.max_penetration);
  json["penetration_exceeded"] = answer.penetration_exceeded;
  json["force"] = vector_json(answer.force_Me);
  json["torque"] = vector_json(answer.torque_Me);
  return json;
}

}  // namespace

Json decided(const fast::Contact& subj) {
  Json json = common_facts(subj);
  json["volume"] = subj.has_volume ? Json(hexadecimal(subj.volume)) : Json();
  json["polygons"] = Json::array();
  for (const fast::Polygon& polygon : subj.polygons) {
    Json points = Json::array();
    const Index end = polygon.first + polygon.count;
    for (Index k = polygon.first; k < end; ++k)
      points.push_back(crossing_json(subj.crossings[static_cast<std::size_t>(k)]));
    json["polygons"].push_back({{"closed", polygon.closed}, {"patch", polygon.patch}, {"points", points}});
  }
  return json;
}

Json decided(const reference::Answer& truth) {
  Json json = common_facts(truth);
  json["volume"] = truth.volume ? Json(hexadecimal(*truth.volume)) : Json();
  json["polygons"] = Json::array();
  for (const reference::Polygon& polygon : truth.polygons) {
    Json points = Json::array();
    for (const reference::Crossing& x : polygon.points) points.push_back(crossing_json(x));
    json["polygons"].push_back({{"closed", polygon.closed}, {"patch", polygon.patch}, {"points", points}});
  }
  return json;
}

std::vector<std::array<std::string, 2>> in_words(const std::vector<Disagreement>& disagreements) {
  std::vector<std::array<std::string, 2>> words;
  for (const Disagreement& d : disagreements) words.push_back({std::string(name(d.kind)), d.text});
  return words;
}

std::string format_case(const Case& posed, const Json& engine, const Json& oracle) {
  Json json;
  json["format"] = "pcm case 1";
  json["origin"] = posed.origin;
  json["pose"] = to_json(MovingPose{posed.pose, posed.velocity});
  for (const MovingPose& state : posed.before) json["before"].push_back(to_json(state));
  json["law"] = law_json(posed.law);
  json["scheme"] = std::string(name(posed.scheme));
  json["mode"] = std::string(name(posed.mode));
  json["disagreements"] = posed.disagreements;
  json["engine"] = engine;
  json["oracle"] = oracle;
  json["E"] = to_json(posed.E, posed.file_E);
  json["F"] = to_json(posed.F, posed.file_F);
  return json_file_text(json);
}

std::string case_file_name(std::string pose) {
  std::replace_if(
      pose.begin(), pose.end(), [](char c) { return c == '/' || c == ' '; }, '_');
  return "case_" + pose + ".json";
}

namespace {

/// Whether the file is a case under the name that a run gives it, that of its pose: its origin, or one of what commas
/// part there. Others are somebody's own.
bool is_of_a_run(const std::filesystem::path& file) {
  const Json json = json_or_discarded(file);
  if (!json.is_object() || !json.contains("origin") || !json["origin"].is_string()) return false;
  const auto origin = json["origin"].get<std::string>();
  for (std::size_t begin = 0; begin < origin.size();) {
    const std::size_t end = std::min(origin.find(", ", begin), origin.size());
    if (case_file_name(origin.substr(begin, end - begin)) == file.filename().string()) return true;
    begin = end + 2;
  }
  return false;
}

}  // namespace

std::vector<std::filesystem::path> case_files_in(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::directory_iterator entries(folder, error);
  if (error) throw BadInput(folder.string() + ": can't be read: " + error.message());
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::directory_entry& entry : entries)
    if (const std::string name = entry.path().filename().string(); name.starts_with("case_") && name.ends_with(".json"))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

bool remove_case_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files = case_files_in(folder);
  std::erase_if(files, [](const std::filesystem::path& file) { return !is_of_a_run(file); });
  for (const std::filesystem::path& file : files) {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (error) throw BadInput(file.string() + ": of another run, and it can't be removed");
  }
  return !files.empty();
}

Case case_from_text(const std::string& text, const std::filesystem::path& folder) {
  const Json json = strict_json(text, kNoCase);
  if (!json.is_object() || !json.contains("format") || json["format"] != "pcm case 1")
    throw BadInput(std::string(kNoCase) + " (\"format\": \"pcm case 1\" is missing)");
  return case_from(json, folder);
}

Case read_case(const std::filesystem::path& path) {
  const std::string text = read_text_file(path);
  return within(path.string(), [&] { return case_from_text(text, path.parent_path()); });
}

}  // namespace pcm::compare
