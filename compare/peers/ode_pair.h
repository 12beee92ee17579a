// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ode/ode.h>

#include <cstdarg>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// The library is open as long as this lives.
struct OpenOde {
  OpenOde() {
    dSetMessageHandler(say_nothing);
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
  }
  OpenOde(const OpenOde&) = delete;
  OpenOde& operator=(const OpenOde&) = delete;
  ~OpenOde() { dCloseODE(); }

 private:
  /// ODE prints a message where it may report a contact point twice.
  static void say_nothing(int /*number*/, const char* /*message*/, va_list /*arguments*/) {}
};

/// A trimesh; ODE reads the arrays as long as it lives.
class OdeMesh {
 public:
  explicit OdeMesh(const TriangleMesh& mesh) : data_(dGeomTriMeshDataCreate()) {
    for (const Eigen::Vector3d& x : mesh.vertices) coordinates_.insert(coordinates_.end(), {x.x(), x.y(), x.z()});
    for (const Triangle& f : mesh.faces)
      for (const Index v : f) corners_.push_back(static_cast<dTriIndex>(v));
    dGeomTriMeshDataBuildDouble(data_, coordinates_.data(), 3 * sizeof(double), static_cast<int>(mesh.vertices.size()),
                                corners_.data(), static_cast<int>(corners_.size()), 3 * sizeof(dTriIndex));
    geometry_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
  }
  OdeMesh(const OdeMesh&) = delete;
  OdeMesh& operator=(const OdeMesh&) = delete;
  ~OdeMesh() {
    dGeomDestroy(geometry_);
    dGeomTriMeshDataDestroy(data_);
  }

  dGeomID geometry() const { return geometry_; }

 private:
  std::vector<double> coordinates_;
  std::vector<dTriIndex> corners_;
  dTriMeshDataID data_ = nullptr;
  dGeomID geometry_ = nullptr;
};

/// Two surfaces as ODE has them. OpenOde must outlive this.
class OdePair {
 public:
  OdePair(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : E_(mesh_E), F_(mesh_F), points_(kMostPoints) {}

  /// How many contact points ODE makes.
  int collide(const Pose& pose) {
    dMatrix3 rotation = {};  // three rows of four
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) rotation[4 * row + column] = pose.A(row, column);
    dGeomSetRotation(F_.geometry(), rotation);
    dGeomSetPosition(F_.geometry(), pose.r.x(), pose.r.y(), pose.r.z());
    return dCollide(E_.geometry(), F_.geometry(), kMostPoints, points_.data(), sizeof(dContactGeom));
  }

 private:
  static constexpr int kMostPoints = 0xffff;  ///< what ODE's flags can hold

  OdeMesh E_, F_;
  std::vector<dContactGeom> points_;
};

}  // namespace pcm::compare
