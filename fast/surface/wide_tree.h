// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "fast/base/box_tree.h"

namespace pcm::fast {

/// How many boxes or faces are tested at once.
inline constexpr std::size_t kLanes = 8;
struct alignas(32) Lanes {
  std::array<float, kLanes> value{};
};

/// A node with up to eight children, in its first lanes. Coordinates are those of its tree, single precision; every box
/// holds what it stands for however numbers were rounded to single precision, to within roundings in double precision.
/// Empty lanes are zeros, which `used` tells from boxes.
struct alignas(64) WideNode {
  std::array<Lanes, 3> centre;        ///< of the children's boxes, by axis
  std::array<Lanes, 3> half;          ///< half their widths
  std::array<Index, kLanes> child{};  ///< a node, or in a bottom node a face
  std::array<float, 3> own_centre{};  ///< of this node's box
  std::array<float, 3> own_half{};
  Index group = -1;  ///< in a bottom node: where its faces are; -1 in others
  Index count = 0;   ///< of children

  std::uint32_t used() const { return (1U << static_cast<unsigned>(count)) - 1; }  ///< bit i: lane i holds a child
  bool bottom() const { return group >= 0; }
  float size() const { return std::max({own_half[0], own_half[1], own_half[2]}); }
};

static_assert(sizeof(WideNode) == 256);  // four lines of a cache

/// The faces of a bottom node, lane by lane.
struct alignas(64) FaceGroup {
  std::array<std::array<Lanes, 3>, 3> vertex;  ///< by corner and axis, rounded to nearest
  std::array<Lanes, 3> normal;  ///< of unit length, rounded; 0 where the face is too narrow for its plane
};

/// The tree of boxes once more, for searches that test many boxes at once: eight children a node, single precision.
/// A node takes three levels of the binary tree; a bottom node holds up to eight faces, all others hold nodes.
/// Coordinates: (x - origin) / unit, x in the surface's frame; none exceeds 1 absolutely, so they have 24 bits whatever
/// the unit of length is and however far the surface is from its own origin.
class WideTree {
 public:
  WideTree() = default;
  WideTree(const TriangleMesh& mesh, const BoxTree& tree);

  Index nodes() const { return static_cast<Index>(nodes_.size()); }
  const WideNode& node(Index i) const { return nodes_[static_cast<std::size_t>(i)]; }
  const FaceGroup& group(Index i) const { return groups_[static_cast<std::size_t>(i)]; }
  const Eigen::Vector3d& origin() const { return origin_; }  ///< m
  double unit() const { return unit_; }                      ///< a power of two, m
  /// No |x| + |y| + |z| of a vertex exceeds it, in this tree's coordinates.
  double radius() const { return radius_; }

  /// A face's plane counts where its least height is greater than this, in this tree's coordinates: then it is known
  /// to single precision.
  static constexpr double kLeastHeight = 0x1p-14;

 private:
  std::vector<WideNode> nodes_;
  std::vector<FaceGroup> groups_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double unit_ = 1;
  double radius_ = 0;
};

}  // namespace pcm::fast
