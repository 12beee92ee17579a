// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>

#include "compare/cli/law_options.h"
#include "compare/cli/surface_warnings.h"
#include "compare/cli/verify_audits.h"
#include "compare/cli/verify_engines.h"
#include "compare/cli/verify_error_budget.h"
#include "compare/cli/verify_known_answers.h"
#include "compare/verify/kept_run.h"
#include "compare/verify/summary.h"
#include "compare/verify/verification_table.h"
#include "compare/verify/verification_widths.h"
#include "compare/verify/verify.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
  std::string poses = std::to_string(VerificationPlan().poses);
  std::string seed = std::to_string(VerificationPlan().seed);
  std::vector<std::string> strata;
  std::vector<std::vector<std::string>> pairs;
  std::string mode = "both";
  std::optional<std::string> scheme;  ///< both, where it is not given
  std::vector<std::string> engines;
  std::optional<std::string> jobs;
  std::optional<std::string> out;
  std::optional<std::string> case_file;
  bool known_answers = false;
  bool error_budget = false;
  bool audits = false;
  bool quick = false;
};

/// More than any machine gets through; products of pose numbers and shares stay below 2^63.
constexpr std::uint64_t kMostPoses = 10'000'000'000;

/// Set by the first interrupt; a signal can't reach anything else. The second one ends the program as usual.
volatile std::sig_atomic_t interrupted = 0;

void note_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

/// While it lives the first interrupt is only noted, and progress is shown on a terminal.
class Interruptible {
 public:
  explicit Interruptible(std::int64_t poses) : poses_(poses), terminal_(isatty(STDERR_FILENO) != 0) {
    std::signal(SIGINT, note_interrupt);
    std::signal(SIGTERM, note_interrupt);
  }
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  ~Interruptible() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    if (terminal_) std::cerr << '\n';
  }

  bool interrupted() const { return pcm::compare::interrupted != 0; }
  void show(std::int64_t done) const {
    if (terminal_ && (done % 16 == 0 || done == poses_))
      std::cerr << fmt::format("\r{} of {} poses", done, poses_) << std::flush;
  }

 private:
  std::int64_t poses_;
  bool terminal_;
};

int number_of_jobs(const VerifyOptions& options) {
  if (options.jobs) return static_cast<int>(whole_number("--jobs", *options.jobs, 1, 4096));
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// What the options ask for. `notices` gets lines on what is left out or odd.
VerificationPlan plan_from(const VerifyOptions& options, std::vector<std::string>& notices) {
  VerificationPlan plan;
  plan.poses = static_cast<std::int64_t>(whole_number("--poses", options.poses, 1, kMostPoses));
  plan.seed = whole_number("--seed", options.seed, 0, std::numeric_limits<std::uint64_t>::max());
  plan.modes = options.mode == "all" ? HeldPairing::Modes{Mode::E, Mode::F, Mode::both}
                                     : HeldPairing::Modes{mode_named(options.mode)};
  plan.schemes = options.scheme && *options.scheme != "both" ? std::vector{scheme_named(*options.scheme)}
                                                             : std::vector{Scheme::barycentric, Scheme::clipped};
  plan.schemes_named = options.scheme.has_value();
  plan.strata_named = !options.strata.empty();
  plan.pairs_named = !options.pairs.empty();
  if (plan.strata_named) plan.strata.clear();
  for (const std::string& word : options.strata) {
    const std::optional<Stratum> stratum = stratum_named(word);
    if (!stratum) {
      std::string known;
      for (const Stratum s : kStrata) known += (known.empty() ? "" : ", ") + std::string(name(s));
      throw BadInput("--strata: unknown stratum '" + word + "'; known are " + known);
    }
    if (std::find(plan.strata.begin(), plan.strata.end(), *stratum) == plan.strata.end())
      plan.strata.push_back(*stratum);
  }
  for (const std::vector<std::string>& files : options.pairs) {
    const SurfacePair& pair = plan.pairs.emplace_back(pair_from_files(files.at(0), files.at(1)));
    for (const TriangleMesh* mesh : {&pair.E, &pair.F}) {
      const std::string warning = require_fit_or_warn(*mesh);
      if (!warning.empty() && std::find(notices.begin(), notices.end(), warning) == notices.end())
        notices.push_back(warning);
    }
  }
  if (!plan.pairs.empty()) {
    // Two pairs of one name would draw the same random numbers and could not be told apart in the tables.
    for (std::size_t i = 0; i < plan.pairs.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (plan.pairs[j].name == plan.pairs[i].name) plan.pairs[i].name += fmt::format(" ({})", i + 1);
    return plan;
  }
  std::vector<std::string> missing;
  plan.pairs = built_in_pairs(installed_real_surfaces(), missing);
  if (!missing.empty())
    notices.push_back(
        fmt::format("skipped for want of the real surfaces of libcgal-demo: {}", fmt::join(missing, ", ")));
  return plan;
}

/// The folder of a run, made if need be. Throws BadInput where nothing can be written there.
fs::path prepare_folder(const std::string& out) {
  const fs::path folder = out;
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error)) throw BadInput("--out " + out + ": no such folder, and it cannot be made");
  write_text_file(folder / "state.probe", "");
  fs::remove(folder / "state.probe", error);
  return folder;
}

