// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "simulate/record/noted_table.h"
#include "simulate/run/integrator_comparison.h"

namespace pcm::simulate {

/// All trials.
NotedTable comparison_table(const IntegratorComparison& comparison);

/// Two plots as an SVG picture: the error at the end over the evaluations, a marker a tolerance, and evaluations over
/// the slip velocity.
std::string comparison_picture(const std::string& title, const IntegratorComparison& comparison);

}  // namespace pcm::simulate
