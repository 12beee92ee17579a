// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace pcm::reference {

/// Which pairs of faces get an exact look: those whose boxes meet, or all, to show that this leaves nothing out.
enum class CandidateRegion : std::uint8_t { near, everywhere };

}  // namespace pcm::reference
