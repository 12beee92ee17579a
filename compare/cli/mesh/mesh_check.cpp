// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/mesh/mesh_check.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "compare/cli/frame/surface_warnings.h"
#include "fast/surface/prepare_surface.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

Exit check_file(const std::string& file) {
  const TriangleMesh mesh = read_mesh(file);
  const MeshReport report = check(mesh);
  if (const std::string why = report.fit() ? fast::out_of_range(fast::max_coordinates_of(mesh).maxCoeff()) : "";
      !why.empty()) {
    std::cout << mesh.name << ": not fit for contact\n  error: " << why << '\n';
    flush_output();
    return Exit::negative;
  }
  std::cout << report.summary() << '\n';
  const bool has_triangles =
      report.out_of_range_faces.empty() && report.repeated_vertex_faces.empty() && report.non_finite_vertices.empty();
  const std::string crossings = has_triangles ? self_intersection_warning(mesh) : "";
  if (!crossings.empty()) std::cout << "  warning: " << crossings << '\n';
  flush_output();
  return report.fit() ? Exit::success : Exit::negative;
}

Exit check_files(const std::vector<std::string>& files) {
  Exit worst = Exit::success;
  for (const std::string& file : files) {
    Exit status = Exit::bad_input;
    try {
      status = check_file(file);
    } catch (const BadInput& error) {
      complain(error.what());
    }
    worst = std::max(worst, status);
  }
  return worst;
}

}  // namespace

void add_mesh_check_command(CLI::App& mesh, Run& run) {
  auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      mesh.add_subcommand("check", "Say whether surfaces are fit for contact, and if not, why and where");
  command->footer(
      "Open surfaces are fit. Unused vertices and faces that intersect are warned of. Vertices and faces are numbered\n"
      "from 1, as in an OBJ file. Exit status: 0 if all are fit, 1 if one is not, 2 if one can't be read.\n"
      "Example:\n"
      "  pcm mesh check bolt.obj nut.obj");
  command->add_option("FILE", *files, std::string("Surfaces, ") + kMeshExtensions)->required()->type_name("");
  command->callback([files, &run] { run = [files] { return check_files(*files); }; });
}

}  // namespace pcm::compare
