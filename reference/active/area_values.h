// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "reference/active/face_points.h"
#include "reference/active/inside_areas.h"

/// Areas, vector areas and volume as numbers of any kind with division: DoubleDouble and Ball to report them,
/// Rational to prove identities.
namespace pcm::reference {

/// A face's area inside the other body in units of its doubled normal's length |N|: without coplanar overlaps, by the
/// convention (opposite ones count in neither area, equal ones in E's only), with all of them, with those that the tie
/// rule leaves inside the other body. Other surface open: nothing, by the tie rule, the whole face, by the tie rule
/// (inside_areas.h).
template <class T>
struct Shares {
  T open, counted, closed, limit;
};

template <class T>
T limited_to(const T& low, const T& x, const T& high) {
  using std::max, std::min;
  return max(low, min(x, high));
}

/// The integral of the winding number over the face, divided by |N|.
template <class T>
T inside_share(const InsidePart& part, Side side, ConvertedPose<T>& pose) {
  T sum = pose.number(0.0);
  if (!part.has_area) return sum;
  if (part.planes.empty()) {
    const int winding = part.cells.empty() ? 0 : part.cells[0].winding;
    return pose.number((part.limited ? std::clamp(winding, 0, 1) : winding) / 2.0);
  }
  const T half = pose.number(0.5);
  for_each_triangle(pose, side, part,
                    [&](int winding, const FacePoint<T>& a, const FacePoint<T>& b, const FacePoint<T>& c) {
                      const T share = share_of(a, b, c, half);
                      sum = sum + (winding == 1 ? share : pose.number(static_cast<double>(winding)) * share);
                    });
  return part.limited ? limited_to(pose.number(0.0), sum, pose.number(0.5)) : sum;
}

template <class T>
Shares<T> shares_of(const InsideAreas& areas, Side side, const InsidePart& part, const T& from_inside,
                    const ConvertedPose<T>& pose) {
  if (part.overlaps.empty()) return {from_inside, from_inside, from_inside, from_inside};
  if (part.limited) return {pose.number(0.0), from_inside, pose.number(part.has_area ? 0.5 : 0.0), from_inside};
  Rational equal = 0, opposite = 0, inside = 0;
  for (const Index i : part.overlaps) {
    const CoplanarOverlap& overlap = areas.overlaps[i];
    (overlap.equal_normals ? equal : opposite) += overlap.share(side);
    if (overlap.inside(side)) inside += overlap.share(side);
  }
  const T open = from_inside - pose.number(equal);
  return {open, side == Side::E ? from_inside : open, from_inside + pose.number(opposite), open + pose.number(inside)};
}

/// A face with a part inside: doubled normal N and its shares of |N|.
template <class T>
struct FaceArea {
  Vec3<T> point;  ///< a corner
  Vec3<T> normal;
  Shares<T> shares;
  bool overlapped;  ///< by a coplanar face; otherwise all four shares are one
};

template <class T>
std::vector<FaceArea<T>> face_areas(const InsideAreas& areas, Side side, ConvertedPose<T>& pose) {
  std::vector<FaceArea<T>> faces;
  for (const InsidePart& part : side == Side::E ? areas.E : areas.F) {
    const auto corners = pose.corners(side, part.face);
    faces.push_back({corners[0], doubled_normal(corners[0], corners[1], corners[2]),
                     shares_of(areas, side, part, inside_share(part, side, pose), pose), !part.overlaps.empty()});
  }
  return faces;
}

/// Whether the shares of some face differ.
template <class T>
bool any_overlapped(const std::vector<FaceArea<T>>& faces) {
  return std::any_of(faces.begin(), faces.end(), [](const FaceArea<T>& face) { return face.overlapped; });
}

template <class T>
Vec3<T> vector_area(const std::vector<FaceArea<T>>& faces, const ConvertedPose<T>& pose,
                    T Shares<T>::*share = &Shares<T>::counted) {
  Vec3<T> sum = pose.zero();
  for (const FaceArea<T>& face : faces) sum = sum + face.shares.*share * face.normal;
  return sum;
}

/// One third of the flux of x - origin through the parts of faces inside. Over both surfaces: the volume of the
/// intersection.
template <class T>
T flux_third(const std::vector<FaceArea<T>>& faces, const Vec3<T>& origin, const ConvertedPose<T>& pose,
             T Shares<T>::*share = &Shares<T>::counted) {
  T sum = pose.number(0.0);
  for (const FaceArea<T>& face : faces) sum = sum + dot(face.point - origin, face.normal) * face.shares.*share;
  return sum / pose.number(3.0);
}

}  // namespace pcm::reference
