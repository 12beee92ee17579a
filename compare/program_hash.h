// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace pcm::compare {

/// SHA-256 of the running program's file, as 64 hexadecimal digits: another build has another one. Shared libraries are
/// not part of it. Read once; some ten milliseconds.
const std::string& program_hash();

}  // namespace pcm::compare
