// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>

#include <memory>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// A surface as a GImpact mesh, Bullet's shape for meshes that are not convex and move. Its numbers are single
/// precision in Debian's build.
class BulletMesh {
 public:
  explicit BulletMesh(const TriangleMesh& mesh) {
    const auto corner = [&](Index v) {
      const Eigen::Vector3d& x = mesh.vertices[static_cast<std::size_t>(v)];
      return btVector3(static_cast<btScalar>(x.x()), static_cast<btScalar>(x.y()), static_cast<btScalar>(x.z()));
    };
    for (const Triangle& f : mesh.faces) faces_.addTriangle(corner(f[0]), corner(f[1]), corner(f[2]));
    shape_ = std::make_unique<btGImpactMeshShape>(&faces_);
    shape_->setMargin(0);
    shape_->updateBound();
    object_.setCollisionShape(shape_.get());
  }
  BulletMesh(const BulletMesh&) = delete;
  BulletMesh& operator=(const BulletMesh&) = delete;
  ~BulletMesh() = default;

  btCollisionObject* object() { return &object_; }

 private:
  btTriangleMesh faces_;
  std::unique_ptr<btGImpactMeshShape> shape_;
  btCollisionObject object_;
};

/// Two surfaces as Bullet has them. Their margin is 0: the question is about the surfaces, not about what is within
/// some distance of them.
class BulletPair {
 public:
  BulletPair(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)
      : E_(mesh_E), F_(mesh_F), dispatcher_(&configuration_) {
    btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher_);
  }

  /// How many contact points without a gap Bullet makes. GImpact is asked as a step of a simulation would ask it:
  /// btCollisionWorld::contactPairTest asks for an algorithm of closest points, which GImpact never registers, and
  /// finds nothing at all.
  int collide(const Pose& pose) {
    btMatrix3x3 rotation;
    for (int row = 0; row < 3; ++row)
      rotation[row].setValue(static_cast<btScalar>(pose.A(row, 0)), static_cast<btScalar>(pose.A(row, 1)),
                             static_cast<btScalar>(pose.A(row, 2)));
    const btTransform placed(rotation, btVector3(static_cast<btScalar>(pose.r.x()), static_cast<btScalar>(pose.r.y()),
                                                 static_cast<btScalar>(pose.r.z())));
    const btCollisionObjectWrapper E = wrapped(E_, btTransform::getIdentity()), F = wrapped(F_, placed);
    Count count(E, F);
    btCollisionAlgorithm* algorithm = dispatcher_.findAlgorithm(&E, &F, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    algorithm->processCollision(&E, &F, btDispatcherInfo(), &count);
    algorithm->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm);
    return count.points;
  }

 private:
  struct Count : btManifoldResult {
    Count(const btCollisionObjectWrapper& E, const btCollisionObjectWrapper& F) : btManifoldResult(&E, &F) {}
    void addContactPoint(const btVector3& /*normal*/, const btVector3& /*point*/, btScalar distance) override {
      points += distance <= 0;
    }
    int points = 0;
  };

  static btCollisionObjectWrapper wrapped(BulletMesh& mesh, const btTransform& placed) {
    mesh.object()->setWorldTransform(placed);
    return {nullptr, mesh.object()->getCollisionShape(), mesh.object(), mesh.object()->getWorldTransform(), -1, -1};
  }

  BulletMesh E_, F_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
};

}  // namespace pcm::compare
