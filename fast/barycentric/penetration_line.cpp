// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/barycentric/penetration_line.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "fast/base/depth.h"
#include "fast/predicates/penetration_predicates.h"
#include "fast/prism/ray.h"
#include "fast/search/line_search.h"
#include "fast/search/line_walk.h"
#include "fast/simd/element_sets.h"
#include "fast/simd/face_lanes.h"
#include "fast/simd/overlap_sets.h"
#include "fast/surface/clearance.h"
#include "fast/surface/thickness.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How far the line's points and a surface's may be from the computed ones, m. No point of the surfaces is farther from
/// the line's origin than 8 times the greatest coordinate.
double line_position_error(Side side, const Ray& ray, const Placement& placement) {
  return placement.position_error(side) + 8 * placement.max_coordinate * ray.direction_error;
}

/// The line in the coordinates of a surface's tree.
WideRay in_tree_of(Side side, const WideTree& tree, const Ray& ray, const Placement& placement, double radius) {
  return {tree, placement.to_frame_of(side, ray.origin), placement.direction_in_frame_of(side, ray.direction),
          line_position_error(side, ray, placement) + radius};
}

/// Where the line meets the plane of a face: bounds of the distance, m.
struct Distance {
  double least = -kInfinity;
  double greatest = kInfinity;

  bool surely_before(const Distance& other) const { return greatest < other.least; }
};

/// Bounds of the distance at which the line meets f, given that it does: no nearer and no farther than f's vertices,
/// and near the quotient (11) where the angle is fair.
Distance distance_to(const Ray& ray, const FacePoints& f, double position_error) {
  if (!(ray.direction_error < 1)) return {};
  const Eigen::Vector3d d0 = f[0] - ray.origin;
  const Eigen::Vector3d first_edge = f[1] - f[0], second_edge = f[2] - f[0];
  const double along0 = ray.direction.dot(d0);
  const double along1 = along0 + ray.direction.dot(first_edge), along2 = along0 + ray.direction.dot(second_edge);
  double least = std::min({along0, along1, along2}), greatest = std::max({along0, along1, along2});
  const Eigen::Vector3d N = first_edge.cross(second_edge);
  // 1-norms: |a x b| <= |a| |b|. Roundings: 32 u covers the 12 of each quantity, 2^-1070 what underflow takes.
  const double size = first_edge.lpNorm<1>() * second_edge.lpNorm<1>();
  const double height_error = (position_error + 32 * 0x1p-53 * d0.lpNorm<1>()) * size + 0x1p-1070;
  const double slope = ray.direction.dot(N);
  const double slope_error = (3 * ray.direction_error + 32 * 0x1p-53) * size;
  if (std::abs(slope) > 2 * slope_error && std::abs(slope) > kLeastProduct) {
    const double height = slope > 0 ? d0.dot(N) : -d0.dot(N);
    const double steepest = std::abs(slope) + slope_error, least_steep = std::abs(slope) - slope_error;
    const auto quotient = [&](double numerator, double small, double great) {
      return numerator / (numerator > 0 ? small : great);
    };
    greatest = std::min(greatest, quotient(height + height_error, least_steep, steepest));
    least = std::max(least, quotient(height - height_error, steepest, least_steep));
  }
  // Where anything overflowed, nothing is known. The last roundings are far below the position error.
  return {std::isfinite(least) ? least - position_error : -kInfinity,
          std::isfinite(greatest) ? greatest + position_error : kInfinity};
}

/// The penetration line as exact predicates take it, made when one is first needed.
class ExactLine {
 public:
  explicit ExactLine(const FacePoints& points) : points_(points) {}
  const PenetrationLine& operator*() {
    if (!line_) line_.emplace(points_[0], points_[1], points_[2]);
    return *line_;
  }

 private:
  const FacePoints& points_;
  std::optional<PenetrationLine> line_;
};

/// A face that the line meets.
struct FaceMet {
  Index face = -1;
  int direction = 0;  ///< -1 where the line leaves the face's body there, +1 where it enters
  FacePoints points_Me;
  Distance distance;
};

