// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The strata generic and grazing (one construction, two ranges of penetration) and separated.
#include <cmath>

#include "compare/poses/opposed_rotation.h"
#include "compare/poses/strata.h"

namespace pcm::compare::detail {
namespace {

/// A point of a surface with an outward direction there.
struct SurfacePoint {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

/// A point of a drawn face, edge or vertex, each kind as often. Where the normals of an edge or a vertex cancel, its
/// first face stands in.
SurfacePoint draw_surface_point(const SurfaceFeatures& surface, PoseRandom& random) {
  SurfacePoint drawn;
  const std::uint64_t kind = random.below(3);
  const auto face = static_cast<Index>(random.below(surface.mesh.faces.size()));
  const Triangle& corners = surface.mesh.faces[static_cast<std::size_t>(face)];
  Eigen::Vector3d normal = surface.face_normal(face);
  if (kind == 0) {
    double s = random.uniform(), t = random.uniform();
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    const Eigen::Vector3d& p = vertex(surface, corners[0]);
    drawn.point = p + (vertex(surface, corners[1]) - p) * s + (vertex(surface, corners[2]) - p) * t;
  } else if (kind == 1) {
    const FeatureEdge& edge = surface.edges[random.below(surface.edges.size())];
    const Eigen::Vector3d& a = vertex(surface, edge.ends[0]);
    drawn.point = a + (vertex(surface, edge.ends[1]) - a) * random.uniform();
    normal = ordered_normalized(surface.face_normal(edge.faces.front()));
    if (edge.faces.size() > 1) normal += ordered_normalized(surface.face_normal(edge.faces.back()));
    if (ordered_dot(normal, normal) < 1e-6) normal = surface.face_normal(edge.faces.front());
  } else {
    drawn.point = vertex(surface, corners[0]);
    const Eigen::Vector3d sum = surface.vertex_normal(corners[0]);
    if (ordered_dot(sum, sum) > 1e-6 * ordered_dot(normal, normal)) normal = sum;
  }
  drawn.normal = ordered_normalized(normal);
  return drawn;
}

/// Feature-to-feature pose: a drawn point of F lies in a drawn one of E at `depth`, outward normals opposed but for a
/// tilt. Half the tangents of the half tilt are log-uniform down to 2^-40, so that nearly parallel faces come often.
DrawnPose draw_feature_pose(const FeaturePair& pair, double depth, PoseRandom& random) {
  const SurfacePoint on_E = draw_surface_point(pair.E, random);
  const SurfacePoint on_F = draw_surface_point(pair.F, random);
  const double t = random.coin() ? random.log_uniform(0x1p-40, 0.5) : random.uniform(0, 0.5);
  DrawnPose drawn;
  drawn.pose.A = draw_opposed_rotation(on_E.normal, on_F.normal, t, random);
  drawn.pose.r = on_E.point - on_E.normal * depth - ordered_product(drawn.pose.A, on_F.point);
  drawn.construction = "feature to feature";
  return drawn;
}

/// Support points along a drawn direction on one line, overlapping by `depth` (apart where it is negative).
DrawnPose draw_support_pose(const FeaturePair& pair, double depth, PoseRandom& random) {
  DrawnPose drawn;
  drawn.pose.A = random.rotation();
  const Eigen::Vector3d d_Me = random.direction();
  const Eigen::Vector3d d_Mf = ordered_product(drawn.pose.A.transpose(), d_Me);
  const Eigen::Vector3d& x_E = vertex(pair.E, pair.E.support(d_Me));
  const Eigen::Vector3d& x_F = vertex(pair.F, pair.F.support(-d_Mf));
  drawn.pose.r = x_E - d_Me * depth - ordered_product(drawn.pose.A, x_F);
  drawn.construction = "support points";
  return drawn;
}

bool boxes_overlap(const FeaturePair& pair, const Pose& pose) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (const Index v : pair.F.used_vertices) {
    const Eigen::Vector3d x_Me = ordered_product(pose.A, vertex(pair.F, v)) + pose.r;
    low = low.cwiseMin(x_Me);
    high = high.cwiseMax(x_Me);
  }
  return (low.array() <= pair.E.box_max.array()).all() && (high.array() >= pair.E.box_min.array()).all();
}

}  // namespace

DrawnPose draw_overlapping(const FeaturePair& pair, double least, double greatest, PoseRandom& random) {
  const double depth = random.log_uniform(least, greatest) * pair.size();
  return random.coin() ? draw_support_pose(pair, depth, random) : draw_feature_pose(pair, depth, random);
}

DrawnPose draw_separated(const FeaturePair& pair, PoseRandom& random) {
  // A gap of 1e-9 sizes is far above the rounding of a support height (a few 1e-16), so a plane parts the surfaces.
  constexpr int kTries = 64;
  DrawnPose drawn;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const double gap = random.log_uniform(1e-9, 0.1) * pair.size();
    drawn = draw_support_pose(pair, -gap, random);
    if (boxes_overlap(pair, drawn.pose)) break;
  }
  drawn.construction = "parted by a plane";
  return drawn;
}

}  // namespace pcm::compare::detail
