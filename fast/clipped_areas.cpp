// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fast/active_areas.h"
#include "fast/face_lanes.h"

namespace pcm::fast {

namespace {

/// Segments of all polygons: each runs inside one face of E and one of F, with the part of E inside F on its left, the
/// part of F inside E on its right.
void add_segments(Workspace::Data& workspace, Side side_name) {
  SideState& side = workspace.side(side_name);
  const bool other_closed = workspace.side(opposite(side_name)).surface().closed;
  const double sign = side_name == Side::E ? 1 : -1;
  for (const Index c : workspace.crossing_order) {
    const CrossingNode& start = workspace.crossings[static_cast<std::size_t>(c)];
    if (start.next < 0) continue;
    const CrossingNode& end = workspace.crossings[static_cast<std::size_t>(start.next)];
    const Index face = start.segment_face[static_cast<std::size_t>(side_name)];
    FaceClip& clip = workspace.clips[static_cast<std::size_t>(side.slot[face])];
    if (!clip.started) clip.origin_Me = start.position_Me;
    clip.started = true;
    clip.twice_vector_area_Me +=
        sign * (start.position_Me - clip.origin_Me).cross(Eigen::Vector3d(end.position_Me - clip.origin_Me));
    if (other_closed) continue;
    for (const CrossingNode* crossing : {&start, &end}) {
      if (crossing->edge_side != side_name && crossing->face == face &&
          workspace.side(crossing->edge_side).surface().border(crossing->edge)) {
        clip.undefined = true;
      }
    }
  }
}

/// Winding numbers of the other surface about the corners of an intersected face. Of an open one only differences are
/// known: the smallest is taken as 0, or all as 1 where a corner is labelled inside and none outside (rule R8).
std::array<Index, 3> corner_windings(const SideState& side, bool other_closed, Index face) {
  const Triangle& corners = side.surface().face(face);
  if (other_closed) {
    return {side.winding.at(corners[0]), side.winding.at(corners[1]), side.winding.at(corners[2])};
  }
  const auto change = [&](std::size_t k) { return winding_change_along(side, face, k); };
  std::array<Index, 3> windings{0, change(0), change(0) + change(1)};
  Index base = -std::min({windings[0], windings[1], windings[2]});
  if (windings[1] == 0 && windings[2] == 0) {
    std::uint8_t labels = kNoLabel;
    for (const Index v : corners) labels = static_cast<std::uint8_t>(labels | side.label.get(v, kNoLabel));
    base = labels == kInside ? 1 : 0;
  }
  for (Index& winding : windings) winding += base;
  return windings;
}

/// The border of the clipped area along the face's own edges: twice the area between an edge a -> b and the origin,
/// where w winds about it: w(a) a x c + w(b) c x b + the sum over the crossings x_i of delta_i x_i x c, with any point
/// c of the edge. Taken at a crossing, the far ends enter only where the area reaches them, so that the error is a few
/// ulps of a coordinate times the extent of the area, not of the face.
void add_edges(Workspace::Data& workspace, SideState& side, Index face, const std::array<Index, 3>& windings,
               FaceClip& clip) {
  WorkCounters& work = workspace.contact.work;
  const Triangle& corners = side.surface().face(face);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Index edge = side.surface().edges_of(face)[k];
    const EdgeCrossings crossings = side.edge_crossings.get(edge, {});
    if (windings[k] == 0 && windings[next] == 0 && crossings.count == 0) continue;
    const Eigen::Vector3d a = side.posed.vertex_Me(corners[k], work) - clip.origin_Me;
    const Eigen::Vector3d b = side.posed.vertex_Me(corners[next], work) - clip.origin_Me;
    if (crossings.count == 0) {
      clip.twice_vector_area_Me += static_cast<double>(windings[k]) * a.cross(b);
      continue;
    }
    const Index direction = side.surface().runs_forwards(face, k) ? 1 : -1;
    const CrossingNode& first = workspace.crossings[static_cast<std::size_t>(crossings.first)];
    const Eigen::Vector3d c = first.position_Me - clip.origin_Me;
    if (windings[k] != 0) clip.twice_vector_area_Me += static_cast<double>(windings[k]) * a.cross(c);
    if (windings[next] != 0) clip.twice_vector_area_Me += static_cast<double>(windings[next]) * c.cross(b);
    for (Index i = first.next_on_edge; i >= 0;) {
      const CrossingNode& crossing = workspace.crossings[static_cast<std::size_t>(i)];
      const Eigen::Vector3d x = crossing.position_Me - clip.origin_Me;
      clip.twice_vector_area_Me += static_cast<double>(direction * crossing.winding_change()) * x.cross(c);
      i = crossing.next_on_edge;
    }
  }
}

/// Sums over the faces of one side, in face-index order.
struct Totals {
  double area = 0;
  Eigen::Vector3d vector_area_Me = Eigen::Vector3d::Zero();
  double thrice_volume = 0;
};

void add_face(Totals& totals, double area, const Eigen::Vector3d& n_Me, const Eigen::Vector3d& x_Me,
              const Eigen::Vector3d& origin_Me) {
  totals.area += area;
  totals.vector_area_Me += area * n_Me;
  totals.thrice_volume += area * n_Me.dot(x_Me - origin_Me);
}

/// After the last one.
constexpr Index kNoFace = std::numeric_limits<Index>::max();

Totals measure(Workspace::Data& workspace, Side side_name, const Eigen::Vector3d& origin_Me) {
  SideState& side = workspace.side(side_name);
  const bool other_closed = workspace.side(opposite(side_name)).surface().closed;
  workspace.clips.assign(side.intersected.size(), FaceClip{});
  side.slot.start(side.surface().mesh.faces.size());
  for (std::size_t i = 0; i < side.intersected.size(); ++i) side.slot[side.intersected[i]] = static_cast<Index>(i);
  add_segments(workspace, side_name);

  // Faces count as often as the other surface winds about them: once, unless that intersects itself. Only so do the
  // clipped areas of both surfaces bound a volume.
  const auto multiplicity = [&](Index face) {
    return other_closed ? static_cast<double>(side.face_winding.at(face)) : 1.0;
  };
  Totals totals;
  std::size_t next_intersected = 0, next_inner = 0, next_pocket = 0, next_clip = 0;
  const auto head = [](const std::vector<Index>& faces, std::size_t next) {
    return next < faces.size() ? faces[next] : kNoFace;
  };
  const auto next_face = [&] {
    const Index intersected = head(side.intersected, next_intersected);
    const Index inner = head(side.inner, next_inner);
    const Index face = std::min({intersected, inner, head(side.pockets, next_pocket)});
    if (face != kNoFace) ++(face == intersected ? next_intersected : face == inner ? next_inner : next_pocket);
    return face;
  };
  const ElementLanes& lanes = workspace.element_lanes;
  FaceBatch faces{};
  for (std::size_t count = kElementLanes; count == kElementLanes;) {
    count = 0;
    while (count < kElementLanes && (faces[count] = next_face()) != kNoFace) ++count;
    find_geometry(workspace, side_name, faces, count);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const Index face = faces[lane];
      const double whole_area = lanes.area.value[lane];
      const Eigen::Vector3d n_Me = lanes.n_Me[lane];
      if (!side.is_intersected.contains(face)) {
        add_face(totals, multiplicity(face) * whole_area, n_Me, lanes.p_Me[0][lane], origin_Me);
        continue;
      }
      FaceClip& clip = workspace.clips[next_clip++];
      if (clip.undefined) {
        ++workspace.contact.undefined_areas;
        continue;
      }
      add_edges(workspace, side, face, corner_windings(side, other_closed, face), clip);
      double area = 0.5 * clip.twice_vector_area_Me.dot(n_Me);
      if (!other_closed) area = std::clamp(area, 0.0, whole_area);
      add_face(totals, area, n_Me, clip.origin_Me, origin_Me);
    }
  }
  return totals;
}

}  // namespace

