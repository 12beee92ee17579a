// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/barycentric/penetration_walks.h"

#include <algorithm>
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
// off by 2^-34 M, the slope by 2^-36, and where it exceeds 1/4 their quotient, at most 16 M, by less than 2^-29 M.
constexpr double kLeastShare = 0x1p-10;
constexpr double kDistanceError = 0x1p-29;

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
Index walk_to_line(PosedPair& posed, Side master, const ElementLanes& lanes, std::size_t lane, Index start) {
  const double a = lanes.side[0].value[lane], b = lanes.side[1].value[lane];
  if (start < 0 || !(lanes.area.value[lane] > kLeastShare * (a * b))) return -1;
  const LineCoordinates line = line_coordinates(posed, lanes, lane);
  if (!line.usable()) return -1;
  return walk_to_face_left(posed[opposite(master)], line, start, posed.work);
}

DecisionLimits decision_limits(const PosedPair& posed, Side master) {
  const double vertex_error = posed.placement.vertex_error(master);
  const double max_coordinate = posed.surface(master).max_coordinates.maxCoeff();
  DecisionLimits limits;
  limits.least_share = kLeastShare;
  limits.max_coordinate = posed.placement.max_coordinate;
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

/// A lane's element on a face of the slave. Its depth is in the lanes where that is known. Number by number: a copy of
/// what was just written so would have to wait until it has reached memory.
void enter_element(PosedPair& posed, Side slave, Index slave_face, const ElementLanes& lanes, std::size_t lane,
                   LaneBits depth_known, Penetration& penetration) {
  penetration.outcome = Penetration::Outcome::element;
  penetration.slave_face = slave_face;
  penetration.depth = has_lane(depth_known, lane)
                          ? lanes.depth.value[lane]
                          : DepthBelow(geometry_of(lanes, lane), posed.face_Me(slave, slave_face)).value();
  penetration.first_met = -1;
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
  walks.trace.radius = memory.radius();
  walks.trace.beyond = 2 * memory.radius();
  LineTrace* const trace = memory.is_to_remember_faces() ? &walks.trace : nullptr;
  const Penetration penetration = find_penetration(posed, master, face, geometry, walks.open, trace, left);
  if (trace != nullptr && line_stays(posed.placement, master, geometry, memory.radius())) {
    memory.keep(face, penetration.slave_face, *trace);
  } else {
    memory.keep(face, penetration.slave_face);
  }
  return penetration;
}

/// Follows a line among the faces that it may meet, which are remembered.
[[gnu::noinline]] std::optional<Penetration> follow_among_known(PosedPair& posed, Side master,
                                                                const LineMemory::Line& line, const ElementLanes& lanes,
                                                                std::size_t lane, const LineMemory& memory) {
  const KnownFaces known{{{memory.slave_faces(line), line.slave_count}, line.slave_searched},
                         {{memory.own_faces(line), line.own_count}, line.own_searched}};
  return find_penetration_among(posed, master, line.face, geometry_of(lanes, lane), known);
}

/// The penetration lines of up to four faces.
class PenetrationBatch {
 public:
  PenetrationBatch(PosedPair& posed, Side master, const FaceBatch& faces, std::size_t count, ElementLanes& lanes,
                   PenetrationWalks& walks, LineMemory* memory, const RememberedLines& lines,
                   std::array<Penetration, kElementLanes>& penetrations)
      : posed_(posed),
        master_(master),
        slave_(opposite(master)),
        faces_(faces),
        count_(count),
        lanes_(lanes),
        walks_(walks),
        memory_(memory),
        lines_(lines),
        penetrations_(penetrations) {
    start_.fill(-1);
    met_.fill(-1);
    entered_.fill(-1);
  }

  void find() {
    if (memory_ != nullptr) follow_remembered();
    if (walks_.may_walk) walk();
    if (through_ != 0) decide();
    for (std::size_t lane = 0; lane < count_; ++lane) {
      if (has_lane(found_, lane)) {
        keep_found(lane);
      } else if (!take_decision(lane)) {
        search(lane);
      }
    }
  }

 private:
  /// Lines of the last pose: what they find among known faces, and the faces that they still leave the slave through.
  void follow_remembered() {
    LaneBits asked = 0;
    for (std::size_t lane = 0; lane < count_; ++lane) {
      if (lines_[lane] == nullptr) continue;
      const LineMemory::Line& line = *lines_[lane];
      start_[lane] = line.slave_nearby;
      if (memory_->holds(line)) {
        const Index only = walks_.may_walk ? memory_->only_slave_face(line) : -1;
        if (only >= 0) {
          start_[lane] = only;
          has_only_ |= 1U << lane;
        } else {
          follow_known(lane);
        }
      }
      if (!has_lane(found_, lane) && start_[lane] >= 0) asked |= 1U << lane;
    }
    if (asked != 0 && walks_.may_walk) ask_where_left(asked);
  }

  /// Lines that may leave the slave's body through the faces that they start at.
  void ask_where_left(LaneBits asked) {
    posed_.work.predicates += std::int64_t{3} * std::popcount(asked);
    enter_slave_corners(asked, start_);
    const LeavingLanes leaving = fastest_wide_elements().leave(lanes_, walks_.limits);
    for (; asked != 0; asked &= asked - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(asked));
      if (has_lane(leaving.surely, lane)) {
        set_left(lane, start_[lane]);
      } else if (has_lane(has_only_, lane)) {
        has_only_ &= ~(1U << lane);
        const bool meets_nothing = has_lane(leaving.surely_not, lane) && lines_[lane]->slave_searched == kInfinity;
        if (meets_nothing) {
          set_found(lane, {});
        } else {
          follow_known(lane);
        }
      }
    }
  }

  void walk() {
    for (std::size_t lane = 0; lane < count_; ++lane) {
      if (has_lane(found_ | through_, lane)) continue;
      const Index start =
          start_[lane] >= 0 ? start_[lane] : slave_face_near(posed_.surface(master_), faces_[lane], walks_);
      const Index met = walk_to_line(posed_, master_, lanes_, lane, start);
      if (met >= 0) set_left(lane, met);
    }
  }

  void decide() {
    enter_slave_corners(through_, met_);
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      const std::size_t from = one_of(through_, lane);
      lanes_.thickness.value[lane] = thickness(posed_.surface(master_), faces_[from]);
      lanes_.clearance[lane] = clearance(posed_.surface(slave_), met_[from]);
      lanes_.slave_free.value[lane] = has_lane(has_only_, from) ? lines_[from]->slave_searched : 0;
    }
    decided_ = fastest_wide_elements().decide(lanes_, walks_.limits);
  }

  bool take_decision(std::size_t lane) {
    if (has_lane(through_ & decided_.element, lane)) {
      enter_element(posed_, slave_, met_[lane], lanes_, lane, decided_.nearest_known, penetrations_[lane]);
    } else if (has_lane(through_ & decided_.nothing, lane)) {
      penetrations_[lane] = {};
    } else if (has_lane(has_only_, lane) && follow_known(lane)) {
      keep_found(lane);
      return true;
    } else {
      return false;
    }
    if (memory_ != nullptr) keep_decided(lane);
    return true;
  }

  /// A line that certificates decided.
  void keep_decided(std::size_t lane) {
    if (lines_[lane] != nullptr && memory_->is_settled(*lines_[lane])) {
      memory_->keep(*lines_[lane]);
      return;
    }
    if (has_lane(has_only_, lane)) {
      memory_->keep(*lines_[lane], met_[lane]);
    } else {
      memory_->keep(faces_[lane], met_[lane]);
    }
    if (memory_->is_to_settle()) settle(lane);
  }
  /// Asks until when it goes on to find what it found. Roundings may have moved it there as well as here, which a part
  /// of the way pays for.
  void settle(std::size_t lane) {
    const bool element = penetrations_[lane].outcome == Penetration::Outcome::element;
    const DecidedLine line = decided_line(lane, element);
    const LineMotion& motion = memory_->motion();
    const double travel = travel_until_undecided(line, motion);
    if (!line_stays(posed_.placement, master_, line.geometry, 0.25 * motion.way_over_travel * travel)) return;
    memory_->settle(travel, element ? met_[lane] : -1);
  }
  /// One that the faces remembered told of: where it meets none of them, it does so on.
  void keep_found(std::size_t lane) {
    const LineMemory::Line& line = *lines_[lane];
    memory_->keep(line, penetrations_[lane].slave_face);
    if (LineMemory::meets_nothing(line)) memory_->settle(memory_->held_for(line), -1);
  }

  DecidedLine decided_line(std::size_t lane, bool element) const {
    DecidedLine line{line_coordinates(posed_, lanes_, lane), geometry_of(lanes_, lane),
                     posed_.face_Me(slave_, met_[lane])};
    line.element = element;
    line.distance_error = walks_.limits.error;
    line.clearance = lanes_.clearance[lane];
    line.greatest_of_slave = walks_.limits.slave_max_coordinate;
    if (element && thickness_holds(posed_.surface(master_), memory_->vertex_error(), line.geometry)) {
      line.thickness = lanes_.thickness.value[lane];
    }
    if (has_lane(has_only_, lane)) {
      line.slave_free = lines_[lane]->slave_searched;
      line.slave_free_travel = memory_->held_for(*lines_[lane]);
    }
    return line;
  }

  void search(std::size_t lane) {
    const Index face = faces_[lane];
    const Index left = has_lane(through_ & decided_.left, lane) ? met_[lane] : -1;
    ++search_counter(lane);
    const FaceGeometry geometry = geometry_of(lanes_, lane);
    penetrations_[lane] = memory_ != nullptr
                              ? search_and_remember(posed_, master_, face, geometry, left, walks_, *memory_)
                              : find_penetration(posed_, master_, face, geometry, walks_.open, nullptr, left);
    const Index found = penetrations_[lane].slave_face;
    if (found >= 0) walks_.slave_nearby[face] = walks_.last = found;
  }

  /// By why it has to be searched for.
  std::int64_t& search_counter(std::size_t lane) {
    WorkCounters& work = posed_.work;
    if (!has_lane(through_, lane)) return work.searches_unseen;
    if (has_lane(decided_.oblique, lane)) return work.searches_oblique;
    return has_lane(decided_.left & decided_.thin, lane) ? work.searches_master : work.searches_slave;
  }

  /// Follows a line among the faces that it may meet, which are remembered; whether these suffice.
  bool follow_known(std::size_t lane) {
    const LineMemory::Line& line = *lines_[lane];
    if (LineMemory::meets_nothing(line)) {
      set_found(lane, {});
    } else if (const auto found = follow_among_known(posed_, master_, line, lanes_, lane, *memory_)) {
      set_found(lane, *found);
    }
    return has_lane(found_, lane);
  }

  void set_found(std::size_t lane, const Penetration& penetration) {
    penetrations_[lane] = penetration;
    found_ |= 1U << lane;
  }
  void set_left(std::size_t lane, Index met) {
    met_[lane] = walks_.slave_nearby[faces_[lane]] = walks_.last = met;
    through_ |= 1U << lane;
  }

  /// All lanes get corners; those that are not asked for will not be looked at.
  void enter_slave_corners(LaneBits which, const FaceBatch& faces) {
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      const Index face = faces[one_of(which, lane)];
      if (entered_[lane] == face) continue;
      entered_[lane] = face;
      enter_corners(posed_, slave_, face, lanes_.slave_corners, lane);
    }
  }

  PosedPair& posed_;
  Side master_, slave_;
  const FaceBatch& faces_;
  std::size_t count_;
  ElementLanes& lanes_;
  PenetrationWalks& walks_;
  LineMemory* memory_;
  const RememberedLines& lines_;
  std::array<Penetration, kElementLanes>& penetrations_;

  LaneBits found_ = 0;     ///< what they find was told by the faces remembered
  LaneBits has_only_ = 0;  ///< may meet one face of the slave alone, as far as that was searched
  LaneBits through_ = 0;   ///< surely pass through the slave's face `met`, from inside, at whatever distance
  FaceBatch start_, met_, entered_;
  DecidedLanes decided_;
};

}  // namespace

