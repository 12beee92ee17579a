// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/numbers/dual.h"
#include "reference/pose/exact_pose.h"

/// What the coordinates of a relative state move, and how fast.
namespace pcm::reference {

/// Motion of Mf relative to Me, resolved in Me, and where Mf is.
template <class T>
struct State {
  Vec3<T> r, v, w;
};

template <class T>
State<T> state_of(const Pose& pose, const Velocity& velocity, const Field<T>& field) {
  return {converted(pose.r, field), converted(velocity.v, field), converted(velocity.w, field)};
}

/// The direction of an axis, 1 along it.
template <class T>
Vec3<T> direction(int axis, const Field<T>& field) {
  return {field(axis == 0 ? 1.0 : 0.0), field(axis == 1 ? 1.0 : 0.0), field(axis == 2 ? 1.0 : 0.0)};
}

template <class T>
Vec3<Dual<T>> with_slope(const Vec3<T>& x, const Vec3<T>& slope) {
  return {{x.x, slope.x}, {x.y, slope.y}, {x.z, slope.z}};
}

/// x, and its slope 1 along the coordinate's axis, where the coordinate is one of x.
template <class T>
Vec3<Dual<T>> moved(const Eigen::Vector3d& x, Coordinate::Of own, const Field<Dual<T>>& field) {
  const int axis = field.coordinate.of == own ? field.coordinate.axis : -1;
  return with_slope(converted(x, field.number), direction(axis, field.number));
}

template <class T>
State<Dual<T>> state_of(const Pose& pose, const Velocity& velocity, const Field<Dual<T>>& field) {
  return {moved(pose.r, Coordinate::Of::position, field), moved(velocity.v, Coordinate::Of::velocity, field),
          moved(velocity.w, Coordinate::Of::angular_velocity, field)};
}

/// A vertex in Me.
template <class T>
Vec3<T> point_of(const ExactPose& pose, Vertex v, const Field<T>& field) {
  return pose.point<T>(v, field);
}

/// E's stay; F's move along with Mf, and turn about it: by axis x (x - r).
template <class T>
Vec3<Dual<T>> point_of(const ExactPose& pose, Vertex v, const Field<Dual<T>>& field) {
  const Vec3<T> x = pose.point<T>(v, field.number);
  const auto [of, axis] = field.coordinate;
  const bool translates = of == Coordinate::Of::position, turns = of == Coordinate::Of::rotation;
  const Vec3<T> along = direction(v.side == Side::F && (translates || turns) ? axis : -1, field.number);
  return with_slope(x, turns ? cross(along, x - converted(pose.pose().r, field.number)) : along);
}

}  // namespace pcm::reference
