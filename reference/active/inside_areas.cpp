// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/active/inside_areas.h"

#include <algorithm>
#include <map>
#include <utility>

#include "reference/active/face_cells.h"
#include "reference/active/face_paths.h"

namespace pcm::reference {
namespace {

bool has_area(const ExactPose& pose, Side side, Index face) {
  const Triangle& t = pose.face(side, face);
  {
    const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
    const auto at = [&](int i) { return interval_point(pose.enclosure({side, t[i]})); };
    const Vec3<Interval> normal = doubled_normal(at(0), at(1), at(2));
    for (int i = 0; i < 3; ++i)
      if (certain_sign(normal[i]) != 0) return true;
  }
  const auto [p0, p1, p2] = pose.corners<Exact>(side, face);
  const Vec3<Exact> normal = doubled_normal(p0, p1, p2);
  return sign_of(normal.x) != 0 || sign_of(normal.y) != 0 || sign_of(normal.z) != 0;
}

/// Finds the parts of one side's faces inside the other body.
class InsidePartFinder {
 public:
  InsidePartFinder(const ExactPose& pose, Side side, const ActiveFaces& active, const std::vector<IndexPair>& columns,
                   Index& undefined)
      : pose_(pose),
        side_(side),
        others_(pose.surface(other(side))),
        active_(active),
        columns_(columns),
        undefined_(undefined) {}

  bool against_closed() const { return others_.closed; }

  /// A face without crossings: one winding number all over.
  InsidePart uncrossed(Index face) const {
    InsidePart part = bare(face);
    const bool inner = std::binary_search(active_.inner.begin(), active_.inner.end(), face);
    const int winding = others_.closed ? active_.winding[pose_.face(side_, face)[0]] : inner ? 1 : 0;
    if (winding != 0) part.cells.push_back({winding, {{1, 2}, {2, 0}, {0, 1}}});
    return part;
  }

  /// A face in crossing pairs, under the plain tie rule.
  InsidePart intersected(Index face, const Crossings& crossings, const std::vector<const Segment*>& segments) const {
    InsidePart part = bare(face);
    std::vector<FaceSegment> face_segments;
    for (const Segment* segment : segments)
      face_segments.push_back({side_ == Side::E ? segment->face_F : segment->face_E,
                               {crossings.ids[segment->start], crossings.ids[segment->end]}});
    if (!others_.closed && border_ends_within(face_segments)) {
      ++undefined_;
      return part;
    }
    const Orientation orientation(pose_);
    const Triangle& t = pose_.face(side_, face);
    cut(part, orientation, face_segments, [&](FaceLines& lines, const std::vector<FaceCell>& cells) {
      if (others_.closed) return active_.winding[t[lines.apex()]];
      return relative_winding(FacePaths(orientation, side_, face, lines, cells[0].corners), lines.apex(),
                              labelled_inside(t));
    });
    return part;
  }

  /// A face with coplanar overlaps, the other surface closed: moved inward.
  InsidePart moved_inward(Index face, const std::vector<Index>& others, std::vector<Index> overlaps) const {
    const Orientation orientation(pose_, ShiftedFace{side_, face});
    InsidePart part = bare(face);
    part.overlaps = std::move(overlaps);
    std::vector<FaceSegment> face_segments;
    for (const Index f : others) {
      const std::vector<PairCrossing> pair =
          side_ == Side::E ? pair_crossings(orientation, face, f) : pair_crossings(orientation, f, face);
      if (!pair.empty()) face_segments.push_back({f, {pair[0].id, pair[1].id}});
    }
    cut(part, orientation, face_segments, [&](FaceLines& lines, const std::vector<FaceCell>&) {
      return winding_number(orientation, {side_, pose_.face(side_, face)[lines.apex()]}, columns_);
    });
    return part;
  }

 private:
  InsidePart bare(Index face) const {
    InsidePart part;
    part.face = face;
    part.has_area = has_area(pose_, side_, face);
    part.limited = !others_.closed;
    return part;
  }

