// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/read_scene.h"

namespace pcm::simulate {

// Of the files beside this one (cmake/embed_text.cmake).
std::string_view bubbles_scene();
std::string_view pedestrian_scene();
std::string_view creep_scene();

const std::vector<BuiltInScene>& built_in_scenes() {
  static const std::vector<BuiltInScene> scenes{
      {"bubbles", bubbles_scene()}, {"pedestrian", pedestrian_scene()}, {"creep", creep_scene()}};
  return scenes;
}

}  // namespace pcm::simulate