/// Whether the line meets the face at q >= 0 (before the shift); fills `met`.
bool meets(ExactLine& line, const Ray& ray, const FacePoints& points, Passage passage, double position_error,
           FaceMet& met, WorkCounters& work) {
  if (passage == Passage::unknown) {
    met.direction = facing(*line, points, work);
    if (met.direction == 0 || !passes_through(*line, points, work)) return false;
  } else {
    met.direction = passage == Passage::leaving ? -1 : 1;
  }
  met.distance = distance_to(ray, points, position_error);
  if (met.distance.greatest < 0) return false;
  return met.distance.least > 0 || distance_sign(*line, points, work) >= 0;
}

/// The order of two faces met: by distance, then shift; 0 where both are tied.
int compare(ExactLine& line, const FaceMet& f, const FaceMet& g, WorkCounters& work) {
  if (f.distance.surely_before(g.distance)) return -1;
  if (g.distance.surely_before(f.distance)) return 1;
  return compare_distance(*line, f.points_Me, g.points_Me, work);
}

/// All faces that a line may meet up to a distance along it, m.
struct FacesAlongLine {
  const LineCoordinates& line;
  std::span<const Index> faces;
  double searched = 0;
};

/// Calls `visit(face, passage)` for every face of a side's surface that the line may meet at most `limit` along it, m,
/// which `visit` may lower: one of `known`, or as the tree has them. Those that the trace wants as well, up to the
/// distance returned.
template <class Visit>
double for_each_face_along(PosedPair& posed, Side side, const Ray& ray, const double& limit,
                           const FacesAlongLine* known, const LineTrace* trace, LineNodes& open, const Visit& visit) {
  if (known != nullptr) {
    for (const Index face : known->faces) {
      const std::optional<Passage> passage = passage_through(posed[side], known->line, face, posed.work);
      if (passage) visit(face, *passage);
    }
    return known->searched;
  }
  const WideTree& tree = posed.surface(side).wide_tree;
  const WideRay wide_ray = in_tree_of(side, tree, ray, posed.placement, trace != nullptr ? trace->radius : 0);
  return search_along(tree, wide_ray, limit, fastest_wide_tests(), open, posed.work, visit);
}

/// The first face of a surface that the line meets, by exact distance, then shift, then face index.
/// `left`: one of them, through which the line surely leaves the body at a distance greater than 0, or -1.
/// `searched`: how far along the line all faces were looked at, m: the first one is no farther than that, or none is.
FaceMet first_face_met(PosedPair& posed, Side slave, ExactLine& line, const Ray& ray, Index left,
                       const FacesAlongLine* known, LineNodes& open, LineTrace* trace, double& searched) {
  WorkCounters& work = posed.work;
  const double position_error = line_position_error(slave, ray, posed.placement);
  const double beyond = trace != nullptr ? trace->beyond : 0;
  FaceMet first;
  if (left >= 0) {
    first.face = left;
    first.direction = -1;
    first.points_Me = posed.face_Me(slave, left);
    first.distance = distance_to(ray, first.points_Me, position_error);
  }
  double limit = first.distance.greatest + beyond;
  const auto visit = [&](Index face, Passage passage) {
    if (trace != nullptr) trace->slave_faces.push_back(face);
    if (face == left) return;
    FaceMet met;
    met.face = face;
    met.points_Me = posed.face_Me(slave, face);
    if (!meets(line, ray, met.points_Me, passage, position_error, met, work)) return;
    if (first.face >= 0) {
      const int order = compare(line, met, first, work);
      if (order > 0 || (order == 0 && face > first.face)) return;
    }
    first = met;
    limit = first.distance.greatest + beyond;
  };
  searched = for_each_face_along(posed, slave, ray, limit, known, trace, open, visit);
  if (trace != nullptr) trace->slave_searched = searched;
  return first;
}

/// Whether the line meets another face of the master strictly before `limit`.
bool leaves_master_before(PosedPair& posed, Side master, Index face, ExactLine& line, const Ray& ray,
                          const FaceMet& limit, const FacesAlongLine* known, LineNodes& open, LineTrace* trace) {
  WorkCounters& work = posed.work;
  const double position_error = line_position_error(master, ray, posed.placement);
  bool leaves = false;
  double no_farther_than = limit.distance.greatest + (trace != nullptr ? trace->beyond : 0);
  const auto visit = [&](Index own, Passage passage) {
    if (own == face || leaves) return;
    if (trace != nullptr) trace->own_faces.push_back(own);
    FaceMet met;
    met.points_Me = posed.face_Me(master, own);
    if (!meets(line, ray, met.points_Me, passage, position_error, met, work) || compare(line, met, limit, work) >= 0)
      return;
    leaves = true;
    no_farther_than = -1;  // The search is over.
  };
  for_each_face_along(posed, master, ray, no_farther_than, known, trace, open, visit);
  if (trace != nullptr) trace->own_listed = !leaves;
  return leaves;
}

