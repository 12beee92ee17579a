// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "simulate/stills/image.h"

namespace pcm::simulate {

/// Corners in the camera's frame C (camera.h), m.
using CameraTriangle = std::array<Eigen::Vector3d, 3>;

/// What is hidden by what was drawn before, and what is not.
enum class Hiding : std::uint8_t { by_depth, none };

/// Flat triangles in perspective, by a z-buffer. A pixel is the mean of samples on a grid within it, 3 by 3. No thread,
/// no clock, no chance: the same calls make the same image.
class Canvas {
 public:
  /// What is nearer to the eye than `near`, m, is cut off. `tan_half_height` is that of the camera.
  Canvas(int width, int height, double tan_half_height, double near, const Rgb& background);

  /// Draws both sides. With `by_depth`, whatever is nearer to the eye hides it, drawn before or later; with `none` it
  /// covers all that was drawn before and hides nothing by depth. A triangle without area in the picture is not seen.
  void draw(const CameraTriangle& triangle_C, const Rgb& colour, Hiding hiding);

  Image image() const;

 private:
  /// A corner in the picture: samples from the upper left corner, and one over its depth, 1/m.
  struct Corner {
    double x = 0, y = 0, inverse_depth = 0;
  };
  Corner projected(const Eigen::Vector3d& x_C) const;
  void fill(const Corner& a, const Corner& b, const Corner& c, const Rgb& colour, Hiding hiding);
  void fill_row(int row, const Corner& a, const Corner& b, const Corner& c, const Rgb& colour, Hiding hiding);
  Rgb mean(int x, int y) const;

  int width_, height_;                 ///< pixels
  int columns_, rows_;                 ///< samples
  double scale_;                       ///< samples per unit of x / depth
  double near_;                        ///< m
  std::vector<Rgb> colours_;           ///< by sample
  std::vector<float> inverse_depths_;  ///< by sample; 0: nothing there
};

}  // namespace pcm::simulate
