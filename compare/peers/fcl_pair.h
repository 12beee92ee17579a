// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcl/fcl.h>

#include <memory>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// Two surfaces as FCL has them: bounding volume hierarchies of OBBRSS, which its examples use for meshes.
class FclPair {
 public:
  FclPair(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : E_(model_of(mesh_E)), F_(model_of(mesh_F)) {}

  /// Pairs of triangles that intersect, at most so many; without contact points, which would be more than that.
  fcl::CollisionResultd collide(const Pose& pose, std::size_t most_pairs) const {
    fcl::Transform3d placed = fcl::Transform3d::Identity();
    placed.linear() = pose.A;
    placed.translation() = pose.r;
    fcl::CollisionResultd result;
    fcl::collide(E_.get(), fcl::Transform3d::Identity(), F_.get(), placed, fcl::CollisionRequestd(most_pairs, false),
                 result);
    return result;
  }

 private:
  using Model = fcl::BVHModel<fcl::OBBRSSd>;

  static std::shared_ptr<Model> model_of(const TriangleMesh& mesh) {
    std::vector<fcl::Triangle> faces;
    for (const Triangle& f : mesh.faces)
      faces.emplace_back(static_cast<std::size_t>(f[0]), static_cast<std::size_t>(f[1]),
                         static_cast<std::size_t>(f[2]));
    auto model = std::make_shared<Model>();
    model->beginModel();
    model->addSubModel(std::vector<Eigen::Vector3d>(mesh.vertices.begin(), mesh.vertices.end()), faces);
    model->endModel();
    return model;
  }

  std::shared_ptr<Model> E_, F_;
};

}  // namespace pcm::compare
