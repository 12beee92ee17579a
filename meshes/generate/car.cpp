// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/car.h"

#include <vector>

#include "meshes/generate/loft.h"

namespace pcm::generate {
namespace {

constexpr Index kSegments = 20;
constexpr Index kRings = 31;
static_assert(2 * kSegments * kRings == 1240);

/// The outlines at one place along the car, m: in side view the lower and the upper one, in plan the half-width.
CrossSection section(double x, double lower, double upper, double half_width) {
  constexpr double kSquareness = 0.8;
  return {x, 0, (lower + upper) / 2, half_width, (upper - lower) / 2, kSquareness};
}

std::vector<CrossSection> sections() {
  return {section(0.00, 0.25, 0.55, 0.72), section(0.15, 0.22, 0.75, 0.80), section(0.60, 0.22, 0.87, 0.86),
          section(1.10, 0.22, 0.94, 0.87), section(1.15, 0.22, 0.95, 0.87), section(1.24, 0.22, 1.00, 0.87),
          section(1.85, 0.22, 1.37, 0.87), section(1.95, 0.22, 1.42, 0.87), section(2.10, 0.22, 1.44, 0.87),
          section(2.60, 0.22, 1.45, 0.87), section(3.10, 0.22, 1.42, 0.87), section(3.20, 0.22, 1.40, 0.87),
          section(3.30, 0.22, 1.36, 0.87), section(3.82, 0.22, 1.08, 0.86), section(3.90, 0.22, 1.05, 0.86),
          section(4.25, 0.23, 1.01, 0.83), section(4.40, 0.28, 0.95, 0.76)};
}

/// Both ends are blunt; in between the rings are closest about the corners of the upper outline.
std::vector<LoftRing> rings() {
  std::vector<LoftRing> rings{{0.004, 0.45}, {0.02, 0.80}, {0.06, 0.95}, {0.15, 1}};
  const auto add = [&rings](double to, Index steps) {
    const double from = rings.back().position;
    for (Index i = 1; i <= steps; ++i) rings.push_back({from + (to - from) * (static_cast<double>(i) / steps), 1});
  };
  add(1.10, 5);
  add(1.24, 1);
  add(1.85, 4);
  add(1.95, 1);
  add(2.10, 1);
  add(3.10, 4);
  add(3.30, 2);
  add(3.82, 3);
  add(3.95, 1);
  add(4.25, 2);
  rings.push_back({4.34, 0.97});
  rings.push_back({4.38, 0.82});
  rings.push_back({4.396, 0.45});
  return rings;
}

/// Factor on y at the height z: the sides lean inwards above the waistline.
double lean(double z) {
  constexpr double kWaistline = 0.85;
  return z > kWaistline ? 1 - 0.40 * (z - kWaistline) : 1.0;
}

}  // namespace

TriangleMesh car() {
  TriangleMesh mesh = loft("car", LoftAxis::x, sections(), rings(), kSegments);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.y() *= lean(vertex.z());
  return mesh;
}

}  // namespace pcm::generate
