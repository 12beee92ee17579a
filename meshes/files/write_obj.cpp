// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/write_obj.h"

#include <array>
#include <charconv>
#include <cmath>

#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm {
namespace {

template <typename Number>
void append(std::string& text, Number number) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  text.append(buffer.data(), result.ptr);
}

}  // namespace

std::string format_obj(const TriangleMesh& mesh) {
  const std::string name = mesh.name.empty() ? "the mesh" : mesh.name;
  if (mesh.vertices.empty() || mesh.faces.empty())
    throw BadInput(name + ": a surface without a vertex or without a face is not written");
  std::string text;
  text.reserve(64 * mesh.vertices.size() + 24 * mesh.faces.size() + mesh.name.size() + 3);
  if (!mesh.name.empty()) {
    text += "# ";
    for (const char c : mesh.name) text.push_back(static_cast<unsigned char>(c) < ' ' ? ' ' : c);
    text.push_back('\n');
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!mesh.vertices[i].allFinite())
      throw BadInput(name + ": vertex " + std::to_string(i + 1) + " is not finite; mend it before writing");
    text.push_back('v');
    for (const double coordinate : mesh.vertices[i]) {
      text.push_back(' ');
      append(text, coordinate);
    }
    text.push_back('\n');
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    text.push_back('f');
    for (const Index vertex : mesh.faces[i]) {
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= mesh.vertices.size()) {
        throw BadInput(name + ": face " + std::to_string(i + 1) + " refers to vertex " +
                       std::to_string(std::int64_t{vertex} + 1) + ", which doesn't exist; mend it before writing");
      }
      text.push_back(' ');
      append(text, std::int64_t{vertex} + 1);
    }
    text.push_back('\n');
  }
  return text;
}

void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path) {
  write_text_file(path, format_obj(mesh));
}

}  // namespace pcm