/// Whether a face's vertices lie exactly on a line: N = 0 where the plane through them holds every point that differs
/// from one of them in a single coordinate.
bool has_no_normal(const FacePoints& p) {
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3d x = p[0];
    x[k] = x[k] == 0 ? 1 : 0;
    if (exact_orientation(p[0].data(), p[1].data(), p[2].data(), x.data()) != 0) return false;
  }
  return true;
}

// What follows holds for faces that are no needles: the area exceeds kLeastShare times the product of two sides'
// 1-norms. With u = 2^-53 and M the greatest |coordinate| in Me: components of the cross product of two sides are off
// by 4 u times that product, so that the computed unit normal is off by less than 2^-38 in length. Then n . (x - C) is
// off by 2^-34 M, the slope by 2^-36, and where it exceeds 1/2 their quotient, at most 8 M, by less than 2^-30 M.
constexpr double kLeastShare = 0x1p-10;
constexpr double kDistanceError = 0x1p-30;

/// Where a walk over the slave to a master face's penetration line may start: near that of a neighbour, or at `last`.
Index slave_face_near(const PreparedSurface& master, Index face, const PenetrationWalks& walks) {
  const Index own = walks.slave_nearby.get(face, -1);
  if (own >= 0) return own;
  for (const Index neighbour : master.neighbours_of(face)) {
    const Index near = walks.slave_nearby.get(neighbour, -1);
    if (near >= 0) return near;
  }
  return walks.last;
}

LineCoordinates line_coordinates(const PosedPair& posed, const ElementLanes& lanes, std::size_t lane) {
  const FacePoints p{lanes.p_Me[0][lane], lanes.p_Me[1][lane], lanes.p_Me[2][lane]};
  return {p, lanes.barycentre_Me[lane], lanes.side[0].value[lane], lanes.side[1].value[lane],
          posed.placement.max_coordinate};
}

/// The face through which a lane's line surely leaves the slave's body, at whatever distance, found by a walk; or -1.
Index walk_from_neighbour(PosedPair& posed, Side master, const ElementLanes& lanes, std::size_t lane, Index start) {
  const double a = lanes.side[0].value[lane], b = lanes.side[1].value[lane];
  if (start < 0 || !(lanes.area.value[lane] > kLeastShare * (a * b))) return -1;
  const LineCoordinates line = line_coordinates(posed, lanes, lane);
  if (!line.usable()) return -1;
  return walk_to_face_left(posed[opposite(master)], line, start, posed.work);
}

/// What `decide` needs to know of a lane's master face and of the slave's face that a walk came to.
void enter_match(PosedPair& posed, Side master, Index face, Index met, ElementLanes& lanes, std::size_t lane) {
  enter_corners(posed, opposite(master), met, lanes.slave_corners, lane);
  lanes.thickness[lane] = &posed.surface(master).thickness[static_cast<std::size_t>(face)];
  lanes.clearance[lane] = &posed.surface(opposite(master)).clearance[static_cast<std::size_t>(met)];
}

DecisionLimits decision_limits(const PosedPair& posed, Side master) {
  const double vertex_error = posed.placement.vertex_error(master);
  const double max_coordinate = posed.surface(master).max_coordinates.maxCoeff();
  DecisionLimits limits;
  limits.least_share = kLeastShare;
  limits.slave_max_coordinate = posed.surface(opposite(master)).max_coordinates.maxCoeff();
  limits.error = kDistanceError * posed.placement.max_coordinate;
  // thickness_holds, for faces that are no needles: there the ray's direction is off by less than 2^-40.
  const double line_error = (1 + 0x1p-10) * (vertex_error + 8 * 0x1p-40 * max_coordinate);
  limits.thick_edges = (1 + 0x1p-40) * 8 * max_coordinate * vertex_error;
  limits.thick_area = kThicknessTolerance * max_coordinate - line_error;
  for (std::size_t cone = 0; cone < 2; ++cone) {
    limits.cone_cosine_square[cone] = kConeCosine[cone] * kConeCosine[cone] * (1 + 0x1p-20);
  }
  return limits;
}

