// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/active/inside_areas.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcm::fast {

namespace {

/// Sums over the faces of one side, in face-index order.
struct Totals {
  double area = 0;
  Eigen::Vector3d vector_area_Me = Eigen::Vector3d::Zero();
  double thrice_volume = 0;
  Index undefined = 0;

  void add_face(double face_area, const Eigen::Vector3d& n_Me, const Eigen::Vector3d& from_origin_Me) {
    area += face_area;
    vector_area_Me += face_area * n_Me;
    thrice_volume += face_area * n_Me.dot(from_origin_Me);
  }
};

/// After the last one.
constexpr Index kNoFace = std::numeric_limits<Index>::max();

/// Measures the area of one side inside the other body.
class SideMeasure {
 public:
  SideMeasure(PosedPair& posed, const Crossings& crossings, const PolygonChains& chains, const ActiveAreas& areas,
              Side side, InsideAreaScratch& scratch)
      : posed_(posed),
        crossings_(crossings),
        chains_(chains),
        side_(side),
        surface_(posed.surface(side)),
        crossed_(crossings.of(side)),
        active_(areas.of(side)),
        other_closed_(posed.surface(opposite(side)).closed),
        scratch_(scratch) {}

  Totals measure(const Eigen::Vector3d& origin_Me);

 private:
  void add_segments();
  std::array<Index, 3> corner_windings(Index face) const;
  void add_edges(Index face, const std::array<Index, 3>& windings, InsidePart& part);
  /// Faces count as often as the other surface winds about them: once, unless that intersects itself. Only so do the
  /// areas of both surfaces bound a volume.
  double multiplicity(Index face) const {
    return other_closed_ ? static_cast<double>(active_.face_winding.at(face)) : 1.0;
  }

  PosedPair& posed_;
  const Crossings& crossings_;
  const PolygonChains& chains_;
  Side side_;
  const PreparedSurface& surface_;
  const CrossedSurface& crossed_;
  const ActiveFaces& active_;
  bool other_closed_;
  InsideAreaScratch& scratch_;
};

/// Segments of all polygons: each runs inside one face of E and one of F, with the part of E inside F on its left, the
/// part of F inside E on its right.
void SideMeasure::add_segments() {
  const double sign = side_ == Side::E ? 1 : -1;
  for (const Index c : chains_.crossing_order) {
    const CrossingNode& start = crossings_[c];
    if (start.next < 0) continue;
    const CrossingNode& end = crossings_[start.next];
    const Index face = start.segment_face[static_cast<std::size_t>(side_)];
    InsidePart& part = scratch_.parts[static_cast<std::size_t>(scratch_.slot.at(face))];
    if (!part.started) part.origin_Me = start.position_Me;
    part.started = true;
    part.twice_vector_area_Me +=
        sign * (start.position_Me - part.origin_Me).cross(Eigen::Vector3d(end.position_Me - part.origin_Me));
    if (other_closed_) continue;
    for (const CrossingNode* crossing : {&start, &end}) {
      if (crossing->edge_side != side_ && crossing->face == face &&
          posed_.surface(crossing->edge_side).border(crossing->edge)) {
        part.undefined = true;
      }
    }
  }
}

/// Winding numbers of the other surface about the corners of an intersected face. Of an open one only differences are
/// known: the smallest is taken as 0, or all as 1 where a corner is labelled inside and none outside (PCM section 5).
std::array<Index, 3> SideMeasure::corner_windings(Index face) const {
  const Triangle& corners = surface_.face(face);
  if (other_closed_) {
    return {active_.winding.at(corners[0]), active_.winding.at(corners[1]), active_.winding.at(corners[2])};
  }
  const auto change = [&](std::size_t k) { return winding_change_along(surface_, crossed_, face, k); };
  std::array<Index, 3> windings{0, change(0), change(0) + change(1)};
  Index base = -std::min({windings[0], windings[1], windings[2]});
  if (windings[1] == 0 && windings[2] == 0) {
    std::uint8_t labels = kNoLabel;
    for (const Index v : corners) labels = static_cast<std::uint8_t>(labels | active_.label.get(v, kNoLabel));
    base = labels == kInside ? 1 : 0;
  }
  for (Index& winding : windings) winding += base;
  return windings;
}

/// The border of the part inside along the face's own edges: twice the area between an edge a -> b and the origin,
/// where w winds about it: w(a) a x c + w(b) c x b + the sum over the crossings x_i of delta_i x_i x c, with any point
/// c of the edge. Taken at a crossing, the far ends enter only where the area reaches them, so that the error is a few
/// ulps of a coordinate times the extent of the area, not of the face.
void SideMeasure::add_edges(Index face, const std::array<Index, 3>& windings, InsidePart& part) {
  const Triangle& corners = surface_.face(face);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Index edge = surface_.edges_of(face)[k];
    const EdgeCrossings crossings = crossed_.edges.get(edge, {});
    if (windings[k] == 0 && windings[next] == 0 && crossings.count == 0) continue;
    const Eigen::Vector3d a = posed_.vertex_Me(side_, corners[k]) - part.origin_Me;
    const Eigen::Vector3d b = posed_.vertex_Me(side_, corners[next]) - part.origin_Me;
    if (crossings.count == 0) {
      part.twice_vector_area_Me += static_cast<double>(windings[k]) * a.cross(b);
      continue;
    }
    const Index direction = surface_.runs_forwards(face, k) ? 1 : -1;
    const CrossingNode& first = crossings_[crossings.first];
    const Eigen::Vector3d c = first.position_Me - part.origin_Me;
    if (windings[k] != 0) part.twice_vector_area_Me += static_cast<double>(windings[k]) * a.cross(c);
    if (windings[next] != 0) part.twice_vector_area_Me += static_cast<double>(windings[next]) * c.cross(b);
    for (Index i = first.next_on_edge; i >= 0;) {
      const CrossingNode& crossing = crossings_[i];
      const Eigen::Vector3d x = crossing.position_Me - part.origin_Me;
      part.twice_vector_area_Me += static_cast<double>(direction * crossing.winding_change()) * x.cross(c);
      i = crossing.next_on_edge;
    }
  }
}

