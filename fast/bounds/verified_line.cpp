// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/verified_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/posed/vertex_rounding.h"
#include "fast/prism/ray.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The computed line, X(s) = origin + s direction, with the tube around it in which the exact problem's line X'(s) runs
/// and its slave's faces may stir.
struct Tube {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;
  double direction_error;  ///< length of the difference of both directions
  double radius;           ///< |X'(s) - X(s)| and a vertex's rounding together, as far as any surface reaches, m
  double rounding;         ///< of a vertex, m

  Tube(const FaceGeometry& face, const FaceError& error, const Eigen::Vector3d& rounding_Me, double tube_radius)
      : origin(face.barycentre_Me()),
        direction(-face.n_Me),
        direction_error(error.normal),
        radius(tube_radius),
        rounding(rounding_Me.sum()) {}
};

/// How the exact line may meet a face.
struct Meeting {
  bool possible = false;  ///< it may pass through the closed face, at any s
  bool sure = false;      ///< it surely passes through its inside, in `direction`
  int facing = 0;         ///< -1: it leaves the body there, +1: it enters, 0: not sure
  double least = 0;       ///< where it meets the face, s lies between these, m
  double greatest = 0;
};

// Where the exact line meets the exact face, X' = X'(s), some point Y of the computed face lies within the radius of
// X(s): the same mean of its corners. Seen along the direction the origin then lies within the radius of the projected
// face, and s within it of the mean of the corners' heights.
//
// Not so where the origin is farther than that outside one edge of the projected face, which may turn either way. It
// surely lies inside where it is farther than that inside all of them: as the vertices move from computed to exact, it
// would have to pass an edge otherwise, while the face does not come to be seen edgewise.
Meeting meeting(const Tube& tube, const FacePoints& f) {
  Meeting result;
  std::array<Eigen::Vector3d, 3> d;
  std::array<double, 3> size, along;
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = f[k] - tube.origin;
    size[k] = d[k].lpNorm<1>();
    along[k] = tube.direction.dot(d[k]);
  }
  // Roundings: 16 u covers the 8 of a triple product and that |direction| is 1 to 3 u only.
  bool plus = true, minus = true, surely_plus = true, surely_minus = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double side = tube.direction.dot(d[k].cross(d[next]));
    const double allowed = kSafetyFactor * (tube.radius * (f[next] - f[k]).lpNorm<1>() + 16 * u * size[k] * size[next]);
    plus = plus && side >= -allowed;
    minus = minus && side <= allowed;
    surely_plus = surely_plus && side > allowed;
    surely_minus = surely_minus && side < -allowed;
  }
  result.possible = plus || minus;
  if (!result.possible) return result;

  const auto [nearest, farthest] = std::minmax_element(along.begin(), along.end());
  const double along_error = kSafetyFactor * (tube.radius + 16 * u * std::max({size[0], size[1], size[2]}));
  result.least = *nearest - along_error;
  result.greatest = *farthest + along_error;

  // On the plane of f: (Y - f0) . N = 0, so |s slope - (f0 - origin) . N| <= radius |N|, short of roundings.
  const Eigen::Vector3d first = f[1] - f[0], second = f[2] - f[0];
  const double edges = first.lpNorm<1>() + second.lpNorm<1>();
  const double product = first.lpNorm<1>() * second.lpNorm<1>();
  const Eigen::Vector3d N = first.cross(second);
  const double slope = tube.direction.dot(N);
  const double rounded_slope = 32 * u * product;
  if (std::abs(slope) > 2 * rounded_slope && std::abs(slope) > kLeastProduct) {
    const double s = d[0].dot(N) / slope;
    const double height_error =
        tube.radius * N.lpNorm<1>() + (tube.radius + 32 * u * size[0]) * product * 32 * u + 32 * u * size[0] * product;
    const double s_error =
        kSafetyFactor * (height_error + std::abs(s) * rounded_slope) / (std::abs(slope) - rounded_slope) +
        4 * u * std::abs(s);
    result.least = std::max(result.least, s - s_error);
    result.greatest = std::min(result.greatest, s + s_error);
  }
  // The exact N differs by at most 2 |rounding| times the edges and the product of both their changes.
  const double by_vertices = 2 * tube.rounding * (edges + 2 * tube.rounding);
  const double slope_error =
      kSafetyFactor * (rounded_slope + by_vertices + tube.direction_error * (product + by_vertices));
  if (std::abs(slope) > slope_error && std::abs(slope) > kLeastProduct) result.facing = slope > 0 ? -1 : 1;
  result.sure = (surely_plus || surely_minus) && result.facing != 0;
  return result;
}