/// All faces that a line may meet, as far as they are known.
struct KnownFaces {
  FacesAlongLine slave, own;
};

/// find_penetration, given a face that the line surely leaves the slave through, at a distance greater than 0; or -1.
/// Nothing where what is known of the faces does not suffice.
std::optional<Penetration> follow_line(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry,
                                       Index left, const KnownFaces* known, LineNodes& open, LineTrace* trace) {
  const Ray ray(geometry, geometry.barycentre_Me());
  Penetration penetration;
  if (!(ray.direction_error < 1) && has_no_normal(geometry.points_Me)) return penetration;
  ExactLine line(geometry.points_Me);
  double searched = 0;
  const FaceMet first = first_face_met(posed, opposite(master), line, ray, left,
                                       known != nullptr ? &known->slave : nullptr, open, trace, searched);
  if (!(first.distance.greatest <= searched)) return std::nullopt;
  penetration.first_met = first.face;
  if (first.face < 0 || first.direction > 0) return penetration;
  if (!thicker_than(posed, master, face, geometry, first.distance.greatest)) {
    const FacesAlongLine* const own = known != nullptr ? &known->own : nullptr;
    if (own != nullptr && !(first.distance.greatest <= own->searched)) return std::nullopt;
    if (leaves_master_before(posed, master, face, line, ray, first, own, open, trace)) {
      penetration.outcome = Penetration::Outcome::too_deep;
      return penetration;
    }
  }
  if (trace != nullptr) trace->own_searched = first.distance.greatest + (trace->own_listed ? trace->beyond : 0);
  if (!(first.distance.least > 0) && distance_sign(*line, first.points_Me, posed.work) == 0) return penetration;
  penetration.outcome = Penetration::Outcome::element;
  penetration.slave_face = first.face;
  penetration.depth = DepthBelow(geometry, first.points_Me).value();
  return penetration;
}

Penetration search_penetration(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, Index left,
                               LineNodes& open, LineTrace* trace) {
  return *follow_line(posed, master, face, geometry, left, nullptr, open, trace);
}

/// Whether roundings of the vertices of a face of F, which differ from pose to pose, turn its normal by so little that
/// its line is no farther than a quarter of this distance from where it would be without, m. E's are the same at all.
bool line_stays(const Placement& placement, Side master, const FaceGeometry& geometry, double distance) {
  if (master == Side::E) return true;
  const auto& p = geometry.points_Me;
  const double sides = (p[1] - p[0]).lpNorm<1>() + (p[2] - p[0]).lpNorm<1>();
  const double turn = 8 * placement.position_error_E * sides / (2 * geometry.area);
  return turn * 8 * placement.max_coordinate < 0.25 * distance;
}

/// Follows the line of a face where no walk could tell, and remembers what it may meet.
Penetration search_and_remember(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, Index left,
                                PenetrationWalks& walks, LineMemory& memory) {
  LineTrace& trace = walks.trace;
  trace.clear();
  trace.radius = memory.radius();
  trace.beyond = 2 * memory.radius();
  const Penetration penetration = search_penetration(posed, master, face, geometry, left, walks.open, &trace);
  if (line_stays(posed.placement, master, geometry, memory.radius())) {
    memory.keep(face, penetration.slave_face, trace);
  } else {
    memory.keep(face, penetration.slave_face);
  }
  return penetration;
}

/// Follows a line among the faces that it may meet, where these are remembered.
std::optional<Penetration> recall_penetration(PosedPair& posed, Side master, Index face, const LineMemory::Line& line,
                                              const ElementLanes& lanes, std::size_t lane, PenetrationWalks& walks,
                                              LineMemory& memory) {
  if (!memory.holds(line)) return std::nullopt;
  std::optional<Penetration> penetration;
  if (line.slave_count == 0 && line.slave_searched == kInfinity) {
    penetration.emplace();
  } else {
    const LineCoordinates coordinates = line_coordinates(posed, lanes, lane);
    const KnownFaces known{{coordinates, {memory.slave_faces(line), line.slave_count}, line.slave_searched},
                           {coordinates, {memory.own_faces(line), line.own_count}, line.own_searched}};
    penetration = follow_line(posed, master, face, geometry_of(lanes, lane), -1, &known, walks.open, nullptr);
  }
  return penetration;
}

}  // namespace

