// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/barycentric/penetration_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fast/base/depth.h"
#include "fast/predicates/penetration_predicates.h"
#include "fast/prism/ray.h"
#include "fast/simd/overlap_sets.h"
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

/// The penetration line as the tests in double precision and the exact ones take it, made when one is first needed.
class TestedLine {
 public:
  TestedLine(const FaceGeometry& geometry, double max_coordinate)
      : geometry_(geometry), max_coordinate_(max_coordinate) {}

  const LineCoordinates& coordinates() {
    if (!coordinates_) {
      const FacePoints& p = geometry_.points_Me;
      coordinates_.emplace(p, geometry_.barycentre_Me(), (p[1] - p[0]).lpNorm<1>(), (p[2] - p[0]).lpNorm<1>(),
                           max_coordinate_);
    }
    return *coordinates_;
  }
  const PenetrationLine& exact() {
    if (!exact_) exact_.emplace(geometry_.points_Me[0], geometry_.points_Me[1], geometry_.points_Me[2]);
    return *exact_;
  }

 private:
  const FaceGeometry& geometry_;
  double max_coordinate_;
  std::optional<LineCoordinates> coordinates_;
  std::optional<PenetrationLine> exact_;
};

/// A face that the line meets.
struct FaceMet {
  Index face = -1;
  int direction = 0;  ///< -1 where the line leaves the face's body there, +1 where it enters
  FacePoints points_Me;
  Distance distance;
};

/// Whether the line meets the face at q >= 0 (before the shift); fills `met`.
bool meets(TestedLine& line, const Ray& ray, const FacePoints& points, Passage passage, double position_error,
           FaceMet& met, WorkCounters& work) {
  if (passage == Passage::unknown) {
    const std::optional<Passage> sharper = passage_through(line.coordinates(), points, work);
    if (!sharper) return false;
    passage = *sharper;
  }
  if (passage == Passage::unknown) {
    met.direction = facing(line.exact(), points, work);
    if (met.direction == 0 || !passes_through(line.exact(), points, work)) return false;
  } else {
    met.direction = passage == Passage::leaving ? -1 : 1;
  }
  met.distance = distance_to(ray, points, position_error);
  if (met.distance.greatest < 0) return false;
  return met.distance.least > 0 || distance_sign(line.exact(), points, work) >= 0;
}

/// The order of two faces met: by distance, then shift; 0 where both are tied.
int compare(TestedLine& line, const FaceMet& f, const FaceMet& g, WorkCounters& work) {
  if (f.distance.surely_before(g.distance)) return -1;
  if (g.distance.surely_before(f.distance)) return 1;
  return compare_distance(line.exact(), f.points_Me, g.points_Me, work);
}

/// Calls `visit(face, passage)` for every face of a side's surface that the line may meet at most `limit` along it, m,
/// which `visit` may lower: one of `known`, or as the tree has them. Those that the trace wants as well, up to the
/// distance returned.
template <class Visit>
double for_each_face_along(PosedPair& posed, Side side, const Ray& ray, const double& limit,
                           const FacesAlongLine* known, const LineTrace* trace, LineNodes& open, const Visit& visit) {
  if (known != nullptr) {
    for (const Index face : known->faces) visit(face, Passage::unknown);
    return known->searched;
  }
  const WideTree& tree = posed.surface(side).wide_tree;
  const WideRay wide_ray = in_tree_of(side, tree, ray, posed.placement, trace != nullptr ? trace->radius : 0);
  return search_along(tree, wide_ray, limit, fastest_wide_tests(), open, posed.work, visit);
}

/// The first face of a surface that the line meets, by exact distance, then shift, then face index.
/// `left`: one of them, through which the line surely leaves the body at a distance greater than 0, or -1.
/// `searched`: how far along the line all faces were looked at, m. Among known ones the first may lie beyond.
FaceMet first_face_met(PosedPair& posed, Side slave, TestedLine& line, const Ray& ray, Index left,
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
bool leaves_master_before(PosedPair& posed, Side master, Index face, TestedLine& line, const Ray& ray,
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

/// Follows a line among the faces that are known, or as the trees have them; nothing where those do not suffice.
std::optional<Penetration> follow_line(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry,
                                       Index left, const KnownFaces* known, LineNodes& open, LineTrace* trace) {
  const Ray ray(geometry, geometry.barycentre_Me());
  Penetration penetration;
  if (!(ray.direction_error < 1) && has_no_normal(geometry.points_Me)) return penetration;
  TestedLine line(geometry, posed.placement.max_coordinate);
  double searched = 0;
  const FaceMet first = first_face_met(posed, opposite(master), line, ray, left,
                                       known != nullptr ? &known->slave : nullptr, open, trace, searched);
  if (known != nullptr && !(first.distance.greatest <= searched)) return std::nullopt;
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
  if (!(first.distance.least > 0) && distance_sign(line.exact(), first.points_Me, posed.work) == 0) return penetration;
  penetration.outcome = Penetration::Outcome::element;
  penetration.slave_face = first.face;
  penetration.depth = DepthBelow(geometry, first.points_Me).value();
  return penetration;
}

}  // namespace

bool thicker_than(const PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, double distance) {
  const PreparedSurface& surface = posed.surface(master);
  return distance < thickness(surface, face) &&
         thickness_holds(surface, posed.placement.vertex_error(master), geometry);
}

Penetration find_penetration(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, LineNodes& open,
                             LineTrace* trace, Index left) {
  if (trace != nullptr) trace->clear();
  return *follow_line(posed, master, face, geometry, left, nullptr, open, trace);
}

std::optional<Penetration> find_penetration_among(PosedPair& posed, Side master, Index face,
                                                  const FaceGeometry& geometry, const KnownFaces& known) {
  LineNodes none;
  return follow_line(posed, master, face, geometry, -1, &known, none, nullptr);
}

}  // namespace pcm::fast
