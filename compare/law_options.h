// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "fast/inputs.h"

namespace pcm::compare {

/// The force law as the command line has it, not yet read: an empty text is an option that was not given.
struct LawOptions {
  std::string stiffness;
  std::string stiffness_E, stiffness_F;
  std::string layer_E, layer_F;
  std::string damping, damping_mode;
  std::string transition_depth;
  std::string friction, slip_velocity;
  std::string max_penetration;
};

/// Adds the law options of the program (--stiffness and so on) to a subcommand.
void add_law_options(CLI::App& command, LawOptions& options);

/// The law that the options describe. Throws BadInput naming the option that is out of its range.
ContactLaw law_from(const LawOptions& options);

}  // namespace pcm::compare
