// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcl/fcl.h>

#include <limits>

#include "compare/bench/peer.h"

namespace pcm::compare {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> model_of(const TriangleMesh& mesh) {
  std::vector<fcl::Triangle> faces;
  for (const Triangle& f : mesh.faces)
    faces.emplace_back(static_cast<std::size_t>(f[0]), static_cast<std::size_t>(f[1]), static_cast<std::size_t>(f[2]));
  auto model = std::make_shared<Model>();
  model->beginModel();
  model->addSubModel(std::vector<Eigen::Vector3d>(mesh.vertices.begin(), mesh.vertices.end()), faces);
  model->endModel();
  return model;
}

/// Without contact points, which would be more than who intersects whom.
class Fcl final : public Peer {
 public:
  Fcl(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, std::size_t most_pairs)
      : E_(model_of(mesh_E)), F_(model_of(mesh_F)), request_(most_pairs, false) {}

  std::int64_t query(const Pose& pose) override {
    fcl::Transform3d placed = fcl::Transform3d::Identity();
    placed.linear() = pose.A;
    placed.translation() = pose.r;
    fcl::CollisionResultd result;
    fcl::collide(E_.get(), fcl::Transform3d::Identity(), F_.get(), placed, request_, result);
    return static_cast<std::int64_t>(result.numContacts());
  }

 private:
  std::shared_ptr<Model> E_, F_;
  fcl::CollisionRequestd request_;
};

PeerEntry fcl_entry(const char* computes, std::size_t most_pairs) {
  return {"FCL " FCL_VERSION " OBBRSS",
          computes,
          "pairs",
          "libfcl-dev",
          true,
          [=](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
            return std::make_unique<Fcl>(mesh_E, mesh_F, most_pairs);
          }};
}

}  // namespace

std::vector<PeerEntry> fcl_peers() {
  return {fcl_entry("all triangle pairs", std::numeric_limits<std::size_t>::max()), fcl_entry("touch only", 1)};
}

}  // namespace pcm::compare
