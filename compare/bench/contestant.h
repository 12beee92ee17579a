// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

/// Who takes part in `pcm bench peers`: the engine, the oracle, and other programs that answer part of the question.
namespace pcm::compare {

/// A contestant, set up for two surfaces. What it needs to be set up is not measured.
class Contestant {
 public:
  Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;
  virtual ~Contestant() = default;

  /// What must happen before each query where a contestant takes no pose but only surfaces in place. Measured apart.
  virtual void prepare(const Pose& /*pose*/) {}
  /// Answers for F at this pose; returns how many of `ContestantEntry::finds` there are.
  virtual std::int64_t query(const Pose& pose) = 0;
};

/// Fewer words for the two kinds of poses a contestant may be asked about.
enum class Distance : std::uint8_t { touching, separated };

/// A contestant by name.
struct ContestantEntry {
  std::string who;
  std::string computes;
  std::string finds;           ///< what `query` counts
  std::string debian_package;  ///< empty for what is always there
  bool separated_too = true;   ///< also asked about separated surfaces
  /// Empty where the program was built without the package.
  std::function<std::unique_ptr<Contestant>(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)> make = {};
};

/// The motion and the law that contestants with forces are given: all of the paper's parameters count.
Velocity bench_velocity();
ContactLaw bench_law();

/// Ours. The first is what all others are compared with: the whole barycentric evaluation.
std::vector<ContestantEntry> engine_contestants();
std::vector<ContestantEntry> oracle_contestants();
/// The algorithms that the engine follows, with the same law.
std::vector<ContestantEntry> published_contestants();

/// One function a peer; its file is compiled where the peer is installed.
std::vector<ContestantEntry> cgal_contestants();
std::vector<ContestantEntry> embree_contestants();
std::vector<ContestantEntry> fcl_contestants();
std::vector<ContestantEntry> ode_contestants();
std::vector<ContestantEntry> simbody_contestants();

/// Everybody in the order of the tables; those that are not installed too, without `make`.
std::vector<ContestantEntry> contestants();

}  // namespace pcm::compare
