// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/face_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "fast/prism/depths_in_prism.h"
#include "fast/search/prism_search.h"
#include "fast/surface/exit_depth.h"
#include "fast/surface/thickness.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A pose that shears F by more than this makes faces that stand upright on others lean by more than roundings do.
constexpr double kGreatestSkew = 0x1p-48;

/// The slave's faces are listed in a prism wider by this share of the greatest coordinate, so that they need not be
/// listed anew for the bound. It is less than what single precision makes the search list anyway.
constexpr double kListedWider = 0x1p-40;

/// How deep the slave is seen, m; -1 where it is not.
struct Depths {
  double deepest = -1;         ///< greatest depth at which the slave may be left, whatever lies before
  double deepest_corner = -1;  ///< greatest depth of a corner of a listed face

  double any() const { return std::max(deepest, deepest_corner); }
};

/// Whether the line of the barycentre may meet the face: decided where errors allow it. Where it does, the weights of
/// the place, the same mean of the corners', are 1/3 each; they are off by no more than the corners' are.
bool near_barycentre(const MasterPrism& prism, const std::array<PrismPoint, 3>& corners) {
  for (int weight = 0; weight < 3; ++weight) {
    const std::size_t side = static_cast<std::size_t>(weight + 1) % 3;
    const double a = corners[0][weight], b = corners[1][weight], c = corners[2][weight];
    const double least = std::min({a, b, c}), greatest = std::max({a, b, c});
    if (least <= 1.0 / 3 && greatest >= 1.0 / 3) continue;
    const double error = 0x1p-20 * (1 + std::abs(a) + std::abs(b) + std::abs(c)) +
                         std::max({prism.weight_error(side, corners[0]), prism.weight_error(side, corners[1]),
                                   prism.weight_error(side, corners[2])});
    if (least > 1.0 / 3 + error || greatest < 1.0 / 3 - error) return false;
  }
  return true;
}

/// Looks at each of the faces' vertices that was not looked at yet.
void see_vertices(PosedPair& posed, Side slave, const MasterPrism& prism, const std::vector<Index>& faces,
                  FastClearArray<PrismPoint>& sights) {
  const PreparedSurface& surface = posed.surface(slave);
  for (const Index face : faces) {
    for (const Index v : surface.face(face)) {
      if (!sights.contains(v)) sights.set(v, prism.see(posed.vertex_Me(slave, v), posed.work));
    }
  }
}

std::array<PrismPoint, 3> corners_of(const FastClearArray<PrismPoint>& sights, const Triangle& vertices) {
  return {sights.at(vertices[0]), sights.at(vertices[1]), sights.at(vertices[2])};
}

/// False where no line meets the face of a side.
bool project(PosedPair& posed, Side side, Index face, const MasterPrism& prism, std::array<PrismPoint, 3> corners,
             ProjectedFace& projected) {
  const int exponent = prism.depths_underflow(corners) ? prism.scale_depths(posed.face_Me(side, face), corners) : 0;
  return project_face(posed.surface(side).face(face), corners, projected, exponent);
}

/// Adds a face of a side to those that lines meet; false where none meets it. It carries nothing yet.
bool add_projected(PosedPair& posed, Side side, Index face, bool of_master, const MasterPrism& prism,
                   const std::array<PrismPoint, 3>& corners, std::vector<ProjectedFace>& faces) {
  ProjectedFace& projected = faces.emplace_back();
  projected.number = static_cast<std::int32_t>(faces.size()) - 1;
  if (!project(posed, side, face, prism, corners, projected)) {
    faces.pop_back();
    return false;
  }
  projected.face = face;
  projected.of_master = of_master;
  projected.carries = false;
  return true;
}

/// Whether what is seen of the face has area for certain. `greatest`, the prism's bound for all faces, settles that for
/// most of them, whose own uncertainty then need not be known.
bool surely_has_area(const MasterPrism& prism, double max_coordinate, const Uncertainty& greatest,
                     const ProjectedFace& face) {
  const double area = 0.5 * twice_area(face.seen);
  const double width_s = face.high_s - face.low_s, width_t = face.high_t - face.low_t;
  return certain(area, width_s, width_t, greatest) ||
         certain(area, width_s, width_t, prism.uncertainty(face.corners, max_coordinate));
}

/// Whether the bounds of the face's thickness and exit depth hold at this pose. F's parts are seen through roundings of
/// its vertices, which may differ by more than the vertices do.
bool own_bounds_hold(const PosedPair& posed, Side master, const FaceGeometry& geometry) {
  const double vertex_error = master == Side::E ? 0 : posed.placement.position_error_F;
  return thickness_holds(posed.surface(master), vertex_error, geometry);
}

