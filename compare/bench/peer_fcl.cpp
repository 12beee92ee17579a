// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "compare/bench/peer.h"
#include "compare/peers/fcl_pair.h"

namespace pcm::compare {
namespace {

class Fcl final : public Peer {
 public:
  Fcl(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, std::size_t most_pairs)
      : pair_(mesh_E, mesh_F), most_pairs_(most_pairs) {}

  std::int64_t query(const Pose& pose) override {
    return static_cast<std::int64_t>(pair_.collide(pose, most_pairs_).numContacts());
  }

 private:
  FclPair pair_;
  std::size_t most_pairs_;
};

PeerEntry fcl_entry(const char* computes, std::size_t most_pairs) {
  return {"FCL " FCL_VERSION " OBBRSS",
          computes,
          "pairs",
          "libfcl-dev",
          true,
          [=](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
            return std::make_unique<Fcl>(mesh_E, mesh_F, most_pairs);
          }};
}

}  // namespace

std::vector<PeerEntry> fcl_peers() {
  return {fcl_entry("all triangle pairs", std::numeric_limits<std::size_t>::max()), fcl_entry("touch only", 1)};
}

}  // namespace pcm::compare
