// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "compare/poses/strata.h"
#include "compare/random/random.h"
#include "pcm/inputs.h"

/// Force laws and velocities drawn for a pose, with the weight on where a law changes its branch. Pure functions of the
/// random numbers and of the figures handed in; the same bits on every machine.
///
/// A law is drawn in three steps, for its thresholds are to lie at figures that depend on what was drawn before: speeds
/// of elements depend on their positions, these on layers and on max_penetration. Callers who want thresholds exactly
/// at an element's figures work these out between the steps; `draw_law` takes all steps with the figures of one law.
///
/// Figures outside the limits of thresholds (law_thresholds.h) count as not handed in.
namespace pcm::compare {

/// A law without thresholds: no transition depth, no slip velocity, no greatest penetration.
///
/// - damping mode: each of the three in a third of the draws;
/// - stiffness: plain in half, else layers; of these a quarter with E rigid, a quarter with F rigid, half with both
///   elastic, either one the stiffer by a ratio between 1 and 2^40: half of the ratios powers of two, each of the 41 as
///   often, the others log-uniform. The softer layer between 2^10 and 2^30 N/m^3;
/// - damping: 0 in a quarter, else that layer's stiffness times 2^-12 to 2^4 s;
/// - friction: 0 in a quarter, else 2^-6 to 2.
ContactLaw draw_law_without_thresholds(PoseRandom& random);

/// Draws transition depth and greatest penetration. `size`: of the smaller body, m. `penetrations`: of elements, m.
///
/// - transition_depth: 0, generic (2^-20 to 1 sizes), at an element's penetration, within 1 to 4 ulps of one, each in a
///   quarter; generic instead of the last two where no penetration is handed in;
/// - max_penetration: infinite in half; in a quarter generic: strictly between two drawn penetrations where there is a
///   double between them, else 2^-20 to 1 sizes; at one and within 1 to 4 ulps of one in an eighth each, generic where
///   none is handed in.
void draw_depths(PoseRandom& random, double size, std::span<const double> penetrations, ContactLaw& law);

/// Draws the slip velocity. `speeds`: tangential, of elements, m/s.
///
/// - slip_velocity: 0, generic (2^-14 to 2^4 sizes a second), at an element's speed, within 1 to 4 ulps of one, each in
///   a quarter; generic instead of the last two where no speed is handed in.
void draw_slip_velocity(PoseRandom& random, double size, std::span<const double> speeds, ContactLaw& law);

/// All three steps.
ContactLaw draw_law(PoseRandom& random, double size, std::span<const double> penetrations,
                    std::span<const double> speeds);

/// A velocity for a pose: |v| of 2^-14 to 2^7 sizes of the smaller body a second, |w| of 2^-14 to 2^7 rad/s. An eighth
/// of the draws each: at rest; v = 0; v along the normal of a drawn face of E, either way, w = 0; the same of F, its
/// normal turned into Me; v in the plane of a drawn face of E, w = 0. In a quarter v has any direction and w = 0, in
/// the last eighth both are drawn.
///
/// Faces orthogonal to an axis are drawn in half of the draws that have a face, where there are any: v is then along an
/// axis exactly (of F: where the pose turns axes into axes).
Velocity draw_velocity(PoseRandom& random, const FeaturePair& pair, const Pose& pose);

}  // namespace pcm::compare
