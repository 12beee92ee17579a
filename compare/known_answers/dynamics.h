// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

/// Dynamic known answers: one body in contact, integrated over a sequence of tolerances, against closed forms.
namespace pcm::compare {

/// One quantity of one motion at one tolerance. Answers that differ in `level` only are a series.
///
/// The bound is made of what the integrator promises and of what the problem makes of it:
///   condition * (2 sqrt(6) rtol * steps + 2^-52 * (steps + 1000) * size / depth) + geometry.
/// A step commits at most sqrt(6) rtol (|y| + scale) <= 2 sqrt(6) rtol scale in a component of the six states;
/// `condition` bounds how much of an error of that size, relative to the scales of depth and velocity, anywhere in the
/// motion, arrives in the quantity, relative to it; it is derived where the motion is described. Where
/// errors decay, a step counts with what is left of its error at the end. The second term is the rounding of positions
/// of the size of the body, and that of the time of the events (100 ulps each).
struct DynamicAnswer {
  std::string id;         ///< e.g. "A12"
  std::string quantity;   ///< e.g. "restitution"
  std::string parameter;  ///< e.g. "z = 0.1, no tension"
  std::string reference;  ///< where the expected value comes from: the formula
  Scheme scheme = Scheme::barycentric;
  Mode mode = Mode::both;
  double tolerance = 0;       ///< of the integrator, relative
  std::string level;          ///< in words: the tolerance or the mesh
  double resolution = 0;      ///< the tolerance, or the mesh's root mean square edge length, m
  bool second_order = false;  ///< the error must be of second order in the resolution
  double computed = 0;
  double expected = 0;
  double bound = 0;  ///< of the relative error; infinite where none is known
  std::int64_t steps = 0;
  std::int64_t derivatives = 0;  ///< asked for by the integrator, each an evaluation of the engine at least

  double relative_error() const;
  bool met() const { return relative_error() <= bound; }
};

/// Which motions are integrated.
struct DynamicPlan {
  std::vector<double> tolerances = {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
  Scheme scheme = Scheme::barycentric;
  Index sphere_level = 3;  ///< of the icosphere of A14 and A15
};

/// A12: vertical bounce of a box on a plate in the three damping modes; A13: damped in the transition depth throughout.
/// Plate and box are masters (mode both): the plate's grid follows the box, so both schemes are exact.
std::vector<DynamicAnswer> flat_bounces(const DynamicPlan& plan);

/// A14: undamped drop of a sphere on a plate, sphere master, guided vertically, with and without gravity; A15: the same
/// sphere, damped, at rest. The bodies are polyhedra: expected is the answer of the polyhedron's own force law in the
/// scheme, which is known in closed form. How far that is from the smooth sphere's is `sphere_geometry`'s.
std::vector<DynamicAnswer> sphere_drops(const DynamicPlan& plan);

/// A16: creep on an incline; A17: stopping distance. A box on a plate, translating; in the barycentric scheme the box
/// is master (the plate's faces don't lie wholly under it), in the clipped scheme both.
std::vector<DynamicAnswer> frictional_slides(const DynamicPlan& plan);

/// A14 and A15 against the smooth sphere's closed form, in the clipped scheme, over icospheres of the given levels; the
/// bound is the tolerance's and that of the geometry: a polyhedron between the spheres r - s and r, whose force at
/// depth h is between K pi (r - s) (h - s)^2 and K pi r^2 h^2 / (r - s). For the contact time there is no such bound.
/// s / h is of second order in the edge length, and so are the errors.
std::vector<DynamicAnswer> sphere_geometry(const std::vector<Index>& levels, double tolerance);

}  // namespace pcm::compare
