// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// Reads the surface in an Object File Format (OFF) file, in the file's order; polygons are cut into triangles as in
/// read_obj.h.
///
/// The header is OFF or COFF, the counts of vertices and faces (and edges, ignored) follow on the same line or the
/// next. Each vertex and each face has a line of its own, comments and empty lines aside; colours behind it are
/// ignored. Other variants (binary, NOFF, STOFF, 4OFF, nOFF) are refused.
///
/// Throws BadInput as read_obj does, also where lines are missing or left over. Cost: linear.
TriangleMesh read_off(const std::filesystem::path& path);

/// The same from the text of such a file; `name` becomes the mesh's and stands for the file in messages.
TriangleMesh parse_off(std::string_view text, const std::string& name);

}  // namespace pcm
