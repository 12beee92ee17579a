// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "simulate/scenes/read_scene.h"

namespace pcm::simulate {

inline Scene built_in_scene(const std::string& name) {
  for (const BuiltInScene& built_in : built_in_scenes())
    if (built_in.name == name) return parse_scene(std::string(built_in.text), name);
  throw std::out_of_range(name);
}

}  // namespace pcm::simulate
