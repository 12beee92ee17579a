// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surfaces committed under meshes/surfaces/ are their generators' output, byte for byte. When a generator changes
// on purpose, run this test once with the environment variable PCM_REWRITE_SURFACES set: it writes the files anew.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "meshes/files/read_obj.h"
#include "meshes/generate/make.h"
#include "pcm/write_obj.h"
#include "tests/meshes/content_of.h"
#include "tests/meshes/same_bits.h"

namespace pcm {
namespace {

struct CommittedSurface {
  std::string shape;
  std::map<std::string, double, std::less<>> parameters;
};

/// Every file is named after its shape.
std::vector<CommittedSurface> committed_surfaces() {
  return {{"box", {}},
          {"bubble", {}},
          {"cone", {{"segments", 16}, {"bands", 4}, {"cap_rings", 2}}},
          {"cylinder", {{"segments", 16}, {"bands", 4}, {"cap_rings", 2}}},
          {"gridded_box", {}},
          {"icosphere", {{"level", 2}}},
          {"knotted_tube", {{"segments", 64}, {"tube_segments", 6}}},
          {"plate", {}},
          {"pyramid", {}},
          {"rectangle", {}},
          {"socket", {{"segments", 24}, {"bands", 6}}},
          {"spur_gear", {{"teeth", 12}}},
          {"torus", {{"segments", 24}, {"tube_segments", 12}}},
          {"tube", {{"segments", 16}, {"bands", 2}}},
          {"uv_sphere", {{"segments", 16}, {"bands", 8}}},
          {"wedge", {}}};
}

const std::filesystem::path kFolder = std::filesystem::path(PCM_SOURCE_DIR) / "meshes" / "surfaces";

TEST(CommittedSurfaces, EqualTheirGeneratorsBitForBit) {
  for (const auto& [shape, parameters] : committed_surfaces()) {
    const std::filesystem::path path = kFolder / (shape + ".obj");
    SCOPED_TRACE(path);
    const TriangleMesh mesh = make(shape, parameters);
    if (std::getenv("PCM_REWRITE_SURFACES") != nullptr) write_obj(mesh, path);
    EXPECT_TRUE(content_of(path) == format_obj(mesh));
    EXPECT_TRUE(same_bits(read_obj(path), mesh));
    EXPECT_LT(std::filesystem::file_size(path), 100'000u);
  }
}

TEST(CommittedSurfaces, FolderHoldsNothingElse) {
  std::set<std::string> expected, found;
  for (const CommittedSurface& surface : committed_surfaces()) expected.insert(surface.shape + ".obj");
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) found.insert(entry.path().filename().string());
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace pcm
