// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pcm/triangle_mesh.h"

namespace pcm::fast {

/// A closed axis-aligned box, in the frame of its surface, m. `half` is rounded to nearest: whoever tests boxes adds a
/// term that covers the last bit of the greatest coordinate.
struct Box {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d half = Eigen::Vector3d::Zero();
};

/// Node of a BoxTree. The children of an inner node lie side by side.
struct BoxNode {
  Box box;
  Index child = -1;  ///< the first child, the second is child + 1; -1 in a leaf
  Index face = -1;   ///< the triangle of a leaf; -1 in an inner node

  bool leaf() const { return child < 0; }
};

/// The binary tree of axis-aligned boxes of PCM section 3: each box halves its triangles along its longest axis, at
/// the median of the centres of their boxes, and a leaf holds one triangle. Flat; node 0 is the root. Depth
/// ceil(log2(faces)). Built in O(n log n).
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const TriangleMesh& mesh);

  const BoxNode& node(Index i) const { return nodes_[static_cast<std::size_t>(i)]; }
  const BoxNode& root() const { return nodes_.front(); }

 private:
  std::vector<BoxNode> nodes_;
};

/// The box of some of a mesh's faces: `count` of them from `faces` on.
Box box_of_faces(const TriangleMesh& mesh, const Index* faces, std::size_t count);

}  // namespace pcm::fast
