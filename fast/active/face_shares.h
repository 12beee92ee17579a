// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "fast/active/intersection.h"
#include "fast/base/shares.h"
#include "fast/posed/posed_team.h"

namespace pcm::fast {

/// The active faces of a side, in shares for threads, each of which appends what it finds to a list of its own. Then
/// all of it can be read in the order of the faces, whoever found it.
class FaceShares {
 public:
  /// Lists the faces.
  void start(const Intersection& intersection, Side side, std::size_t faces_at_once) {
    at_once_ = faces_at_once;
    faces_.clear();
    for_each_active_face(intersection, side, [this](Index face) { faces_.push_back(face); });
  }

  /// Makes `find_of(thread, intersection)` in each thread of the team, for the posed pair of its own, and calls that
  /// with one share of faces after the other; its `found()` is the length of the thread's list.
  template <class FindOf>
  void find(const Intersection& intersection, PosedTeam& team, const FindOf& find_of) {
    Shares shares(faces_.size(), at_once_);
    ranges_.resize(shares.shares());
    const auto take_part = [&](std::size_t thread, PosedPair& own_posed) {
      auto find = find_of(thread, Intersection{own_posed, intersection.crossings, intersection.active});
      for (Shares::Share share = shares.take(); !share.empty(); share = shares.take()) {
        const std::size_t before = find.found();
        find({faces_.data() + share.begin, share.end - share.begin});
        ranges_[share.number] = {thread, before, find.found()};
      }
    };
    team.run(team.threads(), intersection.posed, std::cref(take_part));
  }

  /// Calls `visit(thread, begin, end)`: what lies there in the thread's list is next in the order of the faces.
  template <class Visit>
  void for_each_range(const Visit& visit) const {
    for (const Range& range : ranges_) visit(range.thread, range.begin, range.end);
  }

 private:
  struct Range {
    std::size_t thread, begin, end;
  };

  std::size_t at_once_ = 1;
  std::vector<Index> faces_;
  std::vector<Range> ranges_;
};

}  // namespace pcm::fast
