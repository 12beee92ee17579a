// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/provenance.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "compare/io/json/question_json.h"
#include "compare/io/names.h"
#include "compare/io/provenance/program_provenance.h"
#include "compare/io/provenance/sha256.h"
#include "meshes/files/text_file.h"

namespace pcm::compare {
namespace {

Json surface_json(const SurfaceOrigin& origin) {
  return {{"file", origin.file},
          {"sha256", origin.sha256 ? Json(*origin.sha256) : Json()},
          {"vertices", origin.vertices},
          {"faces", origin.faces}};
}

}  // namespace

SurfaceOrigin surface_origin(const std::string& file, const TriangleMesh& mesh) {
  SurfaceOrigin origin{file, {}, mesh.vertices.size(), mesh.faces.size()};
  if (std::filesystem::is_regular_file(file)) origin.sha256 = sha256(read_text_file(file));
  return origin;
}

Json provenance_json(const Provenance& provenance) {
  Json json = provenance_json(this_program());
  json["engine"] = provenance.engine;
  json["problem"] = provenance.problem;
  json["scheme"] = name(provenance.scheme);
  json["mode"] = name(provenance.mode);
  json["law"] = law_json(provenance.law, Notation::decimal);
  json["scale"] = provenance.scale;
  json["E"] = surface_json(provenance.E);
  json["F"] = surface_json(provenance.F);
  return json;
}

}  // namespace pcm::compare
