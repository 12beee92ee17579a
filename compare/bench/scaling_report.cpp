// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>

#include "compare/bench/scaling.h"

namespace pcm::compare {
namespace {

constexpr const char* kScalingLegend =
    "Median over the poses of the least of up to five times after one unmeasured, mode E, one thread. touch, "
    "polygons,\n"
    "force: nothing else wanted; all: everything, barycentric; clipped: everything, clipped. ns/unit: time for\n"
    "everything, barycentric, a crossing or element. x2: how many times as fast two threads are on any cores, by\n"
    "the wall clock, force and clipped.\n";

TableCell microseconds(const ScalingPoint& point, Asked asked) {
  return number_cell(point.us(asked), 3);
}

/// Greatest cost of a crossing or element over the series, in units of the least.
double spread_of_unit_cost(const ScalingSeries& series) {
  double least = series.points.front().unit_cost_ns(), greatest = least;
  for (const ScalingPoint& point : series.points) {
    least = std::min(least, point.unit_cost_ns());
    greatest = std::max(greatest, point.unit_cost_ns());
  }
  return greatest / least;
}

Table table_of(const ScalingSeries& series) {
  Table table{{{"series", "series", false},
               {"faces", "faces"},
               {"overlap, %", "overlap_of_diameter"},
               {"crossings", "crossings"},
               {"elements", "elements"},
               {"box tests", "box_tests"},
               {"touch us", "touch_us"},
               {"polygons us", "polygons_us"},
               {"force us", "force_us"},
               {"all us", "all_us"},
               {"clipped us", "clipped_us"},
               {"ns/unit", "ns_a_unit"},
               {"force x2", "force_gain_of_two_threads"},
               {"clipped x2", "clipped_gain_of_two_threads"}},
              {}};
  for (const ScalingPoint& p : series.points)
    table.rows.push_back({series.name, count_cell(p.faces), TableCell(fmt::format("{:.2g}", 100 * p.depth), p.depth),
                          number_cell(p.crossings, 3), number_cell(p.elements, 3), number_cell(p.box_tests, 3),
                          microseconds(p, Asked::touch), microseconds(p, Asked::polygons),
                          microseconds(p, Asked::force), microseconds(p, Asked::everything),
                          microseconds(p, Asked::clipped_everything), number_cell(p.unit_cost_ns(), 3),
                          number_cell(p.force_gain_of_two, 3), number_cell(p.clipped_gain_of_two, 3)});
  return table;
}

Table without_series(Table table) {
  table.columns.erase(table.columns.begin());
  for (std::vector<TableCell>& row : table.rows) row.erase(row.begin());
  return table;
}

}  // namespace

Table setup_table(const ScalingResult& result) {
  Table table{{{"faces of each surface", "faces"},
               {"setup ms", "setup_ms"},
               {"setup us/face", "setup_us_a_face"},
               {"all faces ms", "rest_ms"},
               {"FCL's tree ms", "fcl_ms"},
               {"setup/FCL's", "setup_over_fcl"},
               {"bytes/face", "bytes_a_face"},
               {"peak MB", "peak_megabytes"}},
              {}};
  for (const SetupResult& s : result.setups)
    table.rows.push_back({count_cell(s.faces), number_cell(s.setup_ms, 3),
                          number_cell(1e3 * s.setup_ms / static_cast<double>(s.faces), 2), number_cell(s.rest_ms, 3),
                          s.fcl_ms > 0 ? number_cell(s.fcl_ms, 3) : empty_cell(),
                          s.fcl_ms > 0 ? number_cell(s.setup_ms / s.fcl_ms, 2) : empty_cell(),
                          s.bytes_a_face > 0 ? number_cell(s.bytes_a_face, 3) : empty_cell(),
                          number_cell(s.peak_megabytes, 3)});
  return table;
}

Table scaling_table(const ScalingResult& result) {
  Table all;
  for (const ScalingSeries& series : result.series) {
    Table table = table_of(series);
    all.columns = table.columns;
    all.rows.insert(all.rows.end(), table.rows.begin(), table.rows.end());
  }
  return all;
}

Table exponents_table(const ScalingResult& result) {
  Table table{{{"exponents of time", "series", false},
               {"over", "over", false},
               {"touch", "touch"},
               {"polygons", "polygons"},
               {"force", "force"},
               {"all", "all"},
               {"clipped", "clipped"},
               {"ns/unit, most/least", "unit_cost_spread"}},
              {}};
  for (const ScalingSeries& series : result.series) {
    if (series.points.size() < 2) continue;
    std::vector<TableCell> row{series.name, series.over};
    for (const Asked asked :
         {Asked::touch, Asked::polygons, Asked::force, Asked::everything, Asked::clipped_everything})
      row.push_back(number_cell(series.exponent(asked), 2));
    row.push_back(number_cell(spread_of_unit_cost(series), 2));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string scaling_screen(const ScalingResult& result, const Machine& machine) {
  std::string text = describe(machine) + '\n' + kScalingLegend;
  for (const ScalingSeries& series : result.series)
    text += fmt::format("\n{}: {}\n{}", series.name, series.explanation, on_screen(without_series(table_of(series))));
  return text + '\n' + on_screen(exponents_table(result)) + '\n' + on_screen(setup_table(result));
}

std::string scaling_markdown(const ScalingResult& result, const Machine& machine) {
  std::string text = fmt::format("# pcm bench scaling\n\n{}\n\n{}", describe(machine), kScalingLegend);
  for (const ScalingSeries& series : result.series)
    text += fmt::format("\n## {}\n\n{}.\n\n{}", series.name, series.explanation,
                        markdown(without_series(table_of(series))));
  return text + "\n## Exponents\n\n" + markdown(exponents_table(result)) +
         "\n## Setup and memory\n\n`setup`: of one surface; `all faces`: what waits until a contact first asks for a "
         "face, "
         "were it computed for all of them at once; `FCL's tree`: its OBBRSS for the same surface; `bytes/face`: what "
         "a "
         "prepared surface holds, its mesh included; `peak MB`: resident, two surfaces of that size and their "
         "workspace.\n\n" +
         markdown(setup_table(result));
}

}  // namespace pcm::compare
