// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Simbody.h>

#include "compare/bench/peer.h"

namespace pcm::compare {
namespace {

SimTK::ContactGeometry::TriangleMesh geometry_of(const TriangleMesh& mesh) {
  SimTK::Array_<SimTK::Vec3> vertices;
  for (const Eigen::Vector3d& x : mesh.vertices) vertices.push_back(SimTK::Vec3(x.x(), x.y(), x.z()));
  SimTK::Array_<int> corners;
  for (const Triangle& f : mesh.faces)
    for (const Index v : f) corners.push_back(v);
  return {vertices, corners};
}

/// Body E is the ground and carries the springs, as the master does in mode E; F floats.
class Simbody final : public Peer {
 public:
  Simbody(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)
      : matter_(system_), forces_(system_), contacts_(system_), set_(contacts_.createContactSet()) {
    const SimTK::Body::Rigid body(SimTK::MassProperties(1, SimTK::Vec3(0), SimTK::Inertia(1)));
    body_F_ = SimTK::MobilizedBody::Free(matter_.Ground(), body);
    contacts_.addBody(set_, matter_.Ground(), geometry_of(mesh_E), SimTK::Transform());
    contacts_.addBody(set_, body_F_, geometry_of(mesh_F), SimTK::Transform());
    SimTK::ElasticFoundationForce foundation(forces_, contacts_, set_);
    const ContactLaw law = bench_law();
    foundation.setBodyParameters(SimTK::ContactSurfaceIndex(0), law.stiffness, law.damping / law.stiffness,
                                 law.friction, law.friction, 0);
    foundation.setTransitionVelocity(law.slip_velocity);
    state_ = system_.realizeTopology();
  }

  std::int64_t query(const Pose& pose) override {
    SimTK::Mat33 rotation;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) rotation(row, column) = pose.A(row, column);
    const Velocity velocity = bench_velocity();
    body_F_.setQToFitTransform(
        state_, SimTK::Transform(SimTK::Rotation(rotation), SimTK::Vec3(pose.r.x(), pose.r.y(), pose.r.z())));
    body_F_.setUToFitVelocity(state_, SimTK::SpatialVec(SimTK::Vec3(velocity.w.x(), velocity.w.y(), velocity.w.z()),
                                                        SimTK::Vec3(velocity.v.x(), velocity.v.y(), velocity.v.z())));
    system_.realize(state_, SimTK::Stage::Dynamics);
    std::int64_t faces = 0;
    for (const SimTK::Contact& contact : contacts_.getContacts(state_, set_))
      faces +=
          static_cast<std::int64_t>(static_cast<const SimTK::TriangleMeshContact&>(contact).getSurface1Faces().size());
    return faces;
  }

 private:
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::GeneralContactSubsystem contacts_;
  SimTK::ContactSetIndex set_;
  SimTK::MobilizedBody::Free body_F_;
  SimTK::State state_;
};

}  // namespace

std::vector<PeerEntry> simbody_peers() {
  return {{"Simbody 3.7", "elastic foundation", "faces", "libsimbody-dev", true,
           [](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
             return std::make_unique<Simbody>(mesh_E, mesh_F);
           }}};
}

}  // namespace pcm::compare
