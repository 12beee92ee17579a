// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/cli/verify/verify_run.h"
#include "compare/io/report_folder.h"
#include "compare/verify/run/kept_run.h"
#include "compare/verify/run/run_identity.h"
#include "compare/verify/run/run_verdict.h"
#include "compare/verify/run/verify.h"
#include "compare/verify/tables/summary.h"
#include "compare/verify/tables/verification_table.h"
#include "compare/verify/tables/verification_widths.h"
#include "meshes/files/text_file.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

void write_cases(const fs::path& folder, const Verification& run) {
  fast::Workspace workspace;
  const Wanted everything;
  for (const Finding& finding : run.findings()) {
    const Cell& cell = run.cells()[finding.cell];
    Case posed;
    try {
      posed = run.as_case(finding);
    } catch (const std::exception& error) {
      complain(run.poses().pose_name(cell, finding.pose) +
               ": no case file, for the pose can't be drawn: " + error.what());
      continue;
    }
    const HeldPairing& held = run.poses().held_pairing(cell, finding.pose);
    nlohmann::ordered_json engine, oracle;
    try {
      const fast::Pairing pairing(held.engine().surface_E(), held.engine().surface_F(), posed.law, posed.mode,
                                  posed.scheme);
      engine = decided(fast::evaluate(pairing, posed.pose, posed.velocity, everything, workspace));
      reference::Inquiry inquiry(held.oracle(), posed.pose, posed.velocity, everything, posed.law, posed.scheme);
      oracle = decided(inquiry.answer(reference::Problem::rounded, posed.mode));
    } catch (const std::exception&) {
      // The disagreement itself says which side failed, and how.
    }
    std::string file = "case_" + run.poses().pose_name(cell, finding.pose) + ".json";
    for (char& c : file)
      if (c == '/' || c == ' ') c = '_';
    write_text_file(folder / file, format_case(posed, finding.disagreements, engine, oracle));
  }
}

void write_tables(const fs::path& folder, const Verification& run, const ProgramProvenance& program) {
  write_cases(folder, run);
  nlohmann::ordered_json question = question_of(run.plan());
  question["complete"] = run.finished();
  ReportFolder report(folder, "verification", std::move(question), program);
  report.csv("widths", widths_csv(run), widths_units());
  report.csv("verification", verification_csv(run), verification_units());
  report.json("verification", verification_json(run));
  report.markdown("times", times_markdown(run));
  report.markdown("verification",
                  verification_markdown(run) + "\n" + widths_markdown(run) + "\n" + verdict_line(run) + "\n");
  report.finish();
}

Exit verify_poses(const VerifyOptions& options) {
  const int jobs = number_of_jobs(options);
  std::vector<std::string> notices;
  VerificationPlan plan = options.trajectory ? plan_from_trajectory(options, notices) : plan_from(options, notices);
  const std::optional<fs::path> folder = prepared_folder(options);
  std::optional<Interruptible> work(std::in_place, plan.poses);
  Verification run(std::move(plan));
  for (const std::string& notice : notices) complain(notice);
  Resumption kept;
  if (folder) kept = resume_run(*folder, run);
  if (!kept.notice.empty()) complain(kept.notice);
  const nlohmann::ordered_json program = kept.finished_at ? kept.finished_by : provenance_json(this_program());
  while (!run.finished() && !work->interrupted()) {
    run.run_batch(
        jobs, [&] { return work->interrupted(); }, [&](std::int64_t done) { work->show(done); });
    if (folder) keep_run(*folder, run, program);
  }
  work.reset();
  std::cout << verification_summary(run) << '\n';
  for (std::size_t k = 0; k < std::min<std::size_t>(run.findings().size(), 20); ++k) {
    const Finding& finding = run.findings()[k];
    for (const Disagreement& d : finding.disagreements)
      std::cout << fmt::format("{}: {}: {}\n", run.poses().pose_name(run.cells()[finding.cell], finding.pose),
                               name(d.kind), d.text);
  }
  if (kept.finished_at)
    std::cout << fmt::format(
        "These tables and this verdict are those of an earlier run of the same build and surfaces, finished {}.\n"
        "Nothing was evaluated now.\n",
        *kept.finished_at);
  std::cout << verdict_line(run);
  if (kept.finished_at)
    std::cout << fmt::format(" (an earlier run's, finished {}; nothing evaluated now)", *kept.finished_at);
  std::cout << '\n';
  // Of a run that an earlier call finished, too: who knows what became of its files.
  if (folder) write_tables(*folder, run, program_from(program));
  return is_verified(run) ? Exit::success : Exit::negative;
}

Exit replay(const std::string& file) {
  const Case posed = read_case(file);
  const HeldPairing held(posed.E, posed.F, posed.law, posed.mode, posed.scheme);
  fast::Workspace workspace;
  const PoseOutcome outcome = held.hold(posed.pose, posed.velocity, workspace).front();
  std::cout << posed.origin << '\n';
  for (const Disagreement& d : outcome.disagreements) std::cout << name(d.kind) << ": " << d.text << '\n';
  const bool agrees = outcome.disagreements.empty();
  std::cout << fmt::format("{}: 1 pose, {} touching, {} disagreements\n", agrees ? "verified" : "NOT verified",
                           outcome.touching ? 1 : 0, agrees ? 0 : 1);
  return agrees ? Exit::success : Exit::negative;
}

}  // namespace

Exit verify(const VerifyOptions& options) {
  return options.case_file ? replay(*options.case_file) : verify_poses(options);
}

}  // namespace pcm::compare
