// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/clipped_elements.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "fast/barycentric/penetration.h"
#include "fast/bounds/clipped_error.h"
#include "fast/bounds/force_bound.h"
#include "fast/clipped/visible_parts.h"
#include "fast/surface/thickness.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What gathers the bound on the errors of one master face's elements.
struct FaceBound {
  PrismError prism_error;
  SightError sight;
  double slack;  ///< how far from the computed prism the exact problem's may be, m

  FaceBound(const MasterPrism& prism, const MasterBound& bound, const ContactLaw& law)
      : prism_error(prism, bound.face_error(), bound.master(), bound.own_rounding_Me(), bound.rounding_Me()),
        sight(bound.sight_scratch(), prism, prism_error, law),
        slack(bound.slack()) {}
  FaceBound(const FaceBound&) = delete;
  FaceBound& operator=(const FaceBound&) = delete;
};

/// How far off the prism's lines may be wherever any surface reaches, and so depths: no point is farther from p0 than 4
/// times the reach, m.
double farthest_off(const MasterPrism& prism, const Placement& placement) {
  return prism.tilt() * (4 * placement.reach);
}

/// Lists the faces of a side that may meet the prism at a depth from 0 to `deepest`, ascending.
void list_candidates(PosedPair& posed, Side side, const MasterPrism& prism, double deepest, const FaceBound* bound,
                     ClippedScratch& scratch) {
  const Placement& placement = posed.placement;
  const PreparedSurface& surface = posed.surface(side);
  // A box's point is off by the slack along each of three axes.
  const double slack =
      4 * placement.slack(side) + farthest_off(prism, placement) + (bound != nullptr ? bound->slack : 0);
  const TreePrism tree_prism =
      side == Side::E ? TreePrism(prism, slack) : TreePrism(prism, slack, placement.A, placement.r_Me);
  std::vector<Index>& candidates = scratch.projection.candidates;
  std::vector<Index>& open = scratch.open;
  candidates.clear();
  open.assign(1, 0);
  const WidePrism wide_prism(surface.wide_tree, tree_prism, deepest);
  const WideTests& tests = fastest_wide_tests();
  while (!open.empty()) {
    const WideNode& node = surface.wide_tree.node(open.back());
    open.pop_back();
    posed.work.box_tests += node.count;
    std::vector<Index>& children = node.bottom() ? candidates : open;
    for (std::uint32_t lanes = tests.boxes_in_prism(node, wide_prism); lanes != 0; lanes &= lanes - 1) {
      children.push_back(node.child[static_cast<std::size_t>(std::countr_zero(lanes))]);
    }
  }
  if (bound != nullptr) {
    // Bounds hear of every candidate: which those are is not left to single precision.
    const auto is_far = [&](Index face) { return !tree_prism.may_meet(box_of_faces(surface.mesh, &face, 1), deepest); };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_far), candidates.end());
  }
  std::sort(candidates.begin(), candidates.end());
}

/// Whether the line of the barycentre may meet the face: decided with room to spare. Where it does, the weights of the
/// place, the same mean of the corners', are 1/3 each; they are off by no more than the corners' are.
bool near_barycentre(const MasterPrism& prism, const std::array<PrismPoint, 3>& corners) {
  for (int weight = 0; weight < 3; ++weight) {
    const std::size_t side = static_cast<std::size_t>(weight + 1) % 3;
    const double a = corners[0][weight], b = corners[1][weight], c = corners[2][weight];
    const double least = std::min({a, b, c}), greatest = std::max({a, b, c});
    if (least <= 1.0 / 3 && greatest >= 1.0 / 3) continue;
    const double room = 0x1p-20 * (1 + std::abs(a) + std::abs(b) + std::abs(c)) +
                        std::max({prism.weight_error(side, corners[0]), prism.weight_error(side, corners[1]),
                                  prism.weight_error(side, corners[2])});
    if (least > 1.0 / 3 + room || greatest < 1.0 / 3 - room) return false;
  }
  return true;
}

/// What the penetration lines of one master face meet.
struct View {
  double deepest = -1;               ///< greatest depth at which the slave may be left, whatever lies before, m
  double deepest_corner = -1;        ///< greatest depth of a corner of a candidate, m
  bool slave_at_barycentre = false;  ///< the line of the barycentre may leave the slave
  bool own_at_barycentre = false;    ///< it may meet another face of the master
};

