// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/cli/frame/launcher.h"
#include "compare/cli/verify/verify_run.h"
#include "compare/io/tables/report_folder.h"
#include "compare/verify/run/held_again.h"
#include "compare/verify/run/kept_run.h"
#include "compare/verify/run/run_chunks.h"
#include "compare/verify/run/run_identity.h"
#include "compare/verify/run/run_verdict.h"
#include "compare/verify/run/verify.h"
#include "compare/verify/tables/overview.h"
#include "compare/verify/tables/summary.h"
#include "compare/verify/tables/verification_table.h"
#include "compare/verify/tables/verification_widths.h"
#include "compare/verify/verdict/case_file.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

/// In place of those that an interrupted call has left.
void write_cases(const fs::path& folder, const Verification& run) {
  remove_case_files(folder);
  fast::Workspace workspace;
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
    write_text_file(folder / case_file_name(run.poses().pose_name(cell, finding.pose)),
                    case_file_text(held, posed, workspace));
  }
}

void write_tables(const fs::path& folder, const Verification& run, const ProgramProvenance& program,
                  const std::string& why_unfinished) {
  remove_unfinished_tables(folder);
  write_cases(folder, run);
  nlohmann::ordered_json question = question_of(run.plan());
  question["complete"] = run.finished();
  ReportFolder report(folder, "verification", std::move(question), program);
  report.csv("widths", widths_csv(run), widths_units());
  report.csv("verification", verification_csv(run), verification_units());
  report.json("verification", verification_json(run));
  report.csv("overview", csv(overview_table(run)), overview_units());
  report.markdown("overview", overview_markdown(run, verdict_line(run, why_unfinished)));
  report.markdown("times", times_markdown(run));
  report.markdown("verification", verification_markdown(run) + "\n" + widths_markdown(run) + "\n" +
                                      verdict_line(run, why_unfinished) + "\n");
  report.finish();
}

void print_run(const Verification& run) {
  std::cout << verification_summary(run) << '\n';
  for (std::size_t k = 0; k < std::min<std::size_t>(run.findings().size(), 20); ++k) {
    const Finding& finding = run.findings()[k];
    for (const Disagreement& d : finding.disagreements)
      std::cout << fmt::format("{}: {}: {}\n", run.poses().pose_name(run.cells()[finding.cell], finding.pose),
                               name(d.kind), d.text);
  }
}

/// Until all that the folder is for is done, here or by others, or this process is interrupted.
void run_kept(const Verification& run, KeptRun& kept, int jobs) {
  const Interruptible work(run.poses_in_all());
  const auto stop = [&] { return work.interrupted(); };
  kept.share_in([&] { run_chunks(run, kept, jobs, stop, [&](std::int64_t done) { work.show(done); }); }, stop);
}

/// A run of this process alone, kept nowhere.
Exit verify_here(Verification& run, int jobs) {
  {
    const Interruptible work(run.poses_in_all());
    run_all(
        run, jobs, [&] { return work.interrupted(); }, [&](std::int64_t done) { work.show(done); });
  }
  print_run(run);
  std::cout << verdict_line(run) << '\n';
  return is_verified(run) ? Exit::success : Exit::negative;
}

/// What a run that is not finished lacks.
std::string why_unfinished(const JobPart& part, bool part_is_done) {
  if (!part_is_done) return "interrupted";
  return part == kNoPart ? "parts are missing" : fmt::format("part {} of {}", part.number, part.of);
}

/// One that was begun in vain, so that the folder is free for another one.
void remove_campaign(const fs::path& folder) {
  std::error_code ignored;
  for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(folder / (kCampaignFile + std::string(suffix)), ignored);
  fs::remove(folder, ignored);  // where nothing else is in it
}

/// One of several processes that were launched together speaks for all: the one that finishes the run, or else the
/// first. Whoever was started apart speaks for itself.
Exit verify_kept(Verification& run, const VerifyOptions& options, const fs::path& folder,
                 const LaunchedProcess& process, int jobs) {
  const JobPart part = part_of(options);
  const bool is_new = !fs::exists(folder / kCampaignFile);
  std::optional<KeptRun> keeping(std::in_place, folder, run, part);
  KeptRun& kept = *keeping;
  if (!kept.notice().empty()) complain(kept.notice());
  try {
    if (!options.merge.empty()) kept.merge({options.merge.begin(), options.merge.end()});
  } catch (...) {
    keeping.reset();
    if (is_new) remove_campaign(folder);
    throw;
  }
  const std::optional<KeptRun::Finished> before = kept.finished();
  if (const double done = kept.done(); process.rank == 0 && done > 0 && !kept.part_done())
    complain(fmt::format("--out {}: continued, {:.0f} % are done", folder.string(), std::floor(100 * done)));

  run_kept(run, kept, jobs);
  const Publishing alone = kept.publish();
  const bool all_done = kept.all_done(), part_is_done = kept.part_done();
  run.add(kept.outcomes());
  if (all_done && !run.finished()) throw_damaged(folder / kCampaignFile);
  const std::optional<KeptRun::Finished> finished = kept.finished();
  const bool is_a_part = part.of > 1 && part_is_done;
  const Exit status = (is_a_part ? run.total().disagreeing == 0 : is_verified(run)) ? Exit::success : Exit::negative;
  if (is_silent(process, all_done, finished ? std::optional(finished->launch) : std::nullopt)) return Exit::success;

  print_run(run);
  if (before)
    std::cout << fmt::format(
        "These tables and this verdict are those of an earlier run of the same build and surfaces, finished {}.\n"
        "Nothing was evaluated now.\n",
        before->at);
  const std::string why = why_unfinished(part, part_is_done);
  if (is_a_part)
    std::cout << fmt::format("{}: {} poses, {} touching, {} disagreements", why, run.poses_done(), touching_poses(run),
                             run.total().disagreeing);
  else
    std::cout << verdict_line(run, why);
  if (before) std::cout << fmt::format(" (an earlier run's, finished {}; nothing evaluated now)", before->at);
  std::cout << '\n';
  // Of a run that an earlier call finished, too: who knows what became of its files.
  const nlohmann::ordered_json program = finished ? finished->by : provenance_json(this_program());
  write_tables(folder, run, program_from(program), why);
  if (all_done && !finished) kept.finish(program, process.launch);
  return status;
}

Exit verify_poses(const VerifyOptions& options) {
  const LaunchedProcess process = launched_process();
  const int jobs = number_of_jobs(options);
  if (process.processes > 1 && !options.out)
    throw BadInput(fmt::format("one of {} processes started together: they want --out DIR, a folder that they share",
                               process.processes));
  std::vector<std::string> notices;
  VerificationPlan plan = options.trajectory ? plan_from_trajectory(options, notices) : plan_from(options, notices);
  const std::optional<fs::path> folder = prepared_folder(options);
  Verification run(std::move(plan));
  if (process.rank == 0)
    for (const std::string& notice : notices) complain(notice);
  return folder ? verify_kept(run, options, *folder, process, jobs) : verify_here(run, jobs);
}

Exit replay(const std::string& file) {
  const Case posed = read_case(file);
  const PoseOutcome outcome = held_again(posed);
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
