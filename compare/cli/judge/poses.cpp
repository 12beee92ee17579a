// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/judge/poses.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/cli/frame/programs.h"
#include "compare/cli/verify/verify_run.h"
#include "compare/judge/poses/catalogue_poses.h"
#include "compare/judge/poses/poses_folder.h"
#include "compare/judge/poses/write_poses.h"

namespace pcm::compare {
namespace {

struct PosesOptions {
  VerifyOptions plan;
  bool catalogue = false;
  std::string law = "drawn";
  bool hexadecimal = false;

  Notation notation() const { return hexadecimal ? Notation::hexadecimal : Notation::decimal; }
};

Exit say_what_is_there(std::int64_t poses, const std::filesystem::path& folder) {
  std::cout << fmt::format("{} poses in {}\n", poses, (folder / kPosesFile).string());
  return Exit::success;
}

Exit poses(const PosesOptions& options) {
  if (options.catalogue) {
    const std::filesystem::path folder = *prepared_folder(options.plan);
    return say_what_is_there(write_catalogue_poses(folder, options.notation()), folder);
  }
  const int jobs = number_of_jobs(options.plan);
  std::vector<std::string> notices;
  VerificationPlan plan =
      options.plan.trajectory ? plan_from_trajectory(options.plan, notices) : plan_from(options.plan, notices);
  const std::filesystem::path folder = *prepared_folder(options.plan);
  std::optional<Interruptible> work(std::in_place, plan.poses);
  const PlannedPoses planned(std::move(plan));
  for (const std::string& notice : notices) complain(notice);
  for (const std::string& omission : planned.omissions()) complain(omission);
  std::int64_t written = 0;
  const bool whole = write_poses(
      folder, planned, posed_law_named(options.law), options.notation(), jobs, [&] { return work->interrupted(); },
      [&](std::int64_t lines) {
        written = lines;
        work->show(lines);
      });
  work.reset();
  if (!whole) {
    const std::filesystem::path file = folder / kPosesFile;
    std::cout << (std::filesystem::exists(file)
                      ? fmt::format("interrupted: {} and its surfaces are those of an earlier run\n", file.string())
                      : "interrupted: no poses are left behind\n");
    return Exit::negative;
  }
  return say_what_is_there(written, folder);
}

}  // namespace

void add_poses_command(CLI::App& program, Run& run) {
  auto options = std::make_shared<PosesOptions>();
  options->plan.usual_strata = true;
  CLI::App* command = program.add_subcommand("poses", kPosesDescription);
  command->footer(
      "The folder gets poses.jsonl, whose first line names the surfaces and whose others are a pose each, and the\n"
      "surfaces as OBJ files. docs/judge.md says what stands there and which conventions hold; 'pcm judge --schema\n"
      "poses' prints the schema of a line. The poses are those that 'pcm verify' with the same arguments and strata\n"
      "asks about, each with the law, the scheme and the mode that it asks with, under the name that its tables have.\n"
      "Examples:\n"
      "  pcm poses --out poses --poses 2000\n"
      "  pcm poses --out poses --pair bolt.obj nut.obj --strata generic,degenerate --scheme barycentric");
  command->add_option("--out", options->plan.out, "Folder for poses and surfaces")->type_name("DIR")->required();
  add_plan_options(*command, options->plan);
  command
      ->add_option("--trajectory", options->plan.trajectory,
                   "The poses of this recorded trajectory (trajectory/trajectory.json of a folder of `pcm simulate`) "
                   "instead of random ones")
      ->type_name("FILE")
      ->excludes("--seed", "--strata", "--pair");
  command
      ->add_flag("--catalogue", options->catalogue,
                 "The named degenerate cases instead, each in mode both and in either scheme, with the volume of the "
                 "intersection (known_volume) where it was worked out by hand")
      ->excludes("--poses", "--seed", "--strata", "--pair", "--mode", "--scheme", "--trajectory");
  command
      ->add_option(
          "--law", options->law,
          "drawn: a law and a velocity drawn for each pose; pair: the pair's own law, as 'pcm verify --engine' "
          "asks; elastic: at rest, with stiffness alone, for engines with another law of damping and friction")
      ->type_name("WHICH")
      ->check(CLI::IsMember({"drawn", "pair", "elastic"}))
      ->capture_default_str()
      ->excludes("--catalogue");
  command->add_option("--jobs", options->plan.jobs, "Threads (default: as many as cores)")->type_name("N");
  command->add_flag("--hex", options->hexadecimal, "Doubles as C hexadecimal floating point in quotes");
  command->callback([options, &run] { run = [options] { return poses(*options); }; });
}

}  // namespace pcm::compare