/// What the prism sees of the slave's vertices, each looked at once, and a face's corners from that.
void see_vertices(PosedPair& posed, Side slave, const MasterPrism& prism, ProjectionScratch& scratch) {
  const PreparedSurface& surface = posed.surface(slave);
  StampedArray<PrismPoint>& sights = scratch.sights;
  sights.start(surface.mesh.vertices.size());
  for (const Index face : scratch.candidates) {
    for (const Index v : surface.face(face)) {
      if (!sights.contains(v)) sights.set(v, prism.see(posed.vertex_Me(slave, v), posed.work));
    }
  }
}
std::array<PrismPoint, 3> corners_of(const ProjectionScratch& scratch, const Triangle& vertices) {
  return {scratch.sights.at(vertices[0]), scratch.sights.at(vertices[1]), scratch.sights.at(vertices[2])};
}

/// Adds a face to those that lines meet; false where none meets it. It carries nothing yet.
bool add_projected(const MasterPrism& prism, double reach, Index face, bool own, const Triangle& vertices,
                   const std::array<PrismPoint, 3>& corners, std::vector<ProjectedFace>& faces) {
  ProjectedFace& projected = faces.emplace_back();
  if (!project_face(vertices, corners, projected)) {
    faces.pop_back();
    return false;
  }
  projected.face = face;
  projected.own = own;
  projected.carries = false;
  projected.uncertainty = prism.uncertainty(corners, reach);
  return true;
}

/// Some steps are done for all candidates before the next, though one loop would do: what a processor guesses wrong of
/// a face is then known soon, not only after all that was computed for it.
void project_slave(PosedPair& posed, Side slave, const MasterPrism& prism, FaceBound* bound,
                   ClippedScratch& clipped_scratch, View& view) {
  ProjectionScratch& scratch = clipped_scratch.projection;
  const PreparedSurface& surface = posed.surface(slave);
  list_candidates(posed, slave, prism, kInfinity, bound, clipped_scratch);
  see_vertices(posed, slave, prism, scratch);
  scratch.over.resize(scratch.candidates.size());
  const std::size_t all = bound != nullptr ? 1 : 0;  // Bounds hear of every candidate.
  std::size_t count = 0;
  for (const Index face : scratch.candidates) {
    const std::array<PrismPoint, 3> corners = corners_of(scratch, surface.face(face));
    const PrismPoint greatest = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    view.deepest_corner = std::max(view.deepest_corner, greatest[kDepth]);
    scratch.over[count] = face;
    const auto is_over = static_cast<std::size_t>(greatest.head<3>().minCoeff() > 0);
    const auto is_beneath = static_cast<std::size_t>(greatest[kDepth] >= 0);
    count += all | (is_over & is_beneath);
  }
  scratch.over.resize(count);
  scratch.entered.clear();
  for (const Index face : scratch.over) {
    const Triangle& vertices = surface.face(face);
    const std::array<PrismPoint, 3> corners = corners_of(scratch, vertices);
    if (bound != nullptr) bound->sight.see(posed[slave], face, false, corners, {}, posed.work);
    if (!add_projected(prism, posed.placement.reach, face, false, vertices, corners, scratch.faces)) continue;
    ProjectedFace& projected = scratch.faces.back();
    const bool is_certain = certain(projected.seen, projected.uncertainty);
    if (is_certain && !projected.leaves) scratch.entered.push_back(face);
    projected.carries = projected.leaves && is_certain;
    if (projected.carries) {
      for (int i = 0; i < projected.seen.count; ++i) view.deepest = std::max(view.deepest, projected.seen[i][kDepth]);
    }
    if (bound != nullptr) bound->sight.is_projected(false, face, scratch.faces.size() - 1);
  }
}

/// Where the line of the barycentre may leave the slave: also through a sliver whose side it sees is not certain.
void look_along_barycentre(const PreparedSurface& surface, const MasterPrism& prism, const ProjectionScratch& scratch,
                           View& view) {
  auto entered = scratch.entered.begin();
  for (const Index face : scratch.candidates) {
    if (entered != scratch.entered.end() && *entered == face) {
      ++entered;
      continue;
    }
    const std::array<PrismPoint, 3> corners = corners_of(scratch, surface.face(face));
    const double deepest = std::max({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]});
    if (deepest < 0 || !near_barycentre(prism, corners)) continue;
    view.slave_at_barycentre = true;
    view.deepest = std::max(view.deepest, deepest);
  }
}

