// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace pcm::compare {

/// RFC 4648, section 4: the common alphabet, padded.
std::string base64(std::string_view bytes);

}  // namespace pcm::compare
