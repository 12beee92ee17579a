// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/canvas.h"

#include <algorithm>
#include <cmath>

namespace pcm::simulate {
namespace {

constexpr int kSamples = 3;  // along an edge of a pixel

std::size_t product(int a, int b) {
  return static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

/// What lies at least `near` before the eye of a triangle: nothing, a triangle or a quadrangle.
std::vector<Eigen::Vector3d> clipped(const CameraTriangle& triangle_C, double near) {
  std::vector<Eigen::Vector3d> kept;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d& a = triangle_C[i];
    const Eigen::Vector3d& b = triangle_C[(i + 1) % 3];
    const double beyond_a = -a.z() - near, beyond_b = -b.z() - near;
    if (beyond_a >= 0) kept.push_back(a);
    if ((beyond_a >= 0) != (beyond_b >= 0)) kept.emplace_back(a + beyond_a / (beyond_a - beyond_b) * (b - a));
  }
  return kept;
}

/// The first sample whose middle is at `x` or beyond it, of `count` of them.
int sample_from(double x, int count) {
  return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(count)));
}

}  // namespace

Canvas::Canvas(int width, int height, double tan_half_height, double near, const Rgb& background)
    : width_(width),
      height_(height),
      columns_(kSamples * width),
      rows_(kSamples * height),
      scale_(rows_ / (2 * tan_half_height)),
      near_(near),
      colours_(product(columns_, rows_), background),
      inverse_depths_(colours_.size(), 0) {}

Canvas::Corner Canvas::projected(const Eigen::Vector3d& x_C) const {
  const double inverse_depth = -1 / x_C.z();
  return {columns_ / 2.0 + scale_ * x_C.x() * inverse_depth, rows_ / 2.0 - scale_ * x_C.y() * inverse_depth,
          inverse_depth};
}

void Canvas::draw(const CameraTriangle& triangle_C, const Rgb& colour, Hiding hiding) {
  const std::vector<Eigen::Vector3d> corners = clipped(triangle_C, near_);
  for (std::size_t i = 2; i < corners.size(); ++i)
    fill(projected(corners[0]), projected(corners[i - 1]), projected(corners[i]), colour, hiding);
}

void Canvas::fill(const Corner& a, const Corner& b, const Corner& c, const Rgb& colour, Hiding hiding) {
  const int first = sample_from(std::min({a.y, b.y, c.y}), rows_);
  const int end = sample_from(std::max({a.y, b.y, c.y}) + 1, rows_);
  for (int row = first; row < end; ++row) fill_row(row, a, b, c, colour, hiding);
}

// A sample on an edge that two triangles share is in at least one of them: the products on either side of the edge are
// the same numbers with the opposite sign.
void Canvas::fill_row(int row, const Corner& a, const Corner& b, const Corner& c, const Rgb& colour, Hiding hiding) {
  const double y = row + 0.5;
  const auto twice_area = [y](const Corner& p, const Corner& q, double x) {
    return (p.x - x) * (q.y - y) - (p.y - y) * (q.x - x);
  };
  const double whole = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (whole == 0) return;
  const int end = sample_from(std::max({a.x, b.x, c.x}) + 1, columns_);
  for (int column = sample_from(std::min({a.x, b.x, c.x}), columns_); column < end; ++column) {
    const double x = column + 0.5;
    const double of_a = twice_area(b, c, x) / whole, of_b = twice_area(c, a, x) / whole,
                 of_c = twice_area(a, b, x) / whole;
    if (!(of_a >= 0 && of_b >= 0 && of_c >= 0)) continue;
    const std::size_t sample = product(row, columns_) + static_cast<std::size_t>(column);
    if (hiding == Hiding::by_depth) {
      // One over the depth is linear in the picture.
      const auto inverse_depth =
          static_cast<float>(of_a * a.inverse_depth + of_b * b.inverse_depth + of_c * c.inverse_depth);
      if (!(inverse_depth > inverse_depths_[sample])) continue;
      inverse_depths_[sample] = inverse_depth;
    }
    colours_[sample] = colour;
  }
}

Rgb Canvas::mean(int x, int y) const {
  std::array<int, 3> sum{};
  for (int row = kSamples * y; row < kSamples * (y + 1); ++row)
    for (int column = kSamples * x; column < kSamples * (x + 1); ++column)
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += colours_[product(row, columns_) + static_cast<std::size_t>(column)][k];
  constexpr int kCount = kSamples * kSamples;
  Rgb colour;
  for (std::size_t k = 0; k < 3; ++k) colour[k] = static_cast<std::uint8_t>((sum[k] + kCount / 2) / kCount);
  return colour;
}

Image Canvas::image() const {
  Image image{width_, height_, {}};
  image.pixels.reserve(product(width_, height_));
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) image.pixels.push_back(mean(x, y));
  return image;
}

}  // namespace pcm::simulate
