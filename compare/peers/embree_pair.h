// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "compare/peers/triangle_overlap.h"
#include "compare/poses/rounded_vertices.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// A mesh in place, in a tree of its own. Embree's boxes are single precision; they are rounded outward.
class EmbreeScene {
 public:
  EmbreeScene(RTCDevice device, const TriangleMesh& mesh)
      : vertices(mesh.vertices), mesh_(mesh), scene_(rtcNewScene(device)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST);
    geometry_ = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryBuildQuality(geometry_, RTC_BUILD_QUALITY_REFIT);
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(mesh.faces.size()));
    rtcSetGeometryUserData(geometry_, this);
    rtcSetGeometryBoundsFunction(geometry_, bound, nullptr);
    rtcAttachGeometry(scene_, geometry_);
    refit();
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene() {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }

  void refit() {
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
  }

  RTCScene scene() const { return scene_; }
  std::array<Eigen::Vector3d, 3> corners(unsigned face) const {
    const Triangle& f = mesh_.faces[face];
    return {vertices[static_cast<std::size_t>(f[0])], vertices[static_cast<std::size_t>(f[1])],
            vertices[static_cast<std::size_t>(f[2])]};
  }

  std::vector<Eigen::Vector3d> vertices;  ///< in Me

 private:
  static void bound(const RTCBoundsFunctionArguments* arguments) {
    const std::array<Eigen::Vector3d, 3> c =
        static_cast<const EmbreeScene*>(arguments->geometryUserPtr)->corners(arguments->primID);
    const Eigen::Vector3d low = c[0].cwiseMin(c[1]).cwiseMin(c[2]), high = c[0].cwiseMax(c[1]).cwiseMax(c[2]);
    constexpr float kFar = std::numeric_limits<float>::infinity();
    const auto below = [](double x) { return std::nextafter(static_cast<float>(x), -kFar); };
    const auto above = [](double x) { return std::nextafter(static_cast<float>(x), kFar); };
    *arguments->bounds_o = {below(low.x()),  below(low.y()),  below(low.z()),  0,
                            above(high.x()), above(high.y()), above(high.z()), 0};
  }

  const TriangleMesh mesh_;
  RTCScene scene_;
  RTCGeometry geometry_ = nullptr;
};

struct EmbreeDevice {
  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  EmbreeDevice() = default;
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;
  ~EmbreeDevice() { rtcReleaseDevice(device); }
};

/// Embree finds faces whose boxes overlap; whether the faces do is ours to say (triangle_overlap.h). Its trees stand
/// still: F's is refitted to the moved vertices before a query.
class EmbreePair {
 public:
  EmbreePair(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)
      : mesh_F_(mesh_F), E_(device_.device, mesh_E), F_(device_.device, mesh_F) {}

  void place(const Pose& pose) {
    F_.vertices = rounded_vertices(mesh_F_, pose);
    F_.refit();
  }

  /// Pairs of faces that overlap where F was placed last, E's face first, in no order. They live until the next call.
  const std::vector<std::array<Index, 2>>& collide() {
    pairs_.clear();
    rtcCollide(E_.scene(), F_.scene(), take, this);
    return pairs_;
  }

 private:
  static void take(void* user, RTCCollision* collisions, unsigned number) {
    auto& self = *static_cast<EmbreePair*>(user);
    for (unsigned i = 0; i < number; ++i)
      if (const auto [e, f] = std::array{collisions[i].primID0, collisions[i].primID1};
          triangles_overlap(self.E_.corners(e), self.F_.corners(f)))
        self.pairs_.push_back({static_cast<Index>(e), static_cast<Index>(f)});
  }

  TriangleMesh mesh_F_;
  EmbreeDevice device_;
  EmbreeScene E_, F_;
  std::vector<std::array<Index, 2>> pairs_;
};

}  // namespace pcm::compare
