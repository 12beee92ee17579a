// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/contact/inspect.h"

#include <fmt/core.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/cli/contact/surface_files.h"
#include "compare/cli/frame/law_options.h"
#include "compare/cli/frame/output_files.h"
#include "compare/cli/frame/pose_options.h"
#include "compare/cli/frame/programs.h"
#include "compare/io/names.h"
#include "compare/io/pictures/contact_picture.h"
#include "compare/motion/path_report.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

struct InspectOptions {
  std::string file_E, file_F;
  std::string path;
  OrientationOptions orientations;
  UnitOption unit;
  std::string mode = "E";
  std::string scheme = "barycentric";
  std::string steps = std::to_string(JumpSearch().steps);
  std::optional<std::string> least;
  std::vector<std::string> normal;
  bool json = false;
  std::optional<std::string> out;
  std::optional<std::string> svg;
  std::string at = "0";
  std::optional<std::string> view;
  LawOptions law;
};

constexpr std::uint64_t kMostSteps = 1 << 20;

std::vector<Pose> poses_of(const std::string& file, const PoseReading& reading) {
  PosesFile poses(file, reading);
  ReplacementNotice notice;
  std::vector<Pose> path;
  while (const std::optional<State> state = poses.next()) {
    notice.look_at(*state, poses);
    path.push_back(state->pose);
  }
  if (path.size() < 2) throw BadInput(file + ": a path needs at least two poses; add where it leads");
  return path;
}

std::optional<Eigen::Vector3d> normal_from(const std::vector<std::string>& words) {
  if (words.empty()) return {};
  Eigen::Vector3d normal;
  for (int i = 0; i < 3; ++i) normal[i] = finite_number("--normal", words.at(static_cast<std::size_t>(i)));
  if (!(normal.stableNorm() > 0)) throw BadInput("--normal: the null vector has no direction");
  return normal;
}

/// A place as the table has it: the number of the pose before, plus the share of the way to the next.
PathPoint place_from(const std::string& word, const PosePath& path) {
  const double at = nonnegative_number("--at", word);
  const std::size_t segments = path.segments().size();
  if (at > static_cast<double>(segments))
    throw BadInput(fmt::format("--at {}: the path ends at {}; give a number from 0 to {}", word, segments, segments));
  const std::size_t segment = std::min(static_cast<std::size_t>(at), segments - 1);
  const double share = at - static_cast<double>(segment);
  return {segment, static_cast<std::int64_t>(std::llround(share * static_cast<double>(kGrid)))};
}

std::optional<ViewAxis> view_from(const std::optional<std::string>& word) {
  if (!word) return {};
  const std::optional<ViewAxis> view = view_axis_named(*word);
  if (!view) throw BadInput("--view " + *word + ": no axis; give x, -x, y, -y, z or -z (as --view=-x)");
  return view;
}

std::string picture_of(const fast::Pairing& pairing, const InspectOptions& options, const Pose& pose,
                       const std::optional<ViewAxis>& view) {
  fast::Workspace workspace;
  const fast::Contact& contact = fast::evaluate(pairing, pose, Velocity{}, Wanted{}, workspace);
  const auto file_name = [](const std::string& file) { return std::filesystem::path(file).filename().string(); };
  const Eigen::Vector3d& f = contact.force_Me;
  return svg(ContactPicture{
      pairing.surface_E().mesh(), pairing.surface_F().mesh(), pose, contact, view.value_or(best_view(contact)),
      fmt::format("Contact of {} (E) and {} (F)", file_name(options.file_E), file_name(options.file_F)),
      fmt::format(
          "Arrows: circulation; E's part inside F lies on the left seen from outside E, F's part inside E on the "
          "right seen from outside F. Pose {} of {}, mode {}, {} scheme. Force on E: ({:.4g}, {:.4g}, {:.4g}) N.",
          options.at, file_name(options.path), options.mode, options.scheme, f.x(), f.y(), f.z())});
}

std::string json_lines(const PathReport& report) {
  std::string lines;
  for (const ForceJump& jump : report.walk.jumps) lines += dump_exactly(jump_json(jump)) + '\n';
  return lines + dump_exactly({{"path", path_json(report)}}) + '\n';
}

Exit inspect(const InspectOptions& options) {
  JumpSearch search;
  search.steps = static_cast<std::int64_t>(whole_number("--steps", options.steps, 1, kMostSteps));
  if (options.least) search.least = nonnegative_number("--least", *options.least);
  const std::optional<Eigen::Vector3d> normal_Me = normal_from(options.normal);
  const ContactLaw law = law_from(options.law);
  const double unit = metres_per_unit(options.unit);
  const PosePath path(poses_of(options.path, reading_from(options.orientations, unit)));
  auto [mesh_E, mesh_F] = read_surfaces(options.file_E, options.file_F, unit);
  const PathPoint place = place_from(options.at, path);
  const std::optional<ViewAxis> view = view_from(options.view);
  require_files_of_their_own({{"--out", options.out}, {"--svg", options.svg}},
                             {options.file_E, options.file_F, options.path});
  require_no_standard_output({{"--out", options.out}, {"--svg", options.svg}});
  for (const auto& file : {options.out, options.svg})
    if (file) require_writable(*file);  // better refused now than after the work

  const fast::Pairing pairing(fast::Surface(std::move(mesh_E)), fast::Surface(std::move(mesh_F)), law,
                              mode_named(options.mode), scheme_named(options.scheme));
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const PathWalk found = walk(pairing, path, search, [&](std::size_t segment) {
    if (terminal) std::cerr << fmt::format("\rsegment {} of {}", segment + 1, path.segments().size()) << std::flush;
  });
  if (terminal) std::cerr << fmt::format("\r{:<40}\r", "");
  const PathReport report{pairing, path, search, found, path_work(path, found), normal_Me};
  if (options.svg) write_text_file(*options.svg, picture_of(pairing, options, path.at(place), view));
  if (options.out) write_text_file(*options.out, json_lines(report));
  std::cout << (options.json ? json_lines(report) : path_table(report));
  return Exit::success;
}

}  // namespace

