// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "compare/cli/frame/command_line.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// In which unit of length the files of a command are.
struct UnitOption {
  std::optional<std::string> scale;
};

/// Adds --scale to a subcommand.
void add_unit_option(CLI::App& command, UnitOption& option);

/// 1 where nothing is said. Throws BadInput where it is no positive number.
double metres_per_unit(const UnitOption& option);

/// The surfaces of a pairing, in metres.
struct SurfacesOfFiles {
  TriangleMesh E, F;
};

/// Prints on standard error what is odd about either. Throws BadInput where a file can't be read or a surface is unfit
/// for contact.
SurfacesOfFiles read_surfaces(const std::string& file_E, const std::string& file_F, double metres_per_unit);

}  // namespace pcm::compare
