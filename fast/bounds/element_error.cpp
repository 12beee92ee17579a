// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/element_error.h"

#include <cmath>
#include <limits>

#include "fast/base/depth.h"
#include "fast/posed/vertex_rounding.h"
#include "fast/prism/ray.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;

}  // namespace

// With a = p1 - p0, b = p2 - p0: a term of N = a x b carries 4 roundings (two differences, product, sum). Vertices off
// by d move a and b by up to 2 d, so N by 2 d x (|a| + |b|) + (2 d) x (2 d), all products taken absolutely.
// The unit vectors of N and N' differ by at most 2 |N' - N| / (|N'| + |N|) (Dunkl and Williams 1964), that of N by 5 u
// more for length and division. Of N 2^-1070 m^2 is what underflow may add; other products that underflow count for
// nothing above kLeastProduct.
FaceError::FaceError(const FaceGeometry& face, const Eigen::Vector3d& rounding_Me) {
  const auto& p = face.points_Me;
  const Eigen::Vector3d a = (p[1] - p[0]).cwiseAbs(), b = (p[2] - p[0]).cwiseAbs();
  const Eigen::Vector3d C = face.barycentre_Me();
  N = (4 * u * cross_of_magnitudes(a, b) + 2 * cross_of_magnitudes(rounding_Me, a + b + 2 * rounding_Me)).sum();
  N = kSafetyFactor * N + 0x1p-1070;
  area = 0.5 * N + 3 * u * face.area;
  barycentre_Me = kSafetyFactor * (u * (C.cwiseAbs() + a + b) + rounding_Me);
  const double length_N = 2 * face.area;
  normal_known = length_N > 2 * N && face.area > kLeastProduct;
  normal = normal_known ? kSafetyFactor * (N / (length_N - N) + 5 * u) : 2;
}

// Let unprimed quantities be those of the rounded problem, primed ones the exact problem's, and let the exact line meet
// the exact f at X' = C' - u' n'. X' is a mean of the corners of f' with weights that are not negative; the same mean
// of the corners of f is a point Y of its plane, off X' by at most the vertices' rounding. From (Y - c) . N_f = 0 at
// any corner c:
//     u' (n' . N_f) = -(c - C) . N_f + (C' - C) . N_f - (X' - Y) . N_f.
// One of both surfaces is E, so the last two terms together are at most |N_f| . d, d the rounding of F's vertices. So
// the depth is off by (|height error| + |N_f| . d + u |slope error|) / (|slope| - |slope error|), where the slope's
// error includes n' - n.
double depth_error(const FaceGeometry& master, const FaceError& master_error, const FacePoints& f,
                   const Eigen::Vector3d& rounding_Me) {
  const DepthBelow depth(master, f);
  const auto& p = master.points_Me;
  const Eigen::Vector3d N_f = depth.N_f.cwiseAbs(), from_C = depth.from_C.cwiseAbs();
  const Eigen::Vector3d N_f_error = 4 * u * cross_of_magnitudes((f[1] - f[0]).cwiseAbs(), (f[2] - f[0]).cwiseAbs());
  // corner - C: three differences, two sums, a division.
  const Eigen::Vector3d from_C_error =
      (4 * u / 3) *
      ((depth.corner - p[0]).cwiseAbs() + (depth.corner - p[1]).cwiseAbs() + (depth.corner - p[2]).cwiseAbs());
  // Each scalar product rounds every term three times; 2^-1070 is what underflow may add.
  const double height_error =
      from_C_error.dot(N_f + N_f_error) + from_C.dot(N_f_error) + 3 * u * from_C.dot(N_f) + 0x1p-1070;
  const Eigen::Vector3d n = master.n_Me.cwiseAbs();
  const double slope_error =
      kSafetyFactor * (master_error.normal * (N_f + N_f_error).sum() + n.dot(N_f_error) + 3 * u * n.dot(N_f));
  const double slope = std::abs(depth.slope);
  if (!(slope > 2 * slope_error && slope > kLeastProduct)) return std::numeric_limits<double>::infinity();
  const double value = depth.value();
  const double by_vertices = rounding_Me.dot(N_f + N_f_error);
  return kSafetyFactor * ((height_error + by_vertices + value * slope_error) / (slope - slope_error) + 2 * u * value);
}

}  // namespace pcm::fast
