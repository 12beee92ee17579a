// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// check() on real surfaces that `run` cannot fetch: what scanners, CAD programs and welded STL files leave behind,
// among it edges of three faces, a Moebius strip and fragments. Those that it can fetch are compared with CGAL itself
// (tests/reference/mesh_fitness_test.cpp, MeshFitness.OfRealSurfacesIsThatOfCgal).
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "pcm/bad_input.h"
#include "pcm/check.h"
#include "pcm/read_mesh.h"

namespace pcm {
namespace {

/// A row of the index of real surfaces, whose figures were measured with CGAL.
struct Row {
  std::string name, expected;
  int vertices = 0, faces = 0, components = 0, closed_components = 0;
  int border = 0, non_manifold = 0, flipped = 0, pinched = 0, duplicates = 0, zero_area = 0;
  bool closed = false;
};

std::vector<std::string> split_cells(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t begin = cell.find_first_not_of(' ');
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, cell.find_last_not_of(' ') - begin + 1));
  }
  return cells;
}

std::vector<Row> read_index(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    const std::vector<std::string> cells = split_cells(line);
    if (cells.size() < 12 || cells[1] == "name" || cells[1].starts_with("---")) continue;
    Row row;
    row.name = cells[1];
    row.expected = cells[2];
    const int read = std::sscanf(cells[3].c_str(), "%d / %d", &row.vertices, &row.faces) +
                     std::sscanf(cells[6].c_str(), "%d (%d)", &row.components, &row.closed_components) +
                     std::sscanf(cells[7].c_str(), "%d/%d/%d", &row.border, &row.non_manifold, &row.flipped);
    EXPECT_EQ(read, 7) << line;
    row.closed = cells[5] == "yes";
    row.pinched = std::stoi(cells[8]);
    row.duplicates = std::stoi(cells[9]);
    row.zero_area = std::stoi(cells[10]);
    rows.push_back(row);
  }
  return rows;
}

TEST(RealSurfaces, CheckFindsWhatTheIndexSays) {
  const std::filesystem::path folder = PCM_FURTHER_SURFACES_DIR;
  if (!std::filesystem::exists(folder / "INDEX.md"))
    GTEST_SKIP() << "no further surfaces in " << folder << "; those that ./run fetches are held in test_mesh_fitness";
  const std::vector<Row> rows = read_index(folder / "INDEX.md");
  ASSERT_GT(rows.size(), 80u);
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    const TriangleMesh mesh = read_mesh(folder / (row.name + ".obj"));
    const MeshReport report = check(mesh);
    EXPECT_EQ(report.fit(), row.expected != "unfit") << report.summary();
    if (report.fit()) {
      EXPECT_EQ(report.closed(), row.expected.starts_with("fit")) << report.summary();
      EXPECT_NO_THROW(require_fit(report));
    } else {
      EXPECT_THROW(require_fit(report), BadInput);
    }
    // This one of 47 pieces has four closed ones that look inward; they may be cavities of its open ones.
    EXPECT_EQ(report.possible_cavities.size(), row.name == "b9_mesh_cgal" ? 4u : 0u);
    EXPECT_EQ(report.vertex_count, row.vertices);
    EXPECT_EQ(report.face_count, row.faces);
    EXPECT_EQ(report.closed(), row.closed);
    EXPECT_EQ(report.component_count, row.components);
    EXPECT_EQ(report.closed_component_count, row.closed_components);
    EXPECT_EQ(static_cast<int>(report.border_edges.size()), row.border);
    EXPECT_EQ(static_cast<int>(report.non_manifold_edges.size()), row.non_manifold);
    EXPECT_EQ(static_cast<int>(report.flipped_edges.size()), row.flipped);
    EXPECT_EQ(static_cast<int>(report.pinched_vertices.size()), row.pinched);
    EXPECT_EQ(static_cast<int>(report.duplicate_vertices.size()), row.duplicates);
    EXPECT_EQ(static_cast<int>(report.zero_area_faces.size() + report.repeated_vertex_faces.size()), row.zero_area);
  }
}

}  // namespace
}  // namespace pcm
