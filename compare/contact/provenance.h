// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "compare/io/json/exact_json.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// A surface's file, and what was read of it.
struct SurfaceOrigin {
  std::string file;
  std::optional<std::string> sha256;  ///< of the file's bytes; none of a pipe, which can't be read twice
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

/// Reads the file once more. Throws BadInput where it can't.
SurfaceOrigin surface_origin(const std::string& file, const TriangleMesh& mesh);

/// Where answers come from: all that it takes to get them again.
struct Provenance {
  std::string engine;   ///< as --engine has it
  std::string problem;  ///< rounded or exact
  Scheme scheme = Scheme::barycentric;
  Mode mode = Mode::E;
  ContactLaw law;
  double scale = 1;  ///< m for each unit of length in the files
  SurfaceOrigin E, F;
};

/// With what this program says of itself.
Json provenance_json(const Provenance& provenance);

}  // namespace pcm::compare