/// Calls `visit` for every leaf whose grown box the tube meets at s <= limit, which `visit` may lower.
template <class Visit>
void for_each_face_near(PosedPair& posed, Side side, const Tube& tube, const double& limit, std::vector<Index>& open,
                        const Visit& visit) {
  const Placement& placement = posed.placement;
  const BoxTree& tree = posed.surface(side).tree;
  const TreeRay ray(placement.to_frame_of(side, tube.origin), placement.direction_in_frame_of(side, tube.direction),
                    placement.position_error(side) + 2 * tube.radius);
  open.assign(1, 0);
  while (!open.empty()) {
    const BoxNode& node = tree.node(open.back());
    open.pop_back();
    ++posed.work.box_tests;
    const double entry = ray.entry(node.box);
    if (!(entry <= limit && entry < kInfinity)) continue;
    if (node.leaf()) {
      visit(node.face);
    } else {
      open.push_back(node.child);
      open.push_back(node.child + 1);
    }
  }
}

}  // namespace

// The sum of a box's three widths is more than its diagonal, by enough for a matrix off a rotation.
double extent_of(const PosedPair& posed) {
  const auto half = [&](Side side) { return posed.surface(side).tree.root().box.half.sum(); };
  return 2.1 * (half(Side::E) + half(Side::F)) + posed.placement.position_error_E + posed.placement.position_error_F;
}

double tube_radius(const PosedPair& posed, const FaceError& error, const Eigen::Vector3d& rounding_Me) {
  return kSafetyFactor * (error.barycentre_Me.sum() + rounding_Me.sum() + extent_of(posed) * error.normal);
}

VerifiedLine follow_certainly(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry,
                              const FaceError& error, Index first_met, const LineTrace& trace,
                              const Eigen::Vector3d& rounding_Me, std::vector<Index>& open) {
  using Finding = VerifiedLine::Finding;
  if (!error.normal_known) return {Finding::unknown, extent_of(posed)};
  const Side slave = opposite(master);
  const Tube tube(geometry, error, rounding_Me, tube_radius(posed, error, rounding_Me));

  double limit = extent_of(posed);            // the first slave face is no farther
  double nearest = kInfinity, farthest = -1;  // faces through which the line may leave the slave
  bool rivals = false;
  const auto consider = [&](const Meeting& m) {
    if (!m.possible || m.greatest < 0 || m.least > limit) return false;
    if (m.facing <= 0) {
      nearest = std::min(nearest, m.least);
      farthest = std::max(farthest, m.greatest);
    }
    if (m.sure && m.least > 0) limit = std::min(limit, m.greatest);
    return true;
  };
  Meeting first;
  if (first_met >= 0) {
    first = meeting(tube, posed.face_Me(slave, first_met));
    consider(first);
  }
  const auto visit_slave = [&](Index f) {
    if (f == first_met) return;
    if (consider(meeting(tube, posed.face_Me(slave, f)))) rivals = true;
  };
  for (const Index f : trace.slave_faces) visit_slave(f);
  if (!(limit < trace.slave_searched)) for_each_face_near(posed, slave, tube, limit, open, visit_slave);
  limit = std::min(limit, farthest);
  if (limit < 0) return {Finding::no_element, 0};

  bool left_before = false;
  const auto visit_own = [&](Index own) {
    if (own == face) return;
    const Meeting m = meeting(tube, posed.face_Me(master, own));
    if (!m.possible || m.greatest < 0 || m.least > limit) return;
    rivals = true;
    if (!m.sure || m.least <= 0) return;
    left_before = left_before || m.greatest < nearest;
    limit = left_before ? -1 : std::min(limit, m.greatest);  // Below 0 the search is over.
  };
  for (const Index own : trace.own_faces) visit_own(own);
  if (!left_before && !(limit < trace.own_searched) && !thicker_than(posed, master, face, geometry, limit)) {
    for_each_face_near(posed, master, tube, limit, open, visit_own);
  }
  if (left_before) return {Finding::no_element, 0};
  const bool certain = !rivals && first.sure && first.facing < 0 && first.least > 0;
  return {certain ? Finding::element : Finding::unknown, limit};
}

}  // namespace pcm::fast
