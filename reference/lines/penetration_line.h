// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "reference/pose/exact_pose.h"

namespace pcm::reference {

/// The line along which a master face e looks for the slave, in numbers of kind T: x = C - q N, q >= 0, with C its
/// barycentre and N its doubled normal (PCM section 6). Three times C is kept, so that no division is needed.
template <class T>
struct LineNumbers {
  Vec3<T> C3, N;  ///< 3 C, N
};

/// The line for all vertices within their rounding boxes.
struct EnclosedLine : LineNumbers<Interval> {
  Vec3<Interval> p0;       ///< a corner of e
  Vec3<Interval> moment3;  ///< 3 (C - p0) x N: with N the line's Pluecker coordinates about p0
};

/// a + b d + c d^2, d -> 0+: what comes of C moved by d v1 + d^2 v2, v1 = p1 - p0, v2 = p2 - p0. Products keep no
/// higher powers; what is asked of the line is linear in C, so none are left in the end.
struct Shifted {
  Exact a, b, c;

  Shifted() = default;
  explicit Shifted(double constant) : a(constant), b(0), c(0) {}
  Shifted(Exact constant, Exact linear, Exact square)
      : a(std::move(constant)), b(std::move(linear)), c(std::move(square)) {}
  friend Shifted operator+(const Shifted& x, const Shifted& y) { return {x.a + y.a, x.b + y.b, x.c + y.c}; }
  friend Shifted operator-(const Shifted& x, const Shifted& y) { return {x.a - y.a, x.b - y.b, x.c - y.c}; }
  friend Shifted operator*(const Shifted& x, const Shifted& y) {
    return {x.a * y.a, x.a * y.b + x.b * y.a, x.a * y.c + x.b * y.b + x.c * y.a};
  }
};

/// A face in the way of a line, with its normal, in numbers of kind T.
template <class T>
struct FaceNumbers {
  std::array<Vec3<T>, 3> corners;
  Vec3<T> normal;
};

/// How a line meets a face.
struct Meeting {
  bool met = false;
  int facing = 0;      ///< sign of N_e . N_f: -1 the line leaves F's body there, +1 it enters (for own faces alike)
  bool ahead = false;  ///< q > 0 before the shift; otherwise q = 0
};

/// A lower bound of the q >= 0 at which x - q N may be in the box for an x in `from`; negative where it surely misses
/// it. To be called while the rounding mode is upward.
double begin_of(const Vec3<Interval>& from, const Vec3<Interval>& N, const Box& box);

/// The penetration line of one master face. How it passes a face's edges is told by permuted inner products of Pluecker
/// coordinates; where these do not tell, the point where it meets the face's plane, explicitly, with its barycentric
/// coordinates there. The same point tells which of two faces is met first. Every decision is made for all vertices
/// within their rounding boxes at once where that is possible; where it is not, exactly on the pose's own problem, and
/// `certified` drops to false.
class PenetrationLine {
 public:
  PenetrationLine(const ExactPose& pose, Side master, Index face);

  Side master() const { return master_; }
  Index face() const { return face_; }
  bool certified() const { return certified_; }

  /// Whether the line meets the face at q >= 0, ties of the side tests by the shift d v1 + d^2 v2, d -> 0+.
  Meeting meets(Side side, Index face);

  /// Sign of q_a - q_b for two faces that the line meets; ties by the shift. 0 where the shift does not tell either.
  int compare(Side side_a, Index face_a, Side side_b, Index face_b);

  /// A lower bound of the q >= 0 at which the line may be in the box, for all vertices within their rounding boxes;
  /// negative where it surely misses it.
  double begin_of(const Box& box) const;

  /// An upper bound of the q at which the line meets the face's plane, for all vertices within their rounding boxes.
  double farthest(Side side, Index face) const;

 private:
  const LineNumbers<Shifted>& exact();

  const ExactPose& pose_;
  Side master_;
  Index face_;
  EnclosedLine enclosed_;
  Vec3<Interval> C_;
  std::optional<LineNumbers<Shifted>> exact_;
  bool certified_ = true;
};

}  // namespace pcm::reference
