// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every draw stands in a statement of its own: the order in which a compiler evaluates arguments and operands is its
// own choice, and the laws must be the same bits everywhere.
#include "compare/poses/law_draw.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "compare/poses/law_thresholds.h"

namespace pcm::compare {
namespace {

constexpr int kGreatestRatioExponent = 40;

/// How a threshold is placed.
enum class Place { off, generic, at, near };

/// Off in `off` of eight draws, generic in `generic`; the others half at an element's figure, half near one.
Place draw_place(PoseRandom& random, std::uint64_t off, std::uint64_t generic) {
  const std::uint64_t eighth = random.below(8);
  if (eighth < off) return Place::off;
  if (eighth < off + generic) return Place::generic;
  return random.coin() ? Place::at : Place::near;
}

/// Those at, near and between which thresholds keep their limits.
std::vector<double> usable(std::span<const double> figures) {
  std::vector<double> inside;
  std::copy_if(figures.begin(), figures.end(), std::back_inserter(inside),
               [](double x) { return x > kLeastThreshold && x < kGreatestThreshold; });
  return inside;
}

double draw_one_of(PoseRandom& random, const std::vector<double>& figures) {
  return figures[random.below(figures.size())];
}

/// 1 to 4 ulps beside the figure.
double draw_near(PoseRandom& random, double figure) {
  const std::uint64_t ulps = 1 + random.below(4);
  const double towards = random.coin() ? kGreatestThreshold : kLeastThreshold;
  for (std::uint64_t k = 0; k < ulps; ++k) figure = std::nextafter(figure, towards);
  return figure;
}

/// A threshold that is not off.
double draw_threshold(PoseRandom& random, Place place, const std::vector<double>& figures, double least,
                      double greatest) {
  if (place == Place::generic || figures.empty()) return random.log_uniform(least, greatest);
  const double figure = draw_one_of(random, figures);
  return place == Place::at ? figure : draw_near(random, figure);
}

/// Strictly between two drawn figures: where they are no neighbours the larger one is clamped by it, the other is not.
double draw_between(PoseRandom& random, const std::vector<double>& figures, double least, double greatest) {
  if (!figures.empty()) {
    const double a = draw_one_of(random, figures);
    const double b = draw_one_of(random, figures);
    const double part = random.uniform();
    const double low = std::min(a, b), high = std::max(a, b);
    const double between = low + (high - low) * part;
    if (between > low && between < high) return between;
  }
  return random.log_uniform(least, greatest);
}

LayerStiffness draw_layers(PoseRandom& random, double softer) {
  constexpr double kRigid = std::numeric_limits<double>::infinity();
  const std::uint64_t quarter = random.below(4);
  if (quarter == 0) return {kRigid, softer};
  if (quarter == 1) return {softer, kRigid};
  const double ratio = random.coin() ? std::ldexp(1, static_cast<int>(random.below(kGreatestRatioExponent + 1)))
                                     : random.log_uniform(1, std::ldexp(1, kGreatestRatioExponent));
  if (random.coin()) return {softer, softer * ratio};
  return {softer * ratio, softer};
}

/// The normal of a drawn face in the surface's own frame, of length 1 to rounding; along an axis exactly where the face
/// was drawn from those orthogonal to one.
Eigen::Vector3d draw_face_normal(PoseRandom& random, const SurfaceFeatures& surface) {
  const bool along_axis = random.coin();
  if (along_axis && !surface.axis_faces.empty()) {
    const AxisFace& face = surface.axis_faces[random.below(surface.axis_faces.size())];
    return Eigen::Vector3d::Unit(face.axis) * static_cast<double>(face.sign);
  }
  return ordered_normalized(surface.face_normal(static_cast<Index>(random.below(surface.mesh.faces.size()))));
}

/// The direction in the plane with that normal that is orthogonal to the axis farthest from the normal: along an axis
/// exactly where the normal is.
Eigen::Vector3d direction_in_plane(const Eigen::Vector3d& normal) {
  int axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  return ordered_normalized(ordered_cross(normal, Eigen::Vector3d::Unit(axis)));
}

}  // namespace

ContactLaw draw_law_without_thresholds(PoseRandom& random) {
  ContactLaw law;
  law.damping_mode = static_cast<DampingMode>(random.below(3));
  const double softer = random.log_uniform(0x1p10, 0x1p30);
  if (random.coin())
    law.stiffness = softer;
  else
    law.layers = draw_layers(random, softer);
  if (random.below(4) != 0) law.damping = softer * random.log_uniform(0x1p-12, 0x1p4);
  if (random.below(4) != 0) law.friction = random.log_uniform(0x1p-6, 2);
  return law;
}

void draw_depths(PoseRandom& random, double size, std::span<const double> penetrations, ContactLaw& law) {
  const std::vector<double> depths = usable(penetrations);
  const double least = 0x1p-20 * size;
  const Place transition = draw_place(random, 2, 2);
  law.transition_depth = transition == Place::off ? 0 : draw_threshold(random, transition, depths, least, size);
  const Place clamp = draw_place(random, 4, 2);
  if (clamp == Place::off)
    law.max_penetration = std::numeric_limits<double>::infinity();
  else if (clamp == Place::generic)
    law.max_penetration = draw_between(random, depths, least, size);
  else
    law.max_penetration = draw_threshold(random, clamp, depths, least, size);
}

void draw_slip_velocity(PoseRandom& random, double size, std::span<const double> speeds, ContactLaw& law) {
  const Place place = draw_place(random, 2, 2);
  law.slip_velocity =
      place == Place::off ? 0 : draw_threshold(random, place, usable(speeds), 0x1p-14 * size, 0x1p4 * size);
}

ContactLaw draw_law(PoseRandom& random, double size, std::span<const double> penetrations,
                    std::span<const double> speeds) {
  ContactLaw law = draw_law_without_thresholds(random);
  draw_depths(random, size, penetrations, law);
  draw_slip_velocity(random, size, speeds, law);
  return law;
}

Velocity draw_velocity(PoseRandom& random, const FeaturePair& pair, const Pose& pose) {
  Velocity velocity;
  const std::uint64_t eighth = random.below(8);
  const double magnitude = random.log_uniform(0x1p-14, 0x1p7) * pair.size();
  const double speed = random.coin() ? magnitude : -magnitude;
  const double spin = random.log_uniform(0x1p-14, 0x1p7);
  switch (eighth) {
    case 0:
      break;
    case 1:
      velocity.w = random.direction() * spin;
      break;
    case 2:
      velocity.v = draw_face_normal(random, pair.E) * speed;
      break;
    case 3:
      velocity.v = ordered_product(pose.A, draw_face_normal(random, pair.F)) * speed;
      break;
    case 4:
      velocity.v = direction_in_plane(draw_face_normal(random, pair.E)) * speed;
      break;
    case 5:
    case 6:
      velocity.v = random.direction() * speed;
      break;
    default:
      velocity.v = random.direction() * speed;
      velocity.w = random.direction() * spin;
      break;
  }
  return velocity;
}

}  // namespace pcm::compare