void write_cases(const fs::path& folder, const Verification& run) {
  fast::Workspace workspace;
  const Wanted everything;
  for (const Finding& finding : run.findings()) {
    const Cell& cell = run.cells()[finding.cell];
    Case posed;
    try {
      posed = run.as_case(finding);
    } catch (const std::exception& error) {
      complain(run.pose_name(cell, finding.pose) + ": no case file, for the pose can't be drawn: " + error.what());
      continue;
    }
    const HeldPairing& held = run.held_pairing(cell, finding.pose);
    nlohmann::ordered_json engine, oracle;
    try {
      const std::size_t mode = finding.cell % run.plan().modes.size();
      const fast::Pairing pairing(held.engine(mode).surface_E(), held.engine(mode).surface_F(), posed.law, posed.mode,
                                  posed.scheme);
      engine = decided(fast::evaluate(pairing, posed.pose, posed.velocity, everything, workspace));
      reference::Inquiry inquiry(held.oracle(), posed.pose, posed.velocity, everything, posed.law, posed.scheme);
      oracle = decided(inquiry.answer(reference::Problem::rounded, posed.mode));
    } catch (const std::exception&) {
      // The disagreement itself says which side failed, and how.
    }
    std::string file = "case_" + run.pose_name(cell, finding.pose) + ".json";
    for (char& c : file)
      if (c == '/' || c == ' ') c = '_';
    write_text_file(folder / file, format_case(posed, finding.disagreements, engine, oracle));
  }
}

void write_tables(const fs::path& folder, const Verification& run) {
  write_cases(folder, run);
  write_text_file(folder / "widths.csv", widths_csv(run));
  write_text_file(folder / "verification.csv", verification_csv(run));
  write_text_file(folder / "verification.json", verification_json(run).dump(1) + "\n");
  write_text_file(folder / "times.md", times_markdown(run));
  write_text_file(folder / "verification.md",
                  verification_markdown(run) + "\n" + widths_markdown(run) + "\n" + verdict_line(run) + "\n");
}

