// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "fast/force/element_motion.h"
#include "fast/simd/elements.h"
#include "pcm/contact.h"

namespace pcm::fast {

/// The derivatives of one master's force (23) and torque (24), element by element.
///
/// F moves by dr and turns by a about Mf: its points by d(x) = dr + a x (x - r). Seen from the master, whose area,
/// normal and foot then stay, the slave's face moves by +d (master E) or -d (master F), and u_k (11) grows by g . d(X)
/// or -g . d(X), X being the point that the penetration line meets, g = N_f / (n_k . N_f). The element moves along n_k
/// by s du (13), s the shift. With the lever l = C_k - r and the slopes of the law,
///
///     dF = a g . d(X) + K (dv + dw x l),          a = dF/du +- s K (w x n_k),
///     dM = b g . d(X) + l x K (dv + dw x l),      b = +- s n_k x F + l x a,
///
/// F and M being those on E, K = dF/dv_k: n_k p^T + t q^T + (F_t / v_t) I with the direction of slip t. Summed are
///
///     by position a g^T, b g^T;  by rotation a (X - r x g)^T, b (X - r x g)^T;
///     by velocity K, [l x] K;    by lever K [l x], [l x] K [l x].
///
/// Clipped scheme: what a master face sees of the slave's face changes its outline too, so that its area A, its mean
/// depth u and the centre of pressure p0 + s (p1 - p0) + t (p2 - p0) change, each by a slope g . dr + h . a that is
/// given (ElementMotion) for a slave that moves by +d. Summed are by position c g^T, c' g^T; by rotation c h^T, c' h^T,
/// with
///
///     c of A: +-F / A;   of u: a;   of s: +-K (w x (p1 - p0)), of t with p2;
///     c' of A: l x c;    of u: b;   of s: +-(p1 - p0) x F + l x c, of t with p2.
///
/// What F's own motion adds is known of the sums. Master E: l loses dr, so velocities lose w x dr and the torque
/// dr x F. Master F: all turns with F, so F and M turn by a, and v and w, seen from F, by -a.
class TangentSum {
 public:
  /// Elements whose forces are in the lanes.
  void add(const ElementLanes& lanes, const ForceLimits& limits, LaneBits which);
  /// How the element of a lane moves, before it is added: in the clipped scheme, and there of all elements.
  void set_motion(std::size_t lane, const ElementMotion& motion);
  /// Force and torque are those of these elements together.
  Tangent total(const ForceLimits& limits, const Eigen::Vector3d& force_Me, const Eigen::Vector3d& torque_Me) const;

 private:
  TangentLanes lanes_;
  ElementMotionLanes motions_;
  bool are_parts_ = false;
};

}  // namespace pcm::fast
