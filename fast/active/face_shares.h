// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "fast/active/intersection.h"
#include "fast/base/shares.h"
#include "fast/posed/posed_team.h"

namespace pcm::fast {

/// The active faces of a side, in shares for threads, each of which appends what it finds to lists of its own, in an
/// `OfThread`. Then all of it can be read in the order of the faces, whoever found it.
template <class OfThread>
class FaceShares {
 public:
  /// Makes a `Find(intersection, side, problem, own)` in each thread of the team, for its posed pair and what is its
  /// own, and calls that with one share of faces after the other; its `found()` is the length of the thread's lists.
  template <class Find, class Problem>
  void find(const Intersection& intersection, Side side, const Problem& problem, std::size_t faces_at_once,
            PosedTeam& team) {
    faces_.clear();
    for_each_active_face(intersection, side, [this](Index face) { faces_.push_back(face); });
    Shares shares(faces_.size(), faces_at_once);
    ranges_.resize(shares.shares());
    taking_part_ = std::min(team.threads(), shares.shares());
    if (of_threads_.size() < taking_part_) of_threads_.resize(taking_part_);
    const auto take_part = [&](std::size_t thread, PosedPair& own_posed) {
      Find find({own_posed, intersection.crossings, intersection.active}, side, problem, of_threads_[thread]);
      for (Shares::Share share = shares.take(); !share.empty(); share = shares.take()) {
        const std::size_t before = find.found();
        find({faces_.data() + share.begin, share.end - share.begin});
        ranges_[share.number] = {thread, before, find.found()};
      }
    };
    team.run(taking_part_, intersection.posed, std::cref(take_part));
  }

  /// Of those that took part.
  std::span<const OfThread> of_threads() const { return {of_threads_.data(), taking_part_}; }
  /// Calls `visit(own, i)` for entry i of a thread's lists, in the order of the faces.
  template <class Visit>
  void for_each_found(const Visit& visit) const {
    for (const Range& range : ranges_) {
      for (std::size_t i = range.begin; i < range.end; ++i) visit(of_threads_[range.thread], i);
    }
  }

 private:
  struct Range {
    std::size_t thread, begin, end;
  };

  std::vector<Index> faces_;
  std::vector<Range> ranges_;
  std::vector<OfThread> of_threads_;
  std::size_t taking_part_ = 0;
};

}  // namespace pcm::fast
