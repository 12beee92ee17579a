// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/io/tables/table.h"

namespace pcm::simulate {

/// A table, and lines of what is to be said beneath it.
struct NotedTable {
  compare::Table table;
  std::string notes;
};

inline std::string on_screen(const NotedTable& noted) {
  return compare::on_screen(noted.table) + (noted.notes.empty() ? "" : "\n" + noted.notes);
}

inline std::string markdown(const NotedTable& noted) {
  return compare::markdown(noted.table) + (noted.notes.empty() ? "" : "\n" + noted.notes);
}

}  // namespace pcm::simulate
