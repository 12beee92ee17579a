// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/io/pictures/svg_plot.h"
#include "compare/io/tables/table.h"
#include "compare/stability/stability.h"

namespace pcm::compare::stability {

/// Every figure: a row a point, scheme, group of poses and quantity.
Table stability_table(const StabilityReport& report);
/// Error over condition along each sweep.
Table flatness_table(const StabilityReport& report);
/// Medians of the force along one sweep, both schemes and the published algorithms side by side.
Table force_table(const StabilityReport& report, Sweep sweep);

/// For a screen of 120 columns: the force along every sweep, flatness, and whatever lies outside its bound.
std::string stability_summary(const StabilityReport& report);
std::string stability_markdown(const StabilityReport& report);
/// Error, condition, bound and the published algorithms' errors over what is varied, and error over condition.
Figure stability_figure(const StabilityReport& report, Sweep sweep);
/// The name of its file, without the extension.
std::string stability_picture(Sweep sweep);

/// The last line printed.
std::string stability_verdict(const StabilityReport& report);

}  // namespace pcm::compare::stability
