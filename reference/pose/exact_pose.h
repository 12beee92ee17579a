// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>
#include <vector>

#include "pcm/inputs.h"
#include "reference/numbers/numbers.h"
#include "reference/numbers/vector3.h"
#include "reference/pose/box.h"
#include "reference/pose/surface.h"
#include "reference/vocabulary/answer.h"

namespace pcm::reference {

/// A vertex of either surface. The order is that of the tie rule: E's in file order, then F's.
struct Vertex {
  Side side = Side::E;
  Index index = 0;
  auto operator<=>(const Vertex&) const = default;
};

inline Side other(Side side) {
  return side == Side::E ? Side::F : Side::E;
}

template <class T>
Vec3<T> converted(const Eigen::Vector3d& x, const Field<T>& field) {
  return {field(x[0]), field(x[1]), field(x[2])};
}

/// Both surfaces' vertices in Me, x_E = A x_F + r (PCM section 1), for one problem and one pose.
///
/// Rounded problem: F's vertices are doubles, rounded in the order PCM section 1 lays down. Exact problem: real
/// numbers, given to any kind of number by `point` and enclosed in doubles by `enclosure`.
class ExactPose {
 public:
  /// The surfaces must outlive this.
  ExactPose(Problem problem, const Surface& surface_E, const Surface& surface_F, const Pose& pose);

  Problem problem() const { return problem_; }
  const Surface& surface(Side side) const { return side == Side::E ? surface_E_ : surface_F_; }
  const Triangle& face(Side side, Index face) const { return surface(side).mesh.faces[face]; }
  const Pose& pose() const { return pose_; }

  /// The vertex in Me. T must hold it without loss (Exact, Rational) or enclose it (DoubleDouble, Ball, Interval).
  template <class T>
  Vec3<T> point(Vertex v, const Field<T>& field = {}) const {
    if (v.side == Side::E) return converted(surface_E_.mesh.vertices[v.index], field);
    if (problem_ == Problem::rounded) return converted(rounded_F_[v.index], field);
    const Vec3<T> x_F = converted(surface_F_.mesh.vertices[v.index], field);
    const auto row = [&](int i) -> T {
      return dot(converted(Eigen::Vector3d(pose_.A.row(i)), field), x_F) + field(pose_.r[i]);
    };
    return {row(0), row(1), row(2)};
  }

  template <class T>
  std::array<Vec3<T>, 3> corners(Side side, Index f, const Field<T>& field = {}) const {
    const Triangle& t = face(side, f);
    return {point<T>({side, t[0]}, field), point<T>({side, t[1]}, field), point<T>({side, t[2]}, field)};
  }

  /// The vertex within this problem's own bounds: a point where its coordinates are doubles.
  Box enclosure(Vertex v) const {
    if (v.side == Side::E) return {surface_E_.mesh.vertices[v.index], surface_E_.mesh.vertices[v.index]};
    if (problem_ == Problem::rounded) return {rounded_F_[v.index], rounded_F_[v.index]};
    return true_F_[v.index];
  }

  /// A box that holds the vertex as both problems have it, and whatever its rounding may make of it.
  Box rounding_box(Vertex v) const {
    if (v.side == Side::E) return {surface_E_.mesh.vertices[v.index], surface_E_.mesh.vertices[v.index]};
    Box box = true_F_[v.index];
    box.include({rounded_F_[v.index], rounded_F_[v.index]});
    return box;
  }

  /// Holds the face as both problems have it.
  Box face_box(Side side, Index f) const;
  /// Of all faces.
  std::vector<Box> face_boxes(Side side) const;

 private:
  Problem problem_;
  const Surface& surface_E_;
  const Surface& surface_F_;
  Pose pose_;
  std::vector<Eigen::Vector3d> rounded_F_;
  std::vector<Box> true_F_;
};

inline Vec3<Interval> interval_point(const Box& box) {
  return {Interval(box.lower[0], box.upper[0]), Interval(box.lower[1], box.upper[1]),
          Interval(box.lower[2], box.upper[2])};
}

}  // namespace pcm::reference
