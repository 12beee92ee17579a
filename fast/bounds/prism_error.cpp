// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/prism_error.h"

#include <algorithm>
#include <cmath>

#include "fast/posed/vertex_rounding.h"
#include "fast/predicates/orientation.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;

/// Roundings of a scalar product with a difference of points: the difference, the products, two sums.
constexpr double kProductRoundings = 4;

/// What g . (x - p) may be off by as it is computed (running error analysis): each difference and product is off by u
/// times itself, and so is each sum, in whichever order they are taken.
double roundings_of_product(const Eigen::Vector3d& g, const Eigen::Vector3d& x, const Eigen::Vector3d& p) {
  const double a = g[0] * (x[0] - p[0]), b = g[1] * (x[1] - p[1]), c = g[2] * (x[2] - p[2]);
  return u * (2 * (std::abs(a) + std::abs(b) + std::abs(c)) + std::max(std::abs(a + b), std::abs(b + c)) +
              std::abs(a + b + c)) +
         0x1p-1070;
}

/// What is rounded off in turn in `residual`, times u^2 and the sum of the terms. Of each of the three summands, what
/// its difference and its product round off are u times the product, what the sum does u times that of all; these take
/// up to 5, 4 and 3 roundings, the last one 1 less each, on their way into `off`: 5 + 4 of the products and 3 + 3 + 2,
/// and 1 for those of the sum of the terms.
constexpr double kResidualRoundings = 18;

/// A bound on |g . (p - q) - c|, sharp where the terms cancel: what the operations round off is taken along (Ogita,
/// Rump and Oishi 2005), so that only what is rounded off in turn counts.
double residual(const Eigen::Vector3d& g, const Eigen::Vector3d& p, const Eigen::Vector3d& q, double c) {
  double sum = -c, off = 0, size = std::abs(c);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double d = p[i] - q[i], product = g[i] * d, next = sum + product;
    off += g[i] * rounded_off(p[i], -q[i], d) + std::fma(g[i], d, -product) + rounded_off(sum, product, next);
    size += std::abs(product);
    sum = next;
  }
  return std::abs(sum + off) * (1 + 2 * u) + kResidualRoundings * u * u * size + 0x1p-1070;
}

/// Roundings of what a tilt does to a function (tilt_of). The scalar products of the gradients have 3 each, of their
/// lengths' product, the products with the function's slopes 1 and the sum 1: 5 of G . g_s, 5 of G . g_t, and of the
/// sum of both 6 of either. Each of these three is part of what is summed: 11. Those of that sum are within
/// kSecondOrder.
constexpr double kTiltRoundings = 11;

/// Terms of second order in the position errors, which are less than 2^-6 wherever they are used.
constexpr double kSecondOrder = 1.04;

}  // namespace

