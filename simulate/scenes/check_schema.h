// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "simulate/scenes/located_json.h"

namespace pcm::simulate {

/// Throws BadInput for the first thing that a JSON schema (draft 7) forbids, naming file, line and key.
void check_schema(const LocatedJson& json, std::string_view schema);

}  // namespace pcm::simulate
