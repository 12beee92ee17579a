// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compare/verify/run/verification_plan.h"

/// Which run a kept state is of.
namespace pcm::compare {

/// The plan with the hashes of its surfaces or recorded states: equal for runs that ask the same of the same program.
nlohmann::ordered_json identity_of(const VerificationPlan& plan);

/// What a plan asks, for people and programs that read its tables: seed, poses, modes, schemes, strata, law, and the
/// hashes of the surfaces.
nlohmann::ordered_json question_of(const VerificationPlan& plan);

/// Whether an identity is of a run with the same arguments, whatever program and surfaces it ran with. An argument that
/// it lacks, or that is unknown here, is another one.
bool same_arguments(const VerificationPlan& plan, const nlohmann::ordered_json& identity);

/// What makes the identity one of another run with the same arguments, e.g. "of another build of pcm"; empty where
/// nothing does.
std::string difference_from(const VerificationPlan& plan, const nlohmann::ordered_json& identity);

}  // namespace pcm::compare
