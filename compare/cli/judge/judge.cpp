// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/judge/judge.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/campaign/run_chunks.h"
#include "compare/cli/frame/launcher.h"
#include "compare/cli/frame/output_files.h"
#include "compare/cli/frame/programs.h"
#include "compare/cli/judge/publish_judgement.h"
#include "compare/cli/verify/verify_run.h"
#include "compare/io/provenance/program_hash.h"
#include "compare/io/provenance/sha256.h"
#include "compare/io/tables/report_folder.h"
#include "compare/judge/engines/replies.h"
#include "compare/judge/judgement/judged_cases.h"
#include "compare/judge/judgement/judging_report.h"
#include "compare/judge/judgement/kept_judgement.h"
#include "compare/judge/lines/schemas.h"
#include "compare/judge/poses/poses_folder.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

struct JudgeOptions {
  std::optional<std::string> answers, command, poses, schema;
  std::string time_limit = "10";
  std::string ulps = "8";
  std::vector<std::string> tolerances, absolutes;
  bool shared = false;
  VerifyOptions frame;  ///< --jobs and --out, as for `pcm verify`
};

/// 8 ulps of single precision.
constexpr std::uint64_t kMostUlps = std::uint64_t{8} << 29;

/// Few at first, so that another convention is noticed before every pose has been looked at twice.
constexpr std::size_t kFirstBatch = 64;
constexpr std::size_t kBatch = 1024;

std::shared_ptr<AskedEngine> engine_of_command(const JudgeOptions& options, const PosedQuestions& posed,
                                               std::function<bool()> stop) {
  const Conversation::Seconds limit(positive_number("--time-limit", options.time_limit));
  return std::make_shared<AskedEngine>(*options.command, posed, *options.poses, limit, std::move(stop));
}

/// Judges all that comes. What is wrong with the input ends it; what came before is judged. Returns that complaint;
/// empty where all was well.
std::string judge_all(Judging& run, const ReplySource& source, int jobs, const Interruptible& work) {
  std::string complaint;
  bool more = true;
  for (std::size_t batch = kFirstBatch; more && !work.interrupted(); batch = kBatch) {
    std::vector<Reply> replies;
    try {
      while (replies.size() < batch && !work.interrupted() && more) {
        std::optional<Reply> reply = source.next();
        more = reply.has_value();
        if (reply) replies.push_back(std::move(*reply));
      }
    } catch (const BadInput& error) {
      complaint = error.what();
      more = false;
    }
    run.add(
        std::move(replies), jobs, [&] { return work.interrupted(); }, [&](std::int64_t done) { work.show(done); });
    const Conventions::Found other = run.conventions().found();
    if (!other.text.empty()) return source.place(other.line) + ": " + other.text;
  }
  return complaint.empty() && !work.interrupted() ? source.missing() : complaint;
}

/// Poses a chunk of a judgement that is shared.
constexpr std::size_t kChunk = 8;

/// Judges what nobody else is at until all is judged, by whomever, or this process is interrupted.
void judge_shared(const Judging& run, KeptJudgement& kept, const ReplyTo& reply_to, int jobs,
                  const Interruptible& work) {
  const std::size_t all = run.judge().posed().questions.size();
  std::atomic<std::int64_t> done = 0;
  const auto judge_chunk = [&](std::int64_t chunk) -> std::optional<Judged> {
    Judged judged;
    const std::size_t first = static_cast<std::size_t>(chunk) * kChunk;
    for (std::size_t k = first; k < std::min(all, first + kChunk); ++k) {
      std::optional<Reply> reply = work.interrupted() ? std::nullopt : reply_to(k);
      if (work.interrupted()) return std::nullopt;
      if (reply) judged.merge(run.judge_one(std::move(*reply)));
      work.show(++done);
    }
    return judged;
  };
  const auto stop = [&] { return work.interrupted(); };
  kept.share_in([&] { run_chunks<Judged>(kept, jobs, stop, [&]() -> DoChunk<Judged> { return judge_chunk; }); }, stop);
}

/// Success is an answer at least that could be judged, and none wrong.
Exit exit_status(const Judging& run, bool finished) {
  const JudgedTally total = run.total();
  return finished && total.wrong == 0 && total.judged() > 0 ? Exit::success : Exit::negative;
}