void measure_clipped_areas(Workspace::Data& workspace) {
  Contact& contact = workspace.contact;
  SideState& side_E = workspace.side(Side::E);
  SideState& side_F = workspace.side(Side::F);
  // The volume is taken about a point of the patch, or of a nested component.
  Eigen::Vector3d origin_Me = Eigen::Vector3d::Zero();
  if (!workspace.crossing_order.empty()) {
    origin_Me = workspace.crossings[static_cast<std::size_t>(workspace.crossing_order.front())].position_Me;
  } else if (!side_E.inner.empty()) {
    origin_Me = side_E.posed.vertex_Me(side_E.surface().face(side_E.inner.front())[0], contact.work);
  } else if (!side_F.inner.empty()) {
    origin_Me = side_F.posed.vertex_Me(side_F.surface().face(side_F.inner.front())[0], contact.work);
  }
  const Totals on_E = measure(workspace, Side::E, origin_Me);
  const Totals on_F = measure(workspace, Side::F, origin_Me);
  contact.E.area = on_E.area;
  contact.E.vector_area_Me = on_E.vector_area_Me;
  contact.F.area = on_F.area;
  contact.F.vector_area_Me = on_F.vector_area_Me;
  contact.has_volume = side_E.surface().closed && side_F.surface().closed && !contact.ambiguous;
  if (contact.has_volume) contact.volume = (on_E.thrice_volume + on_F.thrice_volume) / 3;
}

}  // namespace pcm::fast
