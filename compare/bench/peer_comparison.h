// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/bench/bodies.h"
#include "compare/bench/peer.h"
#include "compare/bench/timing.h"
#include "compare/io/table.h"

/// `pcm bench peers`: everybody on the same surfaces at the same poses, pose by pose in turn.
namespace pcm::compare {

/// What a peer needed over all poses of a body.
struct PeerResult {
  PeerEntry entry;
  double setup_ms = 0;          ///< of both surfaces
  std::vector<Timing> timings;  ///< by pose
  double found = 0;             ///< mean over the poses

  double median_us() const;
  double p95_us() const;
  double median_preparation_us() const;
};

/// One body at one distance.
struct PeerComparison {
  std::string body;
  std::size_t faces = 0;  ///< of one of the two surfaces
  Distance distance = Distance::touching;
  std::vector<PeerResult> peers;  ///< the first is the whole barycentric evaluation
};

/// `progress` is told what comes next.
std::vector<PeerComparison> compare_peers(const std::vector<BenchBody>& bodies, std::int64_t poses,
                                          const std::function<void(const std::string&)>& progress);

/// All results in one table. Ratios are of medians, to `everything` and to `force and torque` of the barycentric
/// engine; setup and preparation are not in them.
Table peers_table(const std::vector<PeerComparison>& results);
/// For a screen, bodies side by side; and in Markdown, with all there is to know.
std::string peers_screen(const std::vector<PeerComparison>& results, const Machine& machine);
std::string peers_markdown(const std::vector<PeerComparison>& results, const Machine& machine);

}  // namespace pcm::compare
