// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compare/bench/peer.h"
#include "compare/poses/surface_features.h"

/// What `pcm bench peers` measures on.
namespace pcm::compare {

/// A body in contact with another of its kind.
struct BenchBody {
  std::string name;
  std::string description;
  TriangleMesh mesh;
};

/// Names known to `bench_body`, in the order of the tables.
const std::vector<std::string>& bench_body_names();
/// Throws BadInput for an unknown name.
BenchBody bench_body(const std::string& name);

/// Poses of a body of these features against another one, the same whatever else is run. A uniform rotation, and a
/// uniform direction along which the two support points overlap by 1 to 10 % of the size, uniformly; drawn anew until
/// the surfaces cross. Separated: as far apart instead, drawn anew until a box about F in its own axes and one about E
/// overlap, so that no root of a tree decides.
std::vector<Pose> bench_poses(const TriangleMesh& mesh, Distance distance, std::int64_t number);

}  // namespace pcm::compare
