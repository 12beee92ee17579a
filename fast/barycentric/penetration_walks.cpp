// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/barycentric/penetration_walks.h"

#include <bit>
#include <limits>
#include <optional>

#include "fast/base/depth.h"
#include "fast/predicates/penetration_predicates.h"
#include "fast/search/line_walk.h"
#include "fast/simd/element_sets.h"
#include "fast/surface/clearance.h"
#include "fast/surface/thickness.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

[[gnu::always_inline]] inline LineCoordinates line_coordinates(const PosedPair& posed, const ElementLanes& lanes,
                                                               std::size_t lane) {
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
  lanes.thickness.value[lane] = thickness(posed.surface(master), face);
  lanes.clearance[lane] = clearance(posed.surface(opposite(master)), met);
}

DecisionLimits decision_limits(const PosedPair& posed, Side master) {
  const double vertex_error = posed.placement.vertex_error(master);
  const double max_coordinate = posed.surface(master).max_coordinates.maxCoeff();
  DecisionLimits limits;
  limits.least_share = kLeastShare;
  limits.slave_max_coordinate = posed.surface(opposite(master)).max_coordinates.maxCoeff();
  limits.error = kDistanceError * posed.placement.max_coordinate;
  // thickness_holds, for faces that are no needles, and but for what underflows in prisms alone: there the ray's
  // direction is off by less than 2^-40.
  const double line_error = (1 + 0x1p-10) * (vertex_error + 8 * 0x1p-40 * max_coordinate);
  limits.thick_edges = (1 + 0x1p-40) * 8 * max_coordinate * vertex_error;
  limits.thick_area = kThicknessTolerance * max_coordinate - line_error;
  for (std::size_t cone = 0; cone < 2; ++cone) {
    limits.cone_cosine_square[cone] = kConeCosine[cone] * kConeCosine[cone] * (1 + 0x1p-20);
  }
  return limits;
}

/// Whether roundings of the vertices of a face of F, which differ from pose to pose, turn its normal by so little that
/// its line is no farther than a quarter of this distance from where it would be without, m. E's are the same at
/// all poses.
bool line_stays(const Placement& placement, Side master, const FaceGeometry& geometry, double distance) {
  if (master == Side::E) return true;
  const auto& p = geometry.points_Me;
  const double sides = (p[1] - p[0]).lpNorm<1>() + (p[2] - p[0]).lpNorm<1>();
  const double turn = 8 * placement.position_error_E * sides / (2 * geometry.area);
  return turn * 8 * placement.max_coordinate < 0.25 * distance;
}

/// Follows the line of a face where no walk could tell, and remembers what it may meet.
[[gnu::noinline]] Penetration search_and_remember(PosedPair& posed, Side master, Index face,
                                                  const FaceGeometry& geometry, Index left, PenetrationWalks& walks,
                                                  LineMemory& memory) {
  LineTrace& trace = walks.trace;
  trace.radius = memory.radius();
  trace.beyond = 2 * memory.radius();
  const Penetration penetration = find_penetration(posed, master, face, geometry, walks.open, &trace, left);
  if (line_stays(posed.placement, master, geometry, memory.radius())) {
    memory.keep(face, penetration.slave_face, trace);
  } else {
    memory.keep(face, penetration.slave_face);
  }
  return penetration;
}

/// Follows a line among the faces that it may meet, where these are remembered.
[[gnu::noinline]] std::optional<Penetration> recall_penetration(PosedPair& posed, Side master,
                                                                const LineMemory::Line& line, const ElementLanes& lanes,
                                                                std::size_t lane, const LineMemory& memory) {
  if (!memory.holds(line)) return std::nullopt;
  if (line.slave_count == 0 && line.slave_searched == kInfinity) return Penetration();
  const LineCoordinates coordinates = line_coordinates(posed, lanes, lane);
  const KnownFaces known{{coordinates, {memory.slave_faces(line), line.slave_count}, line.slave_searched},
                         {coordinates, {memory.own_faces(line), line.own_count}, line.own_searched}};
  return find_penetration_among(posed, master, line.face, geometry_of(lanes, lane), known);
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
      if (const auto known = recall_penetration(posed, master, *line, lanes, lane, *memory)) {
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
                        : find_penetration(posed, master, faces[lane], geometry, walks.open, nullptr, left);
      const Index found = penetration.slave_face;
      if (found >= 0) walks.slave_nearby[faces[lane]] = walks.last = found;
    }
    lanes.depth.value[lane] = penetration.depth;
  }
}

}  // namespace pcm::fast
