// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/hard_poses/search.h"
#include "compare/io/tables/table.h"

namespace pcm::compare {

/// A row a goal and scheme: how hard climbs began and ended.
Table search_table(const SearchReport& report);

/// The hardest states of each goal and scheme, so many at most, the hardest first.
std::vector<const Climbed*> hardest_climbs(const SearchReport& report, std::size_t most);

/// A row a state: of hardest_climbs.
Table hardest_table(const std::vector<const Climbed*>& hardest);

/// For a screen of 120 columns: the table with its legend, and what disagrees.
std::string search_summary(const SearchReport& report);
std::string search_markdown(const SearchReport& report, const std::vector<const Climbed*>& hardest);

/// The last line printed.
std::string search_verdict(const SearchReport& report);

}  // namespace pcm::compare
