// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/active/face_paths.h"

namespace pcm::reference {

FacePaths::FacePaths(const Orientation& orientation, Side side, Index face, FaceLines& lines,
                     const std::vector<LineMeeting>& polygon)
    : orientation_(orientation),
      side_(side),
      corners_(orientation.pose().face(side, face)),
      lines_(lines),
      around_{polygon[0], polygon[polygon.size() / 3], polygon[2 * polygon.size() / 3]},
      x_(centre()) {}

Vec3<Interval> FacePaths::centre() const {
  Vec3<Interval> sum{0, 0, 0};
  for (const LineMeeting corner : around_) {
    const Vec3<Interval> at = lines_.point(corner);
    sum = sum + Interval(Interval(1) / (at.x + at.y + at.z)) * at;
  }
  return sum;
}

/// Times a positive number.
const Vec3<Exact>& FacePaths::exact_centre() {
  if (exact_x_) return *exact_x_;
  std::array<Vec3<Exact>, 3> at;
  std::array<Exact, 3> weight;
  for (int i = 0; i < 3; ++i) {
    at[i] = lines_.exact_point(around_[i]);
    weight[i] = at[i].x + at[i].y + at[i].z;
    if (sign_of(weight[i]) > 0) continue;
    at[i] = {-at[i].x, -at[i].y, -at[i].z};
    weight[i] = -weight[i];
  }
  exact_x_ = Exact(weight[1] * weight[2]) * at[0] + Exact(weight[2] * weight[0]) * at[1] +
             Exact(weight[0] * weight[1]) * at[2];
  return *exact_x_;
}

int FacePaths::change(int corner) {
  int sum = 0;
  for (Index segment = 0; segment < lines_.segment_count(); ++segment) sum += passage(corner, segment);
  return sum;
}

int FacePaths::passage(int corner, Index segment) {
  const Index face = lines_.face_of(segment);
  const Triangle& f = orientation_.pose().face(other(side_), face);
  const int from = orientation_.side({side_, corners_[corner]}, other(side_), face);
  if (height_sign(f, segment) == from) return 0;
  const int turn = line_sign(corner, f[0], f[1]);
  return line_sign(corner, f[1], f[2]) == turn && line_sign(corner, f[2], f[0]) == turn ? from : 0;
}

/// Whether x lies above (1) or below (-1) the face: the sum of x_i [f_0 f_1 f_2 p_i].
int FacePaths::height_sign(const Triangle& f, Index segment) {
  if (const int sign = certain_sign(dot(lines_.line(lines_.line_of(segment)), x_)); sign != 0) return sign;
  const Side side = other(side_);
  std::vector<WeightedDeterminant> sum;
  for (int i = 0; i < 3; ++i)
    sum.push_back(
        {exact_centre()[i], {Vertex{side, f[0]}, Vertex{side, f[1]}, Vertex{side, f[2]}, Vertex{side_, corners_[i]}}});
  return orientation_.sign_of_sum(sum);
}

/// On which side of the path the line through q and r passes: the sum of x_i [p_corner p_i q r].
int FacePaths::line_sign(int corner, Index q, Index r) {
  const int i = (corner + 1) % 3, j = (corner + 2) % 3;
  const Vec3<Interval> at = lines_.point_on(q, r);
  if (const int sign = certain_sign(x_[i] * at[j] - x_[j] * at[i]); sign != 0) return sign;
  const Side side = other(side_);
  const auto to = [&](int k) {
    return WeightedDeterminant{
        exact_centre()[k],
        {Vertex{side_, corners_[corner]}, Vertex{side_, corners_[k]}, Vertex{side, q}, Vertex{side, r}}};
  };
  return orientation_.sign_of_sum({to(i), to(j)});
}

}  // namespace pcm::reference
