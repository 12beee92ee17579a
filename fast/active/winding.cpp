// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/active/winding.h"

#include <cmath>
#include <limits>

namespace pcm::fast {

namespace {

/// +1 where the segment from a to z passes through `face` from above to below, -1 the other way, 0 where it misses.
int passage(const RankedPoint& a, const RankedPoint& z, const std::array<RankedPoint, 3>& face, WorkCounters& work) {
  const int above = orientation(face[0], face[1], face[2], a, work);
  if (above == orientation(face[0], face[1], face[2], z, work)) return 0;
  const int side = orientation(a, z, face[0], face[1], work);
  if (side != orientation(a, z, face[1], face[2], work) || side != orientation(a, z, face[2], face[0], work)) return 0;
  return above;
}

}  // namespace

Index winding_about_vertex(PosedPair& posed, Side side, Index v, std::vector<Index>& open) {
  const Side other_side = opposite(side);
  PosedSurface& other = posed[other_side];
  WorkCounters& work = posed.work;
  const BoxTree& tree = other.surface().tree;
  const Box& root = tree.root().box;
  const RankedPoint a = posed[side].point(v, work);

  // The segment runs along an axis of the tree's frame, towards the nearest side of the root box. The point outside is
  // well clear of the position error; its own coordinates in Me and back are off by no more, being within 8 times the
  // greatest coordinate.
  const double position_error = 8 * posed.placement.position_error(other_side);
  const double beyond = root.half.maxCoeff() + 4 * position_error;
  const Eigen::Vector3d x = posed.placement.to_frame_of(other_side, Eigen::Vector3d::Map(a.x_Me));
  int axis = 0;
  double shortest = std::numeric_limits<double>::infinity();
  Eigen::Vector3d end = x;
  for (int k = 0; k < 3; ++k) {
    const double offset = x[k] - root.centre[k];
    if (std::abs(offset) > root.half[k] + position_error) return 0;
    const double length = root.half[k] - std::abs(offset);
    if (length >= shortest) continue;
    shortest = length;
    axis = k;
    end = x;
    end[k] = root.centre[k] + std::copysign(root.half[k] + beyond, offset);
  }
  const Eigen::Vector3d end_Me = posed.placement.from_frame_of(other_side, end);
  const RankedPoint z{end_Me.data(), std::numeric_limits<std::int64_t>::max()};
  const Eigen::Vector3d centre = 0.5 * x + 0.5 * end;
  const double half_length = 0.5 * std::abs(end[axis] - x[axis]);

  Index winding = 0;
  open.assign(1, 0);
  while (!open.empty()) {
    const BoxNode& node = tree.node(open.back());
    open.pop_back();
    bool apart = false;
    ++work.box_tests;
    for (int k = 0; k < 3; ++k) {
      const double width = node.box.half[k] + position_error + (k == axis ? half_length : 0);
      apart = apart || std::abs(node.box.centre[k] - centre[k]) > width;
    }
    if (apart) continue;
    if (node.leaf()) {
      // From v, with winding number w, to 0 outside: w plus the sum of the passages is 0.
      winding -= passage(a, z, other.face_points(node.face, work), work);
    } else {
      open.push_back(node.child);
      open.push_back(node.child + 1);
    }
  }
  return winding;
}

}  // namespace pcm::fast
