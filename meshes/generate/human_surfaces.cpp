// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/human_surfaces.h"

#include <algorithm>
#include <vector>

#include "meshes/generate/loft.h"

namespace pcm::generate::human {
namespace {

/// How a segment is lofted; the first and the last cross-section are where it ends.
struct Shape {
  LoftAxis axis = LoftAxis::z;
  Index segments = 0;
  Index rings = 0;
  RoundedEnd first, last;
  std::vector<CrossSection> sections;
};

// In the tables: position, centre, half-widths, squareness. Along z the two axes are x (forward) and y (left), along x
// they are y and z.

Shape abdomen_and_pelvis() {
  return {LoftAxis::z,
          36,
          26,
          {0.14, 8},
          {0.03, 3},
          {{-0.330, -0.006, 0, 0.105, 0.130, 0},
           {-kWaistToHip, -0.014, 0, 0.122, 0.172, 0.1},
           {-0.150, -0.010, 0, 0.118, 0.168, 0.1},
           {-0.060, 0.000, 0, 0.108, 0.147, 0.1},
           {0.000, 0.002, 0, 0.104, 0.140, 0.1},
           {0.060, 0.004, 0, 0.102, 0.142, 0.1}}};
}

Shape thorax() {
  return {LoftAxis::z,
          36,
          32,
          {0.03, 3},
          {0.02, 2},
          {{-0.060, 0.002, 0, 0.097, 0.134, 0.1},
           {0.000, 0.003, 0, 0.102, 0.139, 0.1},
           {0.080, 0.002, 0, 0.110, 0.152, 0.2},
           {0.170, 0.000, 0, 0.116, 0.170, 0.3},
           {0.225, -0.006, 0, 0.108, 0.183, 0.3},
           {0.268, -0.010, 0, 0.092, 0.182, 0.2},
           {0.296, -0.012, 0, 0.077, 0.145, 0.1},
           {0.318, -0.014, 0, 0.066, 0.092, 0},
           {0.340, -0.014, 0, 0.059, 0.064, 0},
           {0.380, -0.010, 0, 0.052, 0.052, 0}}};
}

Shape head_and_neck() {
  return {LoftAxis::z,
          36,
          32,
          {0.02, 2},
          {0.10, 10},
          {{-0.030, -0.014, 0, 0.054, 0.054, 0},
           {0.020, -0.008, 0, 0.054, 0.053, 0},
           {0.038, 0.004, 0, 0.065, 0.054, 0},
           {0.058, 0.015, 0, 0.084, 0.060, 0.1},
           {0.100, 0.009, 0, 0.097, 0.073, 0},
           {0.150, 0.001, 0, 0.103, 0.080, 0},
           {0.200, -0.003, 0, 0.104, 0.081, 0},
           {kNeckToCrown, -0.005, 0, 0.100, 0.079, 0}}};
}

Shape upper_arm() {
  return {LoftAxis::z,
          24,
          21,
          {0.035, 4},
          {0.055, 5},
          {{-kUpperArm - 0.034, 0, 0, 0.036, 0.034, 0},
           {-kUpperArm, 0.000, 0, 0.039, 0.036, 0},
           {-0.250, 0.002, 0, 0.042, 0.038, 0},
           {-0.150, 0.005, 0, 0.049, 0.043, 0},
           {-0.070, 0.002, 0, 0.052, 0.049, 0},
           {0.000, -0.003, 0, 0.054, 0.052, 0},
           {0.050, -0.005, 0, 0.052, 0.046, 0}}};
}

Shape forearm() {
  return {LoftAxis::z,
          20,
          23,
          {0.02, 3},
          {0.036, 4},
          {{-kForearm - 0.018, 0.001, 0, 0.028, 0.021, 0},
           {-kForearm, 0.001, 0, 0.030, 0.022, 0},
           {-0.180, 0.003, 0, 0.035, 0.029, 0},
           {-0.080, 0.005, 0, 0.046, 0.040, 0},
           {0.000, 0.000, 0, 0.043, 0.039, 0},
           {0.037, 0.000, 0, 0.039, 0.036, 0}}};
}

/// The palm faces the body; the thumb bulges forward.
Shape hand() {
  return {LoftAxis::z,
          21,
          21,
          {0.03, 5},
          {0.018, 3},
          {{-kHand, 0.002, -0.006, 0.026, 0.011, 0.1},
           {-0.150, 0.004, -0.004, 0.038, 0.014, 0.2},
           {-0.110, 0.007, -0.001, 0.045, 0.017, 0.2},
           {-0.075, 0.012, 0.000, 0.051, 0.019, 0.1},
           {-0.035, 0.006, 0.000, 0.040, 0.020, 0},
           {0.000, 0.001, 0.000, 0.030, 0.021, 0},
           {0.020, 0.001, 0.000, 0.028, 0.020, 0}}};
}

Shape thigh() {
  return {LoftAxis::z,
          28,
          27,
          {0.05, 5},
          {0.08, 6},
          {{-kThigh - 0.050, 0.002, 0, 0.052, 0.049, 0},
           {-kThigh, 0.003, 0, 0.055, 0.051, 0},
           {-0.350, 0.004, 0, 0.060, 0.055, 0},
           {-0.200, 0.007, 0, 0.075, 0.068, 0},
           {-0.080, 0.002, 0, 0.085, 0.078, 0},
           {0.000, -0.004, 0, 0.087, 0.080, 0},
           {0.078, -0.006, 0, 0.080, 0.074, 0}}};
}

Shape shank() {
  return {LoftAxis::z,
          28,
          27,
          {0.034, 4},
          {0.048, 5},
          {{-kShank - 0.034, -0.004, 0, 0.038, 0.034, 0},
           {-kShank, -0.004, 0, 0.039, 0.034, 0},
           {-0.360, -0.006, 0, 0.039, 0.036, 0},
           {-0.250, -0.014, 0, 0.051, 0.047, 0},
           {-0.130, -0.017, 0, 0.062, 0.056, 0},
           {-0.050, -0.004, 0, 0.056, 0.052, 0},
           {0.000, 0.003, 0, 0.056, 0.052, 0},
           {0.048, 0.004, 0, 0.053, 0.049, 0}}};
}

/// The cross-section of a foot at x between the sole and `upper`, m above the ankle's centre.
CrossSection foot_section(double x, double center_y, double upper, double half_width) {
  return {x, center_y, (upper - kAnkleHeight) / 2, half_width, (upper + kAnkleHeight) / 2, 0.4};
}

/// From heel to toe, 0.266 m.
Shape foot() {
  return {LoftAxis::x,
          24,
          24,
          {0.035, 5},
          {0.035, 5},
          {foot_section(-0.066, 0.000, 0.004, 0.030), foot_section(-0.030, 0.000, 0.022, 0.034),
           foot_section(0.000, 0.000, 0.028, 0.036), foot_section(0.035, 0.001, 0.012, 0.038),
           foot_section(0.080, 0.004, -0.018, 0.043), foot_section(0.130, 0.007, -0.036, 0.049),
           foot_section(0.170, 0.004, -0.042, 0.047), foot_section(0.200, 0.000, -0.046, 0.040)}};
}

Shape shape_of(std::string_view name) {
  constexpr std::array<Shape (*)(), kShapes.size()> functions{
      abdomen_and_pelvis, thorax, head_and_neck, upper_arm, forearm, hand, thigh, shank, foot};
  return functions[std::find(kShapes.begin(), kShapes.end(), name) - kShapes.begin()]();
}

}  // namespace

TriangleMesh surface(std::string_view shape_name) {
  const Shape shape = shape_of(shape_name);
  const auto rings = rounded_rings(shape.sections.front().position, shape.sections.back().position, shape.first,
                                   shape.last, shape.rings);
  return loft(shape_name, shape.axis, shape.sections, rings, shape.segments);
}

}  // namespace pcm::generate::human
