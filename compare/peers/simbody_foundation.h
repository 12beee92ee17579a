// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Simbody.h>

#include <optional>
#include <set>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// Two surfaces under Simbody's elastic foundation. Body E is the ground and carries the springs, as the master does in
/// mode E; F floats.
class SimbodyFoundation {
 public:
  /// Of the law Simbody takes stiffness, damping as a part of it, friction and slip velocity.
  SimbodyFoundation(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const ContactLaw& law)
      : matter_(system_), forces_(system_), contacts_(system_), set_(contacts_.createContactSet()) {
    const SimTK::Body::Rigid body(SimTK::MassProperties(1, SimTK::Vec3(0), SimTK::Inertia(1)));
    body_F_ = SimTK::MobilizedBody::Free(matter_.Ground(), body);
    contacts_.addBody(set_, matter_.Ground(), geometry_of(mesh_E), SimTK::Transform());
    contacts_.addBody(set_, body_F_, geometry_of(mesh_F), SimTK::Transform());
    SimTK::ElasticFoundationForce foundation(forces_, contacts_, set_);
    foundation.setBodyParameters(SimTK::ContactSurfaceIndex(0), law.stiffness, law.damping / law.stiffness,
                                 law.friction, law.friction, 0);
    if (law.slip_velocity > 0) foundation.setTransitionVelocity(law.slip_velocity);
    state_ = system_.realizeTopology();
  }

  void place(const Pose& pose, const Velocity& velocity) {
    SimTK::Mat33 rotation;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) rotation(row, column) = pose.A(row, column);
    body_F_.setQToFitTransform(state_, SimTK::Transform(SimTK::Rotation(rotation), vec3(pose.r)));
    body_F_.setUToFitVelocity(state_, SimTK::SpatialVec(vec3(velocity.w), vec3(velocity.v)));
    system_.realize(state_, SimTK::Stage::Dynamics);
  }

  /// Faces that cross the other surface or lie inside it.
  struct Faces {
    const std::set<int>& E;
    const std::set<int>& F;
  };
  /// As Simbody found them where F was placed last, until it is placed again; none where it found no contact.
  std::optional<Faces> faces() const {
    const SimTK::Array_<SimTK::Contact>& found = contacts_.getContacts(state_, set_);
    if (found.empty()) return std::nullopt;
    const auto& contact = static_cast<const SimTK::TriangleMeshContact&>(found.front());
    if (contact.getSurface1() == SimTK::ContactSurfaceIndex(0))
      return Faces{contact.getSurface1Faces(), contact.getSurface2Faces()};
    return Faces{contact.getSurface2Faces(), contact.getSurface1Faces()};
  }

  /// On F about its origin, in E's frame.
  struct Load {
    Eigen::Vector3d force, torque;
  };
  Load load_on_F() const {
    const SimTK::SpatialVec& load =
        system_.getRigidBodyForces(state_, SimTK::Stage::Dynamics)[body_F_.getMobilizedBodyIndex()];
    return {{load[1][0], load[1][1], load[1][2]}, {load[0][0], load[0][1], load[0][2]}};
  }

 private:
  static SimTK::Vec3 vec3(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

  static SimTK::ContactGeometry::TriangleMesh geometry_of(const TriangleMesh& mesh) {
    SimTK::Array_<SimTK::Vec3> vertices;
    for (const Eigen::Vector3d& x : mesh.vertices) vertices.push_back(vec3(x));
    SimTK::Array_<int> corners;
    for (const Triangle& f : mesh.faces)
      for (const Index v : f) corners.push_back(v);
    return {vertices, corners};
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::GeneralContactSubsystem contacts_;
  SimTK::ContactSetIndex set_;
  SimTK::MobilizedBody::Free body_F_;
  SimTK::State state_;
};

}  // namespace pcm::compare
