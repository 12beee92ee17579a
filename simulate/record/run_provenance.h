// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compare/io/tables/column_units.h"
#include "simulate/run/integrator_comparison.h"
#include "simulate/scenes/scene.h"

/// What stands beside the tables of a run, so that they can be made again.
namespace pcm::simulate {

/// What the command line may have changed in the scene as its file has it.
nlohmann::ordered_json settings_of(const Scene& scene);

nlohmann::ordered_json pairing_json(const ScenePairing& pairing);

/// What was asked, for compare::ReportFolder: scene, settings, and hashes of the scene's text and of the surfaces.
/// `complete`: the run has come to the scene's end.
nlohmann::ordered_json question_of_run(const std::string& scene_name, const std::string& scene_text, const Scene& scene,
                                       bool complete);

/// The same of a comparison of integrators, which tries several tolerances and slip velocities.
nlohmann::ordered_json question_of_comparison(const std::string& scene_name, const std::string& scene_text,
                                              const Scene& scene, const IntegratorComparison& comparison);

/// Of the columns of the tables that run_folder.h lists, those of states given.
compare::ColumnUnits run_column_units(const std::vector<StateColumn>& of_states);

}  // namespace pcm::simulate