/// What a judgement that others share in is of.
Json identity_of(const JudgeOptions& options, const JudgingSetup& setup) {
  return {{"format", "pcm judgement 1"},
          {"build", program_hash()},
          {"answers", options.answers ? "file" : *options.command},
          {"answers_sha256", setup.answers_sha256},
          {"poses_sha256", setup.poses_sha256},
          {"tolerances", setup.tolerances},
          {"near_ulps", setup.near_ulps}};
}

/// What stopped it; empty where nothing did.
std::string ended_by(const std::string& complaint, bool interrupted) {
  return !complaint.empty() ? complaint : interrupted ? "interrupted" : "";
}

Exit judge_with_others(Judging& run, const JudgeOptions& options, const JudgingSetup& setup, const fs::path& folder,
                       int jobs) {
  const PosedQuestions& posed = run.judge().posed();
  const LaunchedProcess process = launched_process();
  std::string complaint;
  std::optional<Interruptible> work;
  const auto stop = [&work] { return work && work->interrupted(); };
  const ReplyTo reply_to = options.answers ? replies_of_file(*options.answers, posed, complaint)
                                           : replies_of_engine(engine_of_command(options, posed, stop));
  const auto chunks = static_cast<std::int64_t>((posed.questions.size() + kChunk - 1) / kChunk);
  KeptJudgement kept(folder, identity_of(options, setup), chunks, posed);
  work.emplace(std::ssize(posed.questions));
  judge_shared(run, kept, reply_to, jobs, *work);
  const bool interrupted = work->interrupted();
  work.reset();
  const Publishing alone = kept.publish();
  const bool done = kept.all_done();
  run.add(kept.judged());
  if (const Conventions::Found other = run.conventions().found(); complaint.empty() && !other.text.empty())
    complaint =
        (options.answers ? fmt::format("{}:{}", *options.answers, other.line) : "--command") + ": " + other.text;
  const std::optional<std::string> finished_by = kept.finished_by();
  if (is_silent(process, done, finished_by)) return Exit::success;
  publish_judgement(run, setup, folder, ended_by(complaint, interrupted && !done));
  if (done && !finished_by) kept.finish(process.launch);
  if (!complaint.empty()) throw BadInput(complaint);
  return exit_status(run, done);
}

Exit judge_alone(Judging& run, const JudgeOptions& options, const JudgingSetup& setup,
                 const std::optional<fs::path>& folder, int jobs) {
  const PosedQuestions& posed = run.judge().posed();
  std::optional<Interruptible> work;
  const auto stop = [&work] { return work && work->interrupted(); };
  const ReplySource source = options.answers ? source_of_file(*options.answers, posed)
                                             : source_of_engine(engine_of_command(options, posed, stop), posed);
  work.emplace(std::ssize(posed.questions));
  const std::string complaint = judge_all(run, source, jobs, *work);
  const bool interrupted = work->interrupted();
  work.reset();
  publish_judgement(run, setup, folder, ended_by(complaint, interrupted));
  if (!complaint.empty()) throw BadInput(complaint);
  return exit_status(run, !interrupted);
}

/// Throws BadInput where the folder has files of others under the names of tables, the answers themselves even. Those
/// who share in a judgement may come while its tables are being written.
void refuse_to_overwrite(const JudgeOptions& options, const fs::path& folder) {
  for (const char* file : kJudgementFiles)
    if (options.answers && is_same_file(*options.answers, folder / file))
      throw BadInput(*options.answers + ": the tables would take its place; choose another folder for --out");
  const bool with_others = options.shared && fs::exists(folder / kCampaignFile);
  if (!with_others) refuse_files_of_others(folder, kJudgementReport, {kJudgementFiles.begin(), kJudgementFiles.end()});
}

