// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/bench/bench.h"

#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "compare/bench/peer_comparison.h"
#include "compare/bench/scaling.h"
#include "compare/bench/skip.h"
#include "compare/bench/steps.h"
#include "compare/bench/work_precision.h"
#include "compare/cli/frame/programs.h"
#include "compare/io/json/question_json.h"
#include "compare/io/pictures/svg_plot.h"
#include "compare/io/provenance/sha256.h"
#include "compare/io/tables/report_folder.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

struct PeersOptions {
  std::optional<std::string> poses;
  std::vector<std::string> bodies;
  std::optional<std::string> out;
  bool quick = false;
};

/// Of a benchmark whose poses and bodies are its own.
struct FixedOptions {
  std::optional<std::string> out;
  bool quick = false;
};

struct SkipOptions {
  std::optional<std::string> steps;
  std::optional<std::string> out;
  bool quick = false;
};

/// A folder, made if need be, without files of others under these names: before an hour is spent on what can't be kept
/// there.
std::optional<fs::path> output_folder(const std::optional<std::string>& out, const std::string& command,
                                      const std::vector<std::string>& files) {
  if (!out) return {};
  std::error_code error;
  fs::create_directories(*out, error);
  if (!fs::is_directory(*out, error)) throw BadInput("--out " + *out + ": no such folder, and it cannot be made");
  refuse_files_of_others(*out, command, files);
  return fs::path(*out);
}

void show_progress(const std::string& what) {
  if (isatty(STDERR_FILENO) != 0) std::cerr << fmt::format("\r{:<60}\r", what) << std::flush;
}

const ColumnUnits kUnits = {{"us", "us"},        {"ms", "ms"},          {"edge_m", "m"},    {"ns_a_unit", "ns"},
                            {"us_a_face", "us"}, {"bytes_a_face", "B"}, {"megabytes", "MB"}};

nlohmann::ordered_json machine_json(const Machine& machine) {
  return {{"processor", machine.processor},
          {"compiler", machine.compiler},
          {"flags", machine.flags},
          {"core", machine.core}};
}

nlohmann::ordered_json surfaces_json(const std::vector<BenchBody>& bodies) {
  nlohmann::ordered_json surfaces = nlohmann::ordered_json::array();
  for (const BenchBody& body : bodies) surfaces.push_back({{"name", body.name}, {"sha256", sha256(body.mesh)}});
  return surfaces;
}

Exit bench_peers(const PeersOptions& options) {
  const std::string default_poses = options.quick ? "3" : "200";
  const auto poses =
      static_cast<std::int64_t>(whole_number("--poses", options.poses.value_or(default_poses), 1, 1'000'000));
  std::vector<BenchBody> bodies;
  for (const std::string& name : options.bodies.empty() ? bench_body_names() : options.bodies)
    bodies.push_back(bench_body(name));
  const std::optional<fs::path> folder =
      output_folder(options.out, "peers", {"peers.md", "peers.tex", "peers.csv", "peers.json"});
  const Machine machine = this_machine(stay_on_one_core());
  const std::vector<PeerComparison> results = compare_peers(bodies, poses, show_progress);
  show_progress("");
  std::cout << peers_screen(results, machine);
  if (folder) {
    const Table table = peers_table(results);
    ReportFolder report(
        *folder, "peers",
        {{"poses", poses}, {"law", law_json(bench_law(), Notation::decimal)}, {"surfaces", surfaces_json(bodies)}});
    report.markdown("peers", peers_markdown(results, machine));
    report.csv("peers", csv(table), kUnits);
    report.json("peers", {{"machine", machine_json(machine)}, {"poses", poses}, {"contestants", json(table)}});
    report.finish();
  }
  return Exit::success;
}

Exit bench_scaling(const FixedOptions& options) {
  const std::int64_t poses = options.quick ? 2 : 20;
  const std::optional<fs::path> folder =
      output_folder(options.out, "scaling", {"scaling.md", "scaling.tex", "scaling.csv", "setup.csv", "scaling.json"});
  const Machine machine = this_machine(stay_on_one_core());
  const ScalingResult result = run_scaling(options.quick ? 4 : 8, poses, show_progress);
  show_progress("");
  std::cout << scaling_screen(result, machine);
  if (folder) {
    ReportFolder report(*folder, "scaling", {{"poses", poses}, {"quick", options.quick}});
    report.markdown("scaling", scaling_markdown(result, machine));
    report.csv("scaling", csv(scaling_table(result)), kUnits);
    report.csv("setup", csv(setup_table(result)), kUnits);
    report.json("scaling", {{"machine", machine_json(machine)},
                            {"poses", poses},
                            {"points", json(scaling_table(result))},
                            {"exponents", json(exponents_table(result))},
                            {"setup", json(setup_table(result))}});
    report.finish();
  }
  return Exit::success;
}

