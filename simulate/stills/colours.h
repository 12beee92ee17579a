// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "simulate/stills/image.h"

/// The page's colours and light (page/scene.js); tests hold both to each other.
namespace pcm::simulate {

inline constexpr Rgb kBackgroundColour{0xf3, 0xf5, 0xf7};
inline constexpr Rgb kArrowColour{0xc2, 0x00, 0x6b};

/// Viridis: lightness grows evenly, and it reads the same for the colour-blind.
inline constexpr std::array<Rgb, 10> kColourStops{{{0x44, 0x01, 0x54},
                                                   {0x48, 0x28, 0x78},
                                                   {0x3e, 0x49, 0x89},
                                                   {0x31, 0x68, 0x8e},
                                                   {0x26, 0x82, 0x8e},
                                                   {0x1f, 0x9e, 0x89},
                                                   {0x35, 0xb7, 0x79},
                                                   {0x6e, 0xce, 0x58},
                                                   {0xb5, 0xde, 0x2b},
                                                   {0xfd, 0xe7, 0x25}}};

/// The colour of a fraction of the colour bar; of its ends below 0 and above 1.
Rgb bar_colour(double fraction);

/// A face of this colour under a pale sky and a lamp over the viewer's left shoulder. Both in the camera's frame C, of
/// length 1: the face's normal on the side that is seen, and what is upwards in the world.
Rgb lit(const Rgb& colour, const Eigen::Vector3d& normal_C, const Eigen::Vector3d& up_C);

}  // namespace pcm::simulate
