// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/coincident_json.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace pcm::compare {
namespace {

/// Adds both bounds of the area of a side that has one. By value: an object that gets a member moves the others.
void add_bounds(Json& side, Json open, Json closed) {
  const bool has_area = !side["area"].is_null();
  side["area_open"] = has_area ? std::move(open) : Json();
  side["area_closed"] = has_area ? std::move(closed) : Json();
}

Wanted only_areas() {
  Wanted wanted;
  wanted.polygons = wanted.force = wanted.elements = false;
  return wanted;
}

}  // namespace

CoincidentJson::CoincidentJson(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Mode mode, Scheme scheme,
                               reference::Problem problem)
    : explainer_(mesh_E, mesh_F, mode, scheme), oracle_(mesh_E, mesh_F), problem_(problem) {}

void CoincidentJson::add_to(Json& json, const Pose& pose) const {
  const bool coincident = explainer_.coincident(problem_, pose);
  json["coincident"] = coincident;
  if (!coincident) {
    for (const char* side : {"E", "F"}) add_bounds(json[side], json[side]["area"], json[side]["area"]);
    return;
  }
  const reference::Answer truth = oracle_.answer(problem_, pose, {}, only_areas());
  add_bounds(json["E"], truth.E.area_interval.open, truth.E.area_interval.closed);
  add_bounds(json["F"], truth.F.area_interval.open, truth.F.area_interval.closed);
}

}  // namespace pcm::compare
