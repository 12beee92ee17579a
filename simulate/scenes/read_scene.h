// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulate/scenes/scene.h"

namespace pcm::simulate {

/// Reads the text of a scene file (scene.schema.json), its surfaces with it: they are sought beside `file`, which need
/// not exist itself. Throws BadInput, naming
/// file, line and key, for whatever the schema or the sense forbids: unknown or missing keys, a body without mass, a
/// parent that is not named before, a joint with the wrong number of coordinates, a surface that is unfit, a law out of
/// range, a pairing of a surface with one of the same body, a still beyond the end.
Scene parse_scene(const std::string& text, const std::filesystem::path& file);

/// All methods, by the words that scene files call them by.
std::vector<std::pair<std::string, Method>> known_methods();

/// The method that a scene file calls by this word. Throws BadInput, listing the known ones.
Method method_named(const std::string& word);

/// What a scene file makes Jacobians of by this word. Throws BadInput, listing the known ones.
JacobianOf jacobian_named(const std::string& word);

/// The schema itself.
std::string_view scene_schema();

/// Scenes that the program brings along.
struct BuiltInScene {
  std::string_view name, text;
};
const std::vector<BuiltInScene>& built_in_scenes();

}  // namespace pcm::simulate