Exit judge(const JudgeOptions& options) {
  if (options.schema) {
    std::cout << (*options.schema == "poses" ? pose_schema() : answer_schema());
    return Exit::success;
  }
  if (!options.poses) throw BadInput("--poses is missing; give the folder that 'pcm poses' has written");
  if (options.answers.has_value() == options.command.has_value())
    throw BadInput("give either a file of answers or --command");
  if (options.shared && !options.frame.out) throw BadInput("--shared wants --out DIR");
  if (!options.shared && launched_process().processes > 1)
    throw BadInput("one of several processes started together: they want --shared and --out DIR");
  const int jobs = number_of_jobs(options.frame);
  Tolerances tolerances;
  tolerances.add("--tolerance", options.tolerances, &Tolerance::relative);
  tolerances.add("--absolute", options.absolutes, &Tolerance::absolute);
  const auto ulps = static_cast<std::int64_t>(whole_number("--ulps", options.ulps, 0, kMostUlps));
  const PosedQuestions posed = read_poses_folder(*options.poses);
  const std::optional<fs::path> folder = prepared_folder(options.frame);
  if (folder) refuse_to_overwrite(options, *folder);
  JudgingSetup setup{options.answers.value_or(options.command.value_or("")),
                     *options.poses,
                     tolerances.text(),
                     ulps,
                     {},
                     sha256_of_file(fs::path(*options.poses) / kPosesFile).value_or("")};
  // A pipe can't be read twice.
  if (std::error_code error; folder && options.answers) {
    if (fs::is_regular_file(*options.answers, error))
      setup.answers_sha256 = sha256_of_file(*options.answers).value_or("");
    else if (options.shared)
      throw BadInput(*options.answers + ": no file; --shared wants answers in a file, or --command");
  }
  const Judge judge(posed, tolerances, ulps);
  Judging run(judge);
  return options.shared ? judge_with_others(run, options, setup, *folder, jobs)
                        : judge_alone(run, options, setup, folder, jobs);
}

}  // namespace

void add_judge_command(CLI::App& program, Run& run) {
  auto options = std::make_shared<JudgeOptions>();
  CLI::App* command = program.add_subcommand("judge", kJudgeDescription);
  command->footer(fmt::format(
      "Answers are JSON, one a line: the id of a pose and whichever facts the engine knows. docs/judge.md says what\n"
      "each one means. What is not given is not judged. With --command the engine is started, without a shell, and\n"
      "asked pose by pose: first it gets the first line of poses.jsonl, which it does not answer, with absolute paths\n"
      "of the surfaces; then a line a pose, each of which it answers by a line before it gets the next one. After a\n"
      "crash, a hang or a line that is no answer it is started anew.\n"
      "Case files are written of the first {} wrong answers of each stratum; 'pcm verify --case' puts the same "
      "question to this "
      "engine.\n"
      "The exit status is 1 with a wrong answer, where nothing could be judged, or when interrupted, 2 for bad input;\n"
      "what was judged before an interruption is printed.\n"
      "Examples:\n"
      "  pcm poses --out poses --poses 2000\n"
      "  my_engine poses > answers.jsonl\n"
      "  pcm judge answers.jsonl --poses poses --tolerance force=1e-6,torque=1e-6 --out judgement\n"
      "  pcm judge --command 'python3 my_engine.py --fast' --poses poses\n"
      "  mpirun -n 4 pcm judge answers.jsonl --poses poses --shared --out judgement",
      kMostCasesOfAStratum));
  command->add_option("ANSWERS", options->answers, "File of answers")->type_name("FILE");
  command->add_option("--poses", options->poses, "Folder that 'pcm poses' has written")->type_name("DIR");
  command->add_option("--command", options->command, "The engine and its arguments, in place of a file")
      ->type_name("'WORD ...'");
  command->add_option("--time-limit", options->time_limit, "With --command: for one answer, start included, s")
      ->type_name("S")
      ->capture_default_str()
      ->needs("--command");
  command
      ->add_option("--tolerance", options->tolerances,
                   "How far off values may be beyond what roundings make, relative: of the sum of |F_k| (force) or of "
                   "|C_k - r| |F_k| (torque), of the value itself (area, volume, element_area, element_penetration)")
      ->type_name("FACT=X,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--absolute", options->absolutes, "The same in N, N m, m^2, m^3, m^2, m")
      ->type_name("FACT=X,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--ulps", options->ulps,
                   "How far away another answer may be for a wrong one to count as near, in ulps of the greatest "
                   "coordinate; 0: none does")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--jobs", options->frame.jobs, "Threads (default: as many as cores)")->type_name("N");
  command
      ->add_option("--out", options->frame.out,
                   "Folder for tables and case files; those of an earlier judgement are replaced")
      ->type_name("DIR");
  command->add_flag("--shared", options->shared,
                    "With --out: continue the judgement kept there, which any number of processes may share in, by "
                    "mpirun or without");
  command->add_option("--schema", options->schema, "Print the JSON schema of a line instead: poses or answers")
      ->type_name("WHICH")
      ->check(CLI::IsMember({"poses", "answers"}));
  command->callback([options, &run] { run = [options] { return judge(*options); }; });
}

}  // namespace pcm::compare
