// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/contact/contact.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "compare/cli/contact/law_options.h"
#include "compare/cli/frame/programs.h"
#include "compare/cli/frame/surface_warnings.h"
#include "compare/io/contact_json.h"
#include "compare/io/names.h"
#include "compare/io/poses_file.h"
#include "compare/motion/master_advice.h"
#include "compare/wrong_answers/tested_engine.h"
#include "pcm/bad_input.h"
#include "pcm/engine.h"
#include "pcm/read_mesh.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

struct ContactOptions {
  std::string file_E, file_F;
  std::optional<std::string> poses;
  std::string engine = "fast";
  std::string mode = "E";
  std::string scheme = "barycentric";
  std::optional<std::string> problem;
  bool bound = false;
  bool advise = false;
  LawOptions law;
};

/// The pairing as either of the two sees it: the answer to one state.
using Evaluate = std::function<Json(const State&)>;

Evaluate evaluate_by_engine(Engine engine, TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode,
                            Scheme scheme, bool with_bound) {
  const std::shared_ptr<const TestedEngine> tested =
      make_tested_engine(engine, std::move(mesh_E), std::move(mesh_F), law, mode, scheme);
  auto workspace = std::make_shared<TestedEngineWorkspace>();
  Wanted wanted;
  wanted.bound = with_bound;
  return [=](const State& state) {
    Json json = contact_json(tested->evaluate(state.pose, state.velocity, wanted, *workspace));
    if (engine != Engine::fast)
      for (const char* side : {"E", "F"}) json[side]["area"] = json[side]["vector_area"] = nullptr;
    return json;
  };
}

Evaluate evaluate_by_oracle(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode, Scheme scheme,
                            reference::Problem problem) {
  auto oracle = std::make_shared<const reference::Oracle>(std::move(mesh_E), std::move(mesh_F), law, mode, scheme);
  return [oracle, problem](const State& state) {
    return contact_json(oracle->answer(problem, state.pose, state.velocity));
  };
}

/// Each line leaves as soon as it is there, so that what was printed before an error or an interruption is whole.
void print_line(const std::string& answer) {
  std::cout << answer << '\n';
  flush_output();
}

/// Calls `look` and then `use` for each state of the file, or for the identity at rest; what `look` throws gets the
/// file's line.
template <class Look, class Use>
void for_each_state(std::optional<PosesFile>& poses, const Look& look, const Use& use) {
  if (!poses) {
    look(State{});
    use();
    return;
  }
  while (const std::optional<State> state = poses->next()) {
    try {
      look(*state);
    } catch (const BadInput& error) {
      throw BadInput(poses->place() + ": " + error.what());
    }
    use();
  }
}

Exit contact(const ContactOptions& options) {
  const bool by_oracle = options.engine == "reference";
  if (!by_oracle && options.problem)
    throw BadInput("--problem: the engine knows the rounded problem only; add '--engine reference'");
  if (by_oracle && options.bound)
    throw BadInput("--bound: the oracle's force and torque are correctly rounded; leave out '--engine reference'");
  if (options.bound && options.engine != "fast")
    throw BadInput("--bound: the published algorithms know none; leave out '--engine " + options.engine + "'");
  const ContactLaw law = law_from(options.law);
  std::optional<PosesFile> poses;
  if (options.poses) poses.emplace(*options.poses);

  // Unfit surfaces are refused here, alike for engine and oracle.
  TriangleMesh mesh_E = read_mesh(options.file_E);
  const std::string warning_E = require_fit_or_warn(mesh_E);
  TriangleMesh mesh_F = read_mesh(options.file_F);
  print_warnings(warning_E, require_fit_or_warn(mesh_F));
  if (options.advise) {
    MasterAdviser adviser(fast::Surface(std::move(mesh_E)), fast::Surface(std::move(mesh_F)), law);
    for_each_state(
        poses, [&](const State& state) { adviser.add(state.pose); }, [] {});
    std::cout << master_advice_text(adviser.advice());
    return Exit::success;
  }
  const Mode mode = mode_named(options.mode);
  const Scheme scheme = scheme_named(options.scheme);
  const auto problem = options.problem == "exact" ? reference::Problem::exact : reference::Problem::rounded;
  const Evaluate evaluate = by_oracle
                                ? evaluate_by_oracle(std::move(mesh_E), std::move(mesh_F), law, mode, scheme, problem)
                                : evaluate_by_engine(engine_named(options.engine), std::move(mesh_E), std::move(mesh_F),
                                                     law, mode, scheme, options.bound);
  std::string answer;
  for_each_state(
      poses, [&](const State& state) { answer = dump_exactly(evaluate(state)); }, [&] { print_line(answer); });
  return Exit::success;
}

}  // namespace

