// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/read_mesh.h"

#include <string>
#include <system_error>

#include "meshes/files/extension.h"
#include "meshes/files/read_obj.h"
#include "meshes/files/read_off.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm {

// A new format takes a reader beside read_off.cpp, a line here and its name in read_mesh.h. Faces must share vertices,
// which a format of separate triangles has to be made to, and vertices need an order: ties depend on it.
TriangleMesh read_mesh(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".obj") return read_obj(path);
  if (extension == ".off") return read_off(path);
  // A missing file or a folder is the likelier mistake and is reported as such.
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) read_text_file(path);
  throw BadInput(path.string() + ": the extension " + in_quotes(extension) +
                 " is not a surface format known here; use " + kMeshExtensions);
}

}  // namespace pcm