void add_inspect_command(CLI::App& program, Run& run) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command = program.add_subcommand("inspect", kInspectDescription);
  command->footer(
      "The path leads through the poses of a file as for 'pcm contact'; velocities are ignored, so that damping and\n"
      "friction do nothing. From pose to pose r moves on a straight line while F turns by at most 180 degrees about a\n"
      "fixed axis through its marker. Each step over which a contact element appears, vanishes or changes its slave\n"
      "face is halved down to neighbouring poses (2^-52 of the way); what undoes itself within a step is not seen.\n"
      "percent: the jump, of the greater of the forces on its two sides. at: number of the pose before, from 0, plus\n"
      "the share of the way to the next; faces are counted from 0.\n"
      "Causes: edge, the line of a face's barycentre moved to another slave face; entry, the barycentre entered or "
      "left\n"
      "the slave; activity, the face became active or not; depth, the line leaves its own body first; flush, a slave\n"
      "face of the same normal passed through the face. 'clamped': to --max-penetration, which limits jumps and makes\n"
      "none. Work is that of the contact on F (E at rest) by the trapezoidal rule, with an estimate of the rule's\n"
      "error; where the last pose is the first, what is left over is what the model gains or loses in a loop.\n"
      "The picture shows the faces around the contact, active ones outlined, those with elements coloured by their\n"
      "penetration, and the intersection polygons with arrows along their circulation.\n"
      "Example:\n"
      "  pcm mesh make plate --subdivisions_x=10 --subdivisions_y=10 -o E.obj\n"
      "  pcm mesh make box --extent_x=0.3 --extent_y=0.3 --extent_z=0.3 -o F.obj\n"
      "  echo '1 0 0  0 1 0  0 0 1   0 0 0.14' > path.txt\n"
      "  echo '1 0 0  0 1 0  0 0 1   0.2 0 0.14' >> path.txt\n"
      "  pcm inspect E.obj F.obj --path path.txt --normal 0,0,1\n"
      "  pcm inspect E.obj F.obj --path path.txt --svg contact.svg --at 0.5");
  command->add_option("E", options->file_E, std::string("Surface of body E, ") + kMeshExtensions)
      ->required()
      ->type_name("FILE");
  command->add_option("F", options->file_F, "Surface of body F")->required()->type_name("FILE");
  command->add_option("--path", options->path, "Where F goes, pose by pose")->type_name("FILE")->required();
  add_orientation_options(*command, options->orientations);
  add_unit_option(*command, options->unit);
  command->add_option("--mode", options->mode, "Whose faces carry the contact elements: E (default), F or both")
      ->type_name("MODE")
      ->check(CLI::IsMember({"E", "F", "both"}));
  command
      ->add_option("--scheme", options->scheme, "How elements sample the penetration: barycentric (default), clipped")
      ->type_name("SCHEME")
      ->check(CLI::IsMember({"barycentric", "clipped"}));
  command->add_option("--steps", options->steps, "Steps from one pose to the next")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--least", options->least,
                   "Changes of a face's force below this share of the greatest force are not looked for (default 1e-9)")
      ->type_name("SHARE");
  command
      ->add_option("--normal", options->normal,
                   "Normal of the plane F slides along: also prints the greatest force within that plane")
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->expected(3);
  CLI::Option* json = command->add_flag("--json", options->json, "One JSON object a jump, then one for the path");
  command->add_option("--out", options->out, "Writes those objects into a file, beside the table")
      ->type_name("FILE")
      ->excludes(json);
  CLI::Option* svg = command->add_option("--svg", options->svg, "Also draws the contact at one place of the path (SVG)")
                         ->type_name("FILE");
  command->add_option("--at", options->at, "That place, as in the column at (default 0, the first pose)")
      ->type_name("PLACE")
      ->needs(svg);
  command
      ->add_option("--view", options->view,
                   "Axis of E's marker from which the picture shows E (F: from the opposite side): x, -x, y, -y, z or "
                   "-z (default: the one that faces E's active area most)")
      ->type_name("AXIS")
      ->needs(svg);
  add_law_options(*command, options->law);
  command->callback([options, &run] { run = [options] { return inspect(*options); }; });
}

}  // namespace pcm::compare
