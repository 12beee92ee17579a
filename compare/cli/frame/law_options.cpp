// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/law_options.h"

#include <CLI/CLI.hpp>
#include <limits>
#include <vector>

#include "compare/cli/frame/command_line.h"
#include "compare/io/split_at_commas.h"
#include "pcm/bad_input.h"
#include "pcm/layer_stiffness.h"

namespace pcm::compare {
namespace {

constexpr double kRigid = std::numeric_limits<double>::infinity();

/// A positive number or "inf".
double positive_or_rigid(const std::string& option, const std::string& text) {
  return text == "inf" ? kRigid : positive_number(option, text);
}

/// The parts of YOUNG,NU,THICKNESS.
std::vector<std::string> parts_of_layer(const std::string& option, const std::string& text) {
  std::vector<std::string> parts = split_at_commas(text);
  if (parts.size() != 3)
    throw BadInput(option + ": '" + text + "' is not YOUNG,NU,THICKNESS, three numbers with commas");
  return parts;
}

/// Stiffness of a layer given as YOUNG,NU,THICKNESS.
double stiffness_of_layer(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = parts_of_layer(option, text);
  const bool rigid = parts[0] == "inf";
  const double young = rigid ? 1 : positive_number(option, parts[0]);
  const double poisson = finite_number(option, parts[1]);
  const double thickness = positive_number(option, parts[2]);
  try {
    // Of a rigid layer only Poisson's ratio is left to be looked at.
    const double stiffness = fast::layer_stiffness(young, poisson, rigid ? 1 : thickness);
    return rigid ? kRigid : stiffness;
  } catch (const BadInput& error) {
    throw BadInput(option + ": " + error.what());
  }
}

DampingMode damping_mode_named(const std::string& name) {
  if (name == "full") return DampingMode::full;
  if (name == "compression") return DampingMode::compression;
  return DampingMode::no_tension;
}

}  // namespace

bool LawOptions::any() const {
  return stiffness || stiffness_E || stiffness_F || layer_E || layer_F || damping || damping_mode || transition_depth ||
         friction || slip_velocity || max_penetration;
}

void add_law_options(CLI::App& command, LawOptions& options) {
  const auto add = [&command](const std::string& name, LawOptions::Text& text, const std::string& type,
                              const std::string& description) {
    return command.add_option(name, text, description)->type_name(type)->group("Force law");
  };
  CLI::Option* stiffness =
      add("--stiffness", options.stiffness, "c_l", "Areal stiffness of both layers together, N/m^3 (default 1e6)");
  CLI::Option* stiffness_E =
      add("--stiffness-E", options.stiffness_E, "c_E", "Instead: stiffness of E's layer, N/m^3; inf if rigid");
  CLI::Option* stiffness_F = add("--stiffness-F", options.stiffness_F, "c_F", "The same of F's layer");
  CLI::Option* layer_E =
      add("--layer-E", options.layer_E, "YOUNG,NU,THICKNESS",
          "Instead: Young's modulus (Pa; inf if rigid), Poisson's ratio and thickness (m) of E's layer");
  CLI::Option* layer_F = add("--layer-F", options.layer_F, "YOUNG,NU,THICKNESS", "The same of F's layer");
  stiffness_E->needs(stiffness_F);
  stiffness_F->needs(stiffness_E);
  layer_E->needs(layer_F);
  layer_F->needs(layer_E);
  for (CLI::Option* layer : {layer_E, layer_F}) {
    layer->excludes(stiffness)->excludes(stiffness_E)->excludes(stiffness_F);
  }
  stiffness->excludes(stiffness_E)->excludes(stiffness_F);

  add("--damping", options.damping, "d_l", "Areal damping, N s/m^3 (default 0)");
  add("--damping-mode", options.damping_mode, "MODE",
      "no-tension (default): the normal force never pulls; full: it may; compression: damping only while approaching")
      ->check(CLI::IsMember({"no-tension", "full", "compression"}));
  add("--transition-depth", options.transition_depth, "u_d",
      "Penetration up to which damping fades in, m (default 0: no fade)");
  add("--friction", options.friction, "mu", "Coefficient of friction (default 0)");
  add("--slip-velocity", options.slip_velocity, "v_eps",
      "Sliding velocity below which friction is regularised, m/s (default 0)");
  add("--max-penetration", options.max_penetration, "u_max",
      "Penetration beyond which elements are clamped and the answer flagged, m (default: none)");
}

ContactLaw law_from(const LawOptions& options) {
  ContactLaw law;
  if (options.stiffness) law.stiffness = positive_number("--stiffness", *options.stiffness);
  if (options.stiffness_E) {
    law.layers = {positive_or_rigid("--stiffness-E", *options.stiffness_E),
                  positive_or_rigid("--stiffness-F", *options.stiffness_F)};
  } else if (options.layer_E) {
    law.layers = {stiffness_of_layer("--layer-E", *options.layer_E), stiffness_of_layer("--layer-F", *options.layer_F)};
  }
  if (law.layers && law.layers->c_E == kRigid && law.layers->c_F == kRigid) {
    const std::string given = options.stiffness_E ? "--stiffness-E and --stiffness-F" : "--layer-E and --layer-F";
    throw BadInput(given + ": both bodies are rigid; give one of them a finite stiffness");
  }
  if (options.damping) law.damping = nonnegative_number("--damping", *options.damping);
  if (options.damping_mode) law.damping_mode = damping_mode_named(*options.damping_mode);
  if (options.transition_depth)
    law.transition_depth = nonnegative_number("--transition-depth", *options.transition_depth);
  if (options.friction) law.friction = nonnegative_number("--friction", *options.friction);
  if (options.slip_velocity) law.slip_velocity = nonnegative_number("--slip-velocity", *options.slip_velocity);
  if (options.max_penetration) law.max_penetration = positive_number("--max-penetration", *options.max_penetration);
  return law;
}

std::optional<double> layer_thickness(const LawOptions& options, Side side) {
  const std::string option = side == Side::E ? "--layer-E" : "--layer-F";
  const LawOptions::Text& text = side == Side::E ? options.layer_E : options.layer_F;
  if (!text) return std::nullopt;
  return positive_number(option, parts_of_layer(option, *text)[2]);
}

}  // namespace pcm::compare