/// By which depth the lines have surely left the master, m, where they meet the slave nowhere before; else infinite.
double exit_before_slave(PosedPair& posed, Side master, Index master_face, const MasterPrism& prism,
                         const TreePrism& in_tree, FaceViewScratch& scratch, FaceView& view) {
  if (!own_bounds_hold(posed, master, prism.face())) return kInfinity;
  const double exit = exit_depth(posed.surface(master), master_face) + farthest_off(prism, posed.placement);
  if (exit == kInfinity) return kInfinity;
  const Side slave = opposite(master);
  list_faces_in_prism(posed, slave, in_tree, exit, scratch.open, scratch.over);
  see_vertices(posed, slave, prism, scratch.over, view.slave_sights);
  for (const Index face : scratch.over) {
    const std::array<PrismPoint, 3> corners = corners_of(view.slave_sights, posed.surface(slave).face(face));
    if (may_be_met_before(exit, prism, corners, in_tree.box_error())) return kInfinity;
  }
  return exit;
}

/// Lists the slave's faces, none where the lines surely leave the master before they meet any.
void list_slave(PosedPair& posed, Side master, Index master_face, const MasterPrism& prism, bool nested,
                FaceViewScratch& scratch, FaceView& view) {
  const Side slave = opposite(master);
  view.listed_wider_by = kListedWider * posed.placement.max_coordinate;
  view.listed_to_depth = kInfinity;
  view.slave_sights.start(posed.surface(slave).mesh.vertices.size());
  const TreePrism in_tree = prism_in_tree(posed, slave, prism, view.listed_wider_by);
  list_faces_in_prism(posed, slave, in_tree, kInfinity, scratch.open, view.slave_listed);
  // Where surfaces cross, lines mostly meet the slave, and it would cost more to ask than it spares.
  if (!nested || view.slave_listed.empty()) return;
  view.listed_to_depth = exit_before_slave(posed, master, master_face, prism, in_tree, scratch, view);
  if (view.listed_to_depth < kInfinity) view.slave_listed.clear();
}

/// Some steps are done for all faces before the next, though one loop would do: what a processor guesses wrong of
/// a face is then known soon, not only after all that was computed for it.
Depths project_slave(PosedPair& posed, Side slave, const MasterPrism& prism, FaceViewScratch& scratch, FaceView& view) {
  const PreparedSurface& surface = posed.surface(slave);
  see_vertices(posed, slave, prism, view.slave_listed, view.slave_sights);
  Depths depths;
  scratch.over.resize(view.slave_listed.size());
  std::size_t count = 0;
  for (const Index face : view.slave_listed) {
    const std::array<PrismPoint, 3> corners = corners_of(view.slave_sights, surface.face(face));
    const PrismPoint greatest = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    depths.deepest_corner = std::max(depths.deepest_corner, greatest[kDepth]);
    scratch.over[count] = face;
    const auto is_over = static_cast<std::size_t>(greatest.head<3>().minCoeff() > 0);
    const auto is_beneath = static_cast<std::size_t>(greatest[kDepth] >= 0);
    count += is_over & is_beneath;
  }
  scratch.over.resize(count);
  scratch.entered.clear();
  const Uncertainty greatest_uncertainty = prism.greatest_uncertainty(posed.placement.max_coordinate);
  for (const Index face : scratch.over) {
    const std::array<PrismPoint, 3> corners = corners_of(view.slave_sights, surface.face(face));
    if (!add_projected(posed, slave, face, false, prism, corners, view.faces)) continue;
    ProjectedFace& projected = view.faces.back();
    const bool is_certain = surely_has_area(prism, posed.placement.max_coordinate, greatest_uncertainty, projected);
    if (is_certain && !projected.leaves) scratch.entered.push_back(face);
    projected.carries = projected.leaves && is_certain;
    if (!projected.carries) continue;
    for (int i = 0; i < projected.seen.count; ++i) {
      depths.deepest = std::max(depths.deepest, projected.seen[i][kDepth]);
    }
  }
  return depths;
}

/// For the count of lines that are too deep alone, but that faces of the master may lie before what it finds. Where the
/// line of the barycentre may leave the slave: also through a sliver whose side it sees is not certain.
void look_along_barycentre(const PreparedSurface& surface, const MasterPrism& prism, const FaceViewScratch& scratch,
                           FaceView& view, Depths& depths) {
  auto entered = scratch.entered.begin();
  for (const Index face : view.slave_listed) {
    if (entered != scratch.entered.end() && *entered == face) {
      ++entered;
      continue;
    }
    const std::array<PrismPoint, 3> corners = corners_of(view.slave_sights, surface.face(face));
    const double deepest = std::max({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]});
    if (deepest < 0 || !near_barycentre(prism, corners)) continue;
    view.slave_at_barycentre = true;
    depths.deepest = std::max(depths.deepest, deepest);
  }
}

