// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "compare/bench/skip.h"

namespace pcm::compare {
namespace {

std::string sentences(const SkipResult& result) {
  return fmt::format(
      "{} bubbles of 950 faces jostle in an open container, {} steps of {:g} s on a prescribed motion: {} pairings, "
      "{:.0f} "
      "of them\ntouching. Each setting takes its turn at every step; {} answers of pairings compared bit for bit with "
      "those of "
      "the\nfirst line: {} different. A pairing whose boxes are apart costs {:.1f} ns, one with a valid certificate "
      "{:.1f} ns.\n",
      result.bubbles, result.steps, result.step_s, result.pairings, result.touching, result.answers_compared,
      result.answers_different, result.boxes_ns, result.certificate_ns);
}

constexpr const char* kSavingsLegend =
    "Each thing skipped, in a scene made for it. Median over the poses of the least of up to five times, one thread;\n"
    "the oracle is asked once a pose.\n";

}  // namespace

Table scenes_table(const SkipResult& result) {
  Table table{{{"setting", "setting", false},
               {"step us", "median_us"},
               {"mean us", "mean_us"},
               {"ratio", "ratio"},
               {"by boxes", "apart_by_boxes"},
               {"by certificate", "apart_by_certificate"},
               {"evaluated", "evaluated"},
               {"sought", "certificates_sought"},
               {"signs", "predicates"},
               {"exact signs", "exact_predicates"},
               {"vertices", "vertices_transformed"}},
              {}};
  for (const SceneResult& s : result.scenes)
    table.rows.push_back(
        {s.setting, number_cell(s.median_us, 3), number_cell(s.mean_us, 3),
         number_cell(s.median_us / result.scenes.front().median_us, 2), number_cell(s.apart_by_boxes, 3),
         number_cell(s.apart_by_certificate, 3), number_cell(s.evaluated, 3), number_cell(s.certificates_sought, 2),
         number_cell(s.predicates, 3), number_cell(s.exact_predicates, 3), number_cell(s.vertices_transformed, 3)});
  return table;
}

Table savings_table(const SkipResult& result) {
  Table table{{{"skipped", "saving", false},
               {"in", "scene", false},
               {"on us", "on_us"},
               {"off us", "off_us"},
               {"saved %", "saved"},
               {"counted", "counted", false},
               {"on", "work_on"},
               {"off", "work_off"}},
              {}};
  for (const SavingResult& s : result.savings) {
    const double saved = 1 - s.on_us / s.off_us;
    table.rows.push_back({s.saving, s.scene, number_cell(s.on_us, 3), number_cell(s.off_us, 3),
                          TableCell(fmt::format("{:.0f}", 100 * saved), saved), s.counted, count_cell(s.work_on),
                          count_cell(s.work_off)});
  }
  return table;
}

std::string skip_screen(const SkipResult& result, const Machine& machine) {
  return describe(machine) + '\n' + sentences(result) + '\n' + on_screen(scenes_table(result)) + '\n' + kSavingsLegend +
         '\n' + on_screen(savings_table(result));
}

std::string skip_markdown(const SkipResult& result, const Machine& machine) {
  return fmt::format("# pcm bench skip\n\n{}\n\n{}\n{}\n{}\n{}", describe(machine), sentences(result),
                     markdown(scenes_table(result)), kSavingsLegend, markdown(savings_table(result)));
}

}  // namespace pcm::compare
