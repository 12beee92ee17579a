// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/poses/poses_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "compare/io/json/question_json.h"
#include "compare/io/names.h"
#include "compare/io/provenance/sha256.h"
#include "compare/judge/lines/json_lines.h"
#include "compare/verify/verdict/question_range.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

Eigen::Vector3d vector_from(const Json& json) {
  if (!json.is_array() || json.size() != 3) throw BadInput(in_quotes(json.dump()) + " is no list of three numbers");
  Eigen::Vector3d x;
  for (std::size_t i = 0; i < 3; ++i) x[static_cast<Eigen::Index>(i)] = number_in_either_notation(json[i]);
  return x;
}

Eigen::Matrix3d rows_from(const Json& json) {
  if (!json.is_array() || json.size() != 3) throw BadInput("\"A\" is no list of three rows");
  Eigen::Matrix3d A;
  for (std::size_t i = 0; i < 3; ++i) A.row(static_cast<Eigen::Index>(i)) = vector_from(json[i]).transpose();
  return A;
}

std::size_t count_of_poses(const Json& json) {
  if (!json.is_number_unsigned()) throw BadInput("\"poses\": " + in_quotes(json.dump()) + " is no number of poses");
  return json.get<std::size_t>();
}

/// Of a surface's vertices or faces, where the first line has it.
void require_count(const Json& surface, const char* key, std::size_t count) {
  if (surface.contains(key) && surface[key] != count)
    throw BadInput(fmt::format("\"{}\": {} has {}, not {}", key, text_at(surface, "file"), count, surface[key].dump()));
}

std::vector<PosedSurface> surfaces_from(const Json& header, const std::filesystem::path& folder) {
  std::vector<PosedSurface> surfaces;
  for (const Json& json : header.at("surfaces")) {
    refuse_other_keys(json, {"name", "file", "sha256", "vertices", "faces"});
    PosedSurface surface{text_at(json, "name"), text_at(json, "file"), text_at(json, "sha256"), {}};
    if (std::any_of(surfaces.begin(), surfaces.end(), [&](const PosedSurface& s) { return s.name == surface.name; }))
      throw BadInput("\"surfaces\": two are called " + in_quotes(surface.name));
    const std::filesystem::path file = folder / surface.file;
    if (const std::string hash = sha256(read_text_file(file)); hash != surface.sha256)
      throw BadInput(fmt::format("{} has changed since the poses were written: its SHA-256 is {}, it was {}",
                                 file.string(), hash, surface.sha256));
    surface.mesh = read_mesh(file);
    require_count(json, "vertices", surface.mesh.vertices.size());
    require_count(json, "faces", surface.mesh.faces.size());
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

std::size_t surface_named(const Json& json, const char* key, const std::vector<PosedSurface>& surfaces) {
  const std::string word = text_at(json, key);
  const auto found =
      std::find_if(surfaces.begin(), surfaces.end(), [&](const PosedSurface& surface) { return surface.name == word; });
  if (found == surfaces.end()) throw BadInput("no surface is called " + in_quotes(word));
  return static_cast<std::size_t>(found - surfaces.begin());
}

PosedQuestion question_from(const Json& json, const std::vector<PosedSurface>& surfaces) {
  refuse_other_keys(json, {"id", "pair", "stratum", "E", "F", "A", "r", "v", "w", "law", "mode", "scheme", "comment",
                           "known_volume"});
  PosedQuestion question;
  question.id = text_at(json, "id");
  question.pair = text_at(json, "pair");
  question.stratum = text_at(json, "stratum");
  question.E = surface_named(json, "E", surfaces);
  question.F = surface_named(json, "F", surfaces);
  question.pose = {rows_from(json.at("A")), vector_from(json.at("r"))};
  question.velocity = {vector_from(json.at("v")), vector_from(json.at("w"))};
  require_in_range(question.pose, question.velocity);
  question.law = read_at(json, "law", [](const Json& law) { return law_from(law, number_in_either_notation); });
  within("law", [&] { require_in_range(question.law); });
  question.mode = read_at(json, "mode", mode_from);
  question.scheme = read_at(json, "scheme", scheme_from);
  if (json.contains("comment")) question.comment = text_at(json, "comment");
  if (json.contains("known_volume")) question.known_volume = number_in_either_notation(json.at("known_volume"));
  if (question.known_volume && !(*question.known_volume >= 0))
    throw BadInput("\"known_volume\": " + json["known_volume"].dump() + " is negative");
  return question;
}

}  // namespace

Json poses_header(const std::vector<PosedSurface>& surfaces, std::int64_t poses, const std::string& origin) {
  Json list = Json::array();
  for (const PosedSurface& surface : surfaces)
    list.push_back({{"name", surface.name},
                    {"file", surface.file},
                    {"sha256", surface.sha256},
                    {"vertices", surface.mesh.vertices.size()},
                    {"faces", surface.mesh.faces.size()}});
  return {{"format", kPosesFormat}, {"origin", origin}, {"poses", poses}, {"surfaces", std::move(list)}};
}

Json pose_json(const PosedQuestion& question, const std::vector<PosedSurface>& surfaces, Notation notation) {
  Json json;
  json["id"] = question.id;
  json["pair"] = question.pair;
  json["stratum"] = question.stratum;
  json["E"] = surfaces[question.E].name;
  json["F"] = surfaces[question.F].name;
  json["A"] = Json::array();
  for (Eigen::Index i = 0; i < 3; ++i) json["A"].push_back(vector_json(question.pose.A.row(i), notation));
  json["r"] = vector_json(question.pose.r, notation);
  json["v"] = vector_json(question.velocity.v, notation);
  json["w"] = vector_json(question.velocity.w, notation);
  json["law"] = law_json(question.law, notation);
  json["mode"] = name(question.mode);
  json["scheme"] = name(question.scheme);
  if (!question.comment.empty()) json["comment"] = question.comment;
  if (question.known_volume) json["known_volume"] = number_json(*question.known_volume, notation);
  return json;
}

PosesReader::PosesReader(const std::filesystem::path& file, const std::filesystem::path& folder) : lines_(file) {
  const std::optional<Json> header = lines_.next();
  if (!header) throw BadInput(lines_.name() + ": the file is empty");
  within(lines_.place(), [&] {
    if (const std::string format = text_at(*header, "format"); format != kPosesFormat)
      throw BadInput(fmt::format("these are poses of another format, {}; this program reads \"{}\"", in_quotes(format),
                                 kPosesFormat));
    refuse_other_keys(*header, {"format", "origin", "poses", "surfaces"});
    promised_ = count_of_poses(header->at("poses"));
    surfaces_ = surfaces_from(*header, folder);
  });
}

std::optional<PosedQuestion> PosesReader::next() {
  const std::optional<Json> json = lines_.next();
  if (!json) return std::nullopt;
  ++read_;
  return within(lines_.place(), [&] { return question_from(*json, surfaces_); });
}

void PosesReader::require_all() const {
  if (read_ != promised_)
    throw BadInput(fmt::format("{}: {} poses, where the first line says {}", lines_.name(), read_, promised_));
}

PosedQuestions read_poses_folder(const std::filesystem::path& folder) {
  PosesReader reader(folder / kPosesFile, folder);
  PosedQuestions posed{reader.surfaces(), {}};
  std::set<std::string> known;
  while (std::optional<PosedQuestion> question = reader.next()) {
    if (!known.insert(question->id).second)
      throw BadInput(reader.lines().place() + ": a pose " + in_quotes(question->id) + " stands there already");
    posed.questions.push_back(std::move(*question));
  }
  reader.require_all();
  return posed;
}

}  // namespace pcm::compare