void project_own(PosedPair& posed, Side master, Index master_face, const MasterPrism& prism, FaceViewScratch& scratch,
                 FaceView& view) {
  list_faces_in_prism(posed, master, prism_in_tree(posed, master, prism), view.own_depth, scratch.open,
                      scratch.own_listed);
  OwnSights sights(prism, posed.surface(master).face(master_face));
  for (const Index face : scratch.own_listed) {
    if (face == master_face) continue;
    const std::array<PrismPoint, 3> corners = own_corners(posed[master], face, sights, posed.work).points;
    view.own_at_barycentre = view.own_at_barycentre || near_barycentre(prism, corners);
    // What else is listed depends on how it was listed; a face that lies over the master and no deeper is, in any case.
    if (std::min({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]}) > view.own_depth) continue;
    add_projected(posed, master, face, true, prism, corners, view.faces);
  }
}

}  // namespace

SeenArea seen_area(PosedPair& posed, Side master, const MasterPrism& prism, Index slave_face) {
  const Side slave = opposite(master);
  const std::array<PrismPoint, 3> corners = prism.see(posed.face_Me(slave, slave_face), posed.work);
  ProjectedFace projected;
  if (!project(posed, slave, slave_face, prism, corners, projected) || !projected.leaves) return SeenArea::none;
  const double max_coordinate = posed.placement.max_coordinate;
  const bool is_certain = surely_has_area(prism, max_coordinate, prism.greatest_uncertainty(max_coordinate), projected);
  return is_certain ? SeenArea::certain : SeenArea::uncertain;
}

OwnFacesBefore own_faces_before(const PosedPair& posed, Side master, const FaceGeometry& geometry, Index face,
                                double deepest) {
  const PreparedSurface& surface = posed.surface(master);
  const ThicknessEverywhere thickness = thickness_everywhere(surface, face);
  const double known = master == Side::E ? thickness.exact : thickness.rounded;
  if (!(deepest < known && own_bounds_hold(posed, master, geometry))) return OwnFacesBefore::some;
  if (thickness.clear_of_neighbours && deepest < thickness.tolerant) return OwnFacesBefore::none;
  if (master == Side::E) return OwnFacesBefore::none;
  return posed.placement.skew > kGreatestSkew ? OwnFacesBefore::some : OwnFacesBefore::leaning;
}

SeenCorners own_corners(PosedSurface& master, Index face, OwnSights& sights, WorkCounters& work) {
  const auto vertex_Me = [&](Index v) -> const Eigen::Vector3d& { return master.vertex_Me(v, work); };
  return sights.corners(master.surface().face(face), vertex_Me, work);
}

void look_through(PosedPair& posed, Side master, Index face, const MasterPrism& prism, bool nested,
                  FaceViewScratch& scratch, FaceView& view) {
  view.faces.clear();
  view.own_depth = -1;
  view.slave_at_barycentre = view.own_at_barycentre = false;
  list_slave(posed, master, face, prism, nested, scratch, view);
  if (view.listed_to_depth < kInfinity) {
    view.slave_at_barycentre = view.own_at_barycentre = true;
    return;
  }
  Depths depths = project_slave(posed, opposite(master), prism, scratch, view);
  const auto surely_thick = [&](double deepest) {
    const double farthest = deepest + farthest_off(prism, posed.placement);
    return deepest < 0 || own_faces_before(posed, master, prism.face(), face, farthest) != OwnFacesBefore::some;
  };
  // Where nothing lies before any listed face it need not be known which of them the barycentre's line meets.
  bool thick = surely_thick(depths.any());
  // A face that touches the master's plane from above hides nothing, but the barycentre's line meets it.
  const double thickness_at_barycentre = thickness(posed.surface(master), face);
  const bool thick_at_barycentre = thick && depths.any() < thickness_at_barycentre;
  if (!thick_at_barycentre) look_along_barycentre(posed.surface(opposite(master)), prism, scratch, view, depths);
  if (!thick) thick = surely_thick(depths.deepest);
  if (thick) {
    // Where the master's other faces were not looked at, what is known of its thickness tells.
    view.own_at_barycentre = !(depths.deepest < thickness_at_barycentre);
  } else {
    // Faces all deeper than this surely lie after what is seen of the slave: depths are sure to kHeightError.
    view.own_depth = (1 + 4 * kHeightError) * depths.deepest;
    project_own(posed, master, face, prism, scratch, view);
  }
}

}  // namespace pcm::fast
