// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "meshes/generate/deterministic_trigonometry.h"
#include "meshes/generate/generator_support.h"

namespace pcm::generate {
namespace {

/// Written out, so that the order of operations is fixed.
Eigen::Vector3d cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

Eigen::Vector3d normalized(const Eigen::Vector3d& a) {
  const double length = std::sqrt(a.x() * a.x() + a.y() * a.y() + a.z() * a.z());
  return {a.x() / length, a.y() / length, a.z() / length};
}

/// A point in the plane of a gear.
struct PlanePoint {
  double x = 0;
  double y = 0;
};

PlanePoint rotated(const PlanePoint& p, const CosineSine& by) {
  return {p.x * by.cosine - p.y * by.sine, p.x * by.sine + p.y * by.cosine};
}

/// One tooth centred on the positive x axis, counterclockwise from root to root.
std::vector<PlanePoint> tooth_profile(Index teeth, double module, Index flank_points) {
  constexpr double kHalfPi = 0x1.921fb54442d18p0;
  const double pitch_radius = module * teeth / 2;
  const double root_radius = pitch_radius - 1.25 * module;
  const double tip_radius = pitch_radius + module;
  const auto [cosine, sine] = cosine_sine_of_degrees(20);
  const double base_radius = pitch_radius * cosine;

  // On the involute the roll angle t gives the radius base_radius sqrt(1 + t^2) and the polar angle t - atan t; at the
  // pitch circle t is the tangent of the pressure angle, where the tooth fills half the pitch.
  const auto roll_angle = [base_radius](double radius) {
    const double ratio = radius / base_radius;
    return std::sqrt(std::max(ratio * ratio - 1, 0.0));
  };
  const double pressure_angle = kHalfPi * (20.0 / 90.0);
  const double half_angle_at_base = kHalfPi / teeth + (sine / cosine - pressure_angle);
  const CosineSine to_tooth = cosine_sine_of_radians(-half_angle_at_base);
  const double first_roll = roll_angle(std::max(base_radius, pitch_radius - module));
  const double last_roll = roll_angle(tip_radius);

  std::vector<PlanePoint> flank;
  for (Index i = 0; i < flank_points; ++i) {
    const double roll = first_roll + (last_roll - first_roll) * (static_cast<double>(i) / (flank_points - 1));
    const auto [c, s] = cosine_sine_of_radians(roll);
    flank.push_back(rotated({base_radius * (c + roll * s), base_radius * (s - roll * c)}, to_tooth));
  }

  // The root lies halfway in angle between the flank's start and the middle of the gap.
  const CosineSine middle_of_gap = cosine_sine_of_turn(-1, std::int64_t{2} * teeth);
  const double start_radius = std::sqrt(flank[0].x * flank[0].x + flank[0].y * flank[0].y);
  const PlanePoint bisector{flank[0].x / start_radius + middle_of_gap.cosine,
                            flank[0].y / start_radius + middle_of_gap.sine};
  const double scale = root_radius / std::sqrt(bisector.x * bisector.x + bisector.y * bisector.y);

  std::vector<PlanePoint> profile{{bisector.x * scale, bisector.y * scale}};
  profile.insert(profile.end(), flank.begin(), flank.end());
  for (std::size_t i = profile.size(); i-- > 0;) profile.push_back({profile[i].x, -profile[i].y});
  return profile;
}

}  // namespace

TriangleMesh socket(double radius, double wall, Index segments, Index bands) {
  require_length("radius", radius);
  require_length("wall", wall);
  require_count("segments", segments, 3);
  require_count("bands", bands, 1);
  const double outer_radius = radius + wall;
  std::vector<ProfilePoint> profile{{0, -outer_radius}, {outer_radius, -outer_radius}, {outer_radius, 0}};
  for (Index j = 0; j <= bands; ++j) {
    const auto [cosine, sine] = cosine_sine_of_turn(j, std::int64_t{4} * bands);
    profile.push_back({radius * cosine, 0.0 - radius * sine});
  }
  return surface_of_revolution("socket", profile, segments);
}

TriangleMesh bumpy_sphere(double radius, double amplitude, Index bumps, Index segments, Index bands) {
  require_length("radius", radius);
  require_between("amplitude", amplitude, 0, 0.5);
  require_count("bumps", bumps, 1);
  require_count("segments", segments, 3);
  require_count("bands", bands, 2);
  const Index rings = bands - 1;
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(static_cast<std::size_t>(rings) * segments + 2);
  vertices.emplace_back(0.0, 0.0, -radius);
  for (Index j = 1; j <= rings; ++j) {
    const auto [cosine_polar, sine_polar] = cosine_sine_of_turn(j, std::int64_t{2} * bands);
    const double wave_polar = cosine_sine_of_turn(static_cast<std::int64_t>(bumps) * j, std::int64_t{2} * bands).sine;
    for (Index k = 0; k < segments; ++k) {
      const auto [cosine, sine] = cosine_sine_of_turn(k, segments);
      const double wave = cosine_sine_of_turn(static_cast<std::int64_t>(bumps) * k, segments).cosine;
      const double distance = radius * (1 + amplitude * sine_polar * wave_polar * wave);
      vertices.emplace_back(distance * sine_polar * cosine, distance * sine_polar * sine,
                            0.0 - distance * cosine_polar);
    }
  }
  vertices.emplace_back(0.0, 0.0, radius);
  return finished("bumpy_sphere", std::move(vertices), pole_to_pole_faces(rings, segments));
}

TriangleMesh knotted_tube(double ring_radius, double tube_radius, Index segments, Index tube_segments) {
  require_length("ring_radius", ring_radius);
  require_length("tube_radius", tube_radius);
  require_between("tube_radius", tube_radius, 0, 0.4 * ring_radius);
  require_count("segments", segments, 48);
  require_count("tube_segments", tube_segments, 3);
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(static_cast<std::size_t>(segments) * tube_segments);
  for (Index i = 0; i < segments; ++i) {
    // The knot is (2 + cos 3t) (cos 2t, sin 2t, 0) + sin 3t e_z, in units of half the ring radius. The normal of the
    // torus it lies on is perpendicular to it and returns to itself, so it makes a frame that closes.
    const auto [c2, s2] = cosine_sine_of_turn(std::int64_t{2} * i, segments);
    const auto [c3, s3] = cosine_sine_of_turn(std::int64_t{3} * i, segments);
    const Eigen::Vector3d centre((2 + c3) * c2, (2 + c3) * s2, s3);
    const Eigen::Vector3d normal(c3 * c2, c3 * s2, s3);
    const Eigen::Vector3d tangent(-3 * s3 * c2 - 2 * (2 + c3) * s2, -3 * s3 * s2 + 2 * (2 + c3) * c2, 3 * c3);
    const Eigen::Vector3d binormal = cross(normalized(tangent), normal);
    for (Index k = 0; k < tube_segments; ++k) {
      const auto [cosine, sine] = cosine_sine_of_turn(k, tube_segments);
      vertices.push_back(ring_radius / 2 * centre + tube_radius * (cosine * normal + sine * binormal));
    }
  }
  return finished("knotted_tube", std::move(vertices), ring_faces(segments, tube_segments));
}

TriangleMesh spur_gear(Index teeth, double module, double width, Index flank_points, Index bands) {
  require_count("teeth", teeth, 6, 1000);
  require_length("module", module);
  require_length("width", width);
  require_count("flank_points", flank_points, 2, 1000);
  require_count("bands", bands, 1, 100);
  std::vector<PlanePoint> outline;
  const std::vector<PlanePoint> tooth = tooth_profile(teeth, module, flank_points);
  for (Index i = 0; i < teeth; ++i) {
    const CosineSine to_tooth = cosine_sine_of_turn(i, teeth);
    for (const PlanePoint& point : tooth) outline.push_back(rotated(point, to_tooth));
  }
  const Index rings = bands + 1;
  const Index segments = static_cast<Index>(outline.size());
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(static_cast<std::size_t>(rings) * segments + 2);
  vertices.emplace_back(0.0, 0.0, -width / 2);
  for (Index j = 0; j < rings; ++j) {
    const double z = j == bands ? width / 2 : -width / 2 + width * (static_cast<double>(j) / bands);
    for (const PlanePoint& point : outline) vertices.emplace_back(point.x, point.y, z);
  }
  vertices.emplace_back(0.0, 0.0, width / 2);
  return finished("spur_gear", std::move(vertices), pole_to_pole_faces(rings, segments));
}

}  // namespace pcm::generate
