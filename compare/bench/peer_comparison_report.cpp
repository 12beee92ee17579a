// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "compare/bench/peer_comparison.h"

namespace pcm::compare {
namespace {

std::string name(Distance distance) {
  return distance == Distance::touching ? "touching" : "separated";
}

std::string protocol(const std::vector<PeerComparison>& results) {
  return fmt::format(
      "{} fresh poses a body, one after the other, as a simulation asks: in each pass everybody in turn asks each\n"
      "pose once; medians over the poses of the median over up to five passes. `again`: the same pose several times\n"
      "running, the least of up to five after one unmeasured. One thread. Ratios of medians over fresh poses to the\n"
      "whole barycentric evaluation; in none of these times is setting up, nor what must happen before each query\n"
      "(moving the second mesh for CGAL, refitting its tree for Embree).\n",
      results.front().peers.front().timings.size());
}

std::string title(const PeerComparison& result) {
  return fmt::format("{}, {} faces each, {}", result.body, result.faces, name(result.distance));
}

TableCell microseconds(double us) {
  return number_cell(us, 3);
}

std::vector<TableCell> row(const PeerComparison& result, const PeerResult& peer) {
  const PeerEntry& entry = peer.entry;
  std::vector<TableCell> cells{result.body, name(result.distance), entry.who};
  if (peer.timings.empty()) {
    cells.emplace_back("not in this build: " + entry.debian_package);
    while (cells.size() < 13) cells.push_back(empty_cell());
    return cells;
  }
  const double preparation = peer.median_preparation_us();
  const auto ratio_to = [&](std::size_t ours) {
    return number_cell(peer.median_us() / result.peers[ours].median_us(), 3);
  };
  cells.emplace_back(entry.computes);
  cells.push_back(microseconds(peer.median_us()));
  cells.push_back(microseconds(peer.p95_us()));
  cells.push_back(microseconds(peer.median_repeated_us()));
  // Less than the clock can tell is none.
  cells.push_back(preparation < 0.5 ? empty_cell() : microseconds(preparation));
  cells.push_back(ratio_to(0));
  cells.push_back(ratio_to(1));
  cells.push_back({fmt::format("{:.1f}", peer.found), peer.found});
  cells.emplace_back(entry.finds);
  cells.push_back(number_cell(peer.setup_ms, 3));
  return cells;
}

Table table_of(const PeerComparison& result) {
  Table table{{{"body", "body", false},
               {"poses", "poses", false},
               {"who", "who", false},
               {"computes", "computes", false},
               {"median us", "median_us"},
               {"p95 us", "p95_us"},
               {"again us", "repeated_us"},
               {"before us", "preparation_us"},
               {"to all", "ratio_to_all"},
               {"to force", "ratio_to_force"},
               {"found", "found"},
               {"of what", "finds", false},
               {"setup ms", "setup_ms"}},
              {}};
  for (const PeerResult& peer : result.peers) table.rows.push_back(row(result, peer));
  return table;
}

/// For people, who read body and poses above the table.
Table without_body(Table table) {
  table.columns.erase(table.columns.begin(), table.columns.begin() + 2);
  for (std::vector<TableCell>& cells : table.rows) cells.erase(cells.begin(), cells.begin() + 2);
  return table;
}

/// Bodies side by side at one distance.
Table side_by_side(const std::vector<PeerComparison>& results, Distance distance) {
  Table table{{{name(distance), "who", false}, {"computes", "computes", false}}, {}};
  for (const PeerComparison& result : results) {
    if (result.distance != distance) continue;
    table.columns.insert(table.columns.end(), {{fmt::format("{} us", result.body), "median_us"},
                                               {"again", "repeated_us"},
                                               {"ratio", "ratio_to_all"},
                                               {"found", "found"}});
    table.rows.resize(result.peers.size());
    for (std::size_t c = 0; c < table.rows.size(); ++c) {
      const std::vector<TableCell> all = row(result, result.peers[c]);
      std::vector<TableCell>& cells = table.rows[c];
      if (cells.empty()) cells = {all[2], all[3]};
      cells.insert(cells.end(), {all[4], all[6], all[8], all[10]});
    }
  }
  return table;
}

}  // namespace

Table peers_table(const std::vector<PeerComparison>& results) {
  Table all;
  for (const PeerComparison& result : results) {
    Table table = table_of(result);
    all.columns = table.columns;
    all.rows.insert(all.rows.end(), table.rows.begin(), table.rows.end());
  }
  return all;
}

std::string peers_screen(const std::vector<PeerComparison>& results, const Machine& machine) {
  return fmt::format(
      "{}\n{}found: intersecting triangle pairs (segments of polygons); 2023: elements; ODE: contact points; Simbody: "
      "faces with springs;\ncorefinement: faces of the solid. Means over the poses.\n\n{}\n{}",
      describe(machine), protocol(results), on_screen(side_by_side(results, Distance::touching)),
      on_screen(side_by_side(results, Distance::separated)));
}

std::string peers_markdown(const std::vector<PeerComparison>& results, const Machine& machine) {
  std::string text = fmt::format(
      "# pcm bench peers\n\n{}\n\n{}\n`before us`: median time of what must happen before each query. `to all`, `to "
      "force`: ratio of medians to everything and to force and torque of the barycentric engine. `found`: mean over "
      "the poses. `setup ms`: of both surfaces; what is left to the first queries (of this engine: what faces have "
      "near them of their own surface) is in none of the times.\n",
      describe(machine), protocol(results));
  for (const PeerComparison& result : results)
    text += fmt::format("\n## {}\n\n{}", title(result), markdown(without_body(table_of(result))));
  return text;
}

}  // namespace pcm::compare
