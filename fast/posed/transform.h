// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "fast/base/fast_clear_array.h"
#include "fast/posed/vertex_rounding.h"
#include "fast/predicates/orientation.h"
#include "fast/surface/prepared_surface.h"
#include "pcm/inputs.h"
#include "pcm/work_counters.h"

namespace pcm::fast {

/// A vertex of F in Me, in the order of operations that defines the rounded problem (PCM section 1):
/// fl(fl(fl(fl(a_i1 x) + fl(a_i2 y)) + fl(a_i3 z)) + r_i), no fused multiply-add.
inline Eigen::Vector3d rounded_transform(const Pose& pose, const Eigen::Vector3d& x_Mf) {
  Eigen::Vector3d x_Me;
  for (int i = 0; i < 3; ++i) {
    x_Me[i] = ((pose.A(i, 0) * x_Mf[0] + pose.A(i, 1) * x_Mf[1]) + pose.A(i, 2) * x_Mf[2]) + pose.r[i];
  }
  return x_Me;
}

/// A surface as the rounded problem has it: vertices in Me and their rank in the order of the tie rule. F's vertices
/// are transformed when first asked for, each once a pose.
class PosedSurface {
 public:
  void place_E(const PreparedSurface& surface) {
    surface_ = &surface;
    vertices_Me_ = surface.mesh.vertices.data();
    moved_ = false;
    first_rank_ = 0;
  }
  /// `with_roundings`: whether sharp roundings will be asked for.
  void place_F(const PreparedSurface& surface, const Pose& pose, std::size_t vertices_of_E, bool with_roundings) {
    surface_ = &surface;
    if (transformed_Me_.size() < surface.mesh.vertices.size()) transformed_Me_.resize(surface.mesh.vertices.size());
    vertices_Me_ = transformed_Me_.data();
    done_.start(surface.mesh.vertices.size());
    if (with_roundings) {
      if (rounding_Me_.size() < surface.mesh.vertices.size()) rounding_Me_.resize(surface.mesh.vertices.size());
      has_rounding_.start(surface.mesh.vertices.size());
    }
    pose_ = pose;
    moved_ = true;
    first_rank_ = static_cast<std::int64_t>(vertices_of_E);
  }

  /// F's vertices all at once, where they are not to be spared.
  void transform_all(WorkCounters& work) {
    for (std::size_t v = 0; v < surface_->mesh.vertices.size(); ++v) vertex_Me(static_cast<Index>(v), work);
  }

  const PreparedSurface& surface() const { return *surface_; }
  /// F's.
  const Pose& pose() const { return pose_; }

  const Eigen::Vector3d& vertex_Me(Index v, WorkCounters& work) {
    const auto i = static_cast<std::size_t>(v);
    if (moved_ && !done_.contains(i)) {
      done_[i] = true;
      transformed_Me_[i] = rounded_transform(pose_, surface_->mesh.vertices[i]);
      ++work.vertices_transformed;
    }
    return vertices_Me_[i];
  }
  /// How far the vertex may be from the exact problem's (PCM section 1), component by component, m; 0 for E's. By
  /// `sharp_vertex_rounding`, found once a pose.
  Eigen::Vector3d sharp_rounding_Me(Index v) {
    if (!moved_) return Eigen::Vector3d::Zero();
    const auto i = static_cast<std::size_t>(v);
    if (!has_rounding_.contains(i)) {
      has_rounding_[i] = true;
      rounding_Me_[i] = sharp_vertex_rounding(pose_, surface_->mesh.vertices[i]);
    }
    return rounding_Me_[i];
  }
  /// The same for all vertices of a face: the greatest of the three. Sharp, where `face_rounding` is not.
  Eigen::Vector3d sharp_face_rounding_Me(Index f) {
    const Triangle& triangle = surface_->face(f);
    return sharp_rounding_Me(triangle[0])
        .cwiseMax(sharp_rounding_Me(triangle[1]))
        .cwiseMax(sharp_rounding_Me(triangle[2]));
  }
  RankedPoint point(Index v, WorkCounters& work) { return {vertex_Me(v, work).data(), first_rank_ + v}; }

  std::array<RankedPoint, 3> face_points(Index f, WorkCounters& work) {
    const Triangle& triangle = surface_->face(f);
    return {point(triangle[0], work), point(triangle[1], work), point(triangle[2], work)};
  }
  std::array<Eigen::Vector3d, 3> face_Me(Index f, WorkCounters& work) {
    const Triangle& triangle = surface_->face(f);
    return {vertex_Me(triangle[0], work), vertex_Me(triangle[1], work), vertex_Me(triangle[2], work)};
  }

 private:
  const PreparedSurface* surface_ = nullptr;
  const Eigen::Vector3d* vertices_Me_ = nullptr;
  std::vector<Eigen::Vector3d> transformed_Me_;
  FastClearArray<bool> done_;
  std::vector<Eigen::Vector3d> rounding_Me_;
  FastClearArray<bool> has_rounding_;
  Pose pose_;
  bool moved_ = false;
  std::int64_t first_rank_ = 0;
};

}  // namespace pcm::fast
