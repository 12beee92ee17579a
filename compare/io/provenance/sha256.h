// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// SHA-256 (FIPS 180-4) of the bytes, as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// The same of a file's bytes; none where it can't be read.
std::optional<std::string> sha256_of_file(const std::filesystem::path& file);

/// SHA-256 of a mesh's vertices (as bits, little-endian) and faces: what the poses and answers depend on.
std::string sha256(const TriangleMesh& mesh);

}  // namespace pcm::compare
