// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/contact/surface_files.h"

#include <CLI/CLI.hpp>
#include <utility>

#include "compare/cli/frame/surface_warnings.h"
#include "compare/contact/units.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

TriangleMesh read_scaled_mesh(const std::string& file, double metres_per_unit) {
  TriangleMesh mesh = read_mesh(file);
  if (metres_per_unit != 1) scale(mesh, metres_per_unit);
  return mesh;
}

}  // namespace

void add_unit_option(CLI::App& command, UnitOption& option) {
  command
      .add_option("--scale", option.scale,
                  "Metres for each unit of length in the files: vertices, and r and v of poses, are multiplied by it "
                  "(default 1); all else, answers too, is in SI units")
      ->type_name("S");
}

double metres_per_unit(const UnitOption& option) {
  return option.scale ? positive_number("--scale", *option.scale) : 1;
}

SurfacesOfFiles read_surfaces(const std::string& file_E, const std::string& file_F, double metres_per_unit) {
  TriangleMesh E = read_scaled_mesh(file_E, metres_per_unit);
  const std::string warning_E = require_fit_or_warn(E);
  TriangleMesh F = read_scaled_mesh(file_F, metres_per_unit);
  print_warnings(warning_E, require_fit_or_warn(F));
  return {std::move(E), std::move(F)};
}

}  // namespace pcm::compare
