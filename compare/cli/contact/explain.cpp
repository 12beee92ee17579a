// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/contact/explain.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/cli/contact/surface_files.h"
#include "compare/cli/frame/output_files.h"
#include "compare/cli/frame/pose_options.h"
#include "compare/cli/frame/programs.h"
#include "compare/explain/answer_map.h"
#include "compare/explain/explanation_json.h"
#include "compare/explain/explanation_text.h"
#include "compare/io/names.h"
#include "compare/verify/verdict/case_file.h"
#include "meshes/files/extension.h"
#include "meshes/files/text_file.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "pcm/bad_input.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

struct ExplainCommand {
  std::vector<std::string> files;  ///< a case file, or two surfaces
  std::optional<std::string> named, mode, scheme;
  PoseOptions poses;
  UnitOption unit;
  std::string ulps = "8";
  std::optional<std::string> map;
  std::string map_axes = "xy", map_steps = "16";
  bool all = false;
  bool json = false;
  bool schema = false;
};

/// What is to be explained; what the command line says of mode and scheme comes first.
struct Asked {
  std::string origin;
  TriangleMesh E, F;
  Pose pose;
  Mode mode = Mode::E;
  Scheme scheme = Scheme::barycentric;
  std::vector<std::array<std::string, 2>> disagreements;  ///< of a case file, as it has them
  std::vector<std::string> files;                         ///< that a case file refers to
};

Asked from_case_file(const std::string& path) {
  Case posed = read_case(path);
  return {posed.origin,
          std::move(posed.E),
          std::move(posed.F),
          posed.pose,
          posed.mode,
          posed.scheme,
          std::move(posed.disagreements),
          {posed.file_E.string(), posed.file_F.string()}};
}

/// By its name, or by the id that `pcm poses --catalogue` gives it: catalogue/NAME/both, catalogue/NAME/both/clipped.
Asked from_catalogue(std::string word) {
  const std::string origin = word;
  constexpr std::string_view kBegin = "catalogue/", kMode = "/both", kClipped = "/clipped";
  const bool clipped = word.ends_with(kClipped);
  if (clipped) word.erase(word.size() - kClipped.size());
  if (word.ends_with(kMode)) word.erase(word.size() - kMode.size());
  if (word.starts_with(kBegin)) word.erase(0, kBegin.size());
  degenerate::Case named = degenerate::find_case(word);
  return {fmt::format("{}: {}", origin, named.shows),
          std::move(named.E),
          std::move(named.F),
          {named.A, named.r},
          Mode::both,
          clipped ? Scheme::clipped : Scheme::barycentric,
          {},
          {}};
}

Asked from_surfaces(const std::vector<std::string>& files, double metres_per_unit) {
  auto [E, F] = read_surfaces(files[0], files[1], metres_per_unit);
  return {files[0] + " and " + files[1], std::move(E), std::move(F), {}, Mode::E, Scheme::barycentric, {}, {}};
}

bool is_surface_file(const std::string& file) {
  const std::string extension = extension_of(file);
  return extension == ".obj" || extension == ".off";
}

Asked asked(const ExplainCommand& command) {
  if (command.named.has_value() == !command.files.empty())
    throw BadInput("give a case file, two surfaces, or --pose with the name of a degenerate pose");
  if (command.files.size() > 2) throw BadInput("give one case file or two surfaces, not more");
  if (command.files.size() == 1 && is_surface_file(command.files[0]))
    throw BadInput(command.files[0] + ": one surface alone; give those of E and F, or a case file");
  for (const auto& [option, given] : {std::pair{"--poses", command.poses.poses.has_value()},
                                      std::pair{"--quaternions", command.poses.orientations.quaternions.has_value()},
                                      std::pair{"--orthonormalise", command.poses.orientations.orthonormalise},
                                      std::pair{"--scale", command.unit.scale.has_value()}})
    if (given && command.files.size() != 2)
      throw BadInput(std::string(option) + " goes with two surfaces, not with a case file or a named pose");
  Asked question = command.named               ? from_catalogue(*command.named)
                   : command.files.size() == 1 ? from_case_file(command.files[0])
                                               : from_surfaces(command.files, metres_per_unit(command.unit));
  if (command.mode) question.mode = mode_named(*command.mode);
  if (command.scheme) question.scheme = scheme_named(*command.scheme);
  return question;
}

std::string text_of(const std::vector<std::array<std::string, 2>>& disagreements) {
  if (disagreements.empty()) return {};
  std::string text = "The case file says:\n";
  for (const auto& [kind, words] : disagreements) text += fmt::format("  {}: {}\n", kind, words);
  return text;
}

MapGrid map_grid(const ExplainCommand& command) {
  constexpr std::string_view kAxes = "xyz";
  MapGrid grid;
  for (std::size_t k = 0; k < 2; ++k) grid.axes[k] = static_cast<int>(kAxes.find(command.map_axes.at(k)));
  grid.steps = static_cast<int>(whole_number("--map-steps", command.map_steps, 1, 64));
  return grid;
}

/// The one pose of a file.
Pose only_pose(PosesFile& poses) {
  ReplacementNotice notice;
  const std::optional<State> state = poses.next();
  if (!state) throw BadInput("--map: there is no pose in the file of --poses");
  notice.look_at(*state, poses);
  if (poses.next()) throw BadInput("--map: a map is of one pose; the file of --poses has more");
  return state->pose;
}

