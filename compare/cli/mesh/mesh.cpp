// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/mesh/mesh.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "compare/cli/frame/output_files.h"
#include "compare/cli/frame/programs.h"
#include "compare/cli/mesh/mesh_check.h"
#include "compare/cli/mesh/mesh_make.h"
#include "pcm/bad_input.h"
#include "pcm/read_mesh.h"
#include "pcm/write_obj.h"

namespace pcm::compare {
namespace {

struct ConvertOptions {
  std::string input, output;
};

Exit convert(const ConvertOptions& options) {
  const std::string extension = std::filesystem::path(options.output).extension().string();
  if (extension != ".obj" && extension != ".OBJ")
    throw BadInput(options.output + ": only Wavefront OBJ is written; name the output .obj");
  require_files_of_their_own({{"OUT", options.output}}, {options.input});
  write_obj(read_mesh(options.input), options.output);
  return Exit::success;
}

void add_convert_command(CLI::App& mesh, Run& run) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = mesh.add_subcommand("convert", "Write a surface as Wavefront OBJ, its polygons as triangles");
  command->footer(
      "Vertices keep their order and their coordinates bit for bit. Nothing is repaired.\n"
      "Example:\n"
      "  pcm mesh convert knot.off knot.obj");
  command->add_option("IN", options->input, std::string("Surface to read, ") + kMeshExtensions)
      ->required()
      ->type_name("FILE");
  command->add_option("OUT", options->output, "File to write, .obj")->required()->type_name("FILE");
  command->callback([options, &run] { run = [options] { return convert(*options); }; });
}

}  // namespace

void add_mesh_command(CLI::App& program, Run& run) {
  CLI::App* mesh = program.add_subcommand("mesh", kMeshDescription);
  mesh->require_subcommand(1);
  mesh->footer(
      "Example:\n"
      "  pcm mesh make box -o box.obj\n"
      "  pcm mesh check box.obj");
  add_mesh_check_command(*mesh, run);
  add_mesh_make_command(*mesh, run);
  add_convert_command(*mesh, run);
}

}  // namespace pcm::compare