/// `only_bound`: the elements are known to need none of them.
void project_own(PosedPair& posed, Side master, Index master_face, const MasterPrism& prism, bool only_bound,
                 FaceBound* bound, ClippedScratch& scratch, View& view) {
  const PreparedSurface& surface = posed.surface(master);
  const Triangle& master_vertices = surface.face(master_face);
  // Faces all deeper than this surely lie after what is seen of the slave: depths are sure to kHeightError.
  const double after = (1 + 4 * kHeightError) * view.deepest;
  list_candidates(posed, master, prism, bound != nullptr ? std::max(after, bound->sight.greatest_depth()) : after,
                  bound, scratch);
  std::vector<ProjectedFace>& faces = scratch.projection.faces;
  for (const Index face : scratch.projection.candidates) {
    if (face == master_face) continue;
    const Triangle& vertices = surface.face(face);
    std::array<PrismPoint, 3> corners;
    std::array<bool, 3> is_shared;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto shared = std::find(master_vertices.begin(), master_vertices.end(), vertices[k]);
      is_shared[k] = shared != master_vertices.end();
      corners[k] = shared != master_vertices.end()
                       ? MasterPrism::corner(static_cast<int>(shared - master_vertices.begin()))
                       : prism.see(posed.vertex_Me(master, vertices[k]), posed.work);
    }
    if (bound != nullptr) bound->sight.see(posed[master], face, true, corners, is_shared, posed.work);
    if (only_bound) continue;
    view.own_at_barycentre = view.own_at_barycentre || near_barycentre(prism, corners);
    // What else is listed hangs on how it was listed; a face that lies over the master and no deeper is, in any case.
    if (std::min({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]}) > after) continue;
    if (!add_projected(prism, posed.placement.reach, face, true, vertices, corners, faces)) continue;
    if (bound != nullptr) bound->sight.is_projected(true, face, faces.size() - 1);
  }
}

PlacedFace placed(PosedPair& posed, Side side, const ProjectedFace& face) {
  return {face,
          {posed.vertex_Me(side, face.vertices[0]), posed.vertex_Me(side, face.vertices[1]),
           posed.vertex_Me(side, face.vertices[2])}};
}

/// Integrals over parts of one face; of min(depth, most) in place of the depth. Area and greatest depth are none of the
/// clamp's.
Moments moments_of(std::span<const ConvexPolygon> parts, double most) {
  Moments moments;
  for (const ConvexPolygon& part : parts) moments.add(part);
  if (!(moments.greatest > most)) return moments;
  Moments clamped;
  for (const ConvexPolygon& part : parts) clamped.add_clamped(part, most);
  clamped.area = moments.area;
  clamped.greatest = moments.greatest;
  return clamped;
}

/// Integrals over the part of the master face that sees the slave face at `index` of the projected ones first; of
/// min(depth, most) in place of the depth. `overlap` is the first overlap that may concern it and moves on past them.
Moments moments_of_visible_part(PosedPair& posed, Side master, std::size_t index, double most,
                                ProjectionScratch& scratch, std::vector<Overlap>::const_iterator& overlap,
                                Neglect& neglect) {
  const ProjectedFace& f = scratch.faces[index];
  if (overlap == scratch.overlaps.end() || overlap->first != index) return moments_of({&f.seen, 1}, most);
  const PlacedFace placed_f = placed(posed, opposite(master), f);
  scratch.parts.assign(1, f.seen);
  for (; overlap != scratch.overlaps.end() && overlap->first == index; ++overlap) {
    if (scratch.parts.empty()) continue;
    const ProjectedFace& g = scratch.faces[overlap->second];
    const PlacedFace placed_g = placed(posed, g.own ? master : opposite(master), g);
    subtract_hidden(placed_f, placed_g, scratch.parts, scratch.remaining, neglect, posed.work);
  }
  for (const ConvexPolygon& part : scratch.parts) neglect.add_part(part, f.seen);
  return moments_of(scratch.parts, most);
}

/// x = p0 + s (p1 - p0) + t (p2 - p0), within the face.
Eigen::Vector3d foot_Me(const MasterPrism& prism, const Moments& moments) {
  const double s = std::clamp(moments.s_depth / moments.depth, 0.0, 1.0);
  const double t = std::clamp(moments.t_depth / moments.depth, 0.0, 1.0);
  return prism.p0_Me() + (s * prism.edge_s_Me() + t * prism.edge_t_Me());
}

