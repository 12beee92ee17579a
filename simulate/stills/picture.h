// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/record/recording.h"
#include "simulate/stills/camera.h"
#include "simulate/stills/image.h"

namespace pcm::simulate {

inline constexpr int kStillWidth = 1200, kStillHeight = 900;  // pixels

/// What the pictures of a run share, as on its page: the view, which shows every frame whole, and scales.
struct RunView {
  int width = 0, height = 0;  ///< pixels
  Camera camera;
  double size = 1;               ///< the diagonal of what all frames fill, m
  double greatest_pressure = 0;  ///< Pa: the upper end of the colour bar; 0 where nothing ever touches
  double metres_per_newton = 0;  ///< of arrows: the greatest force's is a fifth of `size`
};

RunView view_of(const Recording& recording, int width = kStillWidth, int height = kStillHeight);

/// A frame as the page shows it: surfaces, over them the faces that carry elements, coloured by pressure and seen
/// through bodies, over them forces as arrows.
Image picture(const Recording& recording, const Frame& frame, const RunView& view);

}  // namespace pcm::simulate
