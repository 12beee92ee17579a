// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/barycentric/barycentric_elements.h"

#include <algorithm>
#include <array>
#include <span>

namespace pcm::fast {

namespace {

/// From so many faces on threads have enough to do: these take some 200 us.
constexpr std::size_t kEnoughForThreads = 2048;
/// Whoever finds some of them knows where neighbours' lines are; shares are whole lanes.
constexpr std::size_t kFacesAtOnce = 256;
static_assert(kFacesAtOnce % kElementLanes == 0);

/// Elements before the law: those of up to kElementLanes faces at a time, in the lanes of the scratch.
class ElementSearch {
 public:
  ElementSearch(const Intersection& intersection, Side master, const ForceProblem& problem, BarycentricSearch& scratch,
                LineMemory* memory)
      : posed_(intersection.posed), master_(master), problem_(problem), scratch_(scratch), memory_(memory) {
    scratch.walks.start(posed_, intersection.crossings, master);
    if (memory != nullptr) memory->note_vertex_error(posed_.placement.vertex_error(master));
  }

  /// The lanes that hold an element; `of` tells of their faces.
  LaneBits find(const FaceBatch& faces, std::size_t count, std::array<ElementFaces, kElementLanes>& of) {
    ElementLanes& lanes = scratch_.lanes;
    std::array<Penetration, kElementLanes> found;
    RememberedLines lines{};
    if (memory_ != nullptr) {
      for (std::size_t lane = 0; lane < count; ++lane) lines[lane] = memory_->recall(faces[lane]);
    }
    posed_.work.lines += static_cast<std::int64_t>(count);
    if (are_settled(lines, count)) {
      posed_.work.lines_settled += static_cast<std::int64_t>(count);
      if (!keep_settled(lines, count)) return 0;
      find_settled(posed_, master_, faces, count, lines, lanes, found);
    } else {
      find_geometry(posed_, master_, faces, count, lanes);
      find_penetrations(posed_, master_, faces, count, lanes, scratch_.walks, memory_, lines, found);
    }
    LaneBits elements = 0;
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (found[lane].outcome == Penetration::Outcome::too_deep) ++too_deep_;
      if (found[lane].outcome == Penetration::Outcome::element) elements |= 1U << lane;
      lanes.depth.value[lane] = std::min(found[lane].depth, problem_.law.max_penetration);
      of[lane] = {faces[lane], found[lane].slave_face, found[lane].depth};
    }
    if (problem_.with_tangent && elements != 0) find_gradients(found, elements);
    return elements;
  }
  /// Of all faces so far.
  Index too_deep() const { return too_deep_; }

 private:
  bool are_settled(const RememberedLines& lines, std::size_t count) const {
    return scratch_.walks.may_walk && std::all_of(lines.begin(), lines.begin() + count, [this](const auto* line) {
             return line != nullptr && memory_->is_settled(*line);
           });
  }
  /// Goes on to remember them; whether some have an element.
  bool keep_settled(const RememberedLines& lines, std::size_t count) {
    bool some = false;
    for (std::size_t lane = 0; lane < count; ++lane) {
      memory_->keep(*lines[lane]);
      some = some || lines[lane]->element_on >= 0;
    }
    return some;
  }
  void find_gradients(const std::array<Penetration, kElementLanes>& found, LaneBits elements) {
    ElementLanes& lanes = scratch_.lanes;
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      enter_corners(posed_, opposite(master_), found[one_of(elements, lane)].slave_face, lanes.slave_corners, lane);
    }
    fastest_wide_elements().gradient(lanes);
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      const bool clamped = found[lane].depth >= problem_.law.max_penetration;
      if (has_lane(elements, lane) && clamped) lanes.depth_gradient_Me.set(lane, Eigen::Vector3d::Zero());
    }
  }

  PosedPair& posed_;
  Side master_;
  const ForceProblem& problem_;
  BarycentricSearch& scratch_;
  LineMemory* memory_;
  Index too_deep_ = 0;
};

/// What one thread finds of its shares: loads where they alone are wanted, else elements before the law.
class SearchOfThread {
 public:
  SearchOfThread(const Intersection& intersection, Side master, const ForceProblem& problem, BarycentricOfThread& own)
      : search_(intersection, master, problem, own.search, nullptr),
        law_(problem, master),
        counter_(problem, own.record, intersection.posed.work),
        loads_alone_(wants_loads_alone(problem)),
        own_(own) {
    own.loads.clear();
    own.found.clear();
    own.record.clear();
  }

  std::size_t found() const { return loads_alone_ ? own_.loads.size() : own_.found.size(); }
  void operator()(std::span<const Index> faces) {
    FaceBatch batch{};
    std::array<ElementFaces, kElementLanes> of{};
    for (std::size_t i = 0; i < faces.size(); i += kElementLanes) {
      const std::size_t count = std::min(kElementLanes, faces.size() - i);
      std::copy_n(faces.begin() + static_cast<std::ptrdiff_t>(i), count, batch.begin());
      const LaneBits which = search_.find(batch, count, of);
      if (which != 0) keep(of, which);
    }
    own_.record.too_deep = search_.too_deep();
  }

 private:
  void keep(const std::array<ElementFaces, kElementLanes>& of, LaneBits which) {
    ElementLanes& lanes = own_.search.lanes;
    if (!loads_alone_) {
      own_.found.push_back({lanes, of, which});
      return;
    }
    law_.apply(of, which, lanes);
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      if (has_lane(which, lane)) counter_.count(of[lane].greatest_penetration);
    }
    own_.loads.push_back({lanes.force_Me, lanes.torque_Me, which});
  }

  ElementSearch search_;
  LawForLanes law_;
  ElementSum counter_;
  bool loads_alone_;
  BarycentricOfThread& own_;
};

MasterForce sum_by_threads(const Intersection& intersection, Side master, const ForceProblem& problem, PosedTeam& team,
                           BarycentricScratch& scratch, ElementRecord& record) {
  scratch.shares.find<SearchOfThread>(intersection, master, problem, kFacesAtOnce, team);
  for (const BarycentricOfThread& own : scratch.shares.of_threads()) record.add(own.record);
  ElementQueue queue(problem, master, record, intersection.posed.work, scratch.search.lanes);
  const bool loads_alone = wants_loads_alone(problem);
  scratch.shares.for_each_found([&](const BarycentricOfThread& own, std::size_t i) {
    if (loads_alone) {
      queue.add_loads(own.loads[i]);
    } else {
      queue.add_kept(own.found[i]);
    }
  });
  return queue.total();
}

}  // namespace

MasterForce sum_barycentric_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                     PosedTeam& team, BarycentricScratch& scratch, LineMemory* memory,
                                     ElementRecord& record) {
  const bool for_threads = team.threads() > 1 && intersection.active_faces(master) >= kEnoughForThreads;
  if (for_threads && memory == nullptr) return sum_by_threads(intersection, master, problem, team, scratch, record);
  ElementSearch search(intersection, master, problem, scratch.search, memory);
  ElementQueue queue(problem, master, record, intersection.posed.work, scratch.search.lanes);
  FaceBatch faces{};
  std::size_t count = 0;
  const auto form_elements = [&] {
    queue.add_lanes(search.find(faces, count, queue.faces()));
    count = 0;
  };
  for_each_active_face(intersection, master, [&](Index face) {
    faces[count++] = face;
    if (count == kElementLanes) form_elements();
  });
  if (count > 0) form_elements();
  record.too_deep += search.too_deep();
  return queue.total();
}

}  // namespace pcm::fast
