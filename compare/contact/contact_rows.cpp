// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/contact_rows.h"

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "compare/io/names.h"

namespace pcm::compare {
namespace {

void add_state(CsvRow& row, const State& state) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) row.add(fmt::format("A_{}{}", i + 1, j + 1), "", state.pose.A(i, j));
  row.add("r", "m", state.pose.r);
  row.add("v", "m/s", state.velocity.v);
  row.add("w", "rad/s", state.velocity.w);
}

std::optional<std::int64_t> count_if(bool known, std::int64_t count) {
  return known ? std::optional(count) : std::nullopt;
}

void add_area(CsvRow& row, const std::string& side, const AreaRecord& active, const Knowledge& known) {
  row.add_count(side + "_intersected", count_if(known.faces, std::ssize(active.intersected)));
  row.add_count(side + "_inner", count_if(known.faces, std::ssize(active.inner)));
  row.add(side + "_area", "m^2", active.area);
  row.add(side + "_vector_area", "m^2", active.vector_area_Me);
}

void add_statistics(CsvRow& row, const fast::Statistics& statistics) {
  row.add("patch_area", "m^2", statistics.patch_area);
  row.add("mean_penetration", "m", statistics.mean_penetration);
  row.add("max_pressure", "Pa", statistics.max_pressure);
  row.add("mean_pressure", "Pa", statistics.mean_pressure);
  row.add("max_normal_velocity", "m/s", statistics.max_normal_velocity);
  row.add("max_tangential_velocity", "m/s", statistics.max_tangential_velocity);
  row.add("centre_of_pressure", "m", statistics.centre_of_pressure_Me);
}

}  // namespace

CsvRow pose_row(std::int64_t pose, const State& state, const ContactRecord& record, bool with_polygons) {
  const Knowledge& known = record.known;
  const bool polygons_known = with_polygons && known.faces;
  const auto flag_if = [](bool is_known, bool flag) { return is_known ? std::optional(flag) : std::nullopt; };
  CsvRow row;
  row.add_count("pose", pose);
  add_state(row, state);
  row.add_flag("touching", record.touching);
  row.add_flag("nested", flag_if(known.areas, record.nested));
  row.add_flag("ambiguous", flag_if(known.areas, record.ambiguous));
  row.add_count("polygons", count_if(polygons_known, std::ssize(record.polygons)));
  row.add_count("patches", count_if(polygons_known, record.patches));
  add_area(row, "E", record.E, known);
  add_area(row, "F", record.F, known);
  row.add("volume", "m^3", record.volume);
  row.add_count("undefined_areas", count_if(known.areas, record.undefined_areas));
  row.add_count("elements", std::ssize(record.elements));
  row.add("force", "N", record.force_Me);
  row.add("torque", "N m", record.torque_Me);
  row.add("max_penetration", "m", record.max_penetration);
  row.add_flag("penetration_exceeded", record.penetration_exceeded);
  row.add_count("too_deep", count_if(known.areas, record.too_deep));
  add_statistics(row, record.statistics);
  return row;
}

CsvRow element_row(std::int64_t pose, const fast::Element& element, const Eigen::Vector3d& face_centroid_Me) {
  CsvRow row;
  row.add_count("pose", pose);
  row.add_word("master", name(element.master));
  row.add_count("master_face", element.master_face);
  row.add_count("slave_face", element.slave_face);
  row.add("face_centroid", "m", face_centroid_Me);
  row.add("position", "m", element.position_Me);
  row.add("normal", "", element.normal_Me);
  row.add("area", "m^2", element.area);
  row.add("penetration", "m", element.penetration);
  row.add("pressure", "Pa", pressure(element));
  row.add("normal_velocity", "m/s", element.normal_velocity);
  row.add("tangential_velocity", "m/s", element.tangential_velocity);
  row.add("normal_force", "N", element.normal_force);
  row.add("tangential_force", "N", element.tangential_force);
  row.add("force", "N", element.force_Me);
  return row;
}

}  // namespace pcm::compare
