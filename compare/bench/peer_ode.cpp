// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/peer.h"
#include "compare/peers/ode_pair.h"

namespace pcm::compare {
namespace {

class Ode final : public Peer {
 public:
  Ode(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : pair_(mesh_E, mesh_F) {}

  std::int64_t query(const Pose& pose) override { return pair_.collide(pose); }

 private:
  OpenOde open_;
  OdePair pair_;
};

}  // namespace

std::vector<PeerEntry> ode_peers() {
  return {
      {"ODE 0.16 trimesh", "contact points", "points", "libode-dev", true,
       [](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) { return std::make_unique<Ode>(mesh_E, mesh_F); }}};
}

}  // namespace pcm::compare