// Frame. Let x' = sum lambda_k p'_k - d' n' be a point of the exact problem. With g the computed gradient of weight w,
// j the corner it is measured from, where w = 0, and p_k the corners of the rounded problem,
//     M_w(x') - lambda_w = sum lambda_k (g . (p_k - p_j) - delta_kw) + g . sum lambda_k (p'_k - p_k) - d' g . n'.
// The first bracket is computed. The second is a displacement of a vertex
// of F. In the last, n' is off the rounded problem's normal n by - sum h_k g_k, h_k the displacement of corner k along
// n, so that its product is no more than h sum |g . g_k|; and |g . n| is computed as well, n being off by 4 u q + 9 u,
// where |N| q is N with every term taken absolutely. Depth: N . (p_k - p_0) is computed; d' (1 - n . n') <= d' |n' -
// n|^2, and |N| and its inverse have 8 roundings.
PrismError::PrismError(const MasterPrism& prism, const FaceError& face, Side master,
                       const Eigen::Vector3d& own_rounding_Me, const Eigen::Vector3d& rounding_Me)
    : prism_(prism),
      g_s_Me_(prism.inward_Me(2)),
      g_t_Me_(prism.inward_Me(0)),
      n_Me_(prism.face().n_Me),
      own_rounding_Me_(own_rounding_Me),
      ss_(g_s_Me_.squaredNorm()),
      st_(g_s_Me_.dot(g_t_Me_)),
      tt_(g_t_Me_.squaredNorm()),
      length_s_(prism.edge_s_Me().norm()),
      length_t_(prism.edge_t_Me().norm()),
      own_moves_(master == Side::F) {
  const Eigen::Vector3d& a_Me = prism.edge_s_Me();
  const Eigen::Vector3d& b_Me = prism.edge_t_Me();
  const Eigen::Vector3d& g_0_Me = prism.inward_Me(1);
  const Eigen::Vector3d a = a_Me.cwiseAbs(), b = b_Me.cwiseAbs(), n = n_Me_.cwiseAbs();
  const Eigen::Vector3d g_s = g_s_Me_.cwiseAbs(), g_t = g_t_Me_.cwiseAbs(), g_0 = g_0_Me.cwiseAbs();
  const double N_terms = a[1] * b[2] + a[2] * b[1] + a[2] * b[0] + a[0] * b[2] + a[0] * b[1] + a[1] * b[0];
  const double q = N_terms / (2 * prism.face().area);
  gradient_s_ = kSecondOrder * std::sqrt(ss_);
  gradient_t_ = kSecondOrder * std::sqrt(tt_);
  any_displacement_ = displacement(rounding_Me);
  const PrismPositionError displaced = displacement(own_rounding_Me);
  height_ = displaced.depth;
  // A product N . (x - p0) has 4 roundings, its quotient by |N| three more. Where it is small (kExactHeight), it is
  // taken exactly and may differ by the 4 u q of N; not where it is more than that part of q, by more than roundings.
  exact_depth_rounding_ = 4 * q * u;
  exact_depth_ = (1 + 0x1p-20) * kExactHeight * q;

  constexpr double k = kProductRoundings * u;
  const auto& p = prism.face().points_Me;
  const Eigen::Vector3d& N_Me = prism.face().N_Me;
  // s is measured from p2, t from p0; heights over the face are divided by |N|.
  const double s_0 = residual(g_s_Me_, p[0], p[2], 0), s_1 = residual(g_s_Me_, p[1], p[2], 1);
  const double t_1 = residual(g_t_Me_, p[1], p[0], 0), t_2 = residual(g_t_Me_, p[2], p[0], 1);
  const double n_1 = residual(N_Me, p[1], p[0], 0), n_2 = residual(N_Me, p[2], p[0], 0);
  frame_rounding_ = {kSecondOrder * std::max(s_0, s_1), kSecondOrder * std::max(t_1, t_2),
                     kSecondOrder * std::max(n_1, n_2) / (2 * prism.face().area)};
  const double n_rounding = (4 * q + 9) * u;
  tilt_rounding_ = {kSecondOrder * (std::abs(g_s_Me_.dot(n_Me_)) + k * g_s.dot(n) + gradient_s_ * n_rounding),
                    kSecondOrder * (std::abs(g_t_Me_.dot(n_Me_)) + k * g_t.dot(n) + gradient_t_ * n_rounding),
                    face.normal * face.normal + 8 * u};
  frame_ = frame_rounding_;
  tilt_ = tilt_rounding_;
  if (own_moves_) {
    frame_.s += displaced.s;
    frame_.t += displaced.t;
    frame_.depth += displaced.depth;
    tilt_.s += tilt_of({1, 0, 0});
    tilt_.t += tilt_of({0, 1, 0});
  }
  // At p1 the weights are off by what s and t are there; from there on their sum changes with the gradients' sum.
  const Eigen::Vector3d sum = (g_s_Me_ + g_t_Me_ + g_0_Me).cwiseAbs() + 2 * u * (g_s + g_t + g_0);
  third_weight_ = frame_rounding_.s + frame_rounding_.t + kSecondOrder * sum.dot(a + b);
  third_weight_tilt_ = kSecondOrder * sum.dot(n);
}

PrismRounding PrismError::rounding(const std::array<Eigen::Vector3d, 3>& points_Me,
                                   const std::array<PrismPoint, 3>& corners, const std::array<bool, 3>& shared) const {
  const FaceGeometry& face = prism_.face();
  const auto& p = face.points_Me;
  PrismRounding greatest;
  for (std::size_t k = 0; k < 3; ++k) {
    if (shared[k]) {
      greatest.s = std::max(greatest.s, frame_rounding_.s);
      greatest.t = std::max(greatest.t, frame_rounding_.t);
      greatest.depth = std::max(greatest.depth, frame_rounding_.depth);
      continue;
    }
    const Eigen::Vector3d& x = points_Me[k];
    greatest.s = std::max(greatest.s, roundings_of_product(g_s_Me_, x, p[2]));
    greatest.t = std::max(greatest.t, roundings_of_product(g_t_Me_, x, p[0]));
    greatest.third = std::max(greatest.third, roundings_of_product(prism_.inward_Me(1), x, p[1]));
    const double depth = std::abs(corners[k][kDepth]);
    double height_off = roundings_of_product(face.N_Me, x, p[0]) / (2 * face.area);
    const double square = (x - p[0]).squaredNorm();
    // Filters take what may have underflown exactly, too.
    const double underflown = 4 * kExactHeight * kFilterUnderflow * (1 + (x - p[0]).lpNorm<1>());
    if (depth * depth < exact_depth_ * exact_depth_ * square || 2 * face.area * depth <= underflown)
      height_off += exact_depth_rounding_ * std::sqrt(square);
    greatest.depth = std::max(greatest.depth, kSecondOrder * height_off + 4 * u * depth);
  }
  greatest.s *= kSecondOrder;
  greatest.t *= kSecondOrder;
  greatest.third *= kSecondOrder;
  return greatest;
}