Totals SideMeasure::measure(const Eigen::Vector3d& origin_Me) {
  const std::vector<Index>& intersected_faces = crossed_.intersected;
  scratch_.parts.assign(intersected_faces.size(), InsidePart{});
  scratch_.slot.start(surface_.mesh.faces.size());
  for (std::size_t i = 0; i < intersected_faces.size(); ++i) {
    scratch_.slot.set(intersected_faces[i], static_cast<Index>(i));
  }
  add_segments();

  Totals totals;
  std::size_t next_intersected = 0, next_inner = 0, next_pocket = 0, next_part = 0;
  const auto head = [](const std::vector<Index>& faces, std::size_t next) {
    return next < faces.size() ? faces[next] : kNoFace;
  };
  const auto next_face = [&] {
    const Index intersected = head(intersected_faces, next_intersected);
    const Index inner = head(active_.inner, next_inner);
    const Index face = std::min({intersected, inner, head(active_.pockets, next_pocket)});
    if (face != kNoFace) ++(face == intersected ? next_intersected : face == inner ? next_inner : next_pocket);
    return face;
  };
  ElementLanes& lanes = scratch_.lanes;
  FaceBatch faces{};
  for (std::size_t count = kElementLanes; count == kElementLanes;) {
    count = 0;
    while (count < kElementLanes && (faces[count] = next_face()) != kNoFace) ++count;
    find_geometry(posed_, side_, faces, count, lanes);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const Index face = faces[lane];
      const double whole_area = lanes.area.value[lane];
      const Eigen::Vector3d n_Me = lanes.n_Me[lane];
      if (!crossed_.is_intersected.contains(face)) {
        totals.add_face(multiplicity(face) * whole_area, n_Me, lanes.p_Me[0][lane] - origin_Me);
        continue;
      }
      InsidePart& part = scratch_.parts[next_part++];
      if (part.undefined) {
        ++totals.undefined;
        continue;
      }
      add_edges(face, corner_windings(face), part);
      double area = 0.5 * part.twice_vector_area_Me.dot(n_Me);
      if (!other_closed_) area = std::clamp(area, 0.0, whole_area);
      totals.add_face(area, n_Me, part.origin_Me - origin_Me);
    }
  }
  return totals;
}

/// A point of the patch, or of a nested component, that the volume is taken about.
Eigen::Vector3d origin_of_volume(PosedPair& posed, const Crossings& crossings, const PolygonChains& chains,
                                 const ActiveAreas& areas) {
  if (!chains.crossing_order.empty()) return crossings[chains.crossing_order.front()].position_Me;
  for (const Side side : {Side::E, Side::F}) {
    const std::vector<Index>& inner = areas.of(side).inner;
    if (!inner.empty()) return posed.vertex_Me(side, posed.surface(side).face(inner.front())[0]);
  }
  return Eigen::Vector3d::Zero();
}

}  // namespace

InsideAreas measure_inside_areas(PosedPair& posed, const Crossings& crossings, const PolygonChains& chains,
                                 const ActiveAreas& areas, InsideAreaScratch& scratch) {
  const Eigen::Vector3d origin_Me = origin_of_volume(posed, crossings, chains, areas);
  InsideAreas result;
  double thrice_volume = 0;
  for (const Side side : {Side::E, Side::F}) {
    const Totals totals = SideMeasure(posed, crossings, chains, areas, side, scratch).measure(origin_Me);
    result.area[static_cast<std::size_t>(side)] = totals.area;
    result.vector_area_Me[static_cast<std::size_t>(side)] = totals.vector_area_Me;
    result.undefined += totals.undefined;
    thrice_volume += totals.thrice_volume;
  }
  result.has_volume = posed.surface(Side::E).closed && posed.surface(Side::F).closed;
  if (result.has_volume) result.volume = thrice_volume / 3;
  return result;
}

}  // namespace pcm::fast
