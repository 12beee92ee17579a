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

/// The name of the still of an instant, s: still_0.4.png. The number is the shortest that reads back to the same bits,
/// so that two instants never share a name.
std::string still_name(double t);

}  // namespace pcm::simulate
