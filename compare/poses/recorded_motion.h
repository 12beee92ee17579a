// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "compare/poses/strata.h"
#include "compare/random/random.h"

/// The stratum trajectory: poses and velocities that a simulation has gone through.
namespace pcm::compare {

/// Where F was, seen from E, at the end of an accepted step, and how it moved: unit quaternion w, x, y, z of A, to some
/// digits; r, m; v, m/s; w, rad/s. Frames as in Pose and Velocity.
using RecordedStep = std::array<double, 13>;

/// Steps one after the other, two at least; signs of the quaternions go on from one to the next.
using RecordedStretch = std::vector<RecordedStep>;

/// State of a step, or of numbers between those of two steps: the quaternion need not be of length 1.
MovingPose state_of(const RecordedStep& step);

/// A state between two neighbouring steps of one of the stretches, which has at least one: numbers are taken linearly
/// between theirs. `before` is how F came there: along the line of its first velocity, from one size of the smaller
/// body away, where it has a velocity, then step by step. So a state is a function of the recording and of the random
/// numbers alone, however short the recording is, and with all that an engine which remembers can remember of it;
/// nothing depends on what was asked before.
DrawnPose draw_along(const std::vector<RecordedStretch>& motion, double size, PoseRandom random);

}  // namespace pcm::compare
