// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pcm::compare {

/// The commit that this program was built from, twelve hexadecimal digits, "-dirty" behind them where files differed
/// from it; "unknown" where it was not built from a git repository (cmake/commit.cmake).
const char* commit();

}  // namespace pcm::compare
