// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "reference/active/inside_areas.h"
#include "reference/lines/face_lines.h"
#include "reference/pose/converted_pose.h"

/// The cells of a face's part inside in numbers of any kind with division.
namespace pcm::reference {

/// A point of a face: its second and third barycentric coordinate; all three sum up to 1.
template <class T>
struct FacePoint {
  T x1, x2;
};

/// The area of a triangle in the face, in units of the length of the face's doubled normal.
template <class T>
T share_of(const FacePoint<T>& a, const FacePoint<T>& b, const FacePoint<T>& c, const T& half) {
  return half * ((b.x1 - a.x1) * (c.x2 - a.x2) - (b.x2 - a.x2) * (c.x1 - a.x1));
}

/// Lines and points of one face's part inside, in numbers of kind T.
template <class T>
class FacePoints {
 public:
  /// Pose and part must outlive this.
  FacePoints(ConvertedPose<T>& pose, Side side, const InsidePart& part)
      : pose_(pose),
        side_(side),
        part_(part),
        p_(pose.corners(side, part.face)),
        lines_(3 + part.planes.size() + part.crossings.size()),
        places_(part.crossings.size()),
        points_(part.crossings.size()) {}

  std::vector<FacePoint<T>> corners(const InsideCell& cell) {
    std::vector<FacePoint<T>> corners;
    corners.reserve(cell.corners.size());
    for (const LineMeeting& m : cell.corners)
      corners.push_back(m.a == m.b ? crossing(m.a) : normalised(cross(line(m.a), line(m.b))));
    return corners;
  }

 private:
  std::size_t first_ray() const { return 3 + part_.planes.size(); }

  static FacePoint<T> normalised(const Vec3<T>& x) {
    const T sum = x.x + x.y + x.z;
    return {x.y / sum, x.z / sum};
  }

  const FacePoint<T>& crossing(std::size_t ray) {
    std::optional<FacePoint<T>>& known = points_[ray - first_ray()];
    if (!known) known = normalised(place(ray - first_ray()));
    return *known;
  }

  const Vec3<T>& line(std::size_t i) {
    std::optional<Vec3<T>>& known = lines_[i];
    if (known) return *known;
    const T zero = pose_.number(0.0);
    if (i < 3)
      known = own_line(static_cast<Index>(i), zero, pose_.number(1.0));
    else if (i < first_ray())
      known = line_of_plane(pose_.corners(other(side_), part_.planes[i - 3]), p_);
    else
      known = line_through_corner(part_.apex, place(i - first_ray()), zero);
    return *known;
  }

  const Vec3<T>& place(std::size_t crossing) {
    std::optional<Vec3<T>>& known = places_[crossing];
    if (known) return *known;
    const CrossingId& id = part_.crossings[crossing];
    if (id.edge_side == side_) {
      const auto plane = std::find(part_.planes.begin(), part_.planes.end(), id.face) - part_.planes.begin();
      const int own = own_line_of_edge(pose_.pose().face(side_, part_.face), id.edge);
      known = cross(line(own), line(3 + plane));
    } else {
      known = point_of_line(pose_.point({id.edge_side, id.edge[0]}), pose_.point({id.edge_side, id.edge[1]}), p_);
    }
    return *known;
  }

  ConvertedPose<T>& pose_;
  Side side_;
  const InsidePart& part_;
  std::array<Vec3<T>, 3> p_;
  std::vector<std::optional<Vec3<T>>> lines_;
  std::vector<std::optional<Vec3<T>>> places_;  ///< of crossings
  std::vector<std::optional<FacePoint<T>>> points_;
};

/// Calls triangle(winding, a, b, c) for triangles that make up the cells of a face, counterclockwise.
template <class T, class Visit>
void for_each_triangle(ConvertedPose<T>& pose, Side side, const InsidePart& part, const Visit& triangle) {
  FacePoints<T> points(pose, side, part);
  for (const InsideCell& cell : part.cells) {
    const std::vector<FacePoint<T>> x = points.corners(cell);
    for (std::size_t i = 2; i < x.size(); ++i) triangle(cell.winding, x[0], x[i - 1], x[i]);
  }
}

}  // namespace pcm::reference
