// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// Reads the surface in a Wavefront OBJ file: every `v` in file order, every `f` cut into triangles in file order (see
/// triangulate_polygon.h).
///
/// `v x y z`, also with a weight w (which must be 1) and colours (ignored); each number is the double nearest to its
/// decimal. `f` with v, v/vt, v//vn or v/vt/vn; negative indices count back from the last vertex so far. All other
/// statements of the format (normals, groups, materials, lines, ...) are ignored; what is none, as a face misspelt, is
/// refused. The result is as the file has it: check.h says whether it is fit for contact. Its name is the path.
///
/// Throws BadInput naming the file, and the line where there is one, and what to do: missing, a folder, binary, not a
/// finite number, an index out of range, a face of fewer than three corners, no statement of OBJ, no vertex, no face.
/// Cost: linear, tens of megabytes a second, but for concave polygons of many corners.
TriangleMesh read_obj(const std::filesystem::path& path);

/// The same from the text of such a file; `name` becomes the mesh's and stands for the file in messages.
TriangleMesh parse_obj(std::string_view text, const std::string& name);

}  // namespace pcm
