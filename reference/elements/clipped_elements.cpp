// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/elements/clipped_elements.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "reference/lines/convex_pieces.h"
#include "reference/lines/penetration_line.h"
#include "reference/pose/box_tree.h"

namespace pcm::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A column below part of the master face: x - q N for x in the box and 0 <= q <= depth.
struct Column {
  Vec3<Interval> top;
  double depth;
};

/// Ascending; all faces that may have a point in the column.
std::vector<Index> faces_in(const Column& column, const Vec3<Interval>& N, const BoxTree& tree) {
  std::vector<Index> faces;
  tree.look_along([&](const Box& box) { return begin_of(column.top, N, box); },
                  [&](Index face) {
                    faces.push_back(face);
                    return column.depth;
                  });
  std::sort(faces.begin(), faces.end());
  return faces;
}

Vec3<Interval> box_of(VisibilityPoints& points, Face face) {
  return interval_point(points.enclosed.pose().face_box(face.side, face.index));
}

bool is_bounded(const Interval& x) {
  return x.inf() > -kInfinity && x.sup() < kInfinity;
}

/// The column from the piece down to f's greatest depth there; below the whole face where enclosures do not tell.
Column column_below(MasterPlane& plane, const ConvexPiece& piece, Face f, const Vec3<Interval>& master_box) {
  const MasterFrame<Interval>& e = plane.frame();
  const Depth<Interval> d = plane.depth(f);
  Column column{master_box, 0};
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Vec3<Interval>& corner = piece.corners[i];
    const Interval depth = dot(d.numerator, corner) / (d.denominator * corner.z);
    const Vec3<Interval> x = e.p0 + Interval(corner.x / corner.z) * e.v1 + Interval(corner.y / corner.z) * e.v2;
    if (!is_bounded(depth) || !is_bounded(x.x) || !is_bounded(x.y) || !is_bounded(x.z)) return {master_box, kInfinity};
    column.depth = std::max(column.depth, depth.sup());
    column.top = i == 0 ? x : Vec3<Interval>{hull(column.top.x, x.x), hull(column.top.y, x.y), hull(column.top.z, x.z)};
  }
  return column;
}

/// All of one master face's sight.
class Envelope {
 public:
  Envelope(VisibilityPoints& points, Face master, const Proximity& near)
      : pose_(points.enclosed.pose()),
        plane_(points, master),
        slave_(other(master.side)),
        near_(near),
        master_box_(box_of(points, master)) {}

  /// Appends the master face's elements.
  void find_elements(std::vector<ClippedElement>& elements) {
    const Face e = plane_.master();
    const SeenFace& seen_e = plane_.see(e);
    if (seen_e.facing == 0) return;  // without area
    const ConvexPiece whole = whole_face(plane_, seen_e);
    for (const Index f : faces_in({master_box_, kInfinity}, plane_.frame().N, near_.tree(slave_))) {
      const std::vector<ConvexPiece> part = part_that_sees({slave_, f}, whole);
      if (part.empty()) continue;
      elements.push_back({{e.side, e.index, f}, {}});
      for (const ConvexPiece& piece : part) elements.back().pieces.push_back(outline_of(piece, {slave_, f}));
    }
  }

