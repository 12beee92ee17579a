// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/penetration.h"
#include "fast/thickness.h"
#include "fast/visible_parts.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Lists the faces of a side that may meet the prism at a depth from 0 to `deepest`, ascending.
void list_candidates(Workspace::Data& workspace, Side side, const MasterPrism& prism, double deepest) {
  const Placement& placement = workspace.placement;
  const BoxTree& tree = workspace.side(side).surface().tree;
  // A box's point is off by the slack along each of three axes.
  const double slack = 4 * placement.slack(side);
  const TreePrism tree_prism =
      side == Side::E ? TreePrism(prism, slack) : TreePrism(prism, slack, placement.A, placement.r_Me);
  std::vector<Index>& candidates = workspace.projection.candidates;
  std::vector<Index>& open = workspace.nodes;
  candidates.clear();
  open.assign(1, 0);
  while (!open.empty()) {
    const BoxNode& node = tree.node(open.back());
    open.pop_back();
    ++workspace.contact.work.box_tests;
    if (!tree_prism.may_meet(node.box, deepest)) continue;
    if (node.leaf()) {
      candidates.push_back(node.face);
    } else {
      open.push_back(node.child);
      open.push_back(node.child + 1);
    }
  }
  std::sort(candidates.begin(), candidates.end());
}

/// Whether the line of the barycentre may meet the face: decided with room to spare for roundings.
bool near_barycentre(const std::array<PrismPoint, 3>& corners) {
  for (int weight = 0; weight < 3; ++weight) {
    const double a = corners[0][weight], b = corners[1][weight], c = corners[2][weight];
    const double room = 0x1p-20 * (1 + std::abs(a) + std::abs(b) + std::abs(c));
    if (std::min({a, b, c}) > 1.0 / 3 + room || std::max({a, b, c}) < 1.0 / 3 - room) return false;
  }
  return true;
}

/// What the penetration lines of one master face meet.
struct View {
  Uncertainty uncertainty;
  double deepest = -1;               ///< greatest depth at which the slave may be left, whatever lies before, m
  bool slave_at_barycentre = false;  ///< the line of the barycentre may leave the slave
  bool own_at_barycentre = false;    ///< it may meet another face of the master
};

void project_slave(Workspace::Data& workspace, Side slave, const MasterPrism& prism, View& view) {
  WorkCounters& work = workspace.contact.work;
  PosedSurface& posed = workspace.side(slave).posed;
  list_candidates(workspace, slave, prism, kInfinity);
  for (const Index face : workspace.projection.candidates) {
    const Triangle& vertices = posed.surface().face(face);
    const std::array<PrismPoint, 3> corners{prism.see(posed.vertex_Me(vertices[0], work), work),
                                            prism.see(posed.vertex_Me(vertices[1], work), work),
                                            prism.see(posed.vertex_Me(vertices[2], work), work)};
    const double deepest = std::max({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]});
    if (deepest < 0) continue;
    ProjectedFace projected;
    const bool is_seen = project_face(vertices, corners, projected);
    const bool is_certain = is_seen && certain(projected.seen, view.uncertainty);
    // A line may leave the slave through a sliver whose side it sees is not certain.
    if (near_barycentre(corners) && !(is_certain && !projected.leaves)) {
      view.slave_at_barycentre = true;
      view.deepest = std::max(view.deepest, deepest);
    }
    if (!is_seen) continue;
    projected.face = face;
    projected.own = false;
    projected.carries = projected.leaves && is_certain;
    if (projected.carries) {
      for (int i = 0; i < projected.seen.count; ++i) view.deepest = std::max(view.deepest, projected.seen[i][kDepth]);
    }
    workspace.projection.faces.push_back(projected);
  }
}

void project_own(Workspace::Data& workspace, Side master, Index master_face, const MasterPrism& prism, View& view) {
  WorkCounters& work = workspace.contact.work;
  PosedSurface& posed = workspace.side(master).posed;
  const Triangle& master_vertices = posed.surface().face(master_face);
  list_candidates(workspace, master, prism, view.deepest);
  for (const Index face : workspace.projection.candidates) {
    if (face == master_face) continue;
    const Triangle& vertices = posed.surface().face(face);
    std::array<PrismPoint, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto shared = std::find(master_vertices.begin(), master_vertices.end(), vertices[k]);
      corners[k] = shared != master_vertices.end()
                       ? MasterPrism::corner(static_cast<int>(shared - master_vertices.begin()))
                       : prism.see(posed.vertex_Me(vertices[k], work), work);
    }
    view.own_at_barycentre = view.own_at_barycentre || near_barycentre(corners);
    ProjectedFace projected;
    if (!project_face(vertices, corners, projected)) continue;
    projected.face = face;
    projected.own = true;
    projected.carries = false;
    workspace.projection.faces.push_back(projected);
  }
}

