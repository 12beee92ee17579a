// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/flush_places.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "compare/poses/surface_features.h"

namespace pcm::compare {
namespace {

/// Places that rounding leaves more uncertain than this make no place.
constexpr double kGreatestError = 0x1p-10;

/// How near normals and planes must be to be looked at: far above rounding. What is looked at in vain costs a few
/// evaluations and changes nothing.
constexpr double kNear = 0x1p-30;

struct Plane {
  Eigen::Vector3d n;      ///< unit normal
  Eigen::Vector3d point;  ///< of it
};

/// The distinct planes of a mesh's faces: those nearer than kNear count once, but for some on either side of a
/// rounding.
std::vector<Plane> planes_of(const TriangleMesh& mesh) {
  std::vector<Plane> planes;
  std::set<std::array<double, 4>> seen;
  const double size = radius_about_origin(mesh);
  for (const Triangle& face : mesh.faces) {
    const auto vertex = [&](std::size_t i) -> const Eigen::Vector3d& {
      return mesh.vertices[static_cast<std::size_t>(face[i])];
    };
    const Eigen::Vector3d n = (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)).normalized();
    const auto key = [](double x) { return std::round(x / kNear); };
    if (seen.insert({key(n.x()), key(n.y()), key(n.z()), key(n.dot(vertex(0)) / size)}).second)
      planes.push_back({n, vertex(0)});
  }
  return planes;
}

/// Pairs of one grid with another are flush together, but for roundings.
std::vector<FlushPlace> merged(std::vector<FlushPlace> places) {
  std::sort(places.begin(), places.end(), [](const FlushPlace& a, const FlushPlace& b) { return a.share < b.share; });
  std::vector<FlushPlace> result;
  for (const FlushPlace& place : places) {
    if (!result.empty() && place.share - result.back().share <= result.back().error)
      result.back().error = std::max(result.back().error, place.error);
    else
      result.push_back(place);
  }
  return result;
}

/// Collects the flush places of pairs of planes.
class Search {
 public:
  Search(const PathSegment& segment, double size)
      : segment_(segment),
        start_(segment.at(0)),
        shift_(segment.shift_Me()),
        angle_(segment.turn_Me().norm()),
        axis_(angle_ > 0 ? Eigen::Vector3d(segment.turn_Me() / angle_) : Eigen::Vector3d::UnitX()),
        size_(size) {}

  const Eigen::Vector3d& axis() const { return axis_; }
  const Pose& start() const { return start_; }

  void look_at(const Plane& e, const Plane& f) {
    const Eigen::Vector3d n_f = start_.A * f.n;
    const Eigen::Vector3d across_e = e.n - axis_.dot(e.n) * axis_, across_f = n_f - axis_.dot(n_f) * axis_;
    if (angle_ == 0 || across_e.norm() < kNear) {
      if ((e.n - n_f).norm() > kNear) return;
      const double distance = e.n.dot(start_.A * f.point + start_.r - e.point), slope = e.n.dot(shift_);
      if (std::abs(distance) > std::abs(slope) + kNear * size_) return;
      add(-distance / slope, 0x1p-46 * size_ / std::abs(slope));
      return;
    }
    double turn = std::atan2(axis_.dot(across_f.cross(across_e)), across_f.dot(across_e));
    if (turn < 0) turn += 2 * std::numbers::pi;
    // A hair before the start and after the end counts as well.
    for (const double share : {turn / angle_, (turn - 2 * std::numbers::pi) / angle_}) {
      if (share < -kNear || share > 1 + kNear) continue;
      const Pose pose = segment_.at(std::clamp(share, 0.0, 1.0));
      if (std::abs(e.n.dot(pose.A * f.point + pose.r - e.point)) > kNear * size_) continue;
      add(share, 0x1p-46 / (across_e.norm() * angle_));
    }
  }

  std::vector<FlushPlace> places;
  bool all_along = false;

 private:
  /// The share is NaN and the error infinite for a pair that keeps its distance 0.
  void add(double share, double error) {
    if (!(error <= kGreatestError))
      all_along = true;
    else if (share + error >= 0 && share - error <= 1)
      places.push_back({share, error});
  }

  const PathSegment& segment_;
  Pose start_;
  Eigen::Vector3d shift_;
  double angle_;
  Eigen::Vector3d axis_;
  double size_;
};

}  // namespace

FlushPlaces flush_places(const TriangleMesh& E, const TriangleMesh& F, const PathSegment& segment) {
  const Pose start = segment.at(0);
  Search search(segment, radius_about_origin(E) + radius_about_origin(F) + start.r.norm() + segment.shift_Me().norm());
  std::vector<std::pair<double, Plane>> of_F;  // by the component that the motion keeps
  for (const Plane& plane : planes_of(F)) of_F.emplace_back(search.axis().dot(start.A * plane.n), plane);
  const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::sort(of_F.begin(), of_F.end(), less);
  for (const Plane& e : planes_of(E)) {
    const double kept = search.axis().dot(e.n);
    for (auto f = std::lower_bound(of_F.begin(), of_F.end(), std::pair(kept - kNear, Plane{}), less);
         f != of_F.end() && f->first <= kept + kNear; ++f)
      search.look_at(e, f->second);
  }
  return {merged(std::move(search.places)), search.all_along};
}

}  // namespace pcm::compare
