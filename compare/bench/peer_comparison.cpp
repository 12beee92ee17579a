// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/peer_comparison.h"

#include <fmt/core.h>

#include <memory>

namespace pcm::compare {
namespace {

/// How many passes at most, the one that warms up among them, and after how long no more.
constexpr int kPasses = 6;
constexpr double kEnoughUs = 5e6;

/// A peer set up for a body, and all of its times.
struct RunningPeer {
  PeerResult result;
  std::unique_ptr<Peer> peer;               ///< none where this build lacks it
  std::vector<std::vector<Timing>> passes;  ///< by pass and pose
  double used_us = 0;
};

std::vector<RunningPeer> set_up(const BenchBody& body, Distance distance) {
  std::vector<RunningPeer> running;
  for (PeerEntry& entry : all_peers()) {
    if (distance == Distance::separated && !entry.separated_too) continue;
    RunningPeer& added = running.emplace_back();
    double setup_us = 0;
    if (entry.make) setup_us = least_time_us([&] { added.peer = entry.make(body.mesh, body.mesh); });
    added.result = {std::move(entry), 1e-3 * setup_us, {}, 0};
  }
  return running;
}

void ask_each_pose_once(const std::vector<Pose>& poses, RunningPeer& running) {
  std::vector<Timing>& pass = running.passes.emplace_back();
  std::int64_t found = 0;
  for (const Pose& pose : poses) {
    const double preparation_us = time_us([&] { running.peer->prepare(pose); });
    pass.push_back({preparation_us, time_us([&] { found += running.peer->query(pose); })});
    running.used_us += pass.back().preparation_us + pass.back().query_us;
  }
  running.result.found = static_cast<double>(found) / static_cast<double>(poses.size());
}

/// Over the passes but the first, which warms up, where there are others.
double median_over_passes(const RunningPeer& running, std::size_t pose, double Timing::*time) {
  std::vector<double> values;
  for (std::size_t pass = running.passes.size() > 1 ? 1 : 0; pass < running.passes.size(); ++pass)
    values.push_back(running.passes[pass][pose].*time);
  return quantile(std::move(values), 0.5);
}

void summarize(const std::vector<Pose>& poses, RunningPeer& running) {
  for (std::size_t p = 0; p < poses.size(); ++p) {
    const Timing repeated =
        least_time([&] { running.peer->prepare(poses[p]); }, [&] { running.peer->query(poses[p]); });
    running.result.timings.push_back(
        {{median_over_passes(running, p, &Timing::preparation_us), median_over_passes(running, p, &Timing::query_us)},
         repeated.query_us});
  }
}

PeerComparison run_body(const BenchBody& body, Distance distance, std::int64_t number) {
  const std::vector<Pose> poses = bench_poses(body.mesh, distance, number);
  std::vector<RunningPeer> all = set_up(body, distance);
  for (int pass = 0; pass < kPasses; ++pass)
    for (RunningPeer& running : all)
      if (running.peer && running.used_us < kEnoughUs) ask_each_pose_once(poses, running);

  PeerComparison result{body.name, body.mesh.faces.size(), distance, {}};
  for (RunningPeer& running : all) {
    if (running.peer) summarize(poses, running);
    result.peers.push_back(std::move(running.result));
  }
  return result;
}

template <typename Time>
double quantile_over_poses(const std::vector<PoseTiming>& timings, double part, const Time& time) {
  std::vector<double> values;
  values.reserve(timings.size());
  for (const PoseTiming& timing : timings) values.push_back(time(timing));
  return quantile(std::move(values), part);
}

}  // namespace

double PeerResult::median_us() const {
  return quantile_over_poses(timings, 0.5, [](const PoseTiming& t) { return t.fresh.query_us; });
}

double PeerResult::p95_us() const {
  return quantile_over_poses(timings, 0.95, [](const PoseTiming& t) { return t.fresh.query_us; });
}

double PeerResult::median_preparation_us() const {
  return quantile_over_poses(timings, 0.5, [](const PoseTiming& t) { return t.fresh.preparation_us; });
}

double PeerResult::median_repeated_us() const {
  return quantile_over_poses(timings, 0.5, [](const PoseTiming& t) { return t.repeated_us; });
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
