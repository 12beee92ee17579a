// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/peer.h"
#include "compare/published/algorithm_2003.h"
#include "compare/published/algorithm_2023.h"
#include "compare/verify/routes/wanted_presets.h"

namespace pcm::compare {
namespace {

/// Lines of a fifth of the body: twice as deep as the poses, for longer ones cost more.
constexpr double kGreatestDepth = 0.2;

class Algorithm2003Peer final : public Peer {
 public:
  Algorithm2003Peer(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)
      : algorithm_(mesh_E, mesh_F, bench_law(), Mode::E) {}

  std::int64_t query(const Pose& pose) override {
    return algorithm_.evaluate(pose, bench_velocity(), kForceOnly, workspace_).work.crossing_pairs;
  }

 private:
  published::Algorithm2003 algorithm_;
  published::Workspace workspace_;
};

class Algorithm2023Peer final : public Peer {
 public:
  Algorithm2023Peer(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)
      : algorithm_(mesh_E, mesh_F, bench_law(), Mode::E, kGreatestDepth * published::Surface(mesh_E).size) {}

  std::int64_t query(const Pose& pose) override {
    return algorithm_.evaluate(pose, bench_velocity(), kForceOnly, workspace_).element_count;
  }

 private:
  published::Algorithm2023 algorithm_;
  published::Workspace workspace_;
};

template <class Published>
PeerEntry entry(const char* who, const char* finds) {
  return {who, "force and torque", finds, "", true, [](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
            return std::make_unique<Published>(mesh_E, mesh_F);
          }};
}

}  // namespace

std::vector<PeerEntry> published_peers() {
  return {entry<Algorithm2003Peer>("as published 2003", "pairs"),
          entry<Algorithm2023Peer>("as published 2023", "elements")};
}

}  // namespace pcm::compare
