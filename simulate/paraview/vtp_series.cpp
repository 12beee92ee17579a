// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/paraview/vtp_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "simulate/page/base64.h"

namespace pcm::simulate {
namespace {

static_assert(std::endian::native == std::endian::little, "said so in the files");

/// An array as VTK writes it inline: its length in bytes, then the bytes, base64 together.
template <class T>
std::string data_array(std::string_view type, std::string_view name, int components, const std::vector<T>& values) {
  const auto length = static_cast<std::uint32_t>(values.size() * sizeof(T));
  std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
  bytes.append(reinterpret_cast<const char*>(values.data()), length);
  return fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="binary">{}</DataArray>)"
                     "\n",
                     type, name, components, base64(bytes));
}

/// All surfaces as one set of points and triangles; the same for every frame but for the places of the points.
struct Polygons {
  std::vector<std::int32_t> corners, ends, surfaces;
  std::vector<std::size_t> first_face;  ///< by surface

  explicit Polygons(const Recording& recording) {
    std::int32_t points = 0;
    for (std::size_t s = 0; s < recording.surfaces.size(); ++s) {
      const TriangleMesh& mesh = recording.surfaces[s].mesh;
      first_face.push_back(ends.size());
      for (const auto& face : mesh.faces) {
        for (const Index vertex : face) corners.push_back(points + static_cast<std::int32_t>(vertex));
        ends.push_back(static_cast<std::int32_t>(corners.size()));
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

std::vector<float> pressures_of(const Recording& recording, const Frame& frame, const Polygons& polygons) {
  std::vector<float> pressures(polygons.ends.size(), 0);
  for (const RecordedElement& e : frame.elements) {
    const RecordedPairing& pairing = recording.pairings[static_cast<std::size_t>(e.pairing)];
    const Index surface = e.master == Side::E ? pairing.surface_E : pairing.surface_F;
    float& pressure =
        pressures[polygons.first_face[static_cast<std::size_t>(surface)] + static_cast<std::size_t>(e.face)];
    pressure = std::max(pressure, static_cast<float>(e.pressure));
  }
  return pressures;
}

std::string polydata(const Recording& recording, const Frame& frame, const Polygons& polygons) {
  const std::vector<float> points = points_of(recording, frame);
  std::string text = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" header_type="UInt32">
)";
  text += fmt::format(R"(<PolyData><Piece NumberOfPoints="{}" NumberOfPolys="{}">)"
                      "\n",
                      points.size() / 3, polygons.ends.size());
  text += "<Points>\n" + data_array("Float32", "points", 3, points) + "</Points>\n";
  text += "<Polys>\n" + data_array("Int32", "connectivity", 1, polygons.corners) +
          data_array("Int32", "offsets", 1, polygons.ends) + "</Polys>\n";
  text += "<CellData Scalars=\"pressure\">\n" +
          data_array("Float32", "pressure", 1, pressures_of(recording, frame, polygons)) +
          data_array("Int32", "surface", 1, polygons.surfaces) + "</CellData>\n";
  return text + "</Piece></PolyData></VTKFile>\n";
}

}  // namespace

void write_vtp_series(const std::filesystem::path& folder, const Recording& recording) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw BadInput(folder.string() + ": can't be created: " + error.message());
  const Polygons polygons(recording);
  std::string list = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (std::size_t i = 0; i < recording.frames.size(); ++i) {
    write_text_file(folder / fmt::format("{}.vtp", i), polydata(recording, recording.frames[i], polygons));
    list += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}.vtp\"/>\n", recording.frames[i].t, i);
  }
  write_text_file(folder / "frames.pvd", list + "</Collection>\n</VTKFile>\n");
}

}  // namespace pcm::simulate
