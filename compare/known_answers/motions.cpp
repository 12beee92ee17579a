// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/dynamics.h"
#include "compare/known_answers/problems.h"

/// The dynamic known answers as rows: a series over tolerances or meshes each.
namespace pcm::compare {

namespace {

using Motions = std::function<std::vector<DynamicAnswer>()>;

std::vector<Motions> motions_of(Extent extent) {
  const bool full = extent == Extent::full;
  std::vector<Motions> list;
  for (const Scheme scheme : kSchemes) {
    DynamicPlan plan;
    plan.scheme = scheme;
    if (!full) plan.tolerances = {1e-4, 1e-6, 1e-8, 1e-10};
    list.emplace_back([plan] { return flat_bounces(plan); });
    list.emplace_back([plan] { return sphere_drops(plan); });
    list.emplace_back([plan] { return frictional_slides(plan); });
  }
  const std::vector<Index> levels = full ? std::vector<Index>{3, 4, 5} : std::vector<Index>{2, 3, 4};
  list.emplace_back([levels] { return sphere_geometry(levels, 1e-9); });
  return list;
}

/// What the cases are; their series come later.
std::vector<KnownAnswer> cases() {
  const std::string levels =
      " One body moves by translation, integrated by CVODE (Adams formulas), contact's beginning and end found as "
      "events. The levels are the integrator's relative tolerances, in the column `edge`, or meshes.";
  return {
      {"A12",
       "bounce with flat contact",
       "A box falls on a plate at 1 m/s, without gravity; z = d_l A / (2 sqrt(m K A)), three damping modes." + levels,
       "the damped oscillator up to u = 0, to where the force would pull, or damped while approaching only",
       {}},
      {"A13",
       "bounce in the transition depth",
       "The same with damping that fades with depth throughout; a = d_l v0 / (K u_d)." + levels,
       "a - ln(1 + a) = -a e - ln(1 - a e)",
       {}},
      {"A14",
       "undamped drop of a sphere",
       "A sphere of 2 kg, r = 0.2 m, falls on a plate at 4.42945 m/s, sphere master, K = 1.17857e6 N/m^3, guided "
       "vertically." +
           levels,
       "the energy of the polyhedron's own force law in the scheme, in closed form; of the smooth sphere where the "
       "levels are meshes",
       {}},
      {"A15",
       "sphere at rest under its weight",
       "The same sphere, damped, has settled." + levels,
       "the depth at which the polyhedron, or the smooth sphere, carries the weight",
       {}},
      {"A16",
       "creep on an incline",
       "A box on a plate inclined by tan a = 0.2, mu = 0.25, starts from rest." + levels,
       "v = v_eps (1 - sqrt(1 - tan a / mu))",
       {}},
      {"A17",
       "stopping distance",
       "A box slides on a plate, mu = 0.3, v0 = 2 m/s, v_eps = 0.5 m/s." + levels,
       "v0^2 / (2 mu g) + v_eps^2 / (mu g) (ln 2 - 1/2)",
       {}}};
}

bool same_series(const DynamicAnswer& a, const DynamicAnswer& b) {
  return a.id == b.id && a.quantity == b.quantity && a.parameter == b.parameter && a.reference == b.reference &&
         a.scheme == b.scheme && a.mode == b.mode;
}

Series series_of(const std::vector<DynamicAnswer>& answers) {
  const DynamicAnswer& first = answers.front();
  Series series;
  series.quantity = first.parameter.empty() ? first.quantity : first.quantity + ", " + first.parameter;
  series.mode = first.mode;
  series.scheme = first.scheme;
  series.reference = first.expected;
  series.scale = std::abs(first.expected);
  std::vector<double> values;
  for (const DynamicAnswer& answer : answers) {
    Resolution level;
    level.meshes = answer.level;
    level.edge = answer.resolution;
    level.deviation = within(answer.bound);
    series.levels.push_back(level);
    values.push_back(answer.computed);
  }
  if (first.second_order) series.order = Band{1.9, 2.1};
  series.reason = first.second_order ? "force between those of an inner and an outer sphere; second order in the edge"
                                     : "steps' errors, each up to the tolerance, times the condition of the quantity";
  series.measure = [values](std::size_t level, int, fast::Workspace&) { return values[level]; };
  return series;
}

}  // namespace

std::vector<KnownAnswer> motions(Extent extent) {
  const std::vector<Motions> list = motions_of(extent);
  std::vector<std::vector<DynamicAnswer>> found(list.size());
  oneapi::tbb::parallel_for(std::size_t{0}, list.size(), [&](std::size_t i) { found[i] = list[i](); });

  std::vector<std::vector<DynamicAnswer>> grouped;
  for (const std::vector<DynamicAnswer>& answers : found)
    for (const DynamicAnswer& answer : answers) {
      const auto group = std::find_if(grouped.begin(), grouped.end(),
                                      [&](const auto& other) { return same_series(other.front(), answer); });
      if (group == grouped.end()) {
        grouped.push_back({answer});
      } else {
        group->push_back(answer);
      }
    }
  std::vector<KnownAnswer> problems = cases();
  for (KnownAnswer& problem : problems)
    for (const std::vector<DynamicAnswer>& answers : grouped)
      if (answers.front().id == problem.id) problem.series.push_back(series_of(answers));
  return problems;
}

}  // namespace pcm::compare