Exit verify(const VerifyOptions& options) {
  const int jobs = number_of_jobs(options);
  std::vector<std::string> notices;
  VerificationPlan plan = plan_from(options, notices);
  std::optional<fs::path> folder;
  if (options.out) folder = prepare_folder(*options.out);
  std::optional<Interruptible> work(std::in_place, plan.poses);
  Verification run(std::move(plan));
  for (const std::string& notice : notices) complain(notice);
  Resumption kept;
  if (folder) kept = resume_run(*folder, run);
  if (!kept.notice.empty()) complain(kept.notice);

  while (!run.finished() && !work->interrupted()) {
    run.run_batch(
        jobs, [&] { return work->interrupted(); }, [&](std::int64_t done) { work->show(done); });
    if (folder) keep_run(*folder, run);
  }
  work.reset();
  // Of a run that an earlier call finished, too: who knows what became of its files.
  if (folder) write_tables(*folder, run);
  std::cout << verification_summary(run) << '\n';
  for (std::size_t k = 0; k < std::min<std::size_t>(run.findings().size(), 20); ++k) {
    const Finding& finding = run.findings()[k];
    for (const Disagreement& d : finding.disagreements)
      std::cout << fmt::format("{}: {}: {}\n", run.pose_name(run.cells()[finding.cell], finding.pose), name(d.kind),
                               d.text);
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
  return is_verified(run) ? Exit::success : Exit::negative;
}

Exit compare_engines(const VerifyOptions& options) {
  if (options.scheme && *options.scheme != "barycentric")
    throw BadInput("--engine: the published algorithms know the barycentric scheme only; leave out --scheme");
  const int jobs = number_of_jobs(options);
  std::vector<Engine> engines;
  for (const Engine engine : kEngines)
    if (std::find(options.engines.begin(), options.engines.end(), name(engine)) != options.engines.end())
      engines.push_back(engine);
  std::vector<std::string> notices;
  VerificationPlan plan = plan_from(options, notices);
  plan.schemes = {Scheme::barycentric};
  std::optional<fs::path> folder;
  if (options.out) folder = prepare_folder(*options.out);
  for (const std::string& notice : notices) complain(notice);
  const Interruptible work(plan.poses);
  return verify_engines(
      std::move(plan), engines, jobs, folder, [&] { return work.interrupted(); },
      [&](std::int64_t done) { work.show(done); });
}

Exit known_answers(const VerifyOptions& options) {
  const std::uint64_t seed = whole_number("--seed", options.seed, 0, std::numeric_limits<std::uint64_t>::max());
  std::optional<fs::path> folder;
  if (options.out) folder = prepare_folder(*options.out);
  return verify_known_answers(options.quick ? Extent::quick : Extent::full, seed, number_of_jobs(options), folder);
}

Exit error_budget(const VerifyOptions& options) {
  std::optional<fs::path> folder;
  if (options.out) folder = prepare_folder(*options.out);
  return verify_error_budget(options.quick ? Extent::quick : Extent::full, number_of_jobs(options), folder);
}

Exit audits(const VerifyOptions& options) {
  std::optional<fs::path> folder;
  if (options.out) folder = prepare_folder(*options.out);
  return verify_audits(options.quick ? Extent::quick : Extent::full, number_of_jobs(options), folder);
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

void add_verify_command(CLI::App& program, Run& run) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = program.add_subcommand("verify", "Hold the engine against the oracle over randomized poses");
  command->footer(fmt::format(
      "Poses are spread evenly over strata and pairs; the same arguments give the same tables, whatever the number of\n"
      "jobs. A summary is printed; the tables by pair and stratum are written to --out. The last line printed is the\n"
      "verdict; the exit status is 1 with a disagreement, with rounding errors of generic poses above 1e-13 S/p, with "
      "a\n"
      "wrong answer of any --engine, or when interrupted. The measure of 1e-13 S/p is taken at the 99.9th percentile, "
      "of\n"
      "greatest penetrations at the 99th, always leaves out one answer at least, and is not demanded of the pairs "
      "made\n"
      "to hurt; an interrupted run is `unfinished`, not verified. A stratum, scheme or pair that is named must get a\n"
      "pose; what else gets none is said.\n"
      "Every pose is answered on all paths that callers take (everything, with a bound, force only, touch only, drawn\n"
      "choices, in a scene), under a law drawn for it; widths.csv says how wide each kind of check was. Case files "
      "are\n"
      "written of the first {} answers with a disagreement in the order of the tables; all are counted.\n"
      "Known answers, error budget and audits: 1 when any row is out of its bounds; the tables and a page for each "
      "case\n"
      "are written to --out.\n"
      "Examples:\n"
      "  pcm verify --poses 200000 --mode all --out results\n"
      "  pcm verify --pair bolt.obj nut.obj --strata generic,degenerate\n"
      "  pcm verify --engine fast,published-2003,published-2023\n"
      "  pcm verify --known-answers --out answers\n"
      "  pcm verify --error-budget --out budget\n"
      "  pcm verify --audits --out audits\n"
      "  pcm verify --case results/case_cube-cube_degenerate_17_both.json",
      kMostFindings));
  command->add_option("--poses", options->poses, "How many poses in all (strata that no pair has leave theirs out)")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of the random poses, a whole number")
      ->type_name("S")
      ->capture_default_str();
  command
      ->add_option("--strata", options->strata,
                   "Of generic, grazing, separated, nested, degenerate, near-degenerate (default: all)")
      ->type_name("NAME,...")
      ->delimiter(',');
  command
      ->add_option("--pair", options->pairs,
                   "Two surfaces E and F (OBJ or OFF) in place of the built-in pairs; may be repeated")
      ->type_name("E F")
      ->type_size(2)
      ->allow_extra_args(false);
  command
      ->add_option("--mode", options->mode,
                   "Whose faces are masters: E, F or both; all: each pose in these three modes")
      ->check(CLI::IsMember({"E", "F", "both", "all"}))
      ->capture_default_str();
  command
      ->add_option(
          "--scheme", options->scheme,
          "How elements sample the penetration: barycentric, clipped, or both (default: every third pose in the "
          "clipped scheme)")
      ->check(CLI::IsMember({"barycentric", "clipped", "both"}));
  command
      ->add_option(
          "--engine", options->engines,
          "Of fast (default), published-2003, published-2023: with one of the published algorithms, instead of "
          "the full verdict how many answers of each named one are wrong, by stratum and by what")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->check(CLI::IsMember({"fast", "published-2003", "published-2023"}));
  command->add_option("--jobs", options->jobs, "Threads (default: as many as cores)")->type_name("N");
  command
      ->add_option(
          "--out", options->out,
          "Folder for tables and case files; a run with the same arguments is continued, but one of another build or "
          "surfaces is removed, its case_*.json too, and so is what a run without state.json has left")
      ->type_name("DIR");
  command->add_option("--case", options->case_file, "Replay a case file instead")
      ->type_name("FILE")
      ->excludes("--poses", "--seed", "--strata", "--pair", "--mode", "--scheme", "--engine", "--out");
  CLI::Option* known = command
                           ->add_flag("--known-answers", options->known_answers,
                                      "Instead: forces known in closed form over resolutions, and identities (minutes)")
                           ->excludes("--poses", "--strata", "--pair", "--mode", "--scheme", "--engine", "--case");
  CLI::Option* budget =
      command
          ->add_flag("--error-budget", options->error_budget,
                     "Instead: rounding, discretisation and geometry error of smooth bodies over resolutions (minutes)")
          ->excludes(known)
          ->excludes("--poses", "--seed", "--strata", "--pair", "--mode", "--scheme", "--engine", "--case");
  command
      ->add_flag("--audits", options->audits,
                 "Instead: work left over, tangential force and jumps of the elastic force over closed loops of poses")
      ->excludes(known, budget)
      ->excludes("--poses", "--seed", "--strata", "--pair", "--mode", "--scheme", "--engine", "--case");
  command->add_flag("--quick", options->quick,
                    "Known answers or error budget on coarser meshes only, audits in coarser steps");
  command->callback([options, &run] {
    run = [options] {
      if (options->case_file) return replay(*options->case_file);
      if (options->quick && !options->known_answers && !options->error_budget && !options->audits)
        throw BadInput("--quick goes with --known-answers, --error-budget or --audits");
      if (options->audits) return audits(*options);
      if (options->error_budget) return error_budget(*options);
      if (options->known_answers) return known_answers(*options);
      const bool fast_alone = std::all_of(options->engines.begin(), options->engines.end(),
                                          [](const std::string& word) { return word == name(Engine::fast); });
      return fast_alone ? verify(*options) : compare_engines(*options);
    };
  });
}

}  // namespace pcm::compare
