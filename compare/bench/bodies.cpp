// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/bodies.h"

#include <fmt/format.h>

#include <array>

#include "compare/random/random.h"
#include "compare/verify/routes/wanted_presets.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"
#include "pcm/bad_input.h"
#include "pcm/engine.h"

namespace pcm::compare {
namespace {

constexpr std::uint64_t kSeed = 20031;

/// Support points along a drawn direction on one line, overlapping by `depth`, apart where it is negative.
Pose draw_pose(const SurfaceFeatures& body, double depth, PoseRandom& random) {
  const auto vertex = [&body](Index v) { return body.mesh.vertices[static_cast<std::size_t>(v)]; };
  Pose pose;
  pose.A = random.rotation();
  const Eigen::Vector3d d_Me = random.direction();
  const Eigen::Vector3d d_Mf = ordered_product(pose.A.transpose(), d_Me);
  pose.r = vertex(body.support(d_Me)) - d_Me * depth - ordered_product(pose.A, vertex(body.support(-d_Mf)));
  return pose;
}

/// By the axes of either box; two boxes that only a cross product of axes parts count as overlapping.
bool boxes_overlap(const SurfaceFeatures& body, const Pose& pose) {
  const Eigen::Vector3d centre = (body.box_min + body.box_max) / 2, half = (body.box_max - body.box_min) / 2;
  const Eigen::Vector3d apart_Me = pose.A * centre + pose.r - centre;
  const Eigen::Matrix3d absolute = pose.A.cwiseAbs();
  return (apart_Me.cwiseAbs().array() <= (half + absolute * half).array()).all() &&
         ((pose.A.transpose() * apart_Me).cwiseAbs().array() <= (half + absolute.transpose() * half).array()).all();
}

}  // namespace

const std::vector<std::string>& bench_body_names() {
  static const std::vector<std::string> names{"bubbles", "bumpy", "spheres"};
  return names;
}

BenchBody bench_body(const std::string& name) {
  if (name == "bubbles") return {name, "bubble on bubble", generate::bubble()};
  if (name == "bumpy") return {name, "bumpy sphere on bumpy sphere", generate::bumpy_sphere()};
  if (name == "spheres") return {name, "sphere on sphere", generate::icosphere(1, 5)};
  throw BadInput(fmt::format("--bodies: unknown '{}'; known are {}", name, fmt::join(bench_body_names(), ", ")));
}

std::vector<Pose> bench_poses(const TriangleMesh& mesh, Distance distance, std::int64_t number) {
  const SurfaceFeatures body(mesh);
  const bool touching = distance == Distance::touching;
  const fast::Surface surface(mesh);
  const fast::Pairing pairing(surface, surface);
  fast::Workspace workspace;
  const auto as_wanted = [&](const Pose& pose) {
    return touching ? fast::evaluate(pairing, pose, {}, kTouchOnly, workspace).touching : boxes_overlap(body, pose);
  };
  std::vector<Pose> poses;
  for (std::uint64_t p = 0; static_cast<std::int64_t>(poses.size()) < number; ++p) {
    PoseRandom random(kSeed, static_cast<std::uint64_t>(distance), 0, p);
    const double depth = random.uniform(0.01, 0.1) * body.size;
    const Pose pose = draw_pose(body, touching ? depth : -depth, random);
    if (as_wanted(pose)) poses.push_back(pose);
  }
  return poses;
}

}  // namespace pcm::compare
