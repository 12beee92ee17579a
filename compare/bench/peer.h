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
/// A peer of `pcm bench peers` takes a file peer_NAME.cpp; its function below; its lines in peer_list.cpp, without
/// which it is built and not asked; pcm_add_peer in CMakeLists.txt; its package in `run` and its row in
/// docs/performance.md. How its surfaces are set up stands in compare/peers, for it may be a contestant of `pcm judge`
/// too (compare/contestants/contestant.h).
namespace pcm::compare {

/// One that is timed in the table, ours included, set up for two surfaces.
class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;

  /// What must happen before each query where a peer takes no pose but only surfaces in place. Measured apart.
  virtual void prepare(const Pose& /*pose*/) {}
  /// Answers for F at this pose; returns how many of `PeerEntry::finds` there are.
  virtual std::int64_t query(const Pose& pose) = 0;
};

/// The two kinds of poses that a peer may be asked about.
enum class Distance : std::uint8_t { touching, separated };

/// A peer by name.
struct PeerEntry {
  std::string who;
  std::string computes;
  std::string finds;           ///< what `query` counts
  std::string debian_package;  ///< empty for what is always there
  bool separated_too = true;   ///< also asked about separated surfaces
  /// Empty where the program was built without the package.
  std::function<std::unique_ptr<Peer>(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)> make = {};
};

/// The motion and the law that peers with forces are given: all of the paper's parameters count.
Velocity bench_velocity();
ContactLaw bench_law();

/// Ours. The first is what all others are compared with: the whole barycentric evaluation.
std::vector<PeerEntry> engine_peers();
std::vector<PeerEntry> oracle_peers();
/// The algorithms that the engine follows, with the same law.
std::vector<PeerEntry> published_peers();

/// One function a peer; its file is compiled where the peer is installed.
std::vector<PeerEntry> cgal_peers();
std::vector<PeerEntry> embree_peers();
std::vector<PeerEntry> fcl_peers();
std::vector<PeerEntry> ode_peers();
std::vector<PeerEntry> simbody_peers();

/// Everybody in the order of the tables; those that this build lacks too, without `make`.
std::vector<PeerEntry> all_peers();

}  // namespace pcm::compare
