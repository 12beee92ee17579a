// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/poses/poses_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

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
    surfaces_.push_back({word, "surfaces/" + word + ".obj", sha256(format_obj(mesh)), mesh});
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

void PosedSurfaces::write(const std::filesystem::path& folder) const {
  std::error_code error;
  std::filesystem::create_directories(folder / "surfaces", error);
  for (const PosedSurface& surface : surfaces_) write_text_file(folder / surface.file, format_obj(surface.mesh));
}

PosesWriter::PosesWriter(std::filesystem::path folder, const PosedSurfaces& surfaces, std::int64_t poses,
                         const std::string& origin)
    : folder_(std::move(folder)), partial_(folder_ / (std::string(kPosesFile) + ".part")), surfaces_(surfaces) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  out_.open(partial_, std::ios::binary);
  add(dump_exactly(poses_header(surfaces.surfaces(), poses, origin)));
}

PosesWriter::~PosesWriter() {
  out_.close();
  std::error_code error;
  std::filesystem::remove(partial_, error);
}

void PosesWriter::finish() {
  out_.close();
  if (!out_) throw BadInput(partial_.string() + " can't be written");
  // Between the two no poses stand there, rather than some beside surfaces that are not theirs.
  std::filesystem::remove(folder_ / kPosesFile);
  surfaces_.write(folder_);
  std::filesystem::rename(partial_, folder_ / kPosesFile);
}

}  // namespace pcm::compare