// No point is farther from another corner than from p0 by more than the side between them.
PrismPositionError PrismError::greatest_rounding(double distance) const {
  constexpr double k = kProductRoundings * u;
  const double farther = kSafetyFactor * (distance + std::max(length_s_, length_t_));
  return {k * gradient_s_ * farther, k * gradient_t_ * farther,
          (kSecondOrder * (k + exact_depth_rounding_) + 4 * u) * farther};
}

PrismPositionError PrismError::displacement(const Eigen::Vector3d& rounding_Me) const {
  return {kSecondOrder * g_s_Me_.cwiseAbs().dot(rounding_Me), kSecondOrder * g_t_Me_.cwiseAbs().dot(rounding_Me),
          kSecondOrder * n_Me_.cwiseAbs().dot(rounding_Me)};
}

PrismPositionError PrismError::of_vertices(const PrismRounding& rounding, const Eigen::Vector3d& rounding_Me) const {
  const PrismPositionError displaced = displacement(rounding_Me);
  return {displaced.s + rounding.s, displaced.t + rounding.t, displaced.depth + rounding.depth};
}

PrismPositionError PrismError::of_any_vertices(const PrismPositionError& rounding, bool of_master) const {
  // Of both surfaces one is F's.
  const double moves = of_master == own_moves_ ? 1 : 0;
  return {moves * any_displacement_.s + rounding.s, moves * any_displacement_.t + rounding.t,
          moves * any_displacement_.depth + rounding.depth};
}

Eigen::Vector3d PrismError::of_point_in_master() const {
  const Eigen::Vector3d edges = prism_.edge_s_Me().cwiseAbs() + prism_.edge_t_Me().cwiseAbs();
  return own_rounding_Me_ + kSafetyFactor * kUnitRoundoff * (prism_.p0_Me().cwiseAbs() + 6 * edges);
}

PrismPositionError PrismError::of_frame(double depth) const {
  return {frame_.s + tilt_.s * depth, frame_.t + tilt_.t * depth, frame_.depth + tilt_.depth * depth};
}

// With G = per_s g_s + per_t g_t and g_0 = -(g_s + g_t): h (|G . g_0| + |G . g_s| + |G . g_t|).
double PrismError::tilt_of(const PrismFunction& f) const {
  const double G_s = f.per_s * ss_ + f.per_t * st_, G_t = f.per_s * st_ + f.per_t * tt_;
  // By lengths: g_s . g_t may cancel.
  const double lengths = std::sqrt(ss_ * tt_);
  const double size_s = std::abs(f.per_s) * ss_ + std::abs(f.per_t) * lengths;
  const double size_t = std::abs(f.per_s) * lengths + std::abs(f.per_t) * tt_;
  return kSecondOrder * height_ *
         (std::abs(G_s) + std::abs(G_t) + std::abs(G_s + G_t) + kTiltRoundings * u * (size_s + size_t));
}

double PrismError::of_function(const PrismFunction& f, double depth, const PrismRounding& rounding,
                               const Eigen::Vector3d& rounding_Me) const {
  // Vertices are moved in space, so the function changes by its gradient's product with that; likewise the frame.
  const Eigen::Vector3d gradient_Me = f.per_s * g_s_Me_ + f.per_t * g_t_Me_ - f.per_depth * n_Me_;
  double off = kSecondOrder * gradient_Me.cwiseAbs().dot(rounding_Me + own_rounding_Me_);
  if (own_moves_) off += depth * tilt_of(f);
  return off + std::abs(f.per_s) * (rounding.s + frame_rounding_.s + tilt_rounding_.s * depth) +
         std::abs(f.per_t) * (rounding.t + frame_rounding_.t + tilt_rounding_.t * depth) +
         std::abs(f.per_depth) * (rounding.depth + frame_rounding_.depth + tilt_rounding_.depth * depth);
}

double PrismError::of_third_weight(double depth, const PrismRounding& rounding) const {
  return rounding.s + rounding.t + rounding.third + third_weight_ + third_weight_tilt_ * depth;
}

}  // namespace pcm::fast
