// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/paraview/vtp_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "compare/io/create_folder.h"
#include "compare/io/vtp.h"
#include "meshes/files/text_file.h"

namespace pcm::simulate {
namespace {

/// All surfaces as one set of triangles; the same for every frame but for the places of the points.
struct Triangles {
  compare::VtpCells cells;
  std::vector<std::int32_t> surfaces;   ///< by face
  std::vector<std::size_t> first_face;  ///< by surface

  explicit Triangles(const Recording& recording) {
    std::int32_t points = 0;
    for (std::size_t s = 0; s < recording.surfaces.size(); ++s) {
      const TriangleMesh& mesh = recording.surfaces[s].mesh;
      first_face.push_back(cells.ends.size());
      for (const auto& face : mesh.faces) {
        for (const Index vertex : face) cells.corners.push_back(points + static_cast<std::int32_t>(vertex));
        cells.end_cell();
        surfaces.push_back(static_cast<std::int32_t>(s));
      }
      points += static_cast<std::int32_t>(mesh.vertices.size());
    }
  }
};

std::vector<float> points_of(const Recording& recording, const Frame& frame) {
  std::vector<float> points;
  for (std::size_t s = 0; s < recording.surfaces.size(); ++s) {
    const Pose& pose = frame.poses_W[s];
    for (const Eigen::Vector3d& vertex : recording.surfaces[s].mesh.vertices) {
      const Eigen::Vector3f x_W = (pose.A * vertex + pose.r).cast<float>();
      points.insert(points.end(), x_W.data(), x_W.data() + 3);
    }
  }
  return points;
}

std::vector<float> pressures_of(const Recording& recording, const Frame& frame, const Triangles& triangles) {
  std::vector<float> pressures(triangles.surfaces.size(), 0);
  for (const RecordedElement& e : frame.elements) {
    const RecordedPairing& pairing = recording.pairings[static_cast<std::size_t>(e.pairing)];
    const Index surface = e.master == Side::E ? pairing.surface_E : pairing.surface_F;
    float& pressure =
        pressures[triangles.first_face[static_cast<std::size_t>(surface)] + static_cast<std::size_t>(e.face)];
    pressure = std::max(pressure, static_cast<float>(e.pressure));
  }
  return pressures;
}

std::string text_of(const Recording& recording, const Frame& frame, const Triangles& triangles) {
  compare::VtpPolyData data;
  data.points.values = points_of(recording, frame);
  data.polygons = triangles.cells;
  data.cell_data = {{"pressure", 1, pressures_of(recording, frame, triangles)}, {"surface", 1, triangles.surfaces}};
  data.scalars = "pressure";
  return compare::vtp(data);
}

}  // namespace

void write_vtp_series(const std::filesystem::path& folder, const Recording& recording) {
  compare::create_folder(folder);
  const Triangles triangles(recording);
  std::vector<compare::PvdEntry> files;
  for (std::size_t i = 0; i < recording.frames.size(); ++i) {
    const Frame& frame = recording.frames[i];
    const compare::PvdEntry& file = files.emplace_back(compare::PvdEntry{frame.t, 0, fmt::format("{}.vtp", i)});
    write_text_file(folder / file.file, text_of(recording, frame, triangles));
  }
  write_text_file(folder / "frames.pvd", compare::pvd(files));
}

}  // namespace pcm::simulate
