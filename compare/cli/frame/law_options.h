// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "compare/cli/frame/command_line.h"
#include "pcm/inputs.h"

namespace pcm::compare {

/// The force law as the command line has it, not yet read; absent is what was not given.
struct LawOptions {
  using Text = std::optional<std::string>;
  Text stiffness;
  Text stiffness_E, stiffness_F;
  Text layer_E, layer_F;
  Text damping, damping_mode;
  Text transition_depth;
  Text friction, slip_velocity;
  Text max_penetration;

  /// Whether any is given.
  bool any() const;
};

/// Adds the law options of the program (--stiffness and so on) to a subcommand.
void add_law_options(CLI::App& command, LawOptions& options);

/// The law that the options describe. Throws BadInput naming the option that is out of its range.
ContactLaw law_from(const LawOptions& options);

/// THICKNESS of --layer-E and --layer-F, m, where they are given. Throws BadInput as law_from does.
std::optional<double> layer_thickness(const LawOptions& options, Side side);

}  // namespace pcm::compare
