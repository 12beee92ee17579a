// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/poses/poses_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "compare/io/sha256.h"
#include "compare/judge/poses/poses_folder.h"
#include "meshes/files/extension.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/write_obj.h"

namespace pcm::compare {
namespace {

/// Of a surface that was read, its file's name without folder and extension, and what was done with it.
std::string short_name(const std::string& name) {
  const std::string word = name.substr(name.rfind('/') + 1);
  const std::size_t end = std::min(word.find(' '), word.size());
  const std::filesystem::path file = word.substr(0, end);
  const std::string extension = extension_of(file);
  return extension == ".obj" || extension == ".off" ? file.stem().string() + word.substr(end) : word;
}

}  // namespace

std::size_t PosedSurfaces::number_of(const TriangleMesh& mesh) {
  const auto [known, is_new] = by_hash_.try_emplace(sha256(mesh), surfaces_.size());
  if (is_new) {
    const std::string word = free_name(mesh.name);
    surfaces_.push_back({word, "surfaces/" + word + ".obj", "", mesh});
  }
  return known->second;
}

/// The mesh's name as one that any file system takes and no other surface here has.
std::string PosedSurfaces::free_name(const std::string& name) {
  std::string word;
  for (const char c : short_name(name).substr(0, 100)) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    word += is_plain || c == '-' || (c == '.' && !word.empty()) ? c : '-';
  }
  if (word.empty()) word = "surface";
  std::string free = word;
  for (int k = 2; !names_.insert(free).second; ++k) free = fmt::format("{}-{}", word, k);
  return free;
}

const std::vector<PosedSurface>& PosedSurfaces::write(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder / "surfaces", error);
  for (PosedSurface& surface : surfaces_) {
    const std::string text = format_obj(surface.mesh);
    write_text_file(folder / surface.file, text);
    surface.sha256 = sha256(text);
  }
  return surfaces_;
}

PosesWriter::PosesWriter(const std::filesystem::path& folder, const std::vector<PosedSurface>& surfaces,
                         std::int64_t poses, const std::string& origin)
    : file_(folder / kPosesFile),
      partial_(folder / (std::string(kPosesFile) + ".part")),
      out_(partial_, std::ios::binary) {
  add(dump_exactly(poses_header(surfaces, poses, origin)));
}

PosesWriter::~PosesWriter() {
  out_.close();
  std::error_code error;
  std::filesystem::remove(partial_, error);
}

void PosesWriter::finish() {
  out_.close();
  if (!out_) throw BadInput(partial_.string() + " can't be written");
  std::filesystem::rename(partial_, file_);
}

}  // namespace pcm::compare