void find_penetrations(PosedPair& posed, Side master, const FaceBatch& faces, std::size_t count, ElementLanes& lanes,
                       PenetrationWalks& walks, LineMemory* memory,
                       std::array<Penetration, kElementLanes>& penetrations) {
  const Side slave = opposite(master);
  const bool may_walk =
      posed.placement.position_error(slave) < kClearanceTolerance * posed.surface(slave).max_coordinates.maxCoeff();
  std::array<Index, kElementLanes> met;
  met.fill(-1);
  std::array<const LineMemory::Line*, kElementLanes> lines{};
  LaneBits walked = 0, recalled = 0;
  for (std::size_t lane = 0; lane < count; ++lane) {
    const Index face = faces[lane];
    const LineMemory::Line* const line = lines[lane] = memory != nullptr ? memory->recall(face) : nullptr;
    if (line != nullptr) {
      if (const auto known = recall_penetration(posed, master, face, *line, lanes, lane, walks, *memory)) {
        penetrations[lane] = *known;
        recalled |= 1U << lane;
        continue;
      }
    }
    if (!may_walk) continue;
    const bool has_start = line != nullptr && line->slave_nearby >= 0;
    const Index start = has_start ? line->slave_nearby : slave_face_near(posed.surface(master), face, walks);
    met[lane] = walk_from_neighbour(posed, master, lanes, lane, start);
    if (met[lane] < 0) continue;
    walks.slave_nearby[face] = walks.last = met[lane];
    walked |= 1U << lane;
  }
  DecidedLanes decided;
  if (walked != 0) {
    // Lanes that found no face take what another one found, and are not looked at.
    const auto some = static_cast<std::size_t>(std::countr_zero(walked));
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      const std::size_t from = has_lane(walked, lane) ? lane : some;
      enter_match(posed, master, faces[from], met[from], lanes, lane);
    }
    decided = fastest_wide_elements().decide(lanes, decision_limits(posed, master));
  }
  for (std::size_t lane = 0; lane < count; ++lane) {
    Penetration& penetration = penetrations[lane];
    if (has_lane(recalled, lane)) {
      memory->keep(*lines[lane], penetration.slave_face);
      lanes.depth.value[lane] = penetration.depth;
      continue;
    }
    penetration = {};
    const bool nothing = has_lane(walked & decided.nothing, lane), element = has_lane(walked & decided.element, lane);
    if ((nothing || element) && memory != nullptr) memory->keep(faces[lane], met[lane]);
    if (nothing) continue;
    if (element && has_lane(decided.nearest_known, lane)) {
      penetration = {Penetration::Outcome::element, met[lane], lanes.depth.value[lane], -1};
      continue;
    }
    const FaceGeometry geometry = geometry_of(lanes, lane);
    if (element) {
      const FacePoints f = posed.face_Me(slave, met[lane]);
      penetration = {Penetration::Outcome::element, met[lane], DepthBelow(geometry, f).value(), -1};
    } else {
      const Index left = has_lane(walked & decided.left, lane) ? met[lane] : -1;
      penetration = memory != nullptr
                        ? search_and_remember(posed, master, faces[lane], geometry, left, walks, *memory)
                        : search_penetration(posed, master, faces[lane], geometry, left, walks.open, nullptr);
      const Index found = penetration.slave_face;
      if (found >= 0) walks.slave_nearby[faces[lane]] = walks.last = found;
    }
    lanes.depth.value[lane] = penetration.depth;
  }
}

bool thicker_than(const PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, double distance) {
  const PreparedSurface& surface = posed.surface(master);
  return distance < surface.thickness[static_cast<std::size_t>(face)] &&
         thickness_holds(surface, posed.placement.vertex_error(master), geometry);
}

Penetration find_penetration(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, LineNodes& open,
                             LineTrace* trace) {
  if (trace != nullptr) trace->clear();
  return search_penetration(posed, master, face, geometry, -1, open, trace);
}

}  // namespace pcm::fast
