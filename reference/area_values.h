// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "reference/clipped_areas.h"

/// Areas, vector areas and volume as numbers of any kind with division: DoubleDouble and Ball to report them,
/// Rational to prove identities.
namespace pcm::reference {

/// A face's clipped area in units of its doubled normal's length |N|: without coplanar overlaps, by the convention
/// (opposite ones count in neither area, equal ones in E's only), with all of them. Other surface open: nothing, by the
/// tie rule, the whole face (clipped_areas.h).
template <class T>
struct Shares {
  T open, counted, closed;
};

template <class T>
T limited_to(const T& low, const T& x, const T& high) {
  using std::max, std::min;
  return max(low, min(x, high));
}

/// Green's theorem (clipped_areas.h): the integral of the winding number over the face, divided by |N|.
template <class T>
T inside_share(const FaceClip& clip, const std::array<Vec3<T>, 3>& corners, const std::vector<Vec3<T>>& positions,
               const LiftedPose<T>& pose) {
  T sum = pose.number(0.0);
  if (clip.axis < 0) return sum;
  const auto& [w0, w1, w2] = clip.winding;
  if (clip.segments.empty() && clip.on_edges.empty() && w0 == w1 && w1 == w2)  // wholly within: half of |N| each time
    return pose.number(clip.limited ? std::clamp(w0, 0, 1) / 2.0 : w0 / 2.0);
  const int i = (clip.axis + 1) % 3, j = (clip.axis + 2) % 3;
  const Vec3<T>& o = corners[0];
  const auto moment = [&](const Vec3<T>& p, const Vec3<T>& q) -> T {
    return (p[i] - o[i]) * (q[j] - o[j]) - (p[j] - o[j]) * (q[i] - o[i]);
  };
  for_each_chord(clip, corners, positions, [&](int weight, const Vec3<T>& p, const Vec3<T>& q) {
    if (&p == &o || &q == &o) return;  // no moment about a corner of its own
    sum = sum + (weight == 1 ? moment(p, q) : pose.number(static_cast<double>(weight)) * moment(p, q));
  });
  const T share = sum / (pose.number(2.0) * moment(corners[1], corners[2]));
  return clip.limited ? limited_to(pose.number(0.0), share, pose.number(0.5)) : share;
}

template <class T>
Shares<T> shares_of(const ClippedAreas& areas, Side side, const FaceClip& clip, const T& from_inside,
                    const LiftedPose<T>& pose) {
  if (clip.overlaps.empty()) return {from_inside, from_inside, from_inside};
  if (clip.limited) return {pose.number(0.0), from_inside, pose.number(clip.axis < 0 ? 0.0 : 0.5)};
  Rational equal = 0, opposite = 0;
  for (const Index i : clip.overlaps)
    (areas.overlaps[i].equal_normals ? equal : opposite) += areas.overlaps[i].share(side);
  const T open = from_inside - pose.number(equal);
  return {open, side == Side::E ? from_inside : open, from_inside + pose.number(opposite)};
}

/// A clipped face: doubled normal N and its shares of |N|.
template <class T>
struct FaceArea {
  Vec3<T> point;  ///< a corner
  Vec3<T> normal;
  Shares<T> shares;
  bool overlapped;  ///< by a coplanar face; otherwise all three shares are one
};

template <class T>
std::vector<FaceArea<T>> face_areas(const ClippedAreas& areas, Side side, const std::vector<Vec3<T>>& positions,
                                    LiftedPose<T>& pose) {
  std::vector<FaceArea<T>> faces;
  for (const FaceClip& clip : side == Side::E ? areas.E : areas.F) {
    const auto corners = pose.corners(side, clip.face);
    faces.push_back({corners[0], doubled_normal(corners[0], corners[1], corners[2]),
                     shares_of(areas, side, clip, inside_share(clip, corners, positions, pose), pose),
                     !clip.overlaps.empty()});
  }
  return faces;
}

template <class T>
Vec3<T> vector_area(const std::vector<FaceArea<T>>& faces, const LiftedPose<T>& pose) {
  Vec3<T> sum = pose.zero();
  for (const FaceArea<T>& face : faces) sum = sum + face.shares.counted * face.normal;
  return sum;
}

/// One third of the flux of x - origin through the clipped faces. Over both surfaces: the volume of the intersection.
template <class T>
T flux_third(const std::vector<FaceArea<T>>& faces, const Vec3<T>& origin, const LiftedPose<T>& pose) {
  T sum = pose.number(0.0);
  for (const FaceArea<T>& face : faces) sum = sum + dot(face.point - origin, face.normal) * face.shares.counted;
  return sum / pose.number(3.0);
}

}  // namespace pcm::reference
