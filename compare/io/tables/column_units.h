// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pcm::compare {

/// Units of a CSV file's columns: of each whose name this is, or ends with it behind a blank or a low line; a number
/// behind a low line at the end of a name does not count. Other columns hold words, counts or ratios.
using ColumnUnits = std::vector<std::pair<std::string, std::string>>;

}  // namespace pcm::compare
