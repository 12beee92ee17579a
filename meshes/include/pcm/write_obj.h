// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// The mesh as the text of a Wavefront OBJ file: its name as a comment, a `v` a vertex, an `f` a face, in order. Each
/// coordinate is the shortest decimal that reads back bit for bit, negative zero and denormals included.
/// Throws BadInput where read_obj would refuse the result: no vertex or face, a coordinate that is not finite, an index
/// out of range.
std::string format_obj(const TriangleMesh& mesh);

/// Writes that text to a file. It is written under another name beside `path` and renamed when whole, so no partial
/// file is ever seen under `path`. Throws BadInput where the file can't be written, naming it, and leaves nothing
/// behind.
void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace pcm
