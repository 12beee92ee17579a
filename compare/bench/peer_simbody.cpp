// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/peer.h"
#include "compare/peers/simbody_foundation.h"

namespace pcm::compare {
namespace {

class Simbody final : public Peer {
 public:
  Simbody(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : foundation_(mesh_E, mesh_F, bench_law()) {}

  std::int64_t query(const Pose& pose) override {
    foundation_.place(pose, bench_velocity());
    const auto faces = foundation_.faces();
    return faces ? static_cast<std::int64_t>(faces->E.size()) : 0;
  }

 private:
  SimbodyFoundation foundation_;
};

}  // namespace

std::vector<PeerEntry> simbody_peers() {
  return {{"Simbody 3.7", "elastic foundation", "faces", "libsimbody-dev", true,
           [](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
             return std::make_unique<Simbody>(mesh_E, mesh_F);
           }}};
}

}  // namespace pcm::compare