Exit bench_skip(const SkipOptions& options) {
  const auto steps = static_cast<std::int64_t>(
      whole_number("--steps", options.steps.value_or(options.quick ? "3" : "100"), 1, 100'000));
  const std::optional<fs::path> folder =
      output_folder(options.out, "skip", {"skip.md", "skip.tex", "skip_scene.csv", "skip.csv", "skip.json"});
  const Machine machine = this_machine(stay_on_one_core());
  const SkipResult result =
      options.quick ? run_skip(8, steps, 2, show_progress) : run_skip(50, steps, 40, show_progress);
  show_progress("");
  std::cout << skip_screen(result, machine);
  if (folder) {
    ReportFolder report(*folder, "skip", {{"steps", steps}, {"quick", options.quick}});
    report.markdown("skip", skip_markdown(result, machine));
    report.csv("skip_scene", csv(scenes_table(result)), kUnits);
    report.csv("skip", csv(savings_table(result)), kUnits);
    report.json("skip", {{"machine", machine_json(machine)},
                         {"bubbles", result.bubbles},
                         {"pairings", result.pairings},
                         {"steps", result.steps},
                         {"certificate_ns", result.certificate_ns},
                         {"boxes_ns", result.boxes_ns},
                         {"answers_compared", result.answers_compared},
                         {"answers_different", result.answers_different},
                         {"scene", json(scenes_table(result))},
                         {"savings", json(savings_table(result))}});
    report.finish();
  }
  return result.answers_different == 0 ? Exit::success : Exit::negative;
}

Exit bench_steps(const FixedOptions& options) {
  const std::int64_t ways = options.quick ? 2 : 100;
  const int passes = options.quick ? 1 : 5;
  const std::optional<fs::path> folder =
      output_folder(options.out, "steps", {"steps.md", "steps.tex", "steps.csv", "steps_work.csv", "steps.json"});
  const Machine machine = this_machine(stay_on_one_core());
  const std::vector<StepsResult> results = run_steps(ways, passes, show_progress);
  show_progress("");
  std::cout << steps_screen(results, machine);
  if (folder) {
    ReportFolder report(*folder, "steps", {{"ways", ways}, {"passes", passes}});
    report.markdown("steps", steps_markdown(results, machine));
    report.csv("steps", csv(steps_table(results)), kUnits);
    report.csv("steps_work", csv(steps_work_table(results)), kUnits);
    report.json("steps", {{"machine", machine_json(machine)},
                          {"ways", ways},
                          {"steps", json(steps_table(results))},
                          {"work", json(steps_work_table(results))}});
    report.finish();
  }
  const bool alike = std::all_of(results.begin(), results.end(), [](const StepsResult& r) { return r.different == 0; });
  return alike ? Exit::success : Exit::negative;
}

Exit bench_work_precision(const FixedOptions& options) {
  const Extent extent = options.quick ? Extent::quick : Extent::full;
  const std::optional<fs::path> folder =
      output_folder(options.out, "work_precision",
                    {"work_precision.md", "work_precision.tex", "work_precision.csv", "work_precision.json"});
  show_progress("forces of the smooth bodies");
  const std::vector<WorkPrecisionProblem> problems = work_precision_problems(extent);
  std::vector<std::string> pictures;
  for (const WorkPrecisionProblem& problem : problems)
    pictures.push_back(work_precision_picture(problem.pair.id) + ".svg");
  if (folder) refuse_files_of_others(*folder, "work_precision", pictures);
  const Machine machine = this_machine(stay_on_one_core());
  std::vector<WorkPrecisionResult> results;
  for (const WorkPrecisionProblem& problem : problems) results.push_back(run_work_precision(problem, show_progress));
  show_progress("");
  std::cout << work_precision_screen(results, machine);
  if (folder) {
    ReportFolder report(*folder, "work_precision", {{"quick", options.quick}});
    report.markdown("work_precision", work_precision_markdown(results, machine));
    report.csv("work_precision", csv(work_precision_table(results)), kUnits);
    report.json("work_precision", {{"machine", machine_json(machine)},
                                   {"orientations", results.front().orientations},
                                   {"points", json(work_precision_table(results))},
                                   {"barycentric_over_clipped", json(equal_time_table(results))}});
    for (const WorkPrecisionResult& result : results)
      report.picture(work_precision_picture(result.id), svg(work_precision_figure(result, machine)));
    report.finish();
  }
  return Exit::success;
}

void add_peers(CLI::App& bench, Run& run) {
  auto options = std::make_shared<PeersOptions>();
  CLI::App* command = bench.add_subcommand("peers", "This engine against others on the same surfaces and poses");
  command->footer(
      "Peers are those of Debian that were there when the program was built; './run bench' installs them.\n"
      "Example:\n  pcm bench peers --bodies bubbles --poses 50 --out bench");
  command->add_option("--poses", options->poses, "Touching poses, and as many separated ones, a body (200)")
      ->type_name("N");
  command
      ->add_option("--bodies", options->bodies, fmt::format("Only these of: {}", fmt::join(bench_body_names(), ", ")))
      ->delimiter(',');
  command->add_option("--out", options->out, "Folder for tables: peers.md, .csv, .json")->type_name("DIR");
  command->add_flag("--quick", options->quick, "3 poses: to see it work");
  command->callback([options, &run] { run = [options] { return bench_peers(*options); }; });
}

void add_scaling(CLI::App& bench, Run& run) {
  auto options = std::make_shared<FixedOptions>();
  CLI::App* command = bench.add_subcommand("scaling", "Time and memory over mesh size and patch size");
  command->footer(
      "Two spheres of 320 to 1,310,720 faces each.\n"
      "Example:\n  pcm bench scaling --out bench");
  command->add_option("--out", options->out, "Folder for tables: scaling.md, .csv, .json, setup.csv")->type_name("DIR");
  command->add_flag("--quick", options->quick, "2 poses, up to 5120 faces: to see it work");
  command->callback([options, &run] { run = [options] { return bench_scaling(*options); }; });
}

void add_skip(CLI::App& bench, Run& run) {
  auto options = std::make_shared<SkipOptions>();
  CLI::App* command = bench.add_subcommand("skip", "What each thing saves that is skipped, and that no bit changes");
  command->footer(
      "Fifty bubbles jostle in a container on a prescribed motion, with every saving on, each off, all off.\n"
      "The exit status is 1 where an answer differs in a bit.\n"
      "Example:\n  pcm bench skip --out bench");
  command->add_option("--steps", options->steps, "Steps of a millisecond (100)")->type_name("N");
  command->add_option("--out", options->out, "Folder for tables: skip.md, .csv, .json, skip_scene.csv")
      ->type_name("DIR");
  command->add_flag("--quick", options->quick, "8 bubbles, 3 steps: to see it work");
  command->callback([options, &run] { run = [options] { return bench_skip(*options); }; });
}

void add_steps(CLI::App& bench, Run& run) {
  auto options = std::make_shared<FixedOptions>();
  CLI::App* command =
      bench.add_subcommand("steps", "What an evaluation costs after others at poses near by, and what it has to do");
  command->footer(
      "Bubbles and spheres on seeded ways, and the pairings of recorded scenes, step by step.\n"
      "The exit status is 1 where an answer differs in a bit from that of the engine without a past.\n"
      "Example:\n  pcm bench steps --out bench");
  command->add_option("--out", options->out, "Folder for tables: steps.md, .csv, .json, steps_work.csv")
      ->type_name("DIR");
  command->add_flag("--quick", options->quick, "2 ways each, 1 pass: to see it work");
  command->callback([options, &run] { run = [options] { return bench_steps(*options); }; });
}

void add_work_precision(CLI::App& bench, Run& run) {
  auto options = std::make_shared<FixedOptions>();
  CLI::App* command = bench.add_subcommand(
      "work-precision", "Force error over run time: mesh resolutions, both schemes, the published algorithms");
  command->footer(
      "Sphere on plane, sphere on sphere, ball in socket, bubble on bubble; error against the smooth bodies' force "
      "and\n"
      "against the exact integral on the same meshes. Both schemes compared on the same meshes and at equal time.\n"
      "Example:\n  pcm bench work-precision --out bench");
  command
      ->add_option("--out", options->out,
                   "Folder for tables and plots: work_precision.md, .csv, .json and one .svg a pair of bodies")
      ->type_name("DIR");
  command->add_flag("--quick", options->quick, "Coarser meshes, 5 orientations: to see it work");
  command->callback([options, &run] { run = [options] { return bench_work_precision(*options); }; });
}

}  // namespace

void add_bench_command(CLI::App& program, Run& run) {
  CLI::App* command = program.add_subcommand("bench", kBenchDescription);
  command->require_subcommand(1);
  command->footer("Example:\n  pcm bench peers --bodies bubbles\n'pcm bench WHAT --help' describes one.");
  add_peers(*command, run);
  add_scaling(*command, run);
  add_skip(*command, run);
  add_steps(*command, run);
  add_work_precision(*command, run);
}

}  // namespace pcm::compare
