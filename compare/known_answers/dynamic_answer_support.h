// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/known_answers/dynamics.h"
#include "compare/known_answers/initial_value_problem.h"

/// What the files of the dynamic known answers share.
namespace pcm::compare {

/// The bound of DynamicAnswer without geometry; `size_over_depth` is at least 1.
double dynamic_bound(double tolerance, double steps, double condition, double size_over_depth);

/// Makes the tolerance the answer's level.
void set_tolerance(DynamicAnswer& answer, double tolerance);

/// Fills in what an integration has found and appends it to `answers`.
void append(DynamicAnswer answer, double computed, double expected, double bound, const IntegrationWork& work,
            std::vector<DynamicAnswer>& answers);

/// A number as in "z = 0.1".
std::string number(double x);

}  // namespace pcm::compare