 private:
  /// Of a piece of the part that sees f. A side that is both e's and f's is named by the line that it moves with (PCM
  /// section 7.1).
  PieceOutline outline_of(const ConvexPiece& piece, Face f) {
    const std::array<HalfPlane, 3> own = plane_.see(plane_.master()).sides;
    PieceOutline outline;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const HalfPlane side = piece.sides[i];
      const bool is_own = std::any_of(own.begin(), own.end(), [&](HalfPlane h) { return h.line == side.line; });
      outline.push_back(plane_.name(is_own ? moving_line(piece, i, f) : side));
    }
    return outline;
  }

  /// For side i of a piece, on the border of e: the line of the edge of f that it lies on where f's sheet, as e sees
  /// it, ends there; else its own.
  HalfPlane moving_line(const ConvexPiece& piece, std::size_t i, Face f) {
    const std::size_t before = i == 0 ? piece.size() - 1 : i - 1;
    const auto corner_is_on = [&](HalfPlane h, std::size_t corner) {
      return plane_.side(h, piece.sides[corner], piece.sides[piece.next(corner)], piece.corners[corner]) == 0;
    };
    for (const HalfPlane h : plane_.see(f).sides)
      if (corner_is_on(h, before) && corner_is_on(h, i) && !beyond(f, plane_.name(h))) return h;
    return piece.sides[i];
  }

  /// The face with which f's sheet goes on beyond this edge of it; none where e sees nothing of it there from within.
  std::optional<Face> beyond(Face f, VisibilityLine edge) {
    const Surface& surface = pose_.surface(f.side);
    const auto faces = surface.edge_faces[static_cast<std::size_t>(find_edge(surface, {edge.a, edge.b}))];
    const Face other_face{f.side, faces[0] == f.index ? faces[1] : faces[0]};
    if (other_face.index == kNone || plane_.see(other_face).facing >= 0) return {};
    return other_face;
  }

  std::vector<ConvexPiece> part_that_sees(Face f, const ConvexPiece& whole) {
    const SeenFace& seen_f = plane_.see(f);
    if (seen_f.facing >= 0 || !seen_f.ahead) return {};  // the line enters, or f lies in e's plane
    ConvexPiece below = clip(plane_, whole, {*seen_f.ahead, seen_f.sides[0], seen_f.sides[1], seen_f.sides[2]});
    if (below.empty()) return {};
    const Column column = column_below(plane_, below, f, master_box_);
    const std::vector<HalfPlane> border = below.sides;
    std::vector<ConvexPiece> part{std::move(below)};
    std::vector<Face> others;
    for (const Side side : {slave_, plane_.master().side})
      for (const Index g : faces_in(column, plane_.frame().N, near_.tree(side))) {
        const Face other_face{side, g};
        if (other_face == f || other_face == plane_.master() || plane_.see(other_face).facing == 0) continue;
        take_out_what_is_before(f, other_face, border, part);
        if (part.empty()) return part;
        others.push_back(other_face);
      }
    for (const Face g : others) end_at_what_hides_the_sheet(f, g, part);
    return part;
  }

  /// proj(g) n {d_g >= 0}.
  std::vector<HalfPlane> met(const SeenFace& g) const {
    std::vector<HalfPlane> bounds(g.sides.begin(), g.sides.end());
    if (g.ahead) bounds.insert(bounds.begin(), *g.ahead);
    return bounds;
  }

  /// Of where g is met, {d_g <= d_f}; nothing where that is nowhere. This bound comes first, as an edge of g may lie in
  /// f: it is g, or the face beyond the edge, that comes out of f there.
  std::vector<HalfPlane> met_before(Face f, Face g) {
    std::vector<HalfPlane> bounds = met(plane_.see(g));
    if (const std::optional<HalfPlane> before = plane_.deeper(f, g))
      bounds.insert(bounds.begin(), *before);
    else if (g.side == plane_.master().side || f < g)
      return {};
    return bounds;
  }

  /// Takes out of the part what g is met before. `border`: of what nothing hides of f.
  void take_out_what_is_before(Face f, Face g, const std::vector<HalfPlane>& border, std::vector<ConvexPiece>& part) {
    const std::vector<HalfPlane> bounds = met(plane_.see(g));
    if (std::all_of(part.begin(), part.end(),
                    [&](const ConvexPiece& piece) { return plainly_apart(plane_, piece, bounds); }))
      return;
    if (const std::vector<HalfPlane> before = met_before(f, g); !before.empty())
      part = subtract(plane_, part, before, border);
  }

  /// Where f's sheet goes on beyond an edge of f, but g hides it from there on, the part ends at g.
  void end_at_what_hides_the_sheet(Face f, Face g, std::vector<ConvexPiece>& part) {
    const std::vector<HalfPlane> bounds = met(plane_.see(g));
    for (const HalfPlane edge : plane_.see(f).sides) {
      if (std::none_of(part.begin(), part.end(),
                       [&](const ConvexPiece& piece) { return may_reach_side(plane_, piece, edge, bounds); }))
        continue;
      const std::optional<Face> next = beyond(f, plane_.name(edge));
      if (!next || *next == g) continue;
      if (const std::vector<HalfPlane> before = met_before(*next, g); !before.empty())
        part = end_beside(plane_, part, edge, before);
    }
  }

  const ExactPose& pose_;
  MasterPlane plane_;
  Side slave_;
  const Proximity& near_;
  Vec3<Interval> master_box_;
};

/// Elements by master face.
struct MasterFaceOrder {
  static Index master_face(Index face) { return face; }
  static Index master_face(const ClippedElement& element) { return element.faces.master_face; }
  template <class A, class B>
  bool operator()(const A& a, const B& b) const {
    return master_face(a) < master_face(b);
  }
};

}  // namespace

ClippedFindings find_clipped_elements(const ExactPose& pose, Side master, const Combinatorics& combinatorics,
                                      const ClippedFindings& other) {
  const CGAL::Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
  ClippedFindings found;
  VisibilityPoints points(pose);
  for (const Index face : (master == Side::E ? combinatorics.E : combinatorics.F).active()) {
    points.robust = true;
    if (std::binary_search(other.robust.begin(), other.robust.end(), face)) {
      const auto [begin, end] = std::equal_range(other.elements.begin(), other.elements.end(), face, MasterFaceOrder());
      found.elements.insert(found.elements.end(), begin, end);
    } else {
      Envelope(points, {master, face}, *combinatorics.near).find_elements(found.elements);
    }
    if (points.robust) found.robust.push_back(face);
  }
  return found;
}

}  // namespace pcm::reference
