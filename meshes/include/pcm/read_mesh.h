// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// The formats that `read_mesh` reads, as help texts and messages list them: by extension, and by name.
inline constexpr const char* kMeshExtensions = ".obj or .off";
inline constexpr const char* kMeshFormats = "OBJ or OFF";

/// Reads a surface in the format its extension names, in capitals or not: .obj or .off.
/// Throws BadInput, naming file and line, where the file cannot be read, breaks its format, has no vertex or face, or
/// an index out of range, and for any other extension. Whether the surface is fit for contact, `check` says.
TriangleMesh read_mesh(const std::filesystem::path& path);

}  // namespace pcm