/// A pose that shears F by more than this makes faces that stand upright on others lean by more than roundings do.
constexpr double kGreatestSkew = 0x1p-48;

/// Whether other faces of the master may lie before what is seen, as the thickness computed beforehand says.
enum class Before : std::uint8_t {
  none,     ///< surely none
  leaning,  ///< only as faces that stand upright on the border of the prism lean over it in the exact problem
  some
};
Before own_faces_before(const PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, double deepest) {
  const PreparedSurface& surface = posed.surface(master);
  const auto i = static_cast<std::size_t>(face);
  const ThicknessEverywhere& thickness = surface.thickness_everywhere;
  // F's parts are seen through roundings of its vertices, which may differ by more than the vertices do.
  const double moved = master == Side::E ? 0 : posed.placement.slack_F;
  const double known = master == Side::E ? thickness.exact[i] : thickness.rounded[i];
  if (!(deepest < known && thickness_holds(surface, moved, geometry))) return Before::some;
  if (surface.clear_of_neighbours[i] && deepest < thickness.tolerant[i]) return Before::none;
  if (master == Side::E) return Before::none;
  return posed.placement.skew > kGreatestSkew ? Before::some : Before::leaning;
}

/// Whether depths below the face may be lost to underflow, and its area: their signs then tell nothing.
bool underflows(const FaceGeometry& geometry) {
  const auto& p = geometry.points_Me;
  return std::max((p[1] - p[0]).lpNorm<Eigen::Infinity>(), (p[2] - p[0]).lpNorm<Eigen::Infinity>()) < kLeastDetail;
}

