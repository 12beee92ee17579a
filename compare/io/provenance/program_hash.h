// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace pcm::compare {

/// SHA-256 of the running program's file, as 64 hexadecimal digits: another build has another one. Shared libraries are
/// not part of it. Read once; some ten milliseconds. Throws BadInput where the system has no /proc.
const std::string& program_hash();

/// The same of a program's file. Throws BadInput where it can't be read.
std::string program_hash_of(const std::filesystem::path& program);

}  // namespace pcm::compare
