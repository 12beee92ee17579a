// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_options.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>

#include "compare/poses/strata.h"
#include "compare/verify/run/verify.h"
#include "pcm/bad_input.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {

namespace {

/// Whether the options ask for a table whose problems and laws are its own.
bool asks_for_problems_of_its_own(const VerifyOptions& options) {
  return options.known_answers || options.error_budget || options.audits || options.stability || options.search;
}

}  // namespace

bool asks_for_other_tables(const VerifyOptions& options) {
  return asks_for_problems_of_its_own(options) ||
         std::any_of(options.engines.begin(), options.engines.end(),
                     [](const std::string& engine) { return engine != "fast"; });
}

void add_plan_options(CLI::App& command, VerifyOptions& options) {
  options.seed = std::to_string(VerificationPlan().seed);
  command
      .add_option("--poses", options.poses,
                  "How many poses in all (strata that no pair has leave theirs out); of a trajectory, how many at "
                  "most, spread evenly (default: all)")
      ->type_name("N")
      ->default_str(std::to_string(VerificationPlan().poses));
  command.add_option("--seed", options.seed, "Seed of the random poses, a whole number")
      ->type_name("S")
      ->capture_default_str();
  command
      .add_option(
          "--strata", options.strata,
          "Of " + strata_names() +
              (options.usual_strata
                   ? " (default: all but extreme and adversarial, beyond what most engines say they can do, and "
                     "trajectory)"
                   : " (default: all but trajectory, which has pairs of its own: those of the scenes of `pcm "
                     "simulate`)"))
      ->type_name("NAME,...")
      ->delimiter(',');
  command
      .add_option(
          "--pair", options.pairs,
          std::string("Two surfaces E and F (") + kMeshFormats + ") in place of the built-in pairs; may be repeated")
      ->type_name("E F")
      ->type_size(2)
      ->allow_extra_args(false);
  command
      .add_option("--mode", options.mode,
                  "Whose faces are masters: E, F or both; all: each pose in these three modes (default of a "
                  "trajectory: as recorded)")
      ->check(CLI::IsMember({"E", "F", "both", "all"}))
      ->default_str("both");
  command
      .add_option(
          "--scheme", options.scheme,
          "How elements sample the penetration: barycentric, clipped, or both (default: every third pose in the "
          "clipped scheme; of a trajectory as recorded, or one of the two)")
      ->check(CLI::IsMember({"barycentric", "clipped", "both"}));
}

