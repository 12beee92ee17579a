// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/files/read_obj.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include "meshes/base/floating_point_environment.h"
#include "meshes/files/polygon_list.h"
#include "meshes/files/text_file.h"

namespace pcm {
namespace {

/// The statements of Wavefront OBJ, old spellings among them, but for vertices and faces.
constexpr std::string_view kOtherStatements[] = {
    "vt",        "vn",     "vp",     "g",      "o",     "s",    "mg",       "l",        "p",
    "mtllib",    "usemtl", "maplib", "usemap", "bevel", "lod",  "c_interp", "d_interp", "shadow_obj",
    "trace_obj", "cstype", "deg",    "bmat",   "step",  "curv", "curv2",    "surf",     "parm",
    "trim",      "hole",   "scrv",   "sp",     "end",   "con",  "ctech",    "stech",    "call",
    "csh",       "bsp",    "bzp",    "cdc",    "cdp",   "res"};

bool is_other_statement(std::string_view word) {
  return std::find(std::begin(kOtherStatements), std::end(kOtherStatements), word) != std::end(kOtherStatements);
}

Eigen::Vector3d read_vertex(const TextLines& lines) {
  const std::vector<std::string_view>& words = lines.words();
  const std::size_t count = words.size() - 1;
  if (count < 3) {
    lines.fail("a vertex needs three coordinates, here " + std::string(count == 1 ? "is " : "are ") +
               std::to_string(count) + "; write v x y z");
  }
  if (count == 5 || count > 7) {
    lines.fail("a vertex of " + std::to_string(count) +
               " numbers; write v x y z, with a weight of 1 or three colours at most");
  }
  double numbers[4] = {0, 0, 0, 1};
  for (std::size_t i = 0; i < count; ++i) {
    const double number = read_finite(lines, words[i + 1]);
    if (i < 4) numbers[i] = number;
  }
  // The fourth number is a weight where it stands alone or before three colours; six numbers are x y z r g b.
  if ((count == 4 || count == 7) && numbers[3] != 1) {
    lines.fail("the vertex has the weight " + in_quotes(words[4]) +
               "; only 1 is understood: divide x, y and z by it and leave it out");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

/// One corner of a face: v, v/vt, v//vn or v/vt/vn. Returns the vertex, from 0.
std::int64_t read_corner(const TextLines& lines, std::string_view word, std::int64_t vertices_so_far) {
  const std::string_view vertex_part = word.substr(0, word.find('/'));
  const std::optional<std::int64_t> number = parse_integer(vertex_part);
  bool well_formed = number.has_value();
  std::string_view rest = word.substr(vertex_part.size());
  for (int part = 0; part < 2 && !rest.empty(); ++part) {
    rest.remove_prefix(1);  // the slash
    const std::string_view index = rest.substr(0, rest.find('/'));
    well_formed = well_formed && (index.empty() || parse_integer(index));
    rest.remove_prefix(index.size());
  }
  if (!well_formed || !rest.empty())
    lines.fail(in_quotes(word) +
               " is not a corner of a face; write it as v, v/vt, v//vn or v/vt/vn with whole numbers");
  if (*number == 0) lines.fail("the face refers to vertex 0, but vertices are numbered from 1; correct the index");
  if (*number > 0) return *number - 1;
  if (*number < -vertices_so_far) {
    lines.fail("the face refers to vertex " + std::to_string(*number) + ", counted back from here, but only " +
               std::to_string(vertices_so_far) + " stand above; correct the index");
  }
  return vertices_so_far + *number;
}

}  // namespace

TriangleMesh read_obj(const std::filesystem::path& path) {
  return parse_obj(read_text_file(path), path.string());
}

TriangleMesh parse_obj(std::string_view text, const std::string& name) {
  const DefaultFloatingPoint environment;
  TriangleMesh mesh;
  mesh.name = name;
  PolygonList polygons;
  TextLines lines(text, name);
  while (lines.next()) {
    const std::vector<std::string_view>& words = lines.words();
    const auto vertices_so_far = static_cast<std::int64_t>(mesh.vertices.size());
    if (words[0] == "v") {
      if (vertices_so_far == kMostElements) lines.fail("more than 2147483647 vertices; split the surface");
      mesh.vertices.push_back(read_vertex(lines));
    } else if (words[0] == "f" || words[0] == "fo") {  // "fo" is its old spelling
      polygons.begin(lines.line());
      for (std::size_t i = 1; i < words.size(); ++i) polygons.add_corner(read_corner(lines, words[i], vertices_so_far));
    } else if (!is_other_statement(words[0])) {
      lines.fail(
          in_quotes(words[0]) +
          " is no statement of Wavefront OBJ (a vertex begins with v, a face with f); correct the line, or put # "
          "before it");
    }
  }
  if (mesh.vertices.empty())
    lines.fail_as_a_whole("no vertex in the file; a Wavefront OBJ file with lines 'v x y z' is needed");
  if (polygons.size() == 0)
    lines.fail_as_a_whole("no face in the file; export the surface with its faces, lines 'f i j k'");
  mesh.faces = polygons.triangulate(mesh.vertices, lines, 1);
  return mesh;
}

}  // namespace pcm