void add_contact_command(CLI::App& program, Run& run) {
  auto options = std::make_shared<ContactOptions>();
  CLI::App* command = program.add_subcommand("contact", kContactDescription);
  command->footer(
      "Force and torque (about F's marker) act on E; all vectors are resolved in E's marker, in SI units.\n"
      "touching: the surfaces cross; nested: a component of one lies inside the other without crossing; E, F: "
      "intersected\n"
      "and inner faces, clipped active area; volume: of the intersection, null where a surface is open; elements: "
      "with\n"
      "penetration; too_deep: faces whose line of penetration leaves their own body first; patches: separate "
      "contacts.\n"
      "A poses file holds one pose a line: 12 numbers, the rotation A by rows, then r (x_E = A x_F + r); or 18, with\n"
      "v and w of F relative to E; decimal or C hexadecimal floats; comments from # on. Without it: A = 1, r = 0, at "
      "rest.\n"
      "--bound: the key bound of each object holds bounds on force and torque, component by component, and the two\n"
      "numbers between which max_penetration is (null: infinite, numbers come near the end of the range of doubles);\n"
      "flipped: an element or a flush face hangs on an ulp.\n"
      "--advise: elements, edges across the contact, error of the barycentric force against the clipped integral "
      "(median\n"
      "and greatest), greatest share of one face (what the force jumps by when that is lost), faces too deep, poses "
      "whose\n"
      "force is lost or clamped, and times, for E, F and both as masters.\n"
      "Example:\n"
      "  pcm mesh make box -o E.obj\n"
      "  pcm mesh make icosphere --radius=0.5 -o F.obj\n"
      "  echo '1 0 0  0 1 0  0 0 1   0.1 0 0.9' > poses.txt\n"
      "  pcm contact E.obj F.obj --poses poses.txt --stiffness 1e6 --friction 0.3");
  command->add_option("E", options->file_E, std::string("Surface of body E, ") + kMeshExtensions)
      ->required()
      ->type_name("FILE");
  command->add_option("F", options->file_F, "Surface of body F")->required()->type_name("FILE");
  command->add_option("--poses", options->poses, "Where F is, pose by pose (default: the identity, at rest)")
      ->type_name("FILE");
  CLI::Option* engine =
      command
          ->add_option("--engine", options->engine,
                       "Who answers: fast (default), reference, the exact oracle, or, to compare, published-2003, the "
                       "paper's algorithm in plain floating point, or published-2023, its author's later variant "
                       "(without polygons, blind beyond half the smaller body); the last two know no areas")
          ->type_name("WHO")
          ->check(CLI::IsMember({"fast", "reference", "published-2003", "published-2023"}));
  CLI::Option* mode =
      command->add_option("--mode", options->mode, "Whose faces carry the contact elements: E (default), F or both")
          ->type_name("MODE")
          ->check(CLI::IsMember({"E", "F", "both"}));
  CLI::Option* scheme =
      command
          ->add_option(
              "--scheme", options->scheme,
              "How elements sample the penetration: barycentric (default), once a face, or clipped, its integral")
          ->type_name("SCHEME")
          ->check(CLI::IsMember({"barycentric", "clipped"}));
  CLI::Option* problem =
      command
          ->add_option("--problem", options->problem,
                       "With --engine reference: rounded (default; F's vertices rounded into E's marker) or exact")
          ->type_name("PROBLEM")
          ->check(CLI::IsMember({"rounded", "exact"}));
  CLI::Option* bound =
      command->add_flag("--bound", options->bound,
                        "Also rigorous bounds on the rounding errors of force and torque (with --engine fast)");
  command
      ->add_flag("--advise", options->advise,
                 "Instead: which surface should be master at these poses and why, a table and a sentence")
      ->excludes(engine, mode, scheme, problem, bound);
  add_law_options(*command, options->law);
  command->callback([options, &run] { run = [options] { return contact(*options); }; });
}

}  // namespace pcm::compare
