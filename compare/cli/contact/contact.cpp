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

#include "compare/cli/contact/contact_answers.h"
#include "compare/cli/contact/contact_outputs.h"
#include "compare/cli/contact/surface_files.h"
#include "compare/cli/frame/law_options.h"
#include "compare/cli/frame/pose_options.h"
#include "compare/cli/frame/programs.h"
#include "compare/contact/units.h"
#include "compare/io/names.h"
#include "compare/motion/master_advice.h"
#include "pcm/bad_input.h"
#include "pcm/engine.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

struct ContactOptions {
  std::string file_E, file_F;
  PoseOptions poses;
  std::string engine = "fast";
  std::string mode = "E";
  std::string scheme = "barycentric";
  std::optional<std::string> problem;
  bool bound = false;
  bool advise = false;
  bool no_polygons = false;
  UnitOption unit;
  ContactOutputOptions outputs;
  LawOptions law;
};

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
    use(State{});
    return;
  }
  ReplacementNotice notice;
  while (const std::optional<State> state = poses->next()) {
    notice.look_at(*state, *poses);
    try {
      look(*state);
    } catch (const BadInput& error) {
      throw BadInput(poses->place() + ": " + error.what());
    }
    use(*state);
  }
}

/// Lengths that are likely no metres, unless the user has said what they are.
void remark_on_units(const ContactOptions& options, const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
  if (options.unit.scale) return;
  const LayerThickness thickness{layer_thickness(options.law, Side::E), layer_thickness(options.law, Side::F)};
  if (const std::string remark = millimetre_remark(mesh_E, mesh_F, thickness); !remark.empty())
    complain("remark: " + remark);
}

ContactQuestion question_of(const ContactOptions& options, const ContactLaw& law) {
  ContactQuestion question;
  question.engine = options.engine;
  if (options.problem == "exact") question.problem = reference::Problem::exact;
  question.law = law;
  question.mode = mode_named(options.mode);
  question.scheme = scheme_named(options.scheme);
  question.wanted.bound = options.bound;
  question.wanted.polygons = !options.no_polygons;
  return question;
}

Provenance provenance_of(const ContactOptions& options, const ContactQuestion& question, const TriangleMesh& mesh_E,
                         const TriangleMesh& mesh_F) {
  return {question.engine,
          question.problem == reference::Problem::exact ? "exact" : "rounded",
          question.scheme,
          question.mode,
          question.law,
          metres_per_unit(options.unit),
          surface_origin(options.file_E, mesh_E),
          surface_origin(options.file_F, mesh_F)};
}

Exit contact(const ContactOptions& options) {
  const bool by_oracle = options.engine == "reference";
  if (!by_oracle && options.problem)
    throw BadInput("--problem: the engine knows the rounded problem only; add '--engine reference'");
  if (by_oracle && options.bound)
    throw BadInput("--bound: the oracle's force and torque are correctly rounded; leave out '--engine reference'");
  if (options.bound && options.engine != "fast")
    throw BadInput("--bound: the published algorithms know none; leave out '--engine " + options.engine + "'");
  if (options.advise && (options.outputs.any() || options.no_polygons))
    throw BadInput("--advise gives advice instead of answers; leave out what asks for more of these");
  const ContactLaw law = law_from(options.law);
  const double unit = metres_per_unit(options.unit);
  std::optional<PosesFile> poses = poses_from(options.poses, unit);
  std::vector<std::string> inputs{options.file_E, options.file_F};
  if (options.poses.poses) inputs.push_back(*options.poses.poses);
  require_files_of_their_own(options.outputs, inputs);

  // Unfit surfaces are refused here, alike for engine and oracle.
  SurfacesOfFiles surfaces = read_surfaces(options.file_E, options.file_F, unit);
  TriangleMesh& mesh_E = surfaces.E;
  TriangleMesh& mesh_F = surfaces.F;
  remark_on_units(options, mesh_E, mesh_F);
  if (options.advise) {
    MasterAdviser adviser(fast::Surface(std::move(mesh_E)), fast::Surface(std::move(mesh_F)), law);
    for_each_state(
        poses, [&](const State& state) { adviser.add(state.pose); }, [](const State&) {});
    std::cout << master_advice_text(adviser.advice());
    return Exit::success;
  }
  const ContactQuestion question = question_of(options, law);
  std::optional<ContactOutputs> outputs;
  if (options.outputs.any())
    outputs.emplace(options.outputs, question, mesh_E, mesh_F,
                    [&] { return provenance_of(options, question, mesh_E, mesh_F); });
  const AnswerContact answer_contact =
      contact_answers(question, std::move(mesh_E), std::move(mesh_F), options.outputs.any());
  ContactAnswer answer;
  std::string line;
  for_each_state(
      poses,
      [&](const State& state) {
        answer = answer_contact(state);
        if (outputs) outputs->complete(answer, state);
        line = dump_exactly(answer.json);
      },
      [&](const State& state) {
        // An answer that can't be printed leaves files as they were, a file that can't be written is told of before.
        if (outputs) outputs->prepare();
        print_line(line);
        if (outputs) outputs->write(answer, state);
      });
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
      "--orthonormalise says on standard error, once, that it replaced an orientation; a reflection is always "
      "refused.\n"
      "Without --scale a remark on standard error says where millimetres are likely: both surfaces are 10 m large or "
      "more,\n"
      "or one is a thousand times as large as its layer (--layer-E, --layer-F) is thick.\n"
      "--bound: the key bound of each object holds bounds on force and torque, component by component, and the two\n"
      "numbers between which max_penetration is (null: infinite, numbers come near the end of the range of doubles);\n"
      "flipped: an element or a flush face depends on an ulp.\n"
      "--advise: elements, edges across the contact, error of the barycentric force against the clipped integral "
      "(median\n"
      "and greatest), greatest share of one face (what the force jumps by when that is lost), faces too deep, poses "
      "whose\n"
      "force is lost or clamped, and times, for E, F and both as masters.\n"
      "--full: faces, vertices and edges are numbered from 0 in the order of their files, an edge is named by its "
      "ends; "
      "what\n"
      "each key holds: docs/commands.md.\n"
      "Example:\n"
      "  pcm mesh make box -o E.obj\n"
      "  pcm mesh make icosphere --radius=0.5 -o F.obj\n"
      "  echo '1 0 0  0 1 0  0 0 1   0.1 0 0.9' > poses.txt\n"
      "  pcm contact E.obj F.obj --poses poses.txt --stiffness 1e6 --friction 0.3\n"
      "  pcm contact E.obj F.obj --poses poses.txt --no-polygons --csv contacts.csv --elements elements.csv");
  command->add_option("E", options->file_E, std::string("Surface of body E, ") + kMeshExtensions)
      ->required()
      ->type_name("FILE");
  command->add_option("F", options->file_F, "Surface of body F")->required()->type_name("FILE");
  add_pose_options(*command, options->poses);
  add_unit_option(*command, options->unit);
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
  command
      ->add_flag("--no-polygons", options->no_polygons,
                 "Polygons and patches are not worked out: null in each object, empty in a CSV file")
      ->group("Output");
  add_contact_output_options(*command, options->outputs);
  add_law_options(*command, options->law);
  command->callback([options, &run] { run = [options] { return contact(*options); }; });
}

}  // namespace pcm::compare
