// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// The formats that `read_mesh` reads, as help texts and messages list them: by extension, and by name.
inline constexpr const char* kMeshExtensions = ".obj or .off";
inline constexpr const char* kMeshFormats = "OBJ or OFF";

/// Reads a surface in the format its extension names, in capitals or not: .obj (read_obj.h) or .off (read_off.h).
/// Throws BadInput where the reader does and for any other extension.
///
/// A new format takes a reader beside read_off.cpp, a line in read_mesh.cpp and its name above. Faces must share
/// vertices, which a format of separate triangles has to be made to, and vertices need an order: ties depend on it.
TriangleMesh read_mesh(const std::filesystem::path& path);

}  // namespace pcm
