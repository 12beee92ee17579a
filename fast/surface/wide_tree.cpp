// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/surface/wide_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::fast {

namespace {

/// The least float that is not less.
float rounded_up(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest < x ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

/// A box in the tree's coordinates.
struct FloatBox {
  std::array<float, 3> centre, half;

  FloatBox(const Box& box, const Eigen::Vector3d& origin, double unit) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double exact = (box.centre[axis] - origin[axis]) / unit;
      centre[k] = static_cast<float>(exact);
      half[k] = rounded_up(box.half[axis] / unit + std::abs(exact - centre[k]));
    }
  }
};

/// How many halvings lead to ranges of at most kLanes faces.
int depth_of_bottom(std::size_t faces) {
  int depth = 0;
  while ((faces + (std::size_t{1} << depth) - 1) >> depth > kLanes) ++depth;
  return depth;
}

/// The nodes `levels` below a node of the binary tree, or its leaves where they are nearer, from left to right.
std::vector<Index> descendants(const BoxTree& tree, Index root, int levels) {
  std::vector<Index> nodes{root};
  for (int level = 0; level < levels; ++level) {
    std::vector<Index> next;
    for (const Index i : nodes) {
      const BoxNode& node = tree.node(i);
      if (node.leaf()) {
        next.push_back(i);
      } else {
        next.push_back(node.child);
        next.push_back(node.child + 1);
      }
    }
    nodes = std::move(next);
  }
  return nodes;
}

/// Vertices and plane of a face, into its lane.
void put_face(FaceGroup& group, std::size_t lane, const std::array<Eigen::Vector3d, 3>& p) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t k = 0; k < 3; ++k) {
      group.vertex[corner][k].value[lane] = static_cast<float>(p[corner][static_cast<Eigen::Index>(k)]);
    }
  }
  const Eigen::Vector3d N = (p[1] - p[0]).cross(p[2] - p[0]);
  const double longest = std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
  const bool known = N.norm() > WideTree::kLeastHeight * longest;
  for (std::size_t k = 0; k < 3; ++k) {
    group.normal[k].value[lane] = known ? static_cast<float>(N[static_cast<Eigen::Index>(k)] / N.norm()) : 0.0F;
  }
}

}  // namespace

WideTree::WideTree(const TriangleMesh& mesh, const BoxTree& tree) {
  const Box& root = tree.root().box;
  origin_ = root.centre;
  // The sum of the half widths bounds |x| + |y| + |z|; half an ulp of it is lost in each.
  const double radius = root.half.sum() * (1 + 0x1p-40);
  unit_ = std::ldexp(1.0, std::ilogb(radius) + 1);
  radius_ = radius / unit_;

  struct Open {
    Index node;    ///< of this tree
    Index binary;  ///< of the other
    int depth;     ///< of that one
  };
  const int bottom = depth_of_bottom(mesh.faces.size());
  nodes_.emplace_back();
  std::vector<Open> open{{0, 0, 0}};
  while (!open.empty()) {
    const Open at = open.back();
    open.pop_back();
    const bool is_bottom = at.depth == bottom;
    // Full nodes from the bottom up; what does not divide by three is left to the root.
    const int levels = is_bottom ? 3 : (bottom - at.depth - 1) % 3 + 1;
    const std::vector<Index> children = descendants(tree, at.binary, levels);
    WideNode node;
    const FloatBox own(tree.node(at.binary).box, origin_, unit_);
    node.own_centre = own.centre;
    node.own_half = own.half;
    if (is_bottom) {
      node.group = static_cast<Index>(groups_.size());
      groups_.emplace_back();
    }
    node.count = static_cast<Index>(children.size());
    for (std::size_t lane = 0; lane < children.size(); ++lane) {
      const BoxNode& child = tree.node(children[lane]);
      const FloatBox box(child.box, origin_, unit_);
      for (std::size_t k = 0; k < 3; ++k) {
        node.centre[k].value[lane] = box.centre[k];
        node.half[k].value[lane] = box.half[k];
      }
      if (is_bottom) {
        node.child[lane] = child.face;
        const Triangle& t = mesh.faces[static_cast<std::size_t>(child.face)];
        const auto vertex = [&](std::size_t corner) {
          return Eigen::Vector3d((mesh.vertices[static_cast<std::size_t>(t[corner])] - origin_) / unit_);
        };
        put_face(groups_.back(), lane, {vertex(0), vertex(1), vertex(2)});
      } else {
        node.child[lane] = static_cast<Index>(nodes_.size());
        nodes_.emplace_back();
        open.push_back({node.child[lane], children[lane], at.depth + levels});
      }
    }
    nodes_[static_cast<std::size_t>(at.node)] = node;
  }
}

}  // namespace pcm::fast