  /// Cuts a face into cells; `winding_at_apex(lines, cells)` tells how often the other surface winds about its apex.
  template <class WindingAtApex>
  void cut(InsidePart& part, const Orientation& orientation, const std::vector<FaceSegment>& segments,
           const WindingAtApex& winding_at_apex) const {
    if (!part.has_area) return;
    const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
    FaceLines lines(pose_, side_, part.face, segments);
    const std::vector<FaceCell> cells = cut_into_cells(orientation, side_, part.face, lines);
    const int at_apex = winding_at_apex(lines, cells);
    for (const FaceCell& cell : cells)
      if (const int winding = at_apex + cell.change; winding != 0) part.cells.push_back({winding, cell.corners});
    part.apex = lines.apex();
    part.planes = lines.faces();
    part.crossings = lines.crossings();
  }

  /// The other surface ends within this face: no part of it is bounded.
  bool border_ends_within(const std::vector<FaceSegment>& segments) const {
    const auto on_border = [this](const CrossingId& id) {
      return id.edge_side != side_ && others_.edge_faces[find_edge(others_, id.edge)][1] == kNone;
    };
    return std::any_of(segments.begin(), segments.end(), [&](const FaceSegment& segment) {
      return on_border(segment.ends[0]) || on_border(segment.ends[1]);
    });
  }

  bool labelled_inside(const Triangle& t) const {
    const auto any = [&t](const std::vector<bool>& labels) { return labels[t[0]] || labels[t[1]] || labels[t[2]]; };
    return any(active_.inside) && !any(active_.outside);
  }

  /// Other surface open: how its winding number changes along a path in the face is all that is known. It is taken such
  /// that the smallest at the three corners is 0; where they are alike, all are 1 if labelled inside, otherwise 0.
  static int relative_winding(FacePaths paths, int apex, bool inside) {
    const std::array<int, 3> below_x{paths.change(0), paths.change(1), paths.change(2)};
    const auto [least, greatest] = std::minmax_element(below_x.begin(), below_x.end());
    return *least == *greatest ? (inside ? 1 : 0) : *greatest - below_x[apex];
  }

  const ExactPose& pose_;
  Side side_;
  const Surface& others_;
  const ActiveFaces& active_;
  const std::vector<IndexPair>& columns_;
  Index& undefined_;
};

std::vector<InsidePart> find_parts_of_side(const InsidePartFinder& finder, Side side, const Crossings& crossings,
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

  std::vector<InsidePart> parts;
  for (const auto& [face, indices] : coplanar) {
    if (finder.against_closed()) {
      parts.push_back(finder.moved_inward(face, near[face], indices));
      continue;
    }
    const auto crossed = segments.find(face);
    parts.push_back(crossed != segments.end() ? finder.intersected(face, crossings, crossed->second)
                                              : finder.uncrossed(face));
    parts.back().overlaps = indices;
  }
  for (const auto& [face, of_face] : segments)
    if (coplanar.count(face) == 0) parts.push_back(finder.intersected(face, crossings, of_face));
  for (const std::vector<Index>* uncrossed : {&active.inner, &active.pockets})
    for (const Index face : *uncrossed)
      if (coplanar.count(face) == 0) parts.push_back(finder.uncrossed(face));
  std::sort(parts.begin(), parts.end(), [](const InsidePart& a, const InsidePart& b) { return a.face < b.face; });
  return parts;
}

}  // namespace

InsideAreas find_inside_areas(const ExactPose& pose, const std::vector<IndexPair>& candidates,
                              const Crossings& crossings, const ActiveFaces& active_E, const ActiveFaces& active_F,
                              const std::vector<IndexPair>& columns_E, const std::vector<IndexPair>& columns_F) {
  Index undefined = 0;
  std::vector<CoplanarOverlap> overlaps = find_coplanar_overlaps(pose, candidates);
  const InsidePartFinder finder_E(pose, Side::E, active_E, columns_E, undefined);
  const InsidePartFinder finder_F(pose, Side::F, active_F, columns_F, undefined);
  std::vector<InsidePart> E = find_parts_of_side(finder_E, Side::E, crossings, active_E, candidates, overlaps);
  std::vector<InsidePart> F = find_parts_of_side(finder_F, Side::F, crossings, active_F, candidates, overlaps);
  return {std::move(overlaps), std::move(E), std::move(F), undefined};
}

}  // namespace pcm::reference
