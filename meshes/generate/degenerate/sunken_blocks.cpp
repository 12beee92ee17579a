// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/degenerate/sunken_blocks.h"

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"

namespace pcm::degenerate {
namespace {

/// Of the grid, in metres.
struct Rectangle {
  int x_min, y_min, x_max, y_max;

  Eigen::Vector2d low() const { return {x_min, y_min}; }
  Eigen::Vector2d high() const { return {x_max, y_max}; }
  bool touches(const Rectangle& other) const {
    return other.x_min <= x_max && x_min <= other.x_max && other.y_min <= y_max && y_min <= other.y_max;
  }
};

/// The same numbers on every machine, which distributions of the standard library are not.
class Draw {
 public:
  explicit Draw(std::uint64_t number) : random_(static_cast<std::mt19937::result_type>(number)) {}

  int between(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<std::mt19937::result_type>(high - low + 1));
  }
  /// Apart from those. Of the 81 lowest corners three rectangles leave six at least.
  Rectangle rectangle(const std::vector<Rectangle>& taken) {
    for (;;) {
      const int x = between(-5, 3), y = between(-5, 3);
      const int x_max = x + between(1, 2), y_max = y + between(1, 2);
      const Rectangle drawn{x, y, x_max, y_max};
      const auto touches = [&](const Rectangle& other) { return drawn.touches(other); };
      if (std::none_of(taken.begin(), taken.end(), touches)) return drawn;
    }
  }

 private:
  std::mt19937 random_;
};

}  // namespace

TriangleMesh leaning_block(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double height, double far,
                           double factor) {
  TriangleMesh mesh =
      generate::box({low.x(), low.y(), std::min(height, far)}, {high.x(), high.y(), std::max(height, far)});
  const Eigen::Vector2d middle = 0.5 * (low + high);
  for (Eigen::Vector3d& x : mesh.vertices)
    if (x.z() == far) x.head<2>() = middle + Eigen::Vector2d(factor, 0.875 * factor).cwiseProduct(x.head<2>() - middle);
  return mesh;
}

std::array<TriangleMesh, 2> sunken_blocks(std::uint64_t number) {
  Draw draw(number);
  TriangleMesh plate = generate::box({-16, -17, -5}, {16, 16, 0});
  TriangleMesh body = leaning_block({-6, -6}, {6, 6}, -1, 4, 1.25);
  std::vector<Rectangle> taken;
  for (int i = 0; i < 4; ++i) {
    const Rectangle place = draw.rectangle(taken);
    taken.push_back(place);
    const double depth = draw.between(1, 7) / 8.0;
    if (draw.between(0, 2) == 0) {
      plate = joined(std::move(plate), leaning_block(place.low(), place.high(), -depth, -8, 0.75));
    } else {
      body = joined(std::move(body), leaning_block(place.low(), place.high(), -depth, 6, 0.5));
    }
  }
  plate.name = "plate " + std::to_string(number) + " for sunken blocks";
  body.name = "sunken blocks " + std::to_string(number);
  return {std::move(plate), std::move(body)};
}

}  // namespace pcm::degenerate
