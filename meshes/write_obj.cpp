// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/write_obj.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <random>
#include <system_error>

#include "meshes/bad_input.h"

namespace pcm {
namespace {

template <typename Number>
void append(std::string& text, Number number) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  text.append(buffer.data(), result.ptr);
}

/// A name beside `path` that nothing else uses.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
  std::random_device random;
  std::filesystem::path name = path;
  name += ".part" + std::to_string(random());
  return name;
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
  const std::string text = format_obj(mesh);
  const std::string name = path.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw BadInput(name + ": this is a folder or a device; name a file");
  const std::filesystem::path temporary = temporary_name(path);
  std::ofstream file(temporary, std::ios::binary);
  if (!file)
    throw BadInput(name + ": the file can't be created; check that its folder exists and that you may write to it");
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  bool written = !file.fail();
  if (written) {
    std::filesystem::rename(temporary, path, error);
    written = !error;
  }
  if (!written) {
    std::filesystem::remove(temporary, error);
    throw BadInput(name + ": writing the file failed; check the space on the disk and your permissions");
  }
}

}  // namespace pcm
