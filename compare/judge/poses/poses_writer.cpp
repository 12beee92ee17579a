// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/poses/poses_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "compare/io/provenance/sha256.h"
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

/// What is being written has it behind its name.
constexpr const char* kPart = ".part";

/// Files that the first line of a poses.jsonl names, with their SHA-256. Throws BadInput where there is one that `pcm
/// poses` has not written.
std::map<std::string, std::string> surfaces_of_earlier_poses(const std::filesystem::path& file) {
  std::map<std::string, std::string> hashes;
  std::error_code none_there;
  if (!std::filesystem::exists(std::filesystem::symlink_status(file, none_there))) return hashes;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  const Json header = Json::parse(line, nullptr, false);
  if (!header.is_object() || header.value("format", Json()) != kPosesFormat)
    throw BadInput(file.string() + " is there, which 'pcm poses' has not written; choose another folder");
  if (const auto list = header.find("surfaces"); list != header.end() && list->is_array())
    for (const Json& surface : *list)
      if (surface.is_object() && surface.value("file", Json()).is_string() &&
          surface.value("sha256", Json()).is_string())
        hashes[surface["file"].get<std::string>()] = surface["sha256"].get<std::string>();
  return hashes;
}

/// Throws BadInput where a surface would take the place of a file that is neither its own nor one of earlier poses.
void refuse_files_of_others(const std::filesystem::path& folder, const std::vector<PosedSurface>& surfaces) {
  const std::map<std::string, std::string> earlier = surfaces_of_earlier_poses(folder / kPosesFile);
  for (const PosedSurface& surface : surfaces) {
    const std::filesystem::path file = folder / surface.file;
    std::error_code none_there;
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, none_there))) continue;
    const std::optional<std::string> hash = sha256_of_file(file);
    const auto known = earlier.find(surface.file);
    if (hash && (*hash == surface.sha256 || (known != earlier.end() && known->second == *hash))) continue;
    throw BadInput(
        file.string() +
        " is there, and is not what a poses.jsonl beside it says that 'pcm poses' has written; choose another "
        "folder");
  }
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

void PosedSurfaces::write_beside(const std::filesystem::path& folder) const {
  std::error_code error;
  std::filesystem::create_directories(folder / "surfaces", error);
  for (const PosedSurface& surface : surfaces_)
    write_text_file(folder / (surface.file + kPart), format_obj(surface.mesh));
}

void PosedSurfaces::take_their_places(const std::filesystem::path& folder) const {
  for (const PosedSurface& surface : surfaces_)
    std::filesystem::rename(folder / (surface.file + kPart), folder / surface.file);
}

void PosedSurfaces::remove_those_beside(const std::filesystem::path& folder) const {
  std::error_code none_there;
  for (const PosedSurface& surface : surfaces_) std::filesystem::remove(folder / (surface.file + kPart), none_there);
}

PosesWriter::PosesWriter(std::filesystem::path folder, const PosedSurfaces& surfaces, std::int64_t poses,
                         const std::string& origin)
    : folder_(std::move(folder)), partial_(folder_ / (std::string(kPosesFile) + kPart)), surfaces_(surfaces) {
  refuse_files_of_others(folder_, surfaces.surfaces());
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  out_.open(partial_, std::ios::binary);
  add(dump_exactly(poses_header(surfaces.surfaces(), poses, origin)));
}

PosesWriter::~PosesWriter() {
  out_.close();
  std::error_code error;
  std::filesystem::remove(partial_, error);
  surfaces_.remove_those_beside(folder_);
}

void PosesWriter::finish() {
  out_.close();
  if (!out_) throw BadInput(partial_.string() + " can't be written");
  surfaces_.write_beside(folder_);
  // Until the last of these no poses stand there, rather than some beside surfaces that are not theirs.
  std::filesystem::remove(folder_ / kPosesFile);
  surfaces_.take_their_places(folder_);
  std::filesystem::rename(partial_, folder_ / kPosesFile);
}

}  // namespace pcm::compare
