// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/report.h"

#include <algorithm>

#include "reference/numbers/correct_rounding.h"
#include "reference/numbers/double_double.h"
#include "reference/numbers/radical_sum.h"

namespace pcm::reference {
namespace {

Eigen::Vector3d nearest_doubles(const Vec3<Rational>& v) {
  return {nearest_double(v.x), nearest_double(v.y), nearest_double(v.z)};
}

/// The four sums of shares times |N|.
template <class T>
void round_areas(const std::vector<FaceArea<T>>& faces, const Field<T>& field, CorrectRounder& round,
                 ActiveArea& active) {
  T open = field(0.0), counted = open, closed = open, limit = open;
  for (const FaceArea<T>& face : faces) {
    const T length = sqrt(dot(face.normal, face.normal));
    const T area = face.shares.counted * length;
    counted = counted + area;
    open = open + (face.overlapped ? face.shares.open * length : area);
    closed = closed + (face.overlapped ? face.shares.closed * length : area);
    limit = limit + (face.overlapped ? face.shares.limit * length : area);
  }
  round(counted, active.area);
  round(open, active.area_interval.open);
  round(closed, active.area_interval.closed);
  round(limit, active.limit_area);
}

template <class T>
void round_vector_areas(const std::vector<FaceArea<T>>& faces, const ConvertedPose<T>& pose, CorrectRounder& round,
                        ActiveArea& active) {
  round(vector_area(faces, pose), active.vector_area_Me);
  active.limit_vector_area_Me = active.vector_area_Me;
  if (any_overlapped(faces)) round(vector_area(faces, pose, &Shares<T>::limit), active.limit_vector_area_Me);
}

void report_areas(const std::vector<FaceArea<Rational>>& faces, const ConvertedPose<Rational>& pose,
                  ActiveArea& active) {
  RadicalSum open, counted, closed, limit;
  for (const FaceArea<Rational>& face : faces) {
    const Rational squared_length = dot(face.normal, face.normal);
    counted.add(face.shares.counted, squared_length);
    open.add(face.shares.open, squared_length);
    closed.add(face.shares.closed, squared_length);
    limit.add(face.shares.limit, squared_length);
  }
  active.area = counted.rounded();
  active.area_interval = {open.rounded(), closed.rounded()};
  active.limit_area = limit.rounded();
  active.vector_area_Me = nearest_doubles(vector_area(faces, pose));
  active.limit_vector_area_Me = nearest_doubles(vector_area(faces, pose, &Shares<Rational>::limit));
}

template <class T>
Vec3<T> flux_origin(const std::vector<FaceArea<T>>& E, const std::vector<FaceArea<T>>& F,
                    const ConvertedPose<T>& pose) {
  return !E.empty() ? E[0].point : !F.empty() ? F[0].point : pose.zero();
}

template <class T>
bool report_enclosed(const ExactPose& pose_doubles, const InsideAreas& areas, const Field<T>& field, Answer& answer) {
  ConvertedPose<T> pose(pose_doubles, field);
  const auto E = face_areas(areas, Side::E, pose);
  const auto F = face_areas(areas, Side::F, pose);
  CorrectRounder round;
  round_areas(E, field, round, answer.E);
  round_areas(F, field, round, answer.F);
  round_vector_areas(E, pose, round, answer.E);
  round_vector_areas(F, pose, round, answer.F);
  if (answer.volume) {
    const Vec3<T> origin = flux_origin(E, F, pose);
    round(flux_third(E, origin, pose) + flux_third(F, origin, pose), *answer.volume);
  }
  return round.all();
}

void report_rational(const ExactPose& pose_doubles, const InsideAreas& areas, Answer& answer) {
  ConvertedPose<Rational> pose(pose_doubles);
  const auto E = face_areas(areas, Side::E, pose);
  const auto F = face_areas(areas, Side::F, pose);
  if (answer.volume) {
    const Vec3<Rational> origin = flux_origin(E, F, pose);
    answer.volume = nearest_double(flux_third(E, origin, pose) + flux_third(F, origin, pose));
  }
  report_areas(E, pose, answer.E);
  report_areas(F, pose, answer.F);
}

}  // namespace

void report_polygons(const ExactPose& pose, const CrossingPositions& points, const std::vector<Chain>& chains,
                     const std::vector<Index>& patches, Answer& answer) {
  ConvertedPose<DoubleDouble> enclosures(pose);
  ConvertedPose<Rational> rationals(pose);
  const auto rounded_position = [&](Index crossing) -> Eigen::Vector3d {
    CorrectRounder round;
    Eigen::Vector3d position;
    round(points.position(crossing, enclosures), position);
    return round.all() ? position : nearest_doubles(points.position(crossing, rationals));
  };
  for (std::size_t i = 0; i < chains.size(); ++i) {
    Polygon polygon;
    polygon.closed = chains[i].closed;
    polygon.patch = patches[i];
    answer.patches = std::max(answer.patches, patches[i] + 1);
    for (const Index point : chains[i].points) {
      const CrossingId& id = points.ids()[point];
      polygon.points.push_back({id.edge_side, id.edge, id.face, rounded_position(point)});
    }
    answer.polygons.push_back(polygon);
  }
}

void report_areas(const ExactPose& pose, const InsideAreas& areas, bool has_volume, Answer& answer) {
  answer.undefined_areas = areas.undefined;
  if (has_volume) answer.volume = 0;
  if (report_enclosed(pose, areas, Field<DoubleDouble>{}, answer)) return;
  if (report_enclosed(pose, areas, Field<Ball>{kRoundingPrecision}, answer)) return;
  report_rational(pose, areas, answer);
}

}  // namespace pcm::reference
