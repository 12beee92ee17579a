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
#include "compare/io/tables/table.h"

/// `pcm bench peers`: everybody on the same surfaces at the same poses, in turn.
namespace pcm::compare {

/// What a peer needed at one pose.
struct PoseTiming {
  Timing fresh;            ///< medians over passes that ask each pose once, so that another pose was asked just before
  double repeated_us = 0;  ///< the least time of the same pose asked several times running
};

/// What a peer needed over all poses of a body.
struct PeerResult {
  PeerEntry entry;
  double setup_ms = 0;              ///< of both surfaces
  std::vector<PoseTiming> timings;  ///< by pose
  double found = 0;                 ///< mean over the poses

  /// Of fresh poses.
  double median_us() const;
  double p95_us() const;
  double median_preparation_us() const;
  double median_repeated_us() const;
};

/// One body at one distance.
struct PeerComparison {
  std::string body;
  std::size_t faces = 0;  ///< of one of the two surfaces
  Distance distance = Distance::touching;
  std::vector<PeerResult> peers;  ///< the first is the whole barycentric evaluation
};

/// Passes over all poses, everybody in turn in each: what a peer finds in the caches is what its query before left
/// there, at another pose, as in a simulation. The first pass of several is not counted. Whoever has used up five
/// seconds is left out of further passes. `progress` is told what comes next.
std::vector<PeerComparison> compare_peers(const std::vector<BenchBody>& bodies, std::int64_t poses,
                                          const std::function<void(const std::string&)>& progress);

/// All results in one table. Ratios are of medians over fresh poses, to `everything` and to `force and torque` of the
/// barycentric engine; setup and preparation are not in them.
Table peers_table(const std::vector<PeerComparison>& results);
/// For a screen, bodies side by side; and in Markdown, with all there is to know.
std::string peers_screen(const std::vector<PeerComparison>& results, const Machine& machine);
std::string peers_markdown(const std::vector<PeerComparison>& results, const Machine& machine);

}  // namespace pcm::compare
