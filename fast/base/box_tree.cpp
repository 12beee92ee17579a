// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/base/box_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcm::fast {

namespace {

/// The centre of a triangle's box along one axis, halved coordinates first so that nothing overflows.
double centre_along(const TriangleMesh& mesh, Index face, int axis) {
  const Triangle& triangle = mesh.faces[static_cast<std::size_t>(face)];
  const double x0 = mesh.vertices[static_cast<std::size_t>(triangle[0])][axis];
  const double x1 = mesh.vertices[static_cast<std::size_t>(triangle[1])][axis];
  const double x2 = mesh.vertices[static_cast<std::size_t>(triangle[2])][axis];
  return 0.5 * std::min({x0, x1, x2}) + 0.5 * std::max({x0, x1, x2});
}

}  // namespace

Box box_of_faces(const TriangleMesh& mesh, const Index* faces, std::size_t count) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Index vertex : mesh.faces[static_cast<std::size_t>(faces[i])]) {
      low = low.cwiseMin(mesh.vertices[static_cast<std::size_t>(vertex)]);
      high = high.cwiseMax(mesh.vertices[static_cast<std::size_t>(vertex)]);
    }
  }
  Box box;
  box.centre = 0.5 * low + 0.5 * high;
  box.half = (high - box.centre).cwiseMax(box.centre - low);
  return box;
}

BoxTree::BoxTree(const TriangleMesh& mesh) {
  struct Range {
    Index node;
    std::size_t begin, end;
  };
  std::vector<Index> faces(mesh.faces.size());
  std::iota(faces.begin(), faces.end(), 0);
  nodes_.reserve(2 * faces.size());
  nodes_.emplace_back();
  std::vector<Range> open{{0, 0, faces.size()}};
  while (!open.empty()) {
    const Range range = open.back();
    open.pop_back();
    const std::size_t count = range.end - range.begin;
    BoxNode node;
    node.box = box_of_faces(mesh, faces.data() + range.begin, count);
    if (count == 1) {
      node.face = faces[range.begin];
    } else {
      int axis = 0;
      node.box.half.maxCoeff(&axis);
      const std::size_t middle = range.begin + count / 2;
      const auto first = faces.begin();
      // Equal centres are ordered by face index, so that the tree is the same everywhere.
      std::nth_element(first + static_cast<std::ptrdiff_t>(range.begin), first + static_cast<std::ptrdiff_t>(middle),
                       first + static_cast<std::ptrdiff_t>(range.end), [&mesh, axis](Index f, Index g) {
                         const double cf = centre_along(mesh, f, axis), cg = centre_along(mesh, g, axis);
                         return cf < cg || (cf == cg && f < g);
                       });
      node.child = static_cast<Index>(nodes_.size());
      nodes_.resize(nodes_.size() + 2);
      open.push_back({node.child, range.begin, middle});
      open.push_back({node.child + 1, middle, range.end});
    }
    nodes_[static_cast<std::size_t>(range.node)] = node;
  }
}

}  // namespace pcm::fast
