// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/peer.h"
#include "compare/verify/routes/wanted_presets.h"
#include "pcm/engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

constexpr Wanted kEverything{};

class EnginePeer final : public Peer {
 public:
  EnginePeer(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Scheme scheme, const Wanted& wanted)
      : pairing_(fast::Surface(mesh_E), fast::Surface(mesh_F), bench_law(), Mode::E, scheme), wanted_(wanted) {}

  std::int64_t query(const Pose& pose) override {
    return fast::evaluate(pairing_, pose, bench_velocity(), wanted_, workspace_).work.crossing_pairs;
  }

 private:
  fast::Pairing pairing_;
  fast::Workspace workspace_;
  Wanted wanted_;
};

class OraclePeer final : public Peer {
 public:
  OraclePeer(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, reference::Problem problem)
      : oracle_(mesh_E, mesh_F, bench_law(), Mode::E), problem_(problem) {}

  std::int64_t query(const Pose& pose) override {
    std::int64_t pairs = 0;
    for (const reference::Polygon& polygon : oracle_.answer(problem_, pose, bench_velocity()).polygons)
      pairs += static_cast<std::int64_t>(polygon.points.size()) - (polygon.closed ? 0 : 1);
    return pairs;
  }

 private:
  reference::Oracle oracle_;
  reference::Problem problem_;
};

PeerEntry engine(const char* who, const char* computes, Scheme scheme, const Wanted& wanted) {
  return {who, computes, "pairs", "", true, [=](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
            return std::make_unique<EnginePeer>(mesh_E, mesh_F, scheme, wanted);
          }};
}

PeerEntry oracle(const char* who, reference::Problem problem) {
  return {who, "everything", "pairs", "", false, [=](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
            return std::make_unique<OraclePeer>(mesh_E, mesh_F, problem);
          }};
}

}  // namespace

std::vector<PeerEntry> engine_peers() {
  return {engine("pcm barycentric", "everything", Scheme::barycentric, kEverything),
          engine("pcm barycentric", "force and torque", Scheme::barycentric, kForceOnly),
          engine("pcm barycentric", "force, torque, their derivatives", Scheme::barycentric, kForceAndTangent),
          engine("pcm clipped", "everything", Scheme::clipped, kEverything),
          engine("pcm clipped", "force and torque", Scheme::clipped, kForceOnly),
          engine("pcm clipped", "force, torque, their derivatives", Scheme::clipped, kForceAndTangent),
          engine("pcm", "polygons, patches", Scheme::barycentric, kPolygonsOnly),
          engine("pcm", "touch only", Scheme::barycentric, kTouchOnly)};
}

std::vector<PeerEntry> oracle_peers() {
  return {oracle("pcm oracle, rounded", reference::Problem::rounded),
          oracle("pcm oracle, exact", reference::Problem::exact)};
}

}  // namespace pcm::compare
