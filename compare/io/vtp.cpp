// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/vtp.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string_view>
#include <utility>

#include "compare/io/base64.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

static_assert(std::endian::native == std::endian::little, "said so in the files");

constexpr std::string_view type_name(const std::vector<float>&) {
  return "Float32";
}
constexpr std::string_view type_name(const std::vector<double>&) {
  return "Float64";
}
constexpr std::string_view type_name(const std::vector<std::int32_t>&) {
  return "Int32";
}

/// An array as VTK writes it inline: its length in bytes, then the bytes, base64 together.
template <class T>
std::string data_array(std::string_view name, int components, const std::vector<T>& values) {
  const auto length = static_cast<std::uint32_t>(values.size() * sizeof(T));
  std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
  bytes.append(reinterpret_cast<const char*>(values.data()), length);
  return fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="binary">{}</DataArray>)"
                     "\n",
                     type_name(values), name, components, base64(bytes));
}

std::string data_array(const VtpArray& array) {
  return std::visit([&](const auto& values) { return data_array(array.name, array.components, values); }, array.values);
}

std::size_t points_in(const VtpArray& points) {
  return std::visit([](const auto& values) { return values.size() / 3; }, points.values);
}

/// What a piece holds of a kind of cell; nothing is said of a kind that it has none of.
std::string count_of(std::string_view kind, const VtpCells& cells) {
  return cells.ends.empty() ? "" : fmt::format(R"( NumberOf{}="{}")", kind, cells.ends.size());
}

std::string cells_of(std::string_view kind, const VtpCells& cells) {
  if (cells.ends.empty()) return "";
  return fmt::format("<{}>\n{}{}</{}>\n", kind, data_array("connectivity", 1, cells.corners),
                     data_array("offsets", 1, cells.ends), kind);
}

std::string data_of(std::string_view kind, const std::vector<VtpArray>& arrays, const std::string& scalars) {
  if (arrays.empty()) return "";
  const bool has_scalars =
      std::any_of(arrays.begin(), arrays.end(), [&](const VtpArray& array) { return array.name == scalars; });
  std::string text = has_scalars ? fmt::format("<{} Scalars=\"{}\">\n", kind, scalars) : fmt::format("<{}>\n", kind);
  for (const VtpArray& array : arrays) text += data_array(array);
  return text + fmt::format("</{}>\n", kind);
}

constexpr std::string_view kPvdBegin =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
constexpr std::string_view kPvdEnd = "</Collection>\n</VTKFile>\n";

std::string pvd_lines(const std::vector<PvdEntry>& entries) {
  std::string text;
  for (const PvdEntry& entry : entries)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", entry.time, entry.part, entry.file);
  return text;
}

}  // namespace

std::string vtp(const VtpPolyData& data) {
  std::string text = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" header_type="UInt32">
)";
  text +=
      fmt::format("<PolyData><Piece NumberOfPoints=\"{}\"{}{}{}>\n", points_in(data.points),
                  count_of("Verts", data.vertices), count_of("Lines", data.lines), count_of("Polys", data.polygons));
  text += "<Points>\n" + data_array(data.points) + "</Points>\n";
  text += cells_of("Verts", data.vertices) + cells_of("Lines", data.lines) + cells_of("Polys", data.polygons);
  text += data_of("PointData", data.point_data, data.scalars) + data_of("CellData", data.cell_data, data.scalars);
  return text + "</Piece></PolyData></VTKFile>\n";
}

std::string pvd(const std::vector<PvdEntry>& entries) {
  return std::string(kPvdBegin) + pvd_lines(entries) + std::string(kPvdEnd);
}

PvdFile::PvdFile(std::filesystem::path path) : path_(std::move(path)), file_(path_, std::ios::binary) {
  file_ << kPvdBegin;
  end_ = static_cast<std::streamoff>(kPvdBegin.size());
  add({});
}

void PvdFile::add(const std::vector<PvdEntry>& entries) {
  const std::string lines = pvd_lines(entries);
  file_.seekp(end_);
  file_ << lines << kPvdEnd << std::flush;
  end_ += static_cast<std::streamoff>(lines.size());
  if (!file_) throw BadInput(path_.string() + ": the file can't be written; check the path, the disk and permissions");
}

}  // namespace pcm::compare
