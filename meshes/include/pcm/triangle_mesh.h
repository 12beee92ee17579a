// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcm {

/// Index of a vertex or of a face within its own mesh, from 0 in file order.
using Index = std::int32_t;

/// A triangle's three vertices, counterclockwise seen from outside the body.
using Triangle = std::array<Index, 3>;

/// A surface as it was read or generated: plain data, nothing checked, nothing derived.
///
/// `vertices[i]` is in the frame of the body's marker (Me for surface E, Mf for surface F), in metres.
/// Vertex and face order is that of the file: the tie rule and every sum follow it.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> faces;
  /// Where the mesh comes from (a path or a generator's command line); used in messages only.
  std::string name;
};

}  // namespace pcm
