// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/mesh/mesh_make.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/cli/frame/output_files.h"
#include "fast/base/geometry.h"
#include "meshes/files/extension.h"
#include "meshes/generate/make.h"
#include "pcm/bad_input.h"
#include "pcm/write_obj.h"

namespace pcm::compare {
namespace {

using Parameters = std::map<std::string, double, std::less<>>;

struct MakeOptions {
  std::string shape;
  std::optional<std::string> output;
  std::vector<std::string> parameters;  ///< the words after the name that are no options of the command itself
};

/// "--name=value" or "--name value", any number of times. The shape says which names there are.
Parameters parameters_from(const std::vector<std::string>& words) {
  Parameters parameters;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.size() < 3 || word.substr(0, 2) != "--")
      throw BadInput("unexpected argument '" + word + "'; parameters are written --name=value");
    const std::size_t equals = word.find('=');
    std::string option = word.substr(0, equals);
    if (equals == std::string::npos && i + 1 == words.size())
      throw BadInput(option + ": its value is missing; write " + option + "=value");
    const std::string value = equals == std::string::npos ? words[++i] : word.substr(equals + 1);
    const double number = finite_number(option, value);
    std::replace(option.begin() + 2, option.end(), '-', '_');  // either will do
    const bool added = parameters.emplace(option.substr(2), number).second;
    if (!added) throw BadInput(option + ": it is given twice");
  }
  return parameters;
}

/// What is written is OBJ, under whatever name but that of another format.
void require_no_other_format(const std::string& output) {
  const std::string extension = extension_of(output);
  for (const char* other : {".off", ".stl", ".ply", ".vtk", ".vtp"})
    if (extension == other) throw BadInput(output + ": only Wavefront OBJ is written; name the output .obj");
}

Exit make_shape(const MakeOptions& options) {
  require_files_of_their_own({{"-o", options.output}}, {});
  if (options.output) require_no_other_format(*options.output);
  const TriangleMesh mesh = make(options.shape, parameters_from(options.parameters));
  double greatest = 0;
  for (const Eigen::Vector3d& x : mesh.vertices) greatest = std::max(greatest, x.cwiseAbs().maxCoeff());
  if (!(greatest <= fast::kGreatestCoordinate))
    throw BadInput(
        fmt::format("{}: with these parameters a coordinate is {:.3g} m, beyond what the engine takes, 2^300 m",
                    options.shape, greatest));
  if (options.output) {
    write_obj(mesh, *options.output);
  } else {
    std::cout << format_obj(mesh);
  }
  return Exit::success;
}

std::string list_of_shapes() {
  std::string text = "Shapes, with their parameters and defaults:\n";
  for (const Shape& shape : shapes()) {
    text += fmt::format("  {}: {}\n", shape.name, shape.description);
    for (const ShapeParameter& parameter : shape.parameters)
      text += fmt::format("      {:<28}{} ({})\n", fmt::format("--{}={}", parameter.name, parameter.default_value),
                          parameter.description, parameter.unit);
  }
  return text;
}

}  // namespace

void add_mesh_make_command(CLI::App& mesh, Run& run) {
  auto options = std::make_shared<MakeOptions>();
  CLI::App* command = mesh.add_subcommand("make", "Generate a surface and write it as Wavefront OBJ");
  command->footer(std::string());  // Inherited from the parent, it would be printed after the one below.
  command->footer([] {
    return list_of_shapes() +
           "Example:\n"
           "  pcm mesh make torus --tube_radius=0.1 -o torus.obj";
  });
  command->add_option("NAME", options->shape, "The shape; the words after it are its parameters, --name=value")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", options->output, "File to write (default: standard output)")->type_name("FILE");
  command->allow_extras();
  command->callback([options, command, &run] {
    options->parameters = command->remaining();
    run = [options] { return make_shape(*options); };
  });
}

}  // namespace pcm::compare
