// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/cli/simulate.h"

#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/cli/frame/noted_interrupt.h"
#include "compare/cli/frame/programs.h"
#include "compare/io/create_folder.h"
#include "compare/io/tables/report_folder.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "simulate/page/page.h"
#include "simulate/paraview/vtp_series.h"
#include "simulate/record/integrator_comparison_report.h"
#include "simulate/record/recorded_run.h"
#include "simulate/record/recorded_state.h"
#include "simulate/record/recording_of_run.h"
#include "simulate/record/run_provenance.h"
#include "simulate/record/run_tables.h"
#include "simulate/run/simulation.h"
#include "simulate/scenes/read_scene.h"
#include "simulate/scenes/still_instants.h"
#include "simulate/stills/stills.h"

namespace pcm::simulate {
namespace {

using compare::Exit;

struct SimulateOptions {
  std::string scene, out, method, jacobian, duration, relative, absolute, greatest_step, spectrum, from, at,
      slip_velocity;
  std::optional<std::string> stills;
  bool paraview = false, schema = false, print = false, compares = false;
};

/// "bubbles, pedestrian, ..."
std::string built_in_names() {
  std::string names;
  for (const BuiltInScene& scene : built_in_scenes()) names += (names.empty() ? "" : ", ") + std::string(scene.name);
  return names;
}

/// The text of a built-in scene or of a file.
std::string scene_text(const std::string& name) {
  for (const BuiltInScene& scene : built_in_scenes())
    if (scene.name == name) return std::string(scene.text);
  if (!std::filesystem::exists(name)) throw BadInput(name + ": no such file; built in are: " + built_in_names());
  return read_text_file(name);
}

bool is_before_start(double t, const Scene& scene) {
  return t < scene.begin() && !same_instant(t, scene.begin());
}

/// From "T,T,...".
std::vector<double> still_instants(const std::string& text, const Scene& scene) {
  std::vector<double> instants;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const double t = compare::nonnegative_number("--stills", text.substr(begin, end - begin));
    const std::string flaw = flaw_of_instant(t, instants, scene.duration);
    if (!flaw.empty()) throw BadInput("--stills: " + flaw);
    if (is_before_start(t, scene))
      throw BadInput(fmt::format("--stills: {} s is before the start, {} s", t, scene.begin()));
    instants.push_back(t);
    begin = end + 1;
  }
  return instants;
}

/// As of a scene file: what the options make of it must end some time.
void require_few_steps(const SimulateOptions& options, const Scene& scene) {
  const std::string duration = options.duration.empty() ? options.scene + ": duration" : "--duration";
  const std::string option = options.greatest_step.empty() ? duration : "--greatest-step";
  if (scene.integrator.greatest_step < scene.duration / kMostSteps)
    throw BadInput(option + ": the scene would take more than 1e9 steps of no more than " +
                   fmt::format("{:g} s", scene.integrator.greatest_step));
  const double interval = std::min(scene.output.interval, scene.output.checkpoint_interval);
  if (interval < scene.duration / kMostRecords)
    throw BadInput(fmt::format("{}: the scene's output, every {:g} s, would be recorded more than a million times",
                               duration, interval));
}

/// What the command line says goes before what the scene says.
void apply(const SimulateOptions& options, Scene& scene) {
  const auto number = [](const std::string& option, const std::string& text, double& value) {
    if (!text.empty()) value = compare::positive_number(option, text);
  };
  if (!options.method.empty()) scene.integrator.method = method_named(options.method);
  if (!options.jacobian.empty()) {
    scene.integrator.jacobian = jacobian_named(options.jacobian);
    if (!takes_jacobians(scene.integrator.method))
      throw BadInput("--jacobian: the integrator (" + std::string(name(scene.integrator.method)) + ")" +
                     kTakesNoJacobians);
  }
  number("--duration", options.duration, scene.duration);
  number("--relative-tolerance", options.relative, scene.integrator.relative_tolerance);
  number("--absolute-tolerance", options.absolute, scene.integrator.absolute_tolerance);
  number("--greatest-step", options.greatest_step, scene.integrator.greatest_step);
  require_few_steps(options, scene);
  if (!options.slip_velocity.empty())
    set_slip_velocity(scene, compare::positive_number("--slip-velocity", options.slip_velocity));
  if (!options.spectrum.empty())
    scene.output.spectrum_interval =
        static_cast<std::int64_t>(compare::whole_number("--spectrum", options.spectrum, 1, 1000000000));
  if (options.from.empty() != options.at.empty()) throw BadInput("--from and --at go together");
  if (!options.from.empty())
    scene.initial_state = recorded_state(options.from, compare::nonnegative_number("--at", options.at));
  if (options.stills) scene.output.stills = still_instants(*options.stills, scene);
}

class ProgressLine {
 public:
  void show(const Progress& progress) {
    if (!terminal_) return;
    const int now = static_cast<int>(1000 * progress.t / progress.duration);
    if (now == shown_) return;
    shown_ = now;
    fmt::print(stderr, "\rt = {:.3f} of {:g} s, step {:.2e} s, {:.2f} times real time ", progress.t, progress.duration,
               progress.step, progress.real_time_factor);
  }
  ~ProgressLine() {
    if (shown_ >= 0) fmt::print(stderr, "\n");
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) == 1;
  int shown_ = -1;
};

/// Nothing where there is no reference to measure errors against.
std::optional<IntegratorComparison> comparison_of(const std::string& scene_name, const Scene& scene) {
  const bool terminal = isatty(STDERR_FILENO) == 1;
  try {
    return compare_integrators(scene, known_methods(), [&](const std::string& what) {
      if (terminal) fmt::print(stderr, "{}\n", what);
    });
  } catch (const IntegrationFailure& error) {
    compare::complain(fmt::format(
        "{}: the reference run failed: {} (its tolerance is always {:g}); let the scene end before that with "
        "--duration, or change the scene",
        scene_name, error.what(), kReferenceTolerance));
    return std::nullopt;
  }
}

/// To a folder: a table and a picture.
Exit compare_all(const SimulateOptions& options, const Scene& scene, const std::string& text) {
  const std::filesystem::path folder =
      options.out.empty() ? std::filesystem::path(options.scene).stem().string() + "-integrators" : options.out;
  compare::create_folder(folder);
  compare::refuse_files_of_others(folder, "integrators", {"integrators.md", "integrators.tex", "integrators.svg"});
  const std::optional<IntegratorComparison> comparison = comparison_of(options.scene, scene);
  if (!comparison) return Exit::negative;
  const std::string title = scene.title.empty() ? options.scene : scene.title;
  const NotedTable table = comparison_table(*comparison);
  std::cout << on_screen(table) << std::flush;
  compare::ReportFolder report(folder, "integrators", question_of_comparison(options.scene, text, scene, *comparison));
  report.markdown("integrators", "# " + title + "\n\n" + markdown(table));
  report.picture("integrators", comparison_picture(title + ": integrators compared", *comparison));
  report.finish();
  std::cout << "\npicture: " << (folder / "integrators.svg").string() << '\n';
  return Exit::success;
}

/// The tables of a run, with what made them.
void write_tables(const std::filesystem::path& folder, const std::string& tables, const SimulateOptions& options,
                  const std::string& text, RecordedRun& run, bool finished) {
  const Scene& scene = run.simulation().scene();
  const compare::ColumnUnits units = run_column_units(run.simulation().model().columns());
  compare::ReportFolder report(folder, kRunReport, question_of_run(options.scene, text, scene, finished));
  report.markdown("tables", "# " + (scene.title.empty() ? options.scene : scene.title) + "\n\n" + tables);
  for (const char* table : {"steps", "series", "states", "spectrum"}) report.csv_there(table, units);
  report.finish();
}

/// Before a folder is begun. What can't be started, the engine and the model refuse by themselves, but know no file.
void require_start(const std::string& scene_name, const Scene& scene) {
  try {
    Simulation(scene).start();
  } catch (const BadInput& error) {
    throw BadInput(scene_name + ": " + error.what());
  }
}

Exit simulate(const SimulateOptions& options) {
  if (options.schema) {
    std::cout << scene_schema();
    return Exit::success;
  }
  if (options.scene.empty()) throw BadInput("SCENE is missing; see pcm simulate --help");
  const std::string text = scene_text(options.scene);
  if (options.print) {
    std::cout << text;
    return Exit::success;
  }
  Scene scene = parse_scene(text, options.scene);
  apply(options, scene);
  if (std::ranges::all_of(scene.bodies, [](const Body& body) { return body.joint.type == JointType::weld; }))
    throw BadInput(options.scene + ": nothing can move: every body is welded; give one of them another joint");
  require_start(options.scene, scene);
  if (options.compares) return compare_all(options, scene, text);
  const std::filesystem::path folder =
      options.out.empty() ? std::filesystem::path(options.scene).stem().string() + "-run" : options.out;
  if (scene.surfaces.empty()) throw BadInput(options.scene + ": it has no surfaces, so that there is nothing to show");
  require_three_js();
  std::string notice;
  RecordedRun run(scene, text, folder, notice);
  if (!notice.empty()) compare::complain(notice);
  const compare::NotedInterrupt interrupt;
  bool finished = false;
  std::string failure;
  try {
    ProgressLine line;
    finished = run.run([&interrupt] { return interrupt.interrupted(); },
                       [&line](const Progress& progress) { line.show(progress); });
  } catch (const IntegrationFailure& error) {
    failure = error.what();  // what there is up to then is shown all the same
  }
  const NotedTable cost = cost_table(options.scene, scene, run.kept()),
                   energies = energy_table(run.kept(), run.observe().energies);
  std::cout << on_screen(cost) << '\n' << on_screen(energies) << std::flush;
  write_tables(folder, markdown(cost) + "\n" + markdown(energies), options, text, run, finished);
  if (!failure.empty()) compare::complain(options.scene + ": " + failure + "; tables, page and stills end there");
  const Recording recording = recording_of_run(folder, scene, run.simulation().model());
  if (options.paraview) write_vtp_series(folder / "paraview", recording);
  // Of the scene's own stills those are left out that --from and --at start after, and --duration ends before.
  std::erase_if(scene.output.stills,
                [&](double t) { return is_before_start(t, scene) || t > run.kept().checkpoint.t; });
  const std::vector<std::filesystem::path> stills = write_stills(folder, recording, scene.output.stills);
  write_page(folder / "page.html", recording);
  std::cout << "\npage: " << (folder / "page.html").string() << '\n';
  for (const std::filesystem::path& still : stills) std::cout << "still: " << still.string() << '\n';
  if (failure.empty() && !finished) {
    compare::complain(
        fmt::format("interrupted at t = {:g} s; the same command goes on from there", run.kept().checkpoint.t));
  }
  return finished ? Exit::success : Exit::negative;
}

}  // namespace

