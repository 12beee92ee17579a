// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>

#include "compare/bodies/closed_forms.h"
#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/problems.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"

namespace pcm::compare {
namespace {

constexpr double kBall = 1;
constexpr double kHollow = 1.01;
constexpr double kDisplacement = 0.02;
constexpr double kPi = static_cast<double>(closed_forms::kPi);

struct Level {
  Index refinements = 0;
  Index bands = 0;
  fast::Surface ball;
  fast::Surface socket;
  double edge = 0;
};

/// The socket is the coarser one, so that the two geometry errors, of opposite signs, do not cancel.
std::vector<Level> levels_for(Extent extent) {
  std::vector<Level> levels;
  for (Index refinements = 3; refinements <= (extent == Extent::full ? 6 : 5); ++refinements) {
    const Index bands = Index{8} << (refinements - 3);
    const TriangleMesh ball = generate::icosphere(kBall, refinements);
    levels.push_back({refinements, bands, fast::Surface(ball),
                      fast::Surface(generate::socket(kHollow, 0.5, 4 * bands, bands)), mean_edge(ball)});
  }
  return levels;
}

/// Force with this master and the angle at which its contact ends, E the ball.
long double force(Mode master) {
  return master == Mode::E ? closed_forms::sphere_in_socket_sphere_master(kBall, kHollow, kDisplacement)
                           : closed_forms::sphere_in_socket_socket_master(kBall, kHollow, kDisplacement);
}
long double angle(Mode master) {
  return master == Mode::E ? closed_forms::ball_contact_angle(kBall, kHollow, kDisplacement)
                           : closed_forms::hollow_contact_angle(kBall, kHollow, kDisplacement);
}

/// What the meshes do to the force with this master, to leading order.
struct AddedForce {
  double ball = 0;    ///< taken away
  double socket = 0;  ///< added
};

/// The ball's triangles lie e^2 / 8 inside it on the mean and e^2 / 6 at their barycentres, which takes that from the
/// penetration over the projected area pi sin^2 t. The hollow's lie inside the hollow and add to it: a rectangle of
/// sides a (along a meridian) and a sin s, cut in two, lies (a^2 + a^2 sin^2 s) / 12 inside on the mean and by a third
/// more at the barycentres, over the projected area elements 2 pi sin s cos s ds. All of it is divided by the radius.
/// The barycentric scheme samples its master at barycentres, and the slave all over.
AddedForce added_force(const Level& level, Mode master, Scheme scheme) {
  const double a = kHollow * kPi / 2 / level.bands;
  const double sine = std::sin(static_cast<double>(angle(master))), square = sine * sine;
  const double sampled = scheme == Scheme::barycentric ? 4.0 / 3 : 1;
  return {kPi * square * level.edge * level.edge / 8 / kBall * (master == Mode::E ? sampled : 1),
          kPi * a * a / 12 * (square + square * square / 2) / kHollow * (master == Mode::F ? sampled : 1)};
}

AddedForce added_force_in(const Level& level, Mode mode, Scheme scheme) {
  if (mode != Mode::both) return added_force(level, mode, scheme);
  const AddedForce E = added_force(level, Mode::E, scheme), F = added_force(level, Mode::F, scheme);
  return {(E.ball + F.ball) / 2, (E.socket + F.socket) / 2};
}

}  // namespace

std::vector<KnownAnswer> sockets(Extent extent) {
  KnownAnswer problem;
  problem.id = "A6";
  problem.title = "sphere in a near-conforming socket";
  problem.problem =
      "An inscribed icosphere of radius r = 1 m, in fixed orientations, is displaced by d = 0.02 m into a hollow of "
      "radius R = 1.01 m; K = 1 N/m^3. Mean over the orientations.";
  problem.reference =
      "2 pi r^2 times the integral of u cos t sin t, u = r + d cos t - sqrt(R^2 - d^2 sin^2 t) (sphere master), 2 pi "
      "R^2, u = d cos t + sqrt(r^2 - d^2 sin^2 t) - R (socket master), by quadrature; their mean with both";
  const std::vector<Level> levels = levels_for(extent);
  for (const Mode mode : kModes)
    for (const Scheme scheme : kSchemes) {
      Series& series = problem.series.emplace_back();
      series.quantity = "F_z, d/r = 0.02, R/r = 1.01";
      series.mode = mode;
      series.scheme = scheme;
      series.reference = mode == Mode::both ? (force(Mode::E) + force(Mode::F)) / 2 : force(mode);
      series.scale = static_cast<double>(series.reference);
      series.orientations = extent == Extent::full ? kOrientations : 5;
      std::vector<fast::Pairing> pairings;
      for (const Level& level : levels) {
        pairings.emplace_back(level.ball, level.socket, stiffness(1), mode, scheme);
        series.levels.push_back(
            {fmt::format("icosphere {}, socket {} x {}", 20 << (2 * level.refinements), 4 * level.bands, level.bands),
             level.edge,
             faces_of(level.ball, level.socket),
             2 * static_cast<double>(angle(Mode::E)) * kBall / level.edge,
             {}});
      }
      series.measure = [pairings](std::size_t level, int orientation, fast::Workspace& workspace) {
        const Placement placement{fixed_rotation(orientation), {0, 0, -kDisplacement}};
        return load(pairings[level], placement, workspace).force_F.z();
      };
      const auto [ball, socket] = added_force_in(levels.back(), mode, scheme);
      const double leading = (socket - ball) / series.scale, part = extent == Extent::full ? 0.05 : 0.2;
      series.levels.back().deviation = {leading - part * (ball + socket) / series.scale,
                                        leading + part * (ball + socket) / series.scale};
      series.reason = fmt::format("leading terms: socket {:+.3g}, ball {:+.3g}; to {:.0f} % of them",
                                  socket / series.scale, -ball / series.scale, 100 * part);
      if (extent == Extent::full) series.order = Band{1.9, 2.1};
    }
  return {problem};
}

}  // namespace pcm::compare
