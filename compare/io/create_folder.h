// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <system_error>

#include "pcm/bad_input.h"

namespace pcm::compare {

/// With those above it, where they are missing. Throws BadInput where that can't be.
inline void create_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw BadInput(folder.string() + ": can't be created: " + error.message());
}

}  // namespace pcm::compare