void add_simulate_command(CLI::App& program, compare::Run& run) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = program.add_subcommand("simulate", compare::kSimulateDescription);
  command->footer(
      "Everything is kept in a folder, from which the same command goes on where it was interrupted: tables of steps,\n"
      "energies and loads, states, and the poses of all pairings (docs/simulate.md).\n\n"
      "Examples:\n"
      "  pcm simulate bubbles\n"
      "  pcm simulate pedestrian --integrator bdf\n"
      "  pcm simulate bubbles --stills 0.45,0.5,0.55\n"
      "  pcm simulate bubbles --print > mine.json\n"
      "  pcm simulate mine.json --out mine --integrator bdf\n"
      "  pcm simulate mine.json --from mine --at 1.5 --out finer --relative-tolerance 1e-6");
  CLI::Option* const scene = command->add_option("SCENE", options->scene, built_in_names() + ", or a scene file");
  command->add_option("--out", options->out, "Folder of the run; SCENE-run where it is left out")->type_name("DIR");
  command
      ->add_option("--integrator", options->method,
                   "adams, bdf, ida, dormand_prince, esdirk, rkc or runge_kutta_merson, in place of the scene's")
      ->type_name("METHOD");
  command
      ->add_option("--jacobian", options->jacobian,
                   "differences or tangents, in place of the scene's: of what bdf, ida and esdirk make Jacobians")
      ->type_name("WORD");
  command->add_option("--duration", options->duration, "In s, in place of the scene's")->type_name("S");
  command
      ->add_option("--from", options->from,
                   "Start from a state that a run of this scene, or of one with the same moving bodies and joints, has "
                   "recorded in this folder")
      ->type_name("DIR");
  command->add_option("--at", options->at, "In s: which one; the run begins there, its duration counts from t = 0")
      ->type_name("T");
  command->add_option("--relative-tolerance", options->relative, "In place of the scene's")->type_name("X");
  command->add_option("--absolute-tolerance", options->absolute, "In m, rad, m/s and rad/s, in place of the scene's")
      ->type_name("X");
  command->add_option("--greatest-step", options->greatest_step, "In s, in place of the scene's")->type_name("S");
  command
      ->add_option("--slip-velocity", options->slip_velocity,
                   "In m/s, of every law with friction, in place of the scene's")
      ->type_name("V");
  CLI::Option* const compares = command->add_flag(
      "--compare-integrators", options->compares,
      "In place of a run: every integrator, where it takes Jacobians by differences and by tangents, at several "
      "tolerances and slip velocities; a table and a picture, in the folder SCENE-integrators where --out is left out");
  command
      ->add_option("--spectrum", options->spectrum,
                   "Every so many steps also the eigenvalues of df/dy, in spectrum.csv")
      ->type_name("N");
  command->add_flag("--paraview", options->paraview, "Also write the frames for ParaView: paraview/frames.pvd");
  command
      ->add_option("--stills", options->stills,
                   "In s: also pictures of the recorded states next to these instants, still_T.png; in place of the "
                   "scene's")
      ->type_name("T,T,...");
  for (const char* option : {"--integrator", "--jacobian", "--relative-tolerance", "--absolute-tolerance", "--spectrum",
                             "--paraview", "--stills"})
    compares->excludes(option);
  CLI::Option* const print = command->add_flag("--print", options->print, "Print the scene and run nothing");
  CLI::Option* const schema = command->add_flag("--schema", options->schema, "Print the JSON schema of scene files");
  for (CLI::Option* option : command->get_options()) {
    const bool alone = option == command->get_help_ptr() || option == print || option == schema;
    if (!alone && option != scene) print->excludes(option);
    if (!alone) schema->excludes(option);
  }
  schema->excludes(print);
  command->callback([options, &run] { run = [options] { return simulate(*options); }; });
}

}  // namespace pcm::simulate
