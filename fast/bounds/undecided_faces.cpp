// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/undecided_faces.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>

#include "fast/posed/vertex_rounding.h"
#include "fast/predicates/penetration_predicates.h"

namespace pcm::fast {

namespace {

/// How two closed faces lie to each other, for all positions of their vertices within the rounding.
enum class Relation : std::uint8_t { apart, crossing, unsure };

/// The sign of the triple product x . (y x z) of differences of vertices that are each off by at most `rounding`, where
/// that is sure. The product is linear in each factor: with 1-norms it changes by at most
/// (|x| + 2 d)(|y| + 2 d)(|z| + 2 d) - |x| |y| |z|, and carries 8 roundings; underflow is paid for apart.
class SurePlane {
 public:
  /// The plane through a in the directions of b - a and c - a.
  SurePlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, double rounding)
      : a_(a), N_((b - a).cross(c - a)) {
    const double y = (b - a).lpNorm<1>(), z = (c - a).lpNorm<1>(), d = 2 * rounding;
    // |x| times the first and the second.
    relative_ = kSafetyFactor * (d * (y + z + d) + 10 * kUnitRoundoff * y * z) + 0x1p-1070;
    absolute_ = kSafetyFactor * d * (y + d) * (z + d) + 0x1p-1060;
  }

  /// +1 where x surely lies above the plane, -1 where below.
  int sign(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d from_a = x - a_;
    const double volume = N_.dot(from_a);
    const double bound = relative_ * from_a.lpNorm<1>() + absolute_;
    return (volume > bound) - (volume < -bound);
  }
  std::array<int, 3> signs(const FacePoints& f) const { return {sign(f[0]), sign(f[1]), sign(f[2])}; }

 private:
  Eigen::Vector3d a_, N_;
  double relative_, absolute_;
};

bool surely_one_side(const std::array<int, 3>& signs) {
  return signs[0] != 0 && signs[0] == signs[1] && signs[0] == signs[2];
}

bool all_sure(const std::array<int, 3>& signs) {
  return signs[0] != 0 && signs[1] != 0 && signs[2] != 0;
}

std::size_t lone_corner(const std::array<int, 3>& signs) {
  if (signs[0] == signs[1]) return 2;
  return signs[0] == signs[2] ? 1 : 0;
}

/// The same decisions as the crossings' own, each only where it is sure. Where all signs are, two faces that do not
/// cross don't touch either: on the line that both planes meet in, they cover two intervals with no end in common.
Relation relation(const FacePoints& e, const FacePoints& f, double rounding) {
  const std::array<int, 3> signs_E = SurePlane(f[0], f[1], f[2], rounding).signs(e);
  if (surely_one_side(signs_E)) return Relation::apart;
  const std::array<int, 3> signs_F = SurePlane(e[0], e[1], e[2], rounding).signs(f);
  if (surely_one_side(signs_F)) return Relation::apart;
  if (!all_sure(signs_E) || !all_sure(signs_F)) return Relation::unsure;
  const std::size_t i = lone_corner(signs_E), j = lone_corner(signs_F);
  int sum = 0;
  for (std::size_t step = 1; step <= 2; ++step) {
    const SurePlane plane(e[i], e[(i + step) % 3], f[j], rounding);
    const int first = plane.sign(f[(j + 1) % 3]), second = plane.sign(f[(j + 2) % 3]);
    if (first == 0 || second == 0) return Relation::unsure;
    sum += first + second;
  }
  return std::abs(sum) == 4 ? Relation::apart : Relation::crossing;
}

}  // namespace

void find_undecided_faces(const Intersection& intersection, Side master, const Eigen::Vector3d& rounding_Me,
                          UndecidedFaces& undecided) {
  PosedPair& posed = intersection.posed;
  const Crossings& crossings = intersection.crossings;
  const double rounding = rounding_Me.sum();
  const auto relation_of = [&](Index face_E, Index face_F) {
    return relation(posed.face_Me(Side::E, face_E), posed.face_Me(Side::F, face_F), rounding);
  };
  const std::size_t faces = posed.surface(master).mesh.faces.size();
  undecided.surely_crossed.start(faces);
  undecided.is_undecided.start(faces);
  undecided.faces.clear();
  const auto enter = [&undecided](Index face) {
    undecided.is_undecided[face] = true;
    undecided.faces.push_back(face);
  };

  if (!posed.surface(opposite(master)).closed) {
    for (const auto& [face_E, face_F] : crossings.candidates) {
      if (relation_of(face_E, face_F) != Relation::unsure) continue;
      for (std::size_t face = 0; face < faces; ++face) enter(static_cast<Index>(face));
      return;
    }
    return;
  }

  for (const CrossingNode& crossing : crossings.nodes) {
    const auto& [face_E, face_F] = crossing.segment_face;
    const Index face = master == Side::E ? face_E : face_F;
    if (face < 0 || undecided.surely_crossed.contains(face)) continue;
    if (relation_of(face_E, face_F) == Relation::crossing) undecided.surely_crossed[face] = true;
  }
  for (const auto& [face_E, face_F] : crossings.candidates) {
    const Index face = master == Side::E ? face_E : face_F;
    if (undecided.surely_crossed.contains(face) || undecided.is_undecided.contains(face)) continue;
    if (relation_of(face_E, face_F) != Relation::apart) enter(face);
  }
}

}  // namespace pcm::fast
