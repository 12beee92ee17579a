// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/prism_error.h"

#include "fast/vertex_rounding.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;

/// Roundings of a vertex's s and t, times |gradient| |x - p0|: a difference, a scalar product of three terms.
constexpr double kVertexRoundings = 5;

/// Terms of second order in the shifts, which are less than 2^-6 wherever they are used.
constexpr double kSecondOrder = 1.125;

}  // namespace

// Frame. Let x' = sum lambda_k p'_k - d' n' be a point of the exact problem. With g the computed gradient of weight w,
// j a corner where w = 0, and p_k the corners of the rounded problem,
//     M_w(x') - lambda_w = sum lambda_k (g . (p_k - p_j) - delta_kw) + g . sum
//     lambda_k (p'_k - p_k) - d' g . n'.
// g = (n x side) / |N| with 8 roundings at most, so g . (p_k - p_j) is off by 8 u |g| L, L the longest edge, and for
// the corner opposite the side by the relative error of N besides, 4 u q, where |N| q is N with every term taken
// absolutely; and 12 u for n, |N| and their quotient. |g . n'| <= |g| (|n' - n| + 12 u). Depth: with the computed N, N
// . (p_k - p_0) is off 0 by 4 u q |N| L; and d' (1 - n . n') <= d' (|n' - n|^2 + 8 u).
PrismError::PrismError(const MasterPrism& prism, const FaceError& face, Side master, const Eigen::Vector3d& rounding_Me)
    : length_s_(prism.edge_s_Me().norm()), length_t_(prism.edge_t_Me().norm()), own_moves_(master == Side::F) {
  const Eigen::Vector3d a = prism.edge_s_Me().cwiseAbs(), b = prism.edge_t_Me().cwiseAbs();
  const double N_terms = a[1] * b[2] + a[2] * b[1] + a[2] * b[0] + a[0] * b[2] + a[0] * b[1] + a[1] * b[0];
  const double q = N_terms / (2 * prism.face().area);
  longest_ = length_s_ + length_t_;
  const Eigen::Vector3d g_s = prism.inward_Me(2).cwiseAbs(), g_t = prism.inward_Me(0).cwiseAbs();
  gradient_s_ = kSecondOrder * g_s.norm();
  gradient_t_ = kSecondOrder * g_t.norm();
  moved_ = {kSecondOrder * g_s.dot(rounding_Me), kSecondOrder * g_t.dot(rounding_Me),
            kSecondOrder * prism.face().n_Me.cwiseAbs().dot(rounding_Me)};
  // A product N . (x - p0) has 4 roundings, its quotient by |N| three more. Where its sign is not sure, it is taken
  // exactly and may differ by the 4 u q of N; not where it is more than 9 u q.
  depth_noise_ = 8 * u;
  exact_depth_noise_ = 4 * q * u;
  exact_depth_ = 16 * q * u;
  frame_ = {(8 * q + 12) * u + 8 * u * gradient_s_ * longest_, (8 * q + 12) * u + 8 * u * gradient_t_ * longest_,
            8 * u * q * longest_};
  if (own_moves_) {
    frame_.s += moved_.s;
    frame_.t += moved_.t;
    frame_.depth += moved_.depth;
  }
  tilt_s_ = gradient_s_ * (face.normal + 12 * u);
  tilt_t_ = gradient_t_ * (face.normal + 12 * u);
  tilt_depth_ = face.normal * face.normal + 8 * u;
}

PrismShift PrismError::of_vertices(double distance, double least_depth, bool own) const {
  // Of both surfaces one is F's.
  const double moves = own == own_moves_ ? 1 : 0;
  // A weight is measured from another corner than p0, where it is 0.
  const double noise = kVertexRoundings * u * (distance + longest_);
  const double depth_noise = depth_noise_ + (least_depth < exact_depth_ * distance ? exact_depth_noise_ : 0);
  return {moves * moved_.s + noise * gradient_s_, moves * moved_.t + noise * gradient_t_,
          moves * moved_.depth + depth_noise * distance};
}

PrismShift PrismError::of_frame(double depth) const {
  return {frame_.s + tilt_s_ * depth, frame_.t + tilt_t_ * depth, frame_.depth + tilt_depth_ * depth};
}

}  // namespace pcm::fast
