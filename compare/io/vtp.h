// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

/// Geometry with numbers on it for ParaView: VTK's XML PolyData 0.1, arrays in base64. Written by hand, for VTK's
/// library is two hundred times what this takes.
namespace pcm::compare {

/// Numbers, `components` of them a point or a cell.
struct VtpArray {
  std::string name;
  int components = 1;
  std::variant<std::vector<float>, std::vector<double>, std::vector<std::int32_t>> values;
};

/// Cells of one kind: the numbers of their points one cell after the other, and where each cell's end in that list.
struct VtpCells {
  std::vector<std::int32_t> corners, ends;

  /// Begins a cell's end: what has been appended to `corners` since the last call is a cell.
  void end_cell() { ends.push_back(static_cast<std::int32_t>(corners.size())); }
};

/// Values by cell follow the order vertices, lines, triangles.
struct VtpPolyData {
  VtpArray points{"points", 3, std::vector<double>{}};
  VtpCells vertices, lines, polygons;
  std::vector<VtpArray> point_data, cell_data;
  std::string scalars;  ///< name of the array by which ParaView colours at first, of `cell_data`, or else `point_data`
};

/// The text of a .vtp file.
std::string vtp(const VtpPolyData& data);

/// A file of a .pvd collection: shown at a time, as one of the parts that are shown then.
struct PvdEntry {
  double time = 0;
  int part = 0;
  std::string file;  ///< relative to the collection
};

/// The text of a .pvd file, which ParaView opens as one object that changes over time.
std::string pvd(const std::vector<PvdEntry>& entries);

/// A .pvd file that grows: whole whenever it is looked at, and what has been written is not written again.
class PvdFile {
 public:
  /// Begins the file, without entries. Throws BadInput where it can't be written.
  explicit PvdFile(std::filesystem::path path);

  /// Throws BadInput where it can't be written.
  void add(const std::vector<PvdEntry>& entries);

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::streamoff end_ = 0;  ///< of the entries
};

}  // namespace pcm::compare
