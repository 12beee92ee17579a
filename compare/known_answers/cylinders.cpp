// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>

#include "compare/bodies/closed_forms.h"
#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/problems.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"

namespace pcm::compare {
namespace {

constexpr double kRadius = 1;
constexpr double kLength = 1;

/// Chord of a regular polygon inscribed in a circle of radius 1.
double chord(Index segments) {
  return 2 * std::sin(static_cast<double>(closed_forms::kPi) / segments);
}

/// Turns the z axis into the y axis, exactly.
Eigen::Matrix3d lying() {
  Eigen::Matrix3d R;
  R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return R;
}

std::vector<Index> segments_of(Extent extent) {
  return extent == Extent::full ? std::vector<Index>{64, 128, 256, 512} : std::vector<Index>{64, 128, 256};
}

/// Both sums run over whole periods of the polygon only on the mean over the orientations; the rest stays below 5 % of
/// the leading term where the contact is 50 edges wide.
void expect(Series& series, double leading, Extent extent) {
  const double part = extent == Extent::full ? 0.05 : 0.15;
  const double e = series.levels.back().edge;
  series.levels.back().deviation = between(1 - part, 1 + part, leading * e * e);
  if (extent == Extent::full) series.order = Band{1.9, 2.1};
  series.reason =
      fmt::format("leading term of the inscribed polygon: {:.4g} (e/r)^2, to {:.0f} %", leading, 100 * part);
}

/// Mean deviation from the closed form, relative, divided by the edge length squared (radius 1). A chord lies e^2 / 12
/// inside the circle on the mean and is shorter than its arc by e^2 / 24. Cylinder master: F is the integral of the
/// depth over the wetted arc of half-angle t; the depth falls by e^2 / 12 cos t. Plane master: F is the area of the
/// segment. Barycentric: the second moment of a triangle across the border is e^2 / 18; each of the two borders, of
/// slope sin t, loses half of it with the cylinder as master.
double leading_on_plane(Mode mode, Scheme scheme, double h) {
  const auto cylinder = static_cast<double>(closed_forms::cylinder_on_plane_cylinder_master(kRadius, h));
  const auto plane = static_cast<double>(closed_forms::cylinder_on_plane_plane_master(kRadius, h));
  const double t = std::acos(1 - h);
  const double border = scheme == Scheme::barycentric ? std::sin(t) / 18 : 0;
  const double by_cylinder = -std::sin(t) / 6 - cylinder / 24 - border;
  const double by_plane = -t / 6;
  if (mode == Mode::E) return by_cylinder / cylinder;
  if (mode == Mode::F) return by_plane / plane;
  return (by_cylinder + by_plane) / (cylinder + plane);
}

/// E the cylinder, F the plate. The cylinder's ends lie over grid lines of the plate, which is longer; so every element
/// of the plate is either under the cylinder along all its length or not at all.
KnownAnswer cylinder_on_plane(Extent extent) {
  KnownAnswer problem;
  problem.id = "A5";
  problem.title = "cylinder on plane";
  problem.problem =
      "An inscribed cylinder of radius r = 1 m and length 1 m, rolled about its axis, is pressed by h into the top of "
      "a "
      "longer plate; K = 1 N/m^3. Force per length, mean over the orientations.";
  problem.reference =
      "cylinder master K 2r (r sin t - (r - h) t), plane master K (r^2 t - (r - h) sqrt(2rh - h^2)), cos t = 1 - h/r; "
      "their mean with both";
  for (const double h : {0.05, 0.2})
    for (const Mode mode : kModes)
      for (const Scheme scheme : kSchemes) {
        Series& series = problem.series.emplace_back();
        series.quantity = fmt::format("F_z / L, h/r = {}", h);
        series.mode = mode;
        series.scheme = scheme;
        const long double cylinder = closed_forms::cylinder_on_plane_cylinder_master(kRadius, h);
        const long double plane = closed_forms::cylinder_on_plane_plane_master(kRadius, h);
        series.reference = mode == Mode::E ? cylinder : mode == Mode::F ? plane : (cylinder + plane) / 2;
        series.scale = static_cast<double>(series.reference);
        series.orientations = kOrientations;
        std::vector<fast::Pairing> pairings;
        for (const Index half : segments_of(extent)) {
          const Index n = 2 * half;  // a contact at least 20 edges wide at the last three levels
          const Index cells = n / 4;
          const fast::Surface E(generate::cylinder(kRadius, kLength, n));
          const fast::Surface F(generate::plate(1.5, 2 * kLength, 1, cells, 4));
          pairings.emplace_back(E, F, stiffness(1), mode, scheme);
          series.levels.push_back({fmt::format("{} segments, plate {} x 4", n, cells),
                                   chord(n),
                                   faces_of(E, F),
                                   2 * std::sqrt(2 * h - h * h) / chord(n),
                                   {}});
        }
        series.measure = [pairings, h](std::size_t level, int orientation, fast::Workspace& workspace) {
          const double x = 0.618 * orientation;
          const Placement placement{lying() * fixed_roll(orientation), {0.1 * (x - std::floor(x)), 0, kRadius - h}};
          return load(pairings[level], placement, workspace).force_F.z() / kLength;
        };
        expect(series, leading_on_plane(mode, scheme, h), extent);
      }
  return problem;
}

/// The force with this master, E the journal, without gap.
long double force_in_bore(Mode master, double d) {
  return master == Mode::E ? closed_forms::journal_in_bore_journal_master(kRadius, kRadius, d)
                           : closed_forms::journal_in_bore_bore_master(kRadius, kRadius, d);
}

/// What the meshes add to the force with this master, divided by the journal's chord squared. The journal's chords lie
/// e^2 / 12 inside its circle on the mean, and e^2 / 9 where the barycentres of its triangles are; so do the bore's,
/// half as long, inside its own. The difference counts over the projected width 2 sin t.
double added_in_bore(Mode master, Scheme scheme, double d) {
  const long double t = master == Mode::E ? closed_forms::ball_contact_angle(kRadius, kRadius, d)
                                          : closed_forms::hollow_contact_angle(kRadius, kRadius, d);
  const bool at_barycentres = scheme == Scheme::barycentric;
  const double journal = at_barycentres && master == Mode::E ? 1.0 / 9 : 1.0 / 12;
  const double bore = (at_barycentres && master == Mode::F ? 1.0 / 9 : 1.0 / 12) / 4;
  return (bore - journal) * 2 * static_cast<double>(std::sin(t));
}

/// E the journal, F the bore, which is twice as long and as fine.
KnownAnswer journal_in_bore(Extent extent) {
  KnownAnswer problem;
  problem.id = "A7";
  problem.title = "journal in bore without gap";
  problem.problem =
      "A cylinder of radius r = 1 m and length 1 m, rolled about its axis, is displaced by d = 0.02 m across a bore of "
      "the same radius; K = 1 N/m^3. Force per length, mean over the orientations.";
  problem.reference =
      "integral of u cos t over the master's arc, u = r + d cos t - sqrt(r^2 - d^2 sin^2 t) (journal), d cos t + "
      "sqrt(r^2 - d^2 sin^2 t) - r (bore), by quadrature; (pi/2) K r d to first order";
  const double d = 0.02;
  for (const Mode mode : kModes)
    for (const Scheme scheme : kSchemes) {
      Series& series = problem.series.emplace_back();
      series.quantity = "F_x / L, d/r = 0.02";
      series.mode = mode;
      series.scheme = scheme;
      series.reference =
          mode == Mode::both ? (force_in_bore(Mode::E, d) + force_in_bore(Mode::F, d)) / 2 : force_in_bore(mode, d);
      series.scale = static_cast<double>(series.reference);
      series.orientations = kOrientations;
      std::vector<fast::Pairing> pairings;
      for (const Index n : segments_of(extent)) {
        const fast::Surface E(generate::cylinder(kRadius, kLength, n));
        const fast::Surface F(generate::tube(kRadius, 2 * kRadius, 2 * kLength, 2 * n, 4));
        pairings.emplace_back(E, F, stiffness(1), mode, scheme);
        series.levels.push_back({fmt::format("{} segments, bore {}", n, 2 * n),
                                 chord(n),
                                 faces_of(E, F),
                                 static_cast<double>(closed_forms::kPi) / chord(n),
                                 {}});
      }
      series.measure = [pairings, d](std::size_t level, int orientation, fast::Workspace& workspace) {
        const Placement placement{fixed_roll(orientation), {d, 0, 0}};
        return -load(pairings[level], placement, workspace).force_F.x() / kLength;
      };
      const double added = mode == Mode::both
                               ? (added_in_bore(Mode::E, scheme, d) + added_in_bore(Mode::F, scheme, d)) / 2
                               : added_in_bore(mode, scheme, d);
      expect(series, added / series.scale, extent);
    }
  return problem;
}

}  // namespace

std::vector<KnownAnswer> cylinders(Extent extent) {
  return {cylinder_on_plane(extent), journal_in_bore(extent)};
}

}  // namespace pcm::compare
