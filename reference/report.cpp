// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/report.h"

#include <algorithm>

#include "reference/ball.h"

namespace pcm::reference {
namespace {

/// Precision of the enclosures to begin with: enough for nearly all values.
constexpr mpfr_prec_t kFirstPrecision = 160;
constexpr mpfr_prec_t kLastPrecision = 4096;

bool round_into(const Ball& value, double& target) {
  const std::optional<double> rounded = value.rounded();
  if (rounded) target = *rounded;
  return rounded.has_value();
}

bool round_into(const Vec3<Ball>& value, Eigen::Vector3d& target) {
  bool all = true;
  for (int i = 0; i < 3; ++i) all = round_into(value[i], target[i]) && all;
  return all;
}

Eigen::Vector3d nearest_doubles(const Vec3<Rational>& v) {
  return {nearest_double(v.x), nearest_double(v.y), nearest_double(v.z)};
}

Eigen::Vector3d rounded_position(const CrossingPoints& points, Index crossing) {
  Eigen::Vector3d position;
  const Vec3<Ball> enclosure = points.position<Ball>(crossing, Field<Ball>{kFirstPrecision});
  return round_into(enclosure, position) ? position : nearest_doubles(points.position<Rational>(crossing));
}

/// The three sums of shares times |N|: correctly rounded where the enclosures allow.
template <class T>
bool round_areas(const std::vector<FaceArea<T>>& faces, const Field<Ball>& field, ActiveArea& active, bool last) {
  const auto to_ball = [&field](const T& x) {
    if constexpr (std::is_same_v<T, Ball>)
      return x;
    else
      return field(x);
  };
  Ball open = field(0.0), counted = field(0.0), closed = field(0.0);
  for (const FaceArea<T>& face : faces) {
    const Ball length = sqrt(to_ball(dot(face.normal, face.normal)));
    open = open + to_ball(face.shares.open) * length;
    counted = counted + to_ball(face.shares.counted) * length;
    closed = closed + to_ball(face.shares.closed) * length;
  }
  const bool all = round_into(counted, active.area) & round_into(open, active.area_interval.open) &
                   round_into(closed, active.area_interval.closed);
  if (last && !all) {
    active.area = counted.middle();
    active.area_interval = {open.middle(), closed.middle()};
  }
  return all;
}

template <class T>
Vec3<T> flux_origin(const std::vector<FaceArea<T>>& E, const std::vector<FaceArea<T>>& F, const Field<T>& field) {
  if (!E.empty()) return E[0].point;
  if (!F.empty()) return F[0].point;
  return {field(0.0), field(0.0), field(0.0)};
}

bool report_enclosed(const ExactPose& pose, const ClippedAreas& areas, const Field<Ball>& field, Answer& answer) {
  const std::vector<Vec3<Ball>> positions = all_positions(areas.points, field);
  const auto E = face_areas(pose, areas, Side::E, positions, field);
  const auto F = face_areas(pose, areas, Side::F, positions, field);
  bool all = round_areas(E, field, answer.E, false) & round_areas(F, field, answer.F, false);
  all = round_into(vector_area(E, field), answer.E.vector_area_Me) && all;
  all = round_into(vector_area(F, field), answer.F.vector_area_Me) && all;
  if (answer.volume) {
    const Vec3<Ball> origin = flux_origin(E, F, field);
    all = round_into(flux_third(E, origin, field) + flux_third(F, origin, field), *answer.volume) && all;
  }
  return all;
}

void report_rational(const ExactPose& pose, const ClippedAreas& areas, Answer& answer) {
  const Field<Rational> field;
  const std::vector<Vec3<Rational>> positions = all_positions<Rational>(areas.points);
  const auto E = face_areas(pose, areas, Side::E, positions, field);
  const auto F = face_areas(pose, areas, Side::F, positions, field);
  answer.E.vector_area_Me = nearest_doubles(vector_area(E, field));
  answer.F.vector_area_Me = nearest_doubles(vector_area(F, field));
  if (answer.volume) {
    const Vec3<Rational> origin = flux_origin(E, F, field);
    answer.volume = nearest_double(flux_third(E, origin, field) + flux_third(F, origin, field));
  }
  const auto refine = [](const std::vector<FaceArea<Rational>>& faces, ActiveArea& active) {
    mpfr_prec_t precision = 2 * kFirstPrecision;
    while (!round_areas(faces, Field<Ball>{precision}, active, precision >= kLastPrecision) &&
           precision < kLastPrecision)
      precision *= 2;
  };
  refine(E, answer.E);
  refine(F, answer.F);
}

}  // namespace

void report_polygons(const CrossingPoints& points, const std::vector<Chain>& chains, const std::vector<Index>& patches,
                     Answer& answer) {
  for (std::size_t i = 0; i < chains.size(); ++i) {
    Polygon polygon;
    polygon.closed = chains[i].closed;
    polygon.patch = patches[i];
    answer.patches = std::max(answer.patches, patches[i] + 1);
    for (const Index point : chains[i].points) {
      const CrossingId& id = points.ids()[point];
      polygon.points.push_back({id.edge_side, id.edge, id.face, rounded_position(points, point)});
    }
    answer.polygons.push_back(polygon);
  }
}

void report_areas(const ExactPose& pose, const ClippedAreas& areas, bool has_volume, Answer& answer) {
  answer.undefined_areas = areas.undefined;
  if (has_volume) answer.volume = 0;
  for (const mpfr_prec_t precision : {kFirstPrecision, 2 * kFirstPrecision})
    if (report_enclosed(pose, areas, Field<Ball>{precision}, answer)) return;
  report_rational(pose, areas, answer);
}

}  // namespace pcm::reference