Exit write_map(const ExplainCommand& command, Asked question) {
  if (command.json) throw BadInput("--json goes without --map, which writes a picture");
  std::vector<std::string> inputs = command.files;
  if (command.poses.poses) inputs.push_back(*command.poses.poses);
  for (const std::string& file : question.files)
    if (!file.empty()) inputs.push_back(file);
  require_files_of_their_own({{"--map", command.map}}, inputs);
  require_no_standard_output({{"--map", command.map}});
  if (std::optional<PosesFile> poses = poses_from(command.poses, metres_per_unit(command.unit)))
    question.pose = only_pose(*poses);
  const AnswerMap map = answer_map(question.E, question.F, question.pose, map_grid(command));
  write_text_file(*command.map, answer_map_svg(map, question.origin));
  for (const MappedAnswers& row : map.rows)
    std::cout << fmt::format("{:<16} crossings wrong at {:>6} of {} poses\n", row.who, map.wrong(row),
                             map.grid.cells());
  std::cout << fmt::format("{} answers, drawn in {}\n", map.answers.size(), *command.map);
  return Exit::success;
}

Exit explain(const ExplainCommand& command) {
  if (command.schema) {
    std::cout << explanation_schema();
    return Exit::success;
  }
  ExplainOptions options;
  options.near_ulps = positive_number("--ulps", command.ulps);
  Asked question = asked(command);
  if (command.map) return write_map(command, std::move(question));
  if (command.all) options.listed = std::numeric_limits<std::size_t>::max();
  std::optional<PosesFile> poses = poses_from(command.poses, metres_per_unit(command.unit));
  const Explainer explainer(std::move(question.E), std::move(question.F), question.mode, question.scheme);
  const auto print = [&](const Pose& pose, const std::string& origin) {
    const Explanation explanation = explainer.explain(pose, options);
    if (command.json) {
      Json json = explanation_json(explanation, explainer, options, origin);
      if (!question.disagreements.empty()) json["disagreements"] = question.disagreements;
      std::cout << dump_exactly(json) << '\n';
    } else {
      std::cout << origin << '\n'
                << text_of(question.disagreements) << explanation_text(explanation, options, command.all);
    }
    flush_output();
  };
  if (!poses) {
    print(question.pose, question.origin);
    return Exit::success;
  }
  ReplacementNotice notice;
  while (const std::optional<State> state = poses->next()) {
    notice.look_at(*state, *poses);
    if (!command.json && poses->line() > 1) std::cout << '\n';
    try {
      print(state->pose, fmt::format("{}, {}", question.origin, poses->place()));
    } catch (const BadInput& error) {
      throw BadInput(poses->place() + ": " + error.what());
    }
  }
  return Exit::success;
}

}  // namespace

void add_explain_command(CLI::App& program, Run& run) {
  auto options = std::make_shared<ExplainCommand>();
  CLI::App* command = program.add_subcommand("explain", kExplainDescription);
  command->footer(
      "Which vertices, edges and faces of the two surfaces coincide, or nearly do; what penetration lines pass "
      "through\n"
      "(barycentric scheme); by what margin; whether the floating-point filter decides the signs that depend on it, "
      "exact\n"
      "arithmetic or the tie rule, and by which of its displacements; and how near the next pose with another answer "
      "is.\n"
      "All of it is of the rounded problem. Vertices and faces are numbered from 0. docs/explain.md has worked "
      "examples.\n"
      "Examples:\n"
      "  pcm explain --pose vertex_on_edge\n"
      "  pcm explain case_cube-cube_degenerate_17_both.json --all\n"
      "  pcm explain E.obj F.obj --poses poses.txt --json\n"
      "  pcm explain --pose edge_through_vertex --map map.svg");
  command
      ->add_option(
          "FILES", options->files,
          std::string("A case file of 'pcm verify' or 'pcm judge', or the surfaces of E and F, ") + kMeshExtensions)
      ->type_name("FILE");
  command
      ->add_option("--pose", options->named,
                   "Instead: a pose of the degenerate catalogue, by its name or as 'pcm poses --catalogue' calls it")
      ->type_name("NAME");
  add_pose_options(*command, options->poses);
  add_unit_option(*command, options->unit);
  command
      ->add_option("--mode", options->mode,
                   "Whose faces have penetration lines: E, F or both (default: as the case file says; E for surfaces; "
                   "both for a named pose)")
      ->type_name("MODE")
      ->check(CLI::IsMember({"E", "F", "both"}));
  command
      ->add_option(
          "--scheme", options->scheme,
          "barycentric (default, unless the case says otherwise) or clipped, which has no penetration lines to "
          "look at")
      ->type_name("SCHEME")
      ->check(CLI::IsMember({"barycentric", "clipped"}));
  command
      ->add_option("--ulps", options->ulps,
                   "How far apart features nearly coincide, in ulps of the greatest coordinate")
      ->type_name("X")
      ->capture_default_str();
  command
      ->add_option(
          "--map", options->map,
          "Instead: a picture (SVG) of what oracle, engine and the published algorithm of 2003 answer at poses "
          "an ulp apart about this one. They are of crossings, which are alike in all modes and schemes")
      ->type_name("FILE")
      ->excludes("--mode", "--scheme", "--ulps");
  command->add_option("--map-axes", options->map_axes, "Along which axes r is moved there: to the right and upwards")
      ->type_name("AXES")
      ->check(CLI::IsMember({"xy", "yz", "zx", "yx", "zy", "xz"}))
      ->capture_default_str()
      ->needs("--map");
  command->add_option("--map-steps", options->map_steps, "How many ulps it is moved to either side, up to 64")
      ->type_name("N")
      ->capture_default_str()
      ->needs("--map");
  command->add_flag("--all", options->all, "List all coincidences with all their signs, not only the nearest ten")
      ->excludes("--map");
  command->add_flag("--json", options->json, "One JSON object a line for each pose");
  command->add_flag("--schema", options->schema, "Print the JSON schema of such a line instead");
  command->callback([options, &run] { run = [options] { return explain(*options); }; });
}

}  // namespace pcm::compare
