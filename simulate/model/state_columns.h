// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "simulate/scenes/scene.h"

namespace pcm::simulate {

/// A component of a state, as tables name it.
struct StateColumn {
  std::string name;  ///< "arm.angle"; in a body's name `%2C` stands for a comma, and so on for what tables can't hold
  std::string unit;  ///< SI, "1" of a quaternion's parts
};

/// The coordinates of a body's joint and its speeds, each in Simbody's order: of frame K on the body against frame J on
/// the parent, in J.
std::vector<StateColumn> coordinate_columns(const Body& body);
std::vector<StateColumn> speed_columns(const Body& body);

}  // namespace pcm::simulate
