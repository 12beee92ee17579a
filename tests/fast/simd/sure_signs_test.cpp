// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Single precision decides only what it is sure of, however near to a plane or to an edge: bodies are placed so that a
// vertex or an edge of F lies beside a face or an edge of E, by a few of its roundings.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>

#include "fast/posed/transform.h"
#include "fast/search/candidates.h"
#include "fast/simd/overlap_sets.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"

namespace pcm::fast::sure_signs_test {
namespace {

/// Counts what single precision decides at a pose, and expects all of it to be so.
class Decisions {
 public:
  Decisions(const Surface& E, const Surface& F) : E_(E), F_(F) {}

  void hold_at(const Pose& pose) {
    const Placement placement(E_.data(), F_.data(), pose);
    posed_[0].place_E(E_.data());
    posed_[1].place_F(F_.data(), pose, E_.mesh().vertices.size(), false);
    std::set<std::pair<Index, Index>> candidates;
    for_each_candidate(E_.data(), F_.data(), placement, open_, work_, [&](Index e, Index f, const SureSigns& sure) {
      candidates.emplace(e, f);
      hold_signs(e, f, sure);
      return true;
    });
    for (Index e = 0; e < static_cast<Index>(E_.mesh().faces.size()); ++e) {
      for (Index f = 0; f < static_cast<Index>(F_.mesh().faces.size()); ++f) {
        if (candidates.count({e, f}) == 0) lost_ += cross(e, f);
      }
    }
  }

  /// Signs that are not as they were said to be.
  int wrong() const { return wrong_; }
  /// Pairs of faces that cross and were ruled out.
  int lost() const { return lost_; }
  int sure() const { return sure_; }

 private:
  using Face = std::array<RankedPoint, 3>;
  Face face(std::size_t side, Index f) { return posed_[side].face_points(f, work_); }

  unsigned above(const Face& plane, const Face& x) {
    unsigned corners = 0;
    for (std::size_t k = 0; k < 3; ++k)
      corners |= orientation(plane[0], plane[1], plane[2], x[k], work_) > 0 ? 1U << k : 0U;
    return corners;
  }
  bool passes(const RankedPoint& a, const RankedPoint& b, const Face& f) {
    if (orientation(f[0], f[1], f[2], a, work_) == orientation(f[0], f[1], f[2], b, work_)) return false;
    const int turn = orientation(a, b, f[0], f[1], work_);
    return turn == orientation(a, b, f[1], f[2], work_) && turn == orientation(a, b, f[2], f[0], work_);
  }
  bool any_edge_passes(const Face& e, const Face& f) {
    return passes(e[0], e[1], f) || passes(e[1], e[2], f) || passes(e[2], e[0], f);
  }
  int cross(Index e, Index f) {
    const Face of_E = face(0, e), of_F = face(1, f);
    return any_edge_passes(of_E, of_F) || any_edge_passes(of_F, of_E) ? 1 : 0;
  }
  void hold_signs(Index e, Index f, const SureSigns& sure) {
    const Face of_E = face(0, e), of_F = face(1, f);
    if (sure.of_E()) hold(above(of_F, of_E) == sure.above_of_E());
    if (sure.of_F()) hold(above(of_E, of_F) == sure.above_of_F());
    if (sure.of_passing()) hold((sure.passing() != 0) == (cross(e, f) != 0));
  }
  void hold(bool so) {
    ++sure_;
    wrong_ += so ? 0 : 1;
  }

  const Surface& E_;
  const Surface& F_;
  std::array<PosedSurface, 2> posed_;
  NodePairs open_;
  WorkCounters work_;
  int wrong_ = 0, lost_ = 0, sure_ = 0;
};

class Draw {
 public:
  double between(double low, double high) { return low + (high - low) * (0x1p-64 * static_cast<double>(engine_())); }
  Eigen::Matrix3d rotation() {
    Eigen::Quaterniond q;
    do {
      q = Eigen::Quaterniond(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1));
    } while (q.norm() < 0.1 || q.norm() > 1);
    return q.normalized().toRotationMatrix();
  }
  /// Of either sign, between 2^-28 and 2^-19 m, for bodies of a metre: a sixteenth of single precision's rounding
  /// and 32.
  double gap() { return (between(0, 1) < 0.5 ? -1 : 1) * std::exp2(between(-28, -19)); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

 private:
  std::mt19937_64 engine_{20261126};
};

constexpr int kPoses = 4000;

Eigen::Vector3d corner(const Surface& surface, std::size_t face, std::size_t k) {
  return surface.data().vertex(surface.data().face(static_cast<Index>(face))[k]);
}

TEST(SureSigns, AreSoWhereAVertexIsBesideAFace) {
  const Surface ball(generate::icosphere(0.5, 0)), cube(generate::gridded_box(1, 1));
  Draw draw;
  for (const Surface* E : {&ball, &cube}) {
    Decisions decisions(*E, ball);
    for (int i = 0; i < kPoses; ++i) {
      const std::size_t face = draw.below(E->mesh().faces.size());
      const Eigen::Vector3d a = corner(*E, face, 0), b = corner(*E, face, 1), c = corner(*E, face, 2);
      const Eigen::Vector3d n = (b - a).cross(c - a).normalized();
      const double s = draw.between(0.1, 0.5), t = draw.between(0.1, 0.5);
      const Eigen::Vector3d beside = a + s * (b - a) + t * (c - a) + draw.gap() * n;
      // F lies above the face, but for its lowest vertex.
      const Eigen::Matrix3d A = draw.rotation();
      Eigen::Vector3d lowest = A * ball.mesh().vertices[0];
      for (const Eigen::Vector3d& x : ball.mesh().vertices) {
        if (n.dot(A * x) < n.dot(lowest)) lowest = A * x;
      }
      decisions.hold_at({A, beside - lowest});
    }
    EXPECT_EQ(decisions.wrong(), 0);
    EXPECT_EQ(decisions.lost(), 0);
    EXPECT_GT(decisions.sure(), kPoses);
  }
}

TEST(SureSigns, AreSoWhereAnEdgeIsBesideAnEdge) {
  const Surface ball(generate::icosphere(0.5, 0)), cube(generate::gridded_box(1, 1));
  Draw draw;
  for (const Surface* E : {&ball, &cube}) {
    Decisions decisions(*E, ball);
    for (int i = 0; i < kPoses; ++i) {
      const std::size_t face = draw.below(E->mesh().faces.size()), other = draw.below(ball.mesh().faces.size());
      const Eigen::Matrix3d A = draw.rotation();
      const Eigen::Vector3d a = corner(*E, face, 0), b = corner(*E, face, 1);
      const Eigen::Vector3d p = A * corner(ball, other, 0), q = A * corner(ball, other, 1);
      const Eigen::Vector3d n = (b - a).cross(q - p);
      if (n.norm() < 0.1 * (b - a).norm() * (q - p).norm()) continue;
      const Eigen::Vector3d beside = a + draw.between(0.2, 0.8) * (b - a) + draw.gap() * n.normalized();
      decisions.hold_at({A, beside - (p + draw.between(0.2, 0.8) * (q - p))});
    }
    EXPECT_EQ(decisions.wrong(), 0);
    EXPECT_EQ(decisions.lost(), 0);
    EXPECT_GT(decisions.sure(), kPoses);
  }
}

}  // namespace
}  // namespace pcm::fast::sure_signs_test
