// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/clipped_areas.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pcm::reference {
namespace {

int greatest_component_of_normal(const ExactPose& pose, Side side, Index face) {
  const auto [p0, p1, p2] = pose.corners<Exact>(side, face);
  const Vec3<Exact> normal = doubled_normal(p0, p1, p2);
  int axis = -1;
  Exact greatest(0);
  for (int c = 0; c < 3; ++c) {
    const Exact size = sign_of(normal[c]) < 0 ? -normal[c] : normal[c];
    if (size > greatest) {
      greatest = size;
      axis = c;
    }
  }
  return axis;
}

/// Clips the faces of one side.
class FaceClipper {
 public:
  FaceClipper(const ExactPose& pose, Side side, const ActiveFaces& active, const std::vector<IndexPair>& columns,
              std::vector<CrossingId>& ids, Index& undefined)
      : pose_(pose),
        side_(side),
        others_(pose.surface(other(side))),
        active_(active),
        columns_(columns),
        ids_(ids),
        undefined_(undefined) {}

  bool against_closed() const { return others_.closed; }

  /// A face without crossings: one winding number all over.
  FaceClip uncrossed(Index face) const {
    FaceClip clip = bare(face);
    const bool inner = std::binary_search(active_.inner.begin(), active_.inner.end(), face);
    clip.winding.fill(others_.closed ? active_.winding[pose_.face(side_, face)[0]] : inner ? 1 : 0);
    return clip;
  }

  /// A face in crossing pairs, under the plain tie rule.
  FaceClip intersected(Index face, const Crossings& crossings, const std::vector<const Segment*>& segments) const {
    FaceClip clip = bare(face);
    for (const Segment* segment : segments) {
      add_segment(clip, segment->start, segment->end);
      for (const Index point : {segment->start, segment->end}) add_edge_crossing(clip, point, crossings.deltas[point]);
    }
    const Triangle& t = pose_.face(side_, face);
    if (others_.closed)
      clip.winding = {active_.winding[t[0]], active_.winding[t[1]], active_.winding[t[2]]};
    else
      set_relative_winding(clip, labelled_inside(t));
    return clip;
  }

  /// A face with coplanar overlaps, the other surface closed: moved inward. Its crossings are appended to the common
  /// list.
  FaceClip moved_inward(Index face, const std::vector<Index>& others, std::vector<Index> overlaps) const {
    const Orientation orientation(pose_, ShiftedFace{side_, face});
    FaceClip clip = bare(face);
    clip.overlaps = std::move(overlaps);
    for (const Index f : others) {
      const std::vector<PairCrossing> pair =
          side_ == Side::E ? pair_crossings(orientation, face, f) : pair_crossings(orientation, f, face);
      if (pair.empty()) continue;
      const Index first = static_cast<Index>(ids_.size());
      for (const PairCrossing& crossing : pair) {
        ids_.push_back(crossing.id);
        add_edge_crossing(clip, static_cast<Index>(ids_.size()) - 1, crossing.delta);
      }
      add_segment(clip, pair[0].starts ? first : first + 1, pair[0].starts ? first + 1 : first);
    }
    const Triangle& t = pose_.face(side_, face);
    for (int i = 0; i < 3; ++i) clip.winding[i] = winding_number(orientation, {side_, t[i]}, columns_);
    return clip;
  }

 private:
  FaceClip bare(Index face) const {
    FaceClip clip;
    clip.face = face;
    clip.axis = greatest_component_of_normal(pose_, side_, face);
    clip.limited = !others_.closed;
    return clip;
  }

  /// Start and end in the circulation on E; seen from outside F the inside is on the right, so F's run backwards.
  void add_segment(FaceClip& clip, Index start, Index end) const {
    if (side_ == Side::E)
      clip.segments.push_back({start, end});
    else
      clip.segments.push_back({end, start});
  }

  /// If the crossing lies on an edge of this face, each pair with the other face meets it once.
  void add_edge_crossing(FaceClip& clip, Index crossing, int delta) const {
    const CrossingId& id = ids_[crossing];
    if (id.edge_side != side_) return;
    const Triangle& t = pose_.face(side_, clip.face);
    for (int i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      if (std::minmax(a, b) == std::minmax(id.edge[0], id.edge[1]))
        clip.on_edges.push_back({i, a < b ? delta : -delta, crossing});
    }
  }

  bool labelled_inside(const Triangle& t) const {
    const auto any = [&t](const std::vector<bool>& labels) { return labels[t[0]] || labels[t[1]] || labels[t[2]]; };
    return any(active_.inside) && !any(active_.outside);
  }

