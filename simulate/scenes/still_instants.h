// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace pcm::simulate {

/// What is wrong with one more instant, s, beside those that stills are made of already, in a scene of this duration,
/// s: it lies beyond the end, or is there already. Empty where nothing is. That it is a number and not negative, the
/// caller knows.
std::string flaw_of_instant(double t, const std::vector<double>& others, double duration);

}  // namespace pcm::simulate
