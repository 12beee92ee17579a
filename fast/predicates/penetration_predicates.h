// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "fast/base/bounded.h"
#include "pcm/work_counters.h"

/// The exact decisions about a penetration line (PCM section 6, barycentric scheme): which faces it meets, in which
/// direction it passes through them and in which order. Each: floating-point filter, then exact arithmetic, then the
/// shift rule. All finite doubles are welcome; results do not change when all lengths are multiplied by 2^k.
namespace pcm::fast {

/// The three vertices of a face in its own winding, in Me.
using FacePoints = std::array<Eigen::Vector3d, 3>;

/// The penetration line of a master face (p0, p1, p2): from its barycentre C = (p0 + p1 + p2) / 3 along -N,
/// N = (p1 - p0) x (p2 - p0), both taken exactly. The distance along it is measured by q in units of |N|.
class PenetrationLine {
 public:
  PenetrationLine(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1, const Eigen::Vector3d& p2);

  const FacePoints& points() const { return points_; }
  /// N as the filter has it.
  const NumberVector<Bounded>& approximate_normal() const { return normal_; }

 private:
  FacePoints points_;
  NumberVector<Bounded> normal_;
};

/// The sign of N . N_f, N_f = (f1 - f0) x (f2 - f0): -1 where the line leaves the body through f, +1 where it enters, 0
/// where it never meets f. Degree 4.
int facing(const PenetrationLine& line, const FacePoints& f, WorkCounters& work);

/// The side of the line, taken as infinite both ways, that the directed edge from f_i to f_j passes on: the sign of
/// D(C) = N . ((f_i - C) x (f_j - C)). Where D = 0, C is shifted by d (p1 - p0) + d^2 (p2 - p0), d -> 0+: the first
/// non-zero of D, (f_i - f_j) . (N x (p1 - p0)), (f_i - f_j) . (N x (p2 - p0)) decides. Degree 4. Never 0 for an edge
/// of a face with facing != 0.
int side_sign(const PenetrationLine& line, const Eigen::Vector3d& f_i, const Eigen::Vector3d& f_j, WorkCounters& work);

/// Whether the line passes through f: the three edges of f pass on one side of it. Only for faces with facing != 0.
bool passes_through(const PenetrationLine& line, const FacePoints& f, WorkCounters& work);

/// The sign of q_f = -((f0 - C) . N_f) / (N . N_f), the distance from C along the line to the plane of f, before the
/// shift; 0 where C lies in that plane. Degrees 3 and 4. Only for faces with facing != 0.
int distance_sign(const PenetrationLine& line, const FacePoints& f, WorkCounters& work);

/// The order of q_f against q_g: -1 where f comes first, +1 where g does. Ties by the shift's derivative, first along
/// p1 - p0, then along p2 - p0; 0 where they are still tied, as for faces in one plane. Degree 7. Only for faces with
/// facing != 0.
int compare_distance(const PenetrationLine& line, const FacePoints& f, const FacePoints& g, WorkCounters& work);

/// On which side of a face's side k, from its corner k to the next, its penetration lines through x lie: 1 on the
/// face's, 0 on it, -1 beyond, exactly. The sign of N . ((p_k+1 - p_k) x (x - p_k)), degree 4.
int side_of_prism(const FacePoints& master, std::size_t k, const Eigen::Vector3d& x, WorkCounters& work);

}  // namespace pcm::fast
