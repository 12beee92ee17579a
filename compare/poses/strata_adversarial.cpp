// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The stratum adversarial: poses with rotations in no special place that bring several features of both bodies to
// within roundings of each other, nearer than any pose drawn at random and yet not onto each other.
//
// Three decisions of the engine, each the sign of an orientation of four vertices, are linear in r while the rotation
// stays. So r is solved for that makes all three 0; rounding leaves them near it, and a climb over neighbouring doubles
// goes to where the product of their margins is least, none of them 0.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "compare/poses/orientation_margin.h"
#include "compare/poses/rounded_vertices.h"
#include "compare/poses/strata.h"

namespace pcm::compare::detail {
namespace {

/// Four vertices whose orientation decides: a face and a vertex, or two edges. The first `of_E` are E's, the others
/// F's.
struct Decision {
  std::array<Index, 4> vertices{};
  int of_E = 0;
};

using Points = std::array<Eigen::Vector3d, 4>;

Points points_of(const FeaturePair& pair, const Pose& pose, const Decision& decision) {
  Points points;
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    points[k] = i < decision.of_E
                    ? vertex(pair.E, decision.vertices[k])
                    : Eigen::Vector3d(ordered_product(pose.A, vertex(pair.F, decision.vertices[k])) + pose.r);
  }
  return points;
}

/// The orientation as a linear function of a further shift of F: value + gradient . shift.
struct LinearOrientation {
  double value;
  Eigen::Vector3d gradient;
};

LinearOrientation linear_orientation(const Points& points, int of_E) {
  const auto& [a, b, c, d] = points;
  const Eigen::Vector3d normal = ordered_cross(b - a, c - a);
  const double value = ordered_dot(normal, d - a);
  switch (of_E) {
    case 3:
      return {value, normal};
    case 2:
      return {value, ordered_cross(b - a, c - d)};
    default:
      return {value, ordered_cross(c - b, d - b)};  // a is E's: b, c and d move.
  }
}

/// Whether the features are near to where they would meet: the vertex over the face, or the edges across each other.
bool may_meet(const Points& points, int of_E) {
  constexpr double kBeside = 0.125;
  const auto within = [](double x) { return x >= -kBeside && x <= 1 + kBeside; };
  if (of_E == 2) {
    const Eigen::Vector3d p = points[1] - points[0], q = points[3] - points[2], w = points[2] - points[0];
    const Eigen::Vector3d n = ordered_cross(p, q);
    const double square = ordered_dot(n, n);
    return square > 0 && within(ordered_dot(ordered_cross(w, q), n) / square) &&
           within(ordered_dot(ordered_cross(w, p), n) / square);
  }
  const std::size_t vertex = of_E == 3 ? 3 : 0, corner = of_E == 3 ? 0 : 1;
  const Eigen::Vector3d p = points[corner + 1] - points[corner], q = points[corner + 2] - points[corner];
  const Eigen::Vector3d w = points[vertex] - points[corner], n = ordered_cross(p, q);
  const double square = ordered_dot(n, n);
  if (!(square > 0)) return false;
  const double s = ordered_dot(ordered_cross(w, q), n) / square, t = ordered_dot(ordered_cross(p, w), n) / square;
  return within(s) && within(t) && within(1 - s - t);
}

Decision draw_decision(const FeaturePair& pair, PoseRandom& random) {
  const auto face = [&random](const SurfaceFeatures& surface) {
    return surface.mesh.faces[random.below(surface.mesh.faces.size())];
  };
  const auto a_vertex = [&random](const SurfaceFeatures& surface) {
    return surface.used_vertices[random.below(surface.used_vertices.size())];
  };
  switch (random.below(3)) {
    case 0: {
      const Triangle corners = face(pair.E);
      const Index of_F = a_vertex(pair.F);
      return {{corners[0], corners[1], corners[2], of_F}, 3};
    }
    case 1: {
      const Index of_E = a_vertex(pair.E);
      const Triangle corners = face(pair.F);
      return {{of_E, corners[0], corners[1], corners[2]}, 1};
    }
    default: {
      const auto& edge_E = pair.E.edges[random.below(pair.E.edges.size())].ends;
      const auto& edge_F = pair.F.edges[random.below(pair.F.edges.size())].ends;
      return {{edge_E[0], edge_E[1], edge_F[0], edge_F[1]}, 2};
    }
  }
}

struct Candidate {
  Decision decision;
  LinearOrientation orientation;
  double distance;  ///< how far F would have to move, m
};

/// The nearest of those drawn.
std::vector<Candidate> near_decisions(const FeaturePair& pair, const Pose& pose, PoseRandom& random) {
  constexpr int kDrawn = 512;
  std::vector<Candidate> candidates;
  for (int i = 0; i < kDrawn; ++i) {
    const Decision decision = draw_decision(pair, random);
    const Points points = points_of(pair, pose, decision);
    if (!may_meet(points, decision.of_E)) continue;
    const LinearOrientation orientation = linear_orientation(points, decision.of_E);
    const double steepness = std::sqrt(ordered_dot(orientation.gradient, orientation.gradient));
    const double distance = std::abs(orientation.value) / steepness;
    if (distance < 0.25 * pair.size()) candidates.push_back({decision, orientation, distance});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  return candidates;
}

/// Cramer's rule; none where the gradients are nearly in one plane.
std::optional<Eigen::Vector3d> common_zero(const Candidate& a, const Candidate& b, const Candidate& c) {
  const auto unit = [](const Candidate& x) {
    const double length = std::sqrt(ordered_dot(x.orientation.gradient, x.orientation.gradient));
    return LinearOrientation{x.orientation.value / length, Eigen::Vector3d(x.orientation.gradient / length)};
  };
  const LinearOrientation f = unit(a), g = unit(b), h = unit(c);
  const Eigen::Vector3d g_h = ordered_cross(g.gradient, h.gradient), h_f = ordered_cross(h.gradient, f.gradient);
  const Eigen::Vector3d f_g = ordered_cross(f.gradient, g.gradient);
  const double determinant = ordered_dot(f.gradient, g_h);
  if (std::abs(determinant) < 0x1p-6) return std::nullopt;
  return Eigen::Vector3d(-(g_h * f.value + h_f * g.value + f_g * h.value) / determinant);
}

/// The product of the margins; a margin of 0, features that meet, counts as none.
double hardness(const FeaturePair& pair, const Pose& pose, const std::array<Decision, 3>& decisions) {
  double product = 1;
  for (const Decision& decision : decisions) {
    const double margin = orientation_margin(points_of(pair, pose, decision));
    product *= margin > 0 ? margin : 1;
  }
  return product;
}

/// Goes to neighbouring doubles of r's components as long as that is harder.
void climb(const FeaturePair& pair, const std::array<Decision, 3>& decisions, Pose& pose) {
  constexpr int kRounds = 3, kFarthest = 4;
  double least = hardness(pair, pose, decisions);
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    for (int j = 0; j < 3; ++j) {
      const double from = pose.r[j], ulp = ulp_of(from);
      double best = from;
      for (int steps = -kFarthest; steps <= kFarthest; ++steps) {
        pose.r[j] = from + steps * ulp;
        const double product = hardness(pair, pose, decisions);
        if (!(product < least)) continue;
        least = product;
        best = pose.r[j];
      }
      moved = moved || best != from;
      pose.r[j] = best;
    }
    if (!moved) return;
  }
}

/// Three decisions at once, of the nearest ones those that can be.
bool bring_near(const FeaturePair& pair, PoseRandom& random, Pose& pose) {
  const std::vector<Candidate> near = near_decisions(pair, pose, random);
  constexpr std::size_t kMost = 12;
  const std::size_t n = std::min(near.size(), kMost);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        const std::optional<Eigen::Vector3d> shift = common_zero(near[i], near[j], near[k]);
        if (!shift || !(ordered_dot(*shift, *shift) < 0.0625 * pair.size() * pair.size())) continue;
        pose.r += *shift;
        climb(pair, {near[i].decision, near[j].decision, near[k].decision}, pose);
        return true;
      }
    }
  }
  return false;
}

}  // namespace

DrawnPose draw_adversarial(const FeaturePair& pair, PoseRandom& random) {
  constexpr int kTries = 16;
  DrawnPose drawn;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    drawn = draw_overlapping(pair, 1e-6, 0.5, random);
    drawn.construction = "three decisions near a tie";
    if (bring_near(pair, random, drawn.pose)) return drawn;
  }
  drawn.construction = "no three decisions near a tie";
  return drawn;
}

}  // namespace pcm::compare::detail