/// Forms the elements of one master face and enters them: `enter(element, greatest penetration, centre of pressure,
/// error)`, the first before clamping, the error where it is known. `master_bound`, where given, hears of the face.
template <class Enter>
void form_elements_of(PosedPair& posed, Side master, Index face, const ContactLaw& law, MasterBound* master_bound,
                      ClippedScratch& clipped_scratch, ElementRecord& record, const Enter& enter) {
  ProjectionScratch& scratch = clipped_scratch.projection;
  const PreparedSurface& slave_surface = posed.surface(opposite(master));
  const FaceGeometry geometry = face_with_sure_normal(posed.face_Me(master, face));
  if (master_bound != nullptr) master_bound->begin_clipped_face(face, geometry);
  const bool only_line_tells = underflows(geometry);
  if (only_line_tells && find_penetration(posed, master, face, geometry, clipped_scratch.line_open).outcome ==
                             Penetration::Outcome::too_deep) {
    ++record.too_deep;
  }
  if (!(geometry.area > 0)) {
    if (master_bound != nullptr) master_bound->end_clipped_face(geometry, nullptr);
    return;
  }
  const MasterPrism prism(geometry);
  std::optional<FaceBound> face_bound;
  if (master_bound != nullptr && master_bound->face_error().normal_known) {
    face_bound.emplace(prism, *master_bound, law);
  }
  FaceBound* const bound = face_bound ? &*face_bound : nullptr;
  scratch.faces.clear();
  View view;
  project_slave(posed, opposite(master), prism, bound, clipped_scratch, view);
  const auto surely_thick = [&](double deepest) {
    const double farthest = deepest + farthest_off(prism, posed.placement);
    return deepest < 0 || own_faces_before(posed, master, face, geometry, farthest) != Before::some;
  };
  // Where nothing lies before any candidate it need not be known which of them the barycentre's line meets.
  bool thick = bound == nullptr && surely_thick(std::max(view.deepest, view.deepest_corner));
  // A face that touches the master's plane from above hides nothing, but the barycentre's line meets it.
  const double thickness_at_barycentre = posed.surface(master).thickness[static_cast<std::size_t>(face)];
  const bool thick_at_barycentre = thick && std::max(view.deepest, view.deepest_corner) < thickness_at_barycentre;
  if (!thick_at_barycentre) look_along_barycentre(slave_surface, prism, scratch, view);
  if (!thick) thick = surely_thick(view.deepest);
  bool bound_needs_own = false;
  if (bound != nullptr && bound->sight.greatest_depth() >= 0) {
    const Before before = own_faces_before(posed, master, face, geometry, bound->sight.greatest_depth());
    bound_needs_own = before == Before::some;
    if (thick && before == Before::leaning) bound->sight.may_lean(posed.placement.greatest_lean());
  }
  if (!thick || bound_needs_own) project_own(posed, master, face, prism, thick, bound, clipped_scratch, view);
  // Where the master's other faces were not looked at, what is known of its thickness tells.
  const bool own_at_barycentre = thick ? !(view.deepest < thickness_at_barycentre) : view.own_at_barycentre;
  if (!only_line_tells && view.slave_at_barycentre && own_at_barycentre &&
      find_penetration(posed, master, face, geometry, clipped_scratch.line_open).outcome ==
          Penetration::Outcome::too_deep) {
    ++record.too_deep;
  }
  if (bound != nullptr) {
    bound->sight.compare(slave_surface, posed.surface(master), scratch);
  }
  find_overlaps(scratch.faces, scratch.order, scratch.overlaps);
  auto overlap = scratch.overlaps.cbegin();
  for (std::size_t i = 0; i < scratch.faces.size() && !scratch.faces[i].own; ++i) {
    const Index slave_face = scratch.faces[i].face;
    if (!scratch.faces[i].carries) {
      if (bound != nullptr && scratch.faces[i].leaves) {
        bound->sight.leave_out(slave_face, 0.5 * std::abs(twice_area(scratch.faces[i].seen)));
      }
      continue;
    }
    Neglect neglect;
    const double most = law.max_penetration;
    const Moments moments = moments_of_visible_part(posed, master, i, most, scratch, overlap, neglect);
    const double area = moments.area * (2 * geometry.area);
    const double mean = std::min({moments.depth / moments.area, moments.greatest, most});
    if (!(area > 0 && mean > 0)) {
      // Too small to be an element, but not too shallow.
      if (area > 0) record.note_depth(moments.greatest, law);
      if (bound != nullptr) bound->sight.leave_out(slave_face, std::abs(moments.area) + neglect.area);
      continue;
    }
    Element element;
    element.master = master;
    element.master_face = face;
    element.slave_face = slave_face;
    element.area = area;
    element.penetration = mean;
    element.normal_Me = -geometry.n_Me;
    const Eigen::Vector3d foot = foot_Me(prism, moments);
    if (bound != nullptr) {
      const ElementError error = bound->sight.of_element(slave_face, moments, neglect, master_bound->face_error());
      enter(element, moments.greatest, foot, &error);
    } else {
      enter(element, moments.greatest, foot, nullptr);
    }
  }
  if (master_bound != nullptr) {
    master_bound->end_clipped_face(geometry, bound != nullptr ? &bound->sight : nullptr);
  }
}

}  // namespace

MasterForce sum_clipped_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                 ClippedScratch& scratch, ElementRecord& record, MasterBound* bound) {
  PosedPair& posed = intersection.posed;
  if (bound == nullptr) {
    ElementQueue queue(problem, master, record, posed.work, scratch.lanes);
    for_each_active_face(intersection, master, [&](Index face) {
      form_elements_of(posed, master, face, problem.law, nullptr, scratch, record,
                       [&queue](const Element& element, double greatest_penetration, const Eigen::Vector3d& foot_Me,
                                const ElementError*) { queue.add(element, greatest_penetration, foot_Me); });
    });
    return queue.total();
  }
  const auto add_elements_of = [&](Index face, ElementRecord& face_record, ElementSum& sum) {
    form_elements_of(
        posed, master, face, problem.law, bound, scratch, face_record,
        [&](Element& element, double greatest_penetration, const Eigen::Vector3d& foot_Me, const ElementError* error) {
          sum.add(greatest_penetration, foot_Me, element);
          bound->add_clipped_element(element, error, sum.total());
        });
  };
  ElementSum sum(problem, record, posed.work);
  for_each_active_face(intersection, master, [&](Index face) { add_elements_of(face, record, sum); });
  // Faces that are not active, but may be in the exact problem: what they would add.
  ForceProblem unheard = problem;
  unheard.keep_elements = unheard.with_statistics = false;
  for (const Index face : bound->undecided().faces) {
    if (intersection.is_active(master, face)) continue;
    ElementRecord none;
    WorkCounters no_work;
    ElementSum nothing(unheard, none, no_work);
    add_elements_of(face, none, nothing);
  }
  return sum.total();
}

}  // namespace pcm::fast
