// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_stability.h"

#include <fmt/core.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/cli/frame/progress_line.h"
#include "compare/cli/verify/kept_folder.h"
#include "compare/io/tables/report_folder.h"
#include "compare/stability/stability_report.h"

namespace pcm::compare {
namespace {

void write_tables(const std::filesystem::path& path, const stability::StabilityReport& report, Extent extent) {
  ReportFolder folder(path, "stability",
                      {{"extent", extent == Extent::quick ? "quick" : "full"},
                       {"seed", report.seed},
                       {"poses_at_each_point", report.poses},
                       {"mode", "E"},
                       {"law", "elastic, c_l = 1 N/m^3"}});
  const Table table = stability_table(report), flatness = flatness_table(report);
  folder.markdown("stability", stability_markdown(report));
  folder.csv("stability", csv(table), {});
  folder.csv("flatness", csv(flatness), {});
  folder.json("stability", {{"verdict", {{"met", report.met()}, {"line", stability_verdict(report)}}},
                            {"flatness", json(flatness)},
                            {"points", json(table)}});
  for (const stability::Sweep sweep : stability::kSweeps)
    folder.picture(stability_picture(sweep), svg(stability_figure(report, sweep)));
  folder.finish();
}

}  // namespace

std::vector<std::string> stability_files() {
  std::vector<std::string> files = {"stability.md", "stability.tex", "stability.csv", "flatness.csv", "stability.json"};
  for (const stability::Sweep sweep : stability::kSweeps) files.push_back(stability_picture(sweep) + ".svg");
  return files;
}

Exit verify_stability(Extent extent, std::uint64_t seed, int jobs, const std::optional<std::filesystem::path>& folder) {
  const ProgressLine progress;
  KeptValues kept = kept_values(folder, "stability", extent);
  const stability::StabilityReport report =
      stability::run_stability(extent, seed, jobs, kept, [&](const std::string& what) { progress.show(what); });
  progress.wipe();
  std::cout << stability_summary(report) << stability_verdict(report) << '\n';
  if (folder) {
    write_tables(*folder, report, extent);
    kept.finish();
  }
  return report.met() ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
