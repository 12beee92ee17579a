// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "pcm/triangle_mesh.h"

/// The shapes of the man's segments (human.h), and the lengths that shapes and joints share.
namespace pcm::generate::human {

/// Lengths, m: by Drillis and Contini's fractions of 1.75 m.
constexpr double kThigh = 0.429;
constexpr double kShank = 0.430;
constexpr double kAnkleHeight = 0.068;
constexpr double kUpperArm = 0.326;
constexpr double kForearm = 0.256;
constexpr double kHand = 0.189;
/// Lengths, m: assumed, so that he looks well and is 1.75 m tall.
constexpr double kWaistToHip = 0.223;   ///< T12-L1 to greater trochanter, in height
constexpr double kWaistToNeck = 0.340;  ///< T12-L1 to C7-T1
constexpr double kNeckToCrown = 0.260;
constexpr double kWaistToShoulder = 0.255;
constexpr double kHalfHipWidth = 0.090;  ///< from the median plane to the joint's centre
constexpr double kHalfShoulderWidth = 0.170;

/// Names of the segments with a surface of their own, those of the left for both.
constexpr std::array<std::string_view, 9> kShapes{
    "abdomen_and_pelvis", "thorax", "head_and_neck", "upper_arm", "forearm", "hand", "thigh", "shank", "foot"};

/// The surface of one of kShapes, that of the left side.
TriangleMesh surface(std::string_view shape);

}  // namespace pcm::generate::human
