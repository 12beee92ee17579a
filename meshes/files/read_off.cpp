// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/files/read_off.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "meshes/base/floating_point_environment.h"
#include "meshes/files/polygon_list.h"
#include "meshes/files/text_file.h"

namespace pcm {
namespace {

std::int64_t read_count(const TextLines& lines, std::string_view word, const char* what) {
  std::int64_t value = 0;
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || value < 0)
    lines.fail(in_quotes(word) + " is not " + what + "; write a whole number, 0 or more");
  return value;
}

struct Counts {
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
};

Counts read_header(TextLines& lines) {
  if (!lines.next()) lines.fail_as_a_whole("the file is empty; an OFF file begins with the word OFF");
  const std::string_view keyword = lines.words()[0];
  if (keyword != "OFF" && keyword != "COFF") {
    lines.fail("the file begins with " + in_quotes(keyword) +
               "; only the plain variants of the format, OFF and COFF, are understood: convert it");
  }
  std::size_t first = 1;
  if (lines.words().size() == 1) {
    if (!lines.next()) lines.fail("the file ends before its counts; write the numbers of vertices, faces and edges");
    first = 0;
  }
  const std::vector<std::string_view>& words = lines.words();
  if (words[first] == "BINARY") lines.fail("a binary OFF file; save it as text");
  if (words.size() - first < 2 || words.size() - first > 3)
    lines.fail("expected the numbers of vertices, faces and edges; write three whole numbers");
  const Counts counts{read_count(lines, words[first], "a number of vertices"),
                      read_count(lines, words[first + 1], "a number of faces")};
  if (words.size() - first == 3) read_count(lines, words[first + 2], "a number of edges");
  if (std::max(counts.vertices, counts.faces) > kMostElements)
    lines.fail("more than 2147483647 vertices or faces; split the surface");
  if (counts.vertices == 0) lines.fail_as_a_whole("no vertex in the file; a surface is needed");
  if (counts.faces == 0) lines.fail_as_a_whole("no face in the file; export the surface with its faces");
  return counts;
}

/// What may follow coordinates or corners: the numbers of a colour.
void require_numbers_from(const TextLines& lines, std::size_t first) {
  for (std::size_t i = first; i < lines.words().size(); ++i) read_finite(lines, lines.words()[i]);
}

void next_element(TextLines& lines, const char* what, std::int64_t done, std::int64_t count) {
  if (lines.next()) return;
  lines.fail("the file ends after " + std::to_string(done) + " of " + std::to_string(count) + ' ' + what +
             "; it is cut short or its counts are wrong");
}

}  // namespace

TriangleMesh read_off(const std::filesystem::path& path) {
  return parse_off(read_text_file(path), path.string());
}

TriangleMesh parse_off(std::string_view text, const std::string& name) {
  const DefaultFloatingPoint environment;
  TriangleMesh mesh;
  mesh.name = name;
  TextLines lines(text, name);
  const Counts counts = read_header(lines);
  for (std::int64_t i = 0; i < counts.vertices; ++i) {
    next_element(lines, "vertices", i, counts.vertices);
    const std::vector<std::string_view>& words = lines.words();
    if (words.size() < 3) lines.fail("a vertex needs three coordinates; write x y z");
    mesh.vertices.emplace_back(read_finite(lines, words[0]), read_finite(lines, words[1]),
                               read_finite(lines, words[2]));
    require_numbers_from(lines, 3);
  }
  PolygonList polygons;
  for (std::int64_t i = 0; i < counts.faces; ++i) {
    next_element(lines, "faces", i, counts.faces);
    const std::vector<std::string_view>& words = lines.words();
    const std::int64_t corners = read_count(lines, words[0], "a number of corners");
    if (corners >= static_cast<std::int64_t>(words.size())) {
      lines.fail("the face announces " + std::to_string(corners) + " corners, but " + std::to_string(words.size() - 1) +
                 " follow; complete it");
    }
    polygons.begin(lines.line());
    for (std::int64_t k = 1; k <= corners; ++k)
      polygons.add_corner(read_count(lines, words[static_cast<std::size_t>(k)], "the index of a vertex"));
    require_numbers_from(lines, static_cast<std::size_t>(corners) + 1);
  }
  if (lines.next()) lines.fail("more lines than the header counts; correct the counts or remove the lines");
  mesh.faces = polygons.triangulate(mesh.vertices, lines, 0);
  return mesh;
}

}  // namespace pcm