  /// Other surface open: winding numbers follow from the crossings of the edges, up to one number for the face. The
  /// smallest of them is 0, and where they are all alike `inside` tells.
  void set_relative_winding(FaceClip& clip, bool inside) const {
    for (const auto& segment : clip.segments)
      for (const Index point : segment) {
        const CrossingId& id = ids_[point];
        if (id.edge_side == side_) continue;
        if (others_.edge_faces[find_edge(others_, id.edge)][1] != kNone) continue;
        // The other surface ends within this face: no part of it is bounded.
        clip.segments.clear();
        clip.on_edges.clear();
        clip.winding = {0, 0, 0};
        ++undefined_;
        return;
      }
    std::array<int, 3> sums{};
    for (const FaceClip::EdgeCrossing& x : clip.on_edges) sums[x.corner] += x.delta;
    clip.winding = {0, sums[0], sums[0] + sums[1]};
    const int smallest = *std::min_element(clip.winding.begin(), clip.winding.end());
    const bool alike = sums == std::array<int, 3>{};
    for (int& w : clip.winding) w += (alike && inside ? 1 : 0) - smallest;
  }

  const ExactPose& pose_;
  Side side_;
  const Surface& others_;
  const ActiveFaces& active_;
  const std::vector<IndexPair>& columns_;
  std::vector<CrossingId>& ids_;
  Index& undefined_;
};

std::vector<FaceClip> clip_side(const FaceClipper& clipper, Side side, const Crossings& crossings,
                                const ActiveFaces& active, const std::vector<IndexPair>& candidates,
                                const std::vector<CoplanarOverlap>& overlaps) {
  const auto mine = [side](const auto& pair) { return side == Side::E ? pair.face_E : pair.face_F; };
  std::map<Index, std::vector<const Segment*>> segments;
  for (const Segment& segment : crossings.segments) segments[mine(segment)].push_back(&segment);
  std::map<Index, std::vector<Index>> coplanar, near;
  for (std::size_t i = 0; i < overlaps.size(); ++i) coplanar[mine(overlaps[i])].push_back(static_cast<Index>(i));
  if (!coplanar.empty())
    for (const auto& [e, f] : candidates)
      if (coplanar.count(side == Side::E ? e : f) > 0) near[side == Side::E ? e : f].push_back(side == Side::E ? f : e);

  std::vector<FaceClip> clips;
  for (const auto& [face, indices] : coplanar) {
    if (clipper.against_closed()) {
      clips.push_back(clipper.moved_inward(face, near[face], indices));
      continue;
    }
    const auto crossed = segments.find(face);
    clips.push_back(crossed != segments.end() ? clipper.intersected(face, crossings, crossed->second)
                                              : clipper.uncrossed(face));
    clips.back().overlaps = indices;
  }
  for (const auto& [face, of_face] : segments)
    if (coplanar.count(face) == 0) clips.push_back(clipper.intersected(face, crossings, of_face));
  for (const std::vector<Index>* uncrossed : {&active.inner, &active.pockets})
    for (const Index face : *uncrossed)
      if (coplanar.count(face) == 0) clips.push_back(clipper.uncrossed(face));
  std::sort(clips.begin(), clips.end(), [](const FaceClip& a, const FaceClip& b) { return a.face < b.face; });
  return clips;
}

}  // namespace

ClippedAreas clip_active_areas(const ExactPose& pose, const std::vector<IndexPair>& candidates,
                               const Crossings& crossings, const ActiveFaces& active_E, const ActiveFaces& active_F,
                               const std::vector<IndexPair>& columns_E, const std::vector<IndexPair>& columns_F) {
  std::vector<CrossingId> ids = crossings.ids;
  Index undefined = 0;
  std::vector<CoplanarOverlap> overlaps = find_coplanar_overlaps(pose, candidates);
  const FaceClipper clipper_E(pose, Side::E, active_E, columns_E, ids, undefined);
  const FaceClipper clipper_F(pose, Side::F, active_F, columns_F, ids, undefined);
  std::vector<FaceClip> E = clip_side(clipper_E, Side::E, crossings, active_E, candidates, overlaps);
  std::vector<FaceClip> F = clip_side(clipper_F, Side::F, crossings, active_F, candidates, overlaps);
  return {CrossingPoints(pose, std::move(ids)), std::move(overlaps), std::move(E), std::move(F), undefined};
}

}  // namespace pcm::reference
