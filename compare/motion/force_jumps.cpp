// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/force_jumps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/motion/continuous_change.h"
#include "compare/motion/flush_places.h"

namespace pcm::compare {
namespace {

/// Walks one segment after the other; see `walk`.
class Walker {
 public:
  Walker(const fast::Pairing& pairing, const PosePath& path, const JumpSearch& search)
      : force_(pairing, path), bound_(pairing), steps_(search.steps), clipped_(pairing.scheme() == Scheme::clipped) {
    double greatest = 0;
    for (std::size_t i = 0; i < path.segments().size(); ++i)
      for (std::int64_t k = 0; k <= steps_; ++k)
        greatest = std::max(greatest, force_.at({i, tick(k)}).force_Me.stableNorm());
    least_ = search.least * greatest;
  }

  void walk_segment(std::size_t segment) {
    const fast::Pairing& pairing = force_.pairing();
    flush_ = {};
    if (clipped_)
      flush_ = flush_places(pairing.surface_E().mesh(), pairing.surface_F().mesh(), force_.path().segments()[segment]);
    const std::vector<Cut> cuts = cuts_of_segment();
    PathSample from = force_.at({segment, 0});
    add_point(from, true, false);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      PathSample to = force_.at({segment, cuts[i].tick});
      walk_.most_too_deep = std::max({walk_.most_too_deep, from.too_deep, to.too_deep});
      if (cuts[i].after_flush)
        add_point(to, false, add_jump(from, to, true));
      else
        walk_step(std::move(from), to);
      walk_.points.back().step = cuts[i].step;
      from = std::move(to);
    }
  }

  PathWalk finished() {
    walk_.evaluations = force_.evaluations();
    return std::move(walk_);
  }

 private:
  /// kGrid k / steps, rounded down.
  std::int64_t tick(std::int64_t k) const { return kGrid / steps_ * k + kGrid % steps_ * k / steps_; }

  /// A place at which the walk is to stop.
  struct Cut {
    std::int64_t tick = 0;
    bool step = false;         ///< one of the steps asked for
    bool after_flush = false;  ///< before it lies a flush place
  };

  /// Steps, and both sides of flush places, as near as rounding tells: within, the answer is one of chance.
  std::vector<Cut> cuts_of_segment() const {
    std::vector<Cut> cuts;
    const auto tick_at = [](double share) {
      return static_cast<std::int64_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(kGrid));
    };
    for (const FlushPlace& place : flush_.places) {
      const std::int64_t before = tick_at(place.share - place.error), after = tick_at(place.share + place.error);
      if (cuts.empty() || cuts.back().tick < before) cuts.push_back({before, false, false});
      if (cuts.back().tick < after) cuts.push_back({after, false, true});
    }
    const std::size_t flush_cuts = cuts.size();
    for (std::int64_t k = 0; k <= steps_; ++k) {
      const std::int64_t step = tick(k);
      const auto next = std::lower_bound(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(flush_cuts), step,
                                         [](const Cut& cut, std::int64_t t) { return cut.tick < t; });
      const bool is_cut = next != cuts.begin() + static_cast<std::ptrdiff_t>(flush_cuts);
      if (is_cut && next->tick == step)
        next->step = true;
      else if (!is_cut || !next->after_flush)
        cuts.push_back({step, true, false});
    }
    std::sort(cuts.begin(), cuts.end(), [](const Cut& x, const Cut& y) { return x.tick < y.tick; });
    return cuts;
  }

  /// Halves the step where it must; adds every place looked at, but the first.
  void walk_step(PathSample from, const PathSample& to) {
    std::vector<PathSample> ahead{to};  // the nearest last
    while (!ahead.empty()) {
      const std::int64_t width = ahead.back().where.tick - from.where.tick;
      const bool suspicious = must_be_split(from, ahead.back());
      if (suspicious && width > 1) {
        ahead.push_back(force_.at({from.where.segment, from.where.tick + width / 2}));
        continue;
      }
      const bool jump = suspicious && add_jump(from, ahead.back(), flush_.all_along);
      from = std::move(ahead.back());
      ahead.pop_back();
      add_point(from, false, jump);
    }
  }

  void add_point(const PathSample& sample, bool step, bool after_jump) {
    walk_.points.push_back({sample.where, sample.pose.r, sample.force_Me, sample.torque_Me, step, after_jump});
  }

  /// Calls `visit(before, after)` for every face that carries something on either side.
  template <class Visit>
  static void for_each_face(const PathSample& a, const PathSample& b, const Visit& visit) {
    std::size_t i = 0, j = 0;
    while (i < a.loads.size() || j < b.loads.size()) {
      const bool only_a = j == b.loads.size() || (i < a.loads.size() && a.loads[i].before(b.loads[j]));
      const bool only_b = !only_a && (i == a.loads.size() || b.loads[j].before(a.loads[i]));
      FaceLoad before, after;
      if (!only_b) before = a.loads[i++];
      if (!only_a) after = b.loads[j++];
      FaceLoad& idle = only_a ? after : before;
      if (only_a || only_b) {
        idle.master = (only_a ? before : after).master;
        idle.face = (only_a ? before : after).face;
      }
      visit(before, after);
    }
  }

