// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

namespace pcm::compare {

/// |((b - a) x (c - a)) . (d - a)| over what the terms of this determinant add up to when each is taken absolutely: how
/// near four points are to lying in one plane, 0 where they do. The determinant is computed exactly and the quotient
/// to a few ulps, so that it tells what rounding could not. 0 where all terms are 0.
double orientation_margin(const std::array<Eigen::Vector3d, 4>& points);

}  // namespace pcm::compare
