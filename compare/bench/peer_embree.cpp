// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/peer.h"
#include "compare/peers/embree_pair.h"

namespace pcm::compare {
namespace {

class Embree final : public Peer {
 public:
  Embree(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : pair_(mesh_E, mesh_F) {}

  void prepare(const Pose& pose) override { pair_.place(pose); }
  std::int64_t query(const Pose& /*pose*/) override { return std::ssize(pair_.collide()); }

 private:
  EmbreePair pair_;
};

}  // namespace

std::vector<PeerEntry> embree_peers() {
  return {{"Embree " RTC_VERSION_STRING, "rtcCollide: pairs", "pairs", "libembree-dev", true,
           [](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
             return std::make_unique<Embree>(mesh_E, mesh_F);
           }}};
}

}  // namespace pcm::compare
