// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/recording_of_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "simulate/record/run_folder.h"

namespace pcm::simulate {
namespace {

std::string pairing_name(const Scene& scene, std::size_t p) {
  const auto name = [&scene](Index s) { return scene.surfaces[static_cast<std::size_t>(s)].name; };
  return name(scene.pairings[p].E) + " on " + name(scene.pairings[p].F);
}

/// As seen from a frame that moves along with the followed surface, without turning.
Frame frame_at(double t, const Eigen::VectorXd& y, Model& model, const std::optional<Index>& follow) {
  const Observation now = model.observe(t, y);
  const Eigen::Vector3d origin_G =
      follow ? now.surfaces_G[static_cast<std::size_t>(*follow)].r : Eigen::Vector3d(0, 0, 0);
  Frame frame;
  frame.t = t;
  frame.poses_W = now.surfaces_G;
  for (Pose& pose : frame.poses_W) pose.r -= origin_G;
  for (const ObservedElement& e : now.elements) frame.elements.push_back({e.pairing, e.master, e.face, e.pressure});
  for (std::size_t p = 0; p < now.pairings.size(); ++p) {
    const PairingObservation& pairing = now.pairings[p];
    if (pairing.elements > 0)
      frame.contacts.push_back({static_cast<Index>(p), pairing.centre_of_force_G - origin_G, pairing.force_G});
  }
  return frame;
}

Series series_of(const NumberTable& table, const std::string& column, std::string name, std::string unit,
                 std::string plot) {
  return {std::move(name), std::move(unit), std::move(plot), table.column("t"), table.column(column), false};
}

/// Forces of the pairings that ever have one, so that a legend does not list those that never touch.
void add_forces(const Scene& scene, const NumberTable& table, std::vector<Series>& series) {
  for (std::size_t p = 0; p < scene.pairings.size(); ++p) {
    Series force = series_of(table, fmt::format("normal_force_{}", p), pairing_name(scene, p), "N", "Normal force");
    bool any = false;
    for (const double value : force.value) any = any || value != 0;
    if (any) series.push_back(std::move(force));
  }
}

}  // namespace

Recording recording_of_run(const std::filesystem::path& folder, const Scene& scene, Model& model) {
  Recording recording;
  const std::filesystem::path& named = folder.has_filename() ? folder : folder.parent_path();
  recording.title = scene.title.empty() ? named.filename().string() : scene.title;
  for (const SceneSurface& surface : scene.surfaces)
    recording.surfaces.push_back({surface.name, surface.surface.mesh(), surface.colour});
  for (std::size_t p = 0; p < scene.pairings.size(); ++p)
    recording.pairings.push_back({pairing_name(scene, p), scene.pairings[p].E, scene.pairings[p].F});
  for (const std::vector<double>& row : read_number_table(folder / "states.csv").rows) {
    const Eigen::VectorXd y = Eigen::VectorXd::Map(row.data() + 1, static_cast<Eigen::Index>(row.size()) - 1);
    recording.frames.push_back(frame_at(row[0], y, model, scene.output.follow));
  }
  const NumberTable table = read_number_table(folder / "series.csv");
  for (const auto& [column, name] :
       {std::pair("kinetic", "kinetic"), std::pair("gravity", "gravity's"), std::pair("elastic", "elastic"),
        std::pair("bumpers", "bumpers'"), std::pair("lost_to_damping", "to damping"),
        std::pair("lost_to_friction", "to friction"), std::pair("lost_to_joints", "to joints")})
    recording.series.push_back(series_of(table, column, name, "J", "Energy"));
  if (std::ranges::any_of(scene.bodies, [](const Body& body) { return body.joint.prescribed_speed.has_value(); }))
    recording.series.push_back(series_of(table, "brought_by_motions", "by motions", "J", "Energy"));
  add_forces(scene, table, recording.series);
  const NumberTable steps = read_number_table(folder / "steps.csv");
  recording.series.push_back(series_of(steps, "size", "step", "s", "Step size"));
  recording.series.back().logarithmic = true;
  recording.series.push_back(series_of(steps, "elements", "contact elements", "", "Elements"));
  return recording;
}

}  // namespace pcm::simulate
