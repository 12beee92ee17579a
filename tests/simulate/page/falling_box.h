// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulate/record/recording.h"

namespace pcm::simulate {

inline constexpr double kBoxEdge = 0.4;  // m

/// A red box that falls on a grey plate and bounces, turning about z; 151 frames from 0 to 1.5 s. It slides along x
/// evenly. The motion up and down is a mass on a spring; pressures and some series are invented. Surface 0 is the
/// plate, surface 1 the box, which is E of the only pairing; at the deepest instant the greatest pressure of all lies
/// on `most_pressed`.
Recording falling_box();

/// A point of the box's own frame, as the frame of that index has it in W.
Eigen::Vector3d box_point_W(const Recording& recording, std::size_t frame, const Eigen::Vector3d& point);

struct PressedFace {
  std::size_t frame = 0;
  RecordedElement element;
};
/// The element under the greatest pressure of the run.
PressedFace most_pressed(const Recording& recording);

}  // namespace pcm::simulate