PlacedFace placed(Workspace::Data& workspace, Side side, const ProjectedFace& face) {
  WorkCounters& work = workspace.contact.work;
  PosedSurface& posed = workspace.side(side).posed;
  return {face,
          {posed.vertex_Me(face.vertices[0], work), posed.vertex_Me(face.vertices[1], work),
           posed.vertex_Me(face.vertices[2], work)}};
}

/// Integrals over the part of the master face that sees the slave face at `index` of the projected ones first.
/// `overlap` is the first overlap that may concern it and moves on past them.
Moments moments_of_visible_part(Workspace::Data& workspace, Side master, const Uncertainty& uncertainty,
                                std::size_t index, std::vector<Overlap>::const_iterator& overlap) {
  ProjectionScratch& scratch = workspace.projection;
  const ProjectedFace& f = scratch.faces[index];
  Moments moments;
  if (overlap == scratch.overlaps.end() || overlap->first != index) {
    moments.add(f.seen);
    return moments;
  }
  const PlacedFace placed_f = placed(workspace, opposite(master), f);
  scratch.parts.assign(1, f.seen);
  for (; overlap != scratch.overlaps.end() && overlap->first == index; ++overlap) {
    if (scratch.parts.empty()) continue;
    const ProjectedFace& g = scratch.faces[overlap->second];
    const PlacedFace placed_g = placed(workspace, g.own ? master : opposite(master), g);
    subtract_hidden(uncertainty, placed_f, placed_g, scratch.parts, scratch.remaining, workspace.contact.work);
  }
  for (const ConvexPolygon& part : scratch.parts) moments.add(part);
  return moments;
}

/// x = p0 + s (p1 - p0) + t (p2 - p0), within the face.
Eigen::Vector3d foot_Me(const MasterPrism& prism, const Moments& moments) {
  const double s = std::clamp(moments.s_depth / moments.depth, 0.0, 1.0);
  const double t = std::clamp(moments.t_depth / moments.depth, 0.0, 1.0);
  return prism.p0_Me() + (s * prism.edge_s_Me() + t * prism.edge_t_Me());
}

void add_elements_of(Workspace::Data& workspace, Side master, Index face, const ForceProblem& problem,
                     MasterForce& total) {
  Contact& contact = workspace.contact;
  ProjectionScratch& scratch = workspace.projection;
  const FaceGeometry geometry(workspace.side(master).posed.face_Me(face, contact.work));
  if (!(geometry.area > 0)) return;
  const MasterPrism prism(geometry);
  scratch.faces.clear();
  View view{prism.uncertainty(workspace.placement.reach)};
  project_slave(workspace, opposite(master), prism, view);
  if (view.deepest < 0) return;
  const Surface::Data& surface = workspace.side(master).surface();
  const bool thick = view.deepest < surface.thickness_everywhere[static_cast<std::size_t>(face)] &&
                     thickness_holds(surface, workspace.placement.slack(master), geometry);
  if (!thick) {
    project_own(workspace, master, face, prism, view);
    if (view.slave_at_barycentre && view.own_at_barycentre &&
        find_penetration(workspace, master, face, geometry).outcome == Penetration::Outcome::too_deep) {
      ++contact.too_deep;
    }
  }
  find_overlaps(scratch.faces, scratch.order, scratch.overlaps);
  auto overlap = scratch.overlaps.cbegin();
  for (std::size_t i = 0; i < scratch.faces.size() && !scratch.faces[i].own; ++i) {
    if (!scratch.faces[i].carries) continue;
    const Moments moments = moments_of_visible_part(workspace, master, view.uncertainty, i, overlap);
    const double area = moments.area * (2 * geometry.area);
    const double mean = std::min(moments.depth / moments.area, moments.greatest);
    if (!(area > 0 && mean > 0)) continue;
    Element element;
    element.master = master;
    element.master_face = face;
    element.slave_face = scratch.faces[i].face;
    element.area = area;
    element.penetration = mean;
    element.normal_Me = -geometry.n_Me;
    add_element(contact, problem, moments.greatest, foot_Me(prism, moments), element, total);
  }
}

}  // namespace

MasterForce sum_clipped_elements(Workspace::Data& workspace, Side master, const ForceProblem& problem) {
  MasterForce total;
  for_each_active_face(workspace.side(master),
                       [&](Index face) { add_elements_of(workspace, master, face, problem, total); });
  return total;
}

}  // namespace pcm::fast
