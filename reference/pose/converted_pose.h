// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <concepts>
#include <unordered_map>
#include <utility>

#include "reference/pose/exact_pose.h"
#include "reference/pose/moved_state.h"

namespace pcm::reference {

/// A pose's points as numbers of kind T, each converted once. Belongs to one evaluation, so to one thread.
template <class T>
class ConvertedPose {
 public:
  /// The pose must outlive this.
  explicit ConvertedPose(const ExactPose& pose, Field<T> field = {}) : pose_(pose), field_(field) {}

  /// Points that enclose the vertices as both problems have them: what they decide holds in either.
  static ConvertedPose of_both_problems(const ExactPose& pose) requires std::same_as<T, Interval> {
    ConvertedPose converted(pose);
    converted.both_problems_ = true;
    return converted;
  }

  const ExactPose& pose() const { return pose_; }
  const Field<T>& field() const { return field_; }

  template <class Number>
  T number(const Number& x) const {
    return field_(x);
  }
  Vec3<T> zero() const { return {field_(0.0), field_(0.0), field_(0.0)}; }

  const Vec3<T>& point(Vertex v) {
    auto& known = points_[v.side == Side::E ? 0 : 1];
    auto found = known.find(v.index);
    if (found == known.end()) found = known.emplace(v.index, convert(v)).first;
    return found->second;
  }

  std::array<Vec3<T>, 3> corners(Side side, Index f) {
    const Triangle& t = pose_.face(side, f);
    return {point({side, t[0]}), point({side, t[1]}), point({side, t[2]})};
  }

 private:
  Vec3<T> convert(Vertex v) const {
    if constexpr (std::same_as<T, Interval>)
      if (both_problems_) return interval_point(pose_.rounding_box(v));
    return point_of(pose_, v, field_);
  }

  const ExactPose& pose_;
  Field<T> field_;
  bool both_problems_ = false;
  std::array<std::unordered_map<Index, Vec3<T>>, 2> points_;
};

}  // namespace pcm::reference
