// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// Reads a surface in the format its extension names, in capitals or not: .obj (read_obj.h) or .off (read_off.h).
/// Throws BadInput where the reader does and for any other extension.
TriangleMesh read_mesh(const std::filesystem::path& path);

}  // namespace pcm
