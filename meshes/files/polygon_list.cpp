// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/files/polygon_list.h"

#include <optional>
#include <string>

#include "meshes/files/parse_number.h"
#include "meshes/files/triangulate_polygon.h"

namespace pcm {

double read_finite(const TextLines& lines, std::string_view word) {
  const std::optional<double> number = parse_number(word);
  if (!number) lines.fail(in_quotes(word) + " is not a finite number; write a decimal number such as -1.5e-3");
  return *number;
}

void PolygonList::begin(std::int64_t line) {
  starts_.push_back(corners_.size());
  lines_.push_back(line);
}

std::vector<Triangle> PolygonList::triangulate(const std::vector<Eigen::Vector3d>& vertices, const TextLines& lines,
                                               std::int64_t first_number) const {
  const auto vertex_count = static_cast<std::int64_t>(vertices.size());
  std::vector<Triangle> faces;
  faces.reserve(size());
  std::vector<Index> polygon;
  for (std::size_t i = 0; i < size(); ++i) {
    const std::size_t end = i + 1 < size() ? starts_[i + 1] : corners_.size();
    polygon.clear();
    for (std::size_t k = starts_[i]; k < end; ++k) {
      if (corners_[k] < 0 || corners_[k] >= vertex_count) {
        lines.fail_at(lines_[i], "the face refers to vertex " + std::to_string(corners_[k] + first_number) +
                                     ", but the file's vertices are numbered " + std::to_string(first_number) + " to " +
                                     std::to_string(vertex_count - 1 + first_number) +
                                     "; correct the index or add the vertex");
      }
      polygon.push_back(static_cast<Index>(corners_[k]));
    }
    if (polygon.size() < 3) {
      lines.fail_at(lines_[i], "the face has " + std::to_string(polygon.size()) +
                                   (polygon.size() == 1 ? " corner" : " corners") +
                                   ", it needs at least 3; complete it or remove the line");
    }
    triangulate_polygon(vertices, polygon, faces);
    if (static_cast<std::int64_t>(faces.size()) > kMostElements)
      lines.fail_at(lines_[i], "more than 2147483647 triangles; split the surface");
  }
  return faces;
}

}  // namespace pcm