void PenetrationWalks::start(const PosedPair& posed, const Crossings& crossings, Side master) {
  const Side slave = opposite(master);
  last = -1;
  limits = decision_limits(posed, master);
  may_walk =
      posed.placement.position_error(slave) < kClearanceTolerance * posed.surface(slave).max_coordinates.maxCoeff();
  slave_nearby.start(posed.surface(master).mesh.faces.size());
  for (const CrossingNode& crossing : crossings.nodes) {
    if (crossing.next < 0) continue;
    slave_nearby[crossing.segment_face[static_cast<std::size_t>(master)]] =
        crossing.segment_face[static_cast<std::size_t>(slave)];
  }
}

void find_settled(PosedPair& posed, Side master, const FaceBatch& faces, std::size_t count,
                  const RememberedLines& lines, ElementLanes& lanes,
                  std::array<Penetration, kElementLanes>& penetrations) {
  find_geometry(posed, master, faces, count, lanes);
  const Side slave = opposite(master);
  LaneBits elements = 0;
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (lines[lane]->element_on >= 0) elements |= 1U << lane;
  }
  for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
    enter_corners(posed, slave, lines[one_of(elements, lane)]->element_on, lanes.slave_corners, lane);
  }
  const LaneBits known = fastest_wide_elements().depth(lanes);
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (has_lane(elements, lane)) {
      enter_element(posed, slave, lines[lane]->element_on, lanes, lane, known, penetrations[lane]);
    } else {
      penetrations[lane] = {};
    }
  }
}

void find_penetrations(PosedPair& posed, Side master, const FaceBatch& faces, std::size_t count, ElementLanes& lanes,
                       PenetrationWalks& walks, LineMemory* memory, const RememberedLines& lines,
                       std::array<Penetration, kElementLanes>& penetrations) {
  PenetrationBatch(posed, master, faces, count, lanes, walks, memory, lines, penetrations).find();
}

}  // namespace pcm::fast
