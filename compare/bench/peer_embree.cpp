// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <embree3/rtcore.h>

#include <cmath>
#include <limits>

#include "compare/bench/peer.h"
#include "compare/bench/triangle_overlap.h"

namespace pcm::compare {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

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
  Corners corners(unsigned face) const {
    const Triangle& f = mesh_.faces[face];
    return {vertices[static_cast<std::size_t>(f[0])], vertices[static_cast<std::size_t>(f[1])],
            vertices[static_cast<std::size_t>(f[2])]};
  }

  std::vector<Eigen::Vector3d> vertices;  ///< in Me

 private:
  static void bound(const RTCBoundsFunctionArguments* arguments) {
    const Corners c = static_cast<const EmbreeScene*>(arguments->geometryUserPtr)->corners(arguments->primID);
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

struct Device {
  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() { rtcReleaseDevice(device); }
};

/// Embree finds faces whose boxes overlap; whether the faces do is ours to say. Its trees stand still: F's is refitted
/// to the moved vertices before each query.
class Embree final : public Peer {
 public:
  Embree(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F)
      : E_(device_.device, mesh_E), F_(device_.device, mesh_F), vertices_Mf_(mesh_F.vertices) {}

  void prepare(const Pose& pose) override {
    for (std::size_t v = 0; v < vertices_Mf_.size(); ++v) F_.vertices[v] = pose.A * vertices_Mf_[v] + pose.r;
    F_.refit();
  }

  std::int64_t query(const Pose& /*pose*/) override {
    pairs_ = 0;
    rtcCollide(E_.scene(), F_.scene(), count, this);
    return pairs_;
  }

 private:
  static void count(void* user, RTCCollision* collisions, unsigned number) {
    auto& self = *static_cast<Embree*>(user);
    for (unsigned i = 0; i < number; ++i)
      if (triangles_overlap(self.E_.corners(collisions[i].primID0), self.F_.corners(collisions[i].primID1)))
        ++self.pairs_;
  }

  Device device_;
  EmbreeScene E_, F_;
  std::vector<Eigen::Vector3d> vertices_Mf_;
  std::int64_t pairs_ = 0;
};

}  // namespace

std::vector<PeerEntry> embree_peers() {
  return {{"Embree " RTC_VERSION_STRING, "rtcCollide: pairs", "pairs", "libembree-dev", true,
           [](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
             return std::make_unique<Embree>(mesh_E, mesh_F);
           }}};
}

}  // namespace pcm::compare