  /// The discrete fact about a face.
  bool changed(const FaceLoad& before, const FaceLoad& after) const {
    if (clipped_) return before.slave_faces.empty() != after.slave_faces.empty();
    return before.slave_faces != after.slave_faces;
  }

  bool beyond_continuity(const PathSample& a, const PathSample& b, const FaceLoad& before,
                         const FaceLoad& after) const {
    return bound_.change(before, after) > std::max(least_, bound_(a.pose, b.pose, before, after));
  }

  bool must_be_split(const PathSample& a, const PathSample& b) const {
    bool split = false;
    for_each_face(a, b, [&](const FaceLoad& before, const FaceLoad& after) {
      if (split) return;
      if (changed(before, after) && !passed_common_edge(a, b, before, after))
        split = bound_.change(before, after) > least_;
      else if (flush_.all_along)
        split = beyond_continuity(a, b, before, after);
    });
    return split;
  }

  /// The line moved to a slave face that shares an edge with the one before, and the force as far as it may by that.
  bool passed_common_edge(const PathSample& a, const PathSample& b, const FaceLoad& before,
                          const FaceLoad& after) const {
    if (clipped_ || before.slave_faces.empty() || after.slave_faces.empty()) return false;
    const fast::Pairing& pairing = force_.pairing();
    const TriangleMesh& slave = (before.master == Side::E ? pairing.surface_F() : pairing.surface_E()).mesh();
    const Triangle& f = slave.faces[static_cast<std::size_t>(before.slave_faces.front())];
    const Triangle& g = slave.faces[static_cast<std::size_t>(after.slave_faces.front())];
    const auto shared =
        std::count_if(f.begin(), f.end(), [&](Index v) { return std::find(g.begin(), g.end(), v) != g.end(); });
    return shared == 2 && !beyond_continuity(a, b, before, after);
  }

  /// `flush`: any face may jump in between, not only those that begin or end to carry something.
  bool add_jump(const PathSample& a, const PathSample& b, bool flush) {
    ForceJump jump;
    for_each_face(a, b, [&](const FaceLoad& before, const FaceLoad& after) {
      if (!changed(before, after) && !flush) return;
      if (!beyond_continuity(a, b, before, after)) return;
      jump.force_Me += after.force_Me - before.force_Me;
      jump.torque_Me += after.torque_Me - before.torque_Me;
      jump.faces.push_back({before, after, cause_of(a, b, before, after, flush), bound_.change(before, after),
                            bound_(a.pose, b.pose, before, after)});
    });
    if (jump.faces.empty()) return false;
    jump.before = a.where;
    jump.after = b.where;
    jump.pose_before = a.pose;
    jump.pose_after = b.pose;
    jump.force_there = std::max(a.force_Me.stableNorm(), b.force_Me.stableNorm());
    std::stable_sort(jump.faces.begin(), jump.faces.end(), [](const FaceJump& x, const FaceJump& y) {
      return x.force_Me().stableNorm() > y.force_Me().stableNorm();
    });
    walk_.jumps.push_back(std::move(jump));
    return true;
  }

  JumpCause cause_of(const PathSample& a, const PathSample& b, const FaceLoad& before, const FaceLoad& after,
                     bool flush) {
    if (!before.slave_faces.empty() && !after.slave_faces.empty())
      return clipped_ ? (flush ? JumpCause::flush : JumpCause::other) : JumpCause::edge;
    const PathSample& idle_side = before.slave_faces.empty() ? a : b;
    force_.at(idle_side.where);
    const IdleFace idle = force_.why_idle(before.master, before.face);
    if (flush || (idle.first_met >= 0 && bound_.flush(idle_side.pose, before.master, before.face, idle.first_met)))
      return JumpCause::flush;
    if (idle.why == IdleFace::Why::inactive) return JumpCause::activity;
    if (clipped_) return JumpCause::other;
    return idle.why == IdleFace::Why::too_deep ? JumpCause::depth : JumpCause::entry;
  }

  PathForce force_;
  ContinuousChange bound_;
  std::int64_t steps_;
  bool clipped_;
  double least_ = 0;  ///< N
  FlushPlaces flush_;
  PathWalk walk_;
};

}  // namespace

std::string_view name(JumpCause cause) {
  switch (cause) {
    case JumpCause::edge:
      return "edge";
    case JumpCause::entry:
      return "entry";
    case JumpCause::activity:
      return "activity";
    case JumpCause::depth:
      return "depth";
    case JumpCause::flush:
      return "flush";
    case JumpCause::other:
      return "other";
  }
  return "";
}

std::string_view describe(JumpCause cause) {
  switch (cause) {
    case JumpCause::edge:
      return "line passed a slave edge";
    case JumpCause::entry:
      return "barycentre entered or left slave";
    case JumpCause::activity:
      return "face became active or inactive";
    case JumpCause::depth:
      return "line leaves master first";
    case JumpCause::flush:
      return "flush faces";
    case JumpCause::other:
      return "other";
  }
  return "";
}

PathWalk walk(const fast::Pairing& pairing, const PosePath& path, const JumpSearch& search,
              const std::function<void(std::size_t)>& progress) {
  Walker walker(pairing, path, search);
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    if (progress) progress(i);
    walker.walk_segment(i);
  }
  return walker.finished();
}

}  // namespace pcm::compare
