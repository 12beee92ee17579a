// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/peer_comparison.h"

#include <fmt/core.h>

#include <memory>

namespace pcm::compare {
namespace {

double quantile_of(const std::vector<Timing>& timings, double Timing::*time, double part) {
  std::vector<double> values;
  values.reserve(timings.size());
  for (const Timing& timing : timings) values.push_back(timing.*time);
  return quantile(std::move(values), part);
}

PeerComparison run_body(const BenchBody& body, Distance distance, std::int64_t number) {
  PeerComparison result{body.name, body.mesh.faces.size(), distance, {}};
  std::vector<std::unique_ptr<Peer>> running;
  for (PeerEntry& entry : all_peers()) {
    if (distance == Distance::separated && !entry.separated_too) continue;
    running.emplace_back();
    double setup_us = 0;
    if (entry.make) setup_us = least_time_us([&] { running.back() = entry.make(body.mesh, body.mesh); });
    result.peers.push_back({std::move(entry), 1e-3 * setup_us, {}, 0});
  }
  for (const Pose& pose : bench_poses(body.mesh, distance, number))
    for (std::size_t c = 0; c < running.size(); ++c) {
      if (!running[c]) continue;
      std::int64_t found = 0;
      result.peers[c].timings.push_back(
          least_time([&] { running[c]->prepare(pose); }, [&] { found = running[c]->query(pose); }));
      result.peers[c].found += static_cast<double>(found) / static_cast<double>(number);
    }
  return result;
}

}  // namespace

double PeerResult::median_us() const {
  return quantile_of(timings, &Timing::query_us, 0.5);
}

double PeerResult::p95_us() const {
  return quantile_of(timings, &Timing::query_us, 0.95);
}

double PeerResult::median_preparation_us() const {
  return quantile_of(timings, &Timing::preparation_us, 0.5);
}

std::vector<PeerComparison> compare_peers(const std::vector<BenchBody>& bodies, std::int64_t poses,
                                          const std::function<void(const std::string&)>& progress) {
  std::vector<PeerComparison> results;
  for (const BenchBody& body : bodies)
    for (const Distance distance : {Distance::touching, Distance::separated}) {
      progress(body.description + (distance == Distance::touching ? ", touching" : ", separated"));
      results.push_back(run_body(body, distance, poses));
    }
  return results;
}

}  // namespace pcm::compare