namespace {

std::string footer() {
  return fmt::format(
      "Poses are spread evenly over strata and pairs; the same arguments give the same tables, but for what made them\n"
      "and times, whatever the number of jobs. A summary is printed; the tables by pair and stratum are written to\n"
      "--out. The last line printed is the verdict; the exit status is 1 with a disagreement, with rounding errors of\n"
      "generic poses above 1e-13 S/p, with a wrong answer of any --engine, or when interrupted. The measure of 1e-13\n"
      "S/p is taken at the 99.9th percentile, of greatest penetrations at the 99th, always leaves out one answer at\n"
      "least, and is not demanded of the pairs made to hurt; an interrupted run is `unfinished`, not verified. A\n"
      "stratum, scheme or pair that is named must get a pose; what else gets none is said.\n"
      "With any option of the force law all poses are asked under that law, whose other options have their defaults.\n"
      "Every pose is answered on all paths that callers take (everything, with a bound, force only, touch only, drawn\n"
      "choices, in a scene), under a law drawn for it unless one is given; widths.csv says how wide each kind of\n"
      "check was. Case files are written of the first {} answers with a disagreement in the order of the tables; all\n"
      "are counted.\n"
      "Known answers, error budget and audits: 1 when any row is out of its bounds; the tables and a page for each\n"
      "case are written to --out. Stability: 1 when an error exceeds the engine's own bound or an answer is not\n"
      "finite; tables and a plot a sweep are written to --out. Search: 1 when engine and oracle part where a climb\n"
      "ends; tables are written to --out, and case files of the hardest states to its folder `hardest`, to replay by\n"
      "--case or to climb on from by --from.\n"
      "A run of poses with --out may be killed and goes on where it was; half a second's work is lost, some seconds'\n"
      "in runs over all pairs and strata. Any number of processes may share in it: start the same command once more, "
      "on\n"
      "another machine that has the folder too, or by mpirun.\n"
      "Poses of a trajectory are asked under the law of their pairing; they are not generic, and no measure is "
      "demanded.\n"
      "Examples:\n"
      "  pcm verify --poses 200000 --mode all --out results\n"
      "  mpirun -n 4 pcm verify --poses 1000000 --out results\n"
      "  pcm verify --poses 1000000 --part 2/5 --out second\n"
      "  pcm verify --poses 1000000 --merge first second third fourth fifth --out results\n"
      "  pcm verify --pair bolt.obj nut.obj --strata generic,degenerate\n"
      "  pcm verify --strata degenerate,near-degenerate,extreme,adversarial,trajectory --scheme both\n"
      "  pcm verify --engine fast,published-2003,published-2023\n"
      "  pcm verify --known-answers --out answers\n"
      "  pcm verify --error-budget --out budget\n"
      "  pcm verify --audits --out audits\n"
      "  pcm verify --stability --out stability\n"
      "  pcm verify --search --poses 2000 --out search\n"
      "  pcm verify --search --from search/hardest --seed 2 --out further\n"
      "  pcm verify --trajectory bubbles/trajectory/trajectory.json --out results\n"
      "  pcm verify --case results/case_cube-cube_degenerate_17_both.json",
      kMostFindings);
}

/// Of a run that is kept, and shared.
void add_campaign_options(CLI::App& command, VerifyOptions& options) {
  command.add_option("--jobs", options.jobs, "Threads (default: as many as cores)")->type_name("N");
  command
      .add_option(
          "--out", options.out,
          "Folder for tables and case files. A run with the same arguments is continued; if the build or the surfaces "
          "have changed since, it is removed with its case files and begun anew, and so is what a run without "
          "campaign.sqlite has left. A folder of another run, or of an earlier version, is refused")
      ->type_name("DIR");
  command
      .add_option("--part", options.part,
                  "Only part K of N of the run, e.g. 2/5, for machines that share no folder; --merge puts the parts "
                  "together")
      ->type_name("K/N");
  command
      .add_option("--merge", options.merge,
                  "With the arguments of the run and --out: put together what these folders hold of it")
      ->type_name("DIR")
      ->allow_extra_args()
      ->excludes("--part");
}

/// What is asked in place of random poses.
void add_other_problems(CLI::App& command, VerifyOptions& options) {
  CLI::Option* known = command
                           .add_flag("--known-answers", options.known_answers,
                                     "Instead: forces known in closed form over resolutions, and identities (minutes)")
                           ->excludes("--poses", "--strata", "--pair", "--mode", "--scheme", "--engine", "--case");
  CLI::Option* budget =
      command
          .add_flag("--error-budget", options.error_budget,
                    "Instead: rounding, discretisation and geometry error of smooth bodies over resolutions (minutes)")
          ->excludes(known)
          ->excludes("--poses", "--seed", "--strata", "--pair", "--mode", "--scheme", "--engine", "--case");
  CLI::Option* audits =
      command
          .add_flag(
              "--audits", options.audits,
              "Instead: work left over, tangential force and jumps of the elastic force over closed loops of poses")
          ->excludes(known, budget)
          ->excludes("--poses", "--seed", "--strata", "--pair", "--mode", "--scheme", "--engine", "--case");
  CLI::Option* stability =
      command
          .add_flag("--stability", options.stability,
                    "Instead: rounding error beside the condition of the problem, over offset, scale, aspect ratio, "
                    "depth and mesh size, in both schemes and of the published algorithms (minutes)")
          ->excludes(known, budget, audits)
          ->excludes("--poses", "--strata", "--pair", "--mode", "--scheme", "--engine", "--case");
  CLI::Option* search =
      command
          .add_flag(
              "--search", options.search,
              "Instead: climb to states that are hard for the engine, --poses climbs (default: one for each goal, "
              "scheme and pair, or for each goal and case), from states drawn for small pairs or given by --pair (2000 "
              "faces at most), over poses, velocities, laws, "
              "modes and vertices of small surfaces; minutes, and with --out it goes on where it was ended")
          ->excludes(known, budget, audits, stability)
          ->excludes("--strata", "--mode", "--engine", "--case");
  command
      .add_option(
          "--from", options.from,
          "With --search: climb from these case files, or from all of a folder, in their schemes; the way by which F "
          "came there is left out")
      ->type_name("FILE|DIR")
      ->needs(search)
      ->excludes("--pair", "--scheme");
  command
      .add_option("--trajectory", options.trajectory,
                  "Hold the poses of this recorded trajectory (trajectory/trajectory.json of a folder of `pcm "
                  "simulate`) instead of random ones")
      ->type_name("FILE")
      ->excludes(known, budget, audits, stability, search)
      ->excludes("--seed", "--strata", "--pair", "--engine", "--case");
  command.add_flag("--quick", options.quick,
                   "Known answers or error budget on coarser meshes only, audits in coarser steps, stability at fewer "
                   "points and poses");
}

/// Throws BadInput where options do not go together.
void require_consistent(const VerifyOptions& options) {
  const bool problems_of_its_own = asks_for_problems_of_its_own(options);
  if (options.law.any() && (problems_of_its_own || options.case_file || options.trajectory))
    throw BadInput("the options of the force law go with random poses; all else has laws of its own");
  if (options.quick && (!problems_of_its_own || options.search))
    throw BadInput("--quick goes with --known-answers, --error-budget, --audits or --stability");
  if (options.part || !options.merge.empty()) {
    if (asks_for_other_tables(options) || options.case_file)
      throw BadInput("--part and --merge go with the poses of a run alone");
    if (!options.out) throw BadInput("--part and --merge want --out DIR");
  }
}

}  // namespace

void add_verify_command(CLI::App& program, Run& run, const std::function<Exit(const VerifyOptions&)>& act) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command =
      program.add_subcommand("verify", "Compare the engine with the oracle over randomized or recorded poses");
  command->footer(footer());
  add_plan_options(*command, *options);
  command
      ->add_option(
          "--engine", options->engines,
          "Of fast (default), published-2003, published-2023. Where a published algorithm is named, there is no full "
          "verdict: a table counts the wrong answers of each engine named, by stratum and by what is wrong")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->check(CLI::IsMember({"fast", "published-2003", "published-2023"}));
  add_campaign_options(*command, *options);
  command->add_option("--case", options->case_file, "Replay a case file instead")
      ->type_name("FILE")
      ->excludes("--poses", "--seed", "--strata", "--pair", "--mode", "--scheme", "--engine", "--out");
  add_other_problems(*command, *options);
  add_law_options(*command, options->law);
  command->callback([options, &run, act] {
    run = [options, act] {
      require_consistent(*options);
      return act(*options);
    };
  });
}

}  // namespace pcm::compare
