// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/strata.h"

#include <stdexcept>

namespace pcm::compare {
namespace {

/// One pose in four is at rest. Else both velocities are drawn over six orders of magnitude about one size a second,
/// so that damping and friction see either side of their transitions.
Velocity draw_velocity(double size, PoseRandom& random) {
  Velocity velocity;
  if (random.below(4) == 0) return velocity;
  const Eigen::Vector3d along = random.direction();
  velocity.v = along * (random.log_uniform(1e-4, 1e2) * size);
  if (random.coin()) {
    const Eigen::Vector3d about = random.direction();
    velocity.w = about * random.log_uniform(1e-4, 1e2);
  }
  return velocity;
}

struct Row {
  Stratum stratum;
  std::string_view name;
  bool hard;
  DrawnPose (*draw)(const FeaturePair& pair, PoseRandom& random);
};

/// By their numbers.
constexpr std::array kRows = {
    Row{Stratum::generic, "generic", false,
        [](const FeaturePair& pair, PoseRandom& random) { return detail::draw_overlapping(pair, 1e-6, 0.5, random); }},
    Row{Stratum::grazing, "grazing", false,
        [](const FeaturePair& pair, PoseRandom& random) {
          return detail::draw_overlapping(pair, 1e-15, 1e-6, random);
        }},
    Row{Stratum::separated, "separated", false, detail::draw_separated},
    Row{Stratum::nested, "nested", false, detail::draw_nested},
    Row{Stratum::degenerate, "degenerate", true, detail::draw_degenerate},
    Row{Stratum::near_degenerate, "near-degenerate", true,
        [](const FeaturePair& pair, PoseRandom& random) {
          DrawnPose drawn = detail::draw_degenerate(pair, random);
          detail::move_by_ulps(pair, random, drawn);
          return drawn;
        }},
    Row{Stratum::extreme, "extreme", true, detail::draw_extreme},
    Row{Stratum::adversarial, "adversarial", true, detail::draw_adversarial},
    Row{Stratum::trajectory, "trajectory", false,
        [](const FeaturePair&, PoseRandom&) -> DrawnPose {
          throw std::logic_error("poses of a trajectory are drawn along what was recorded");
        }},
};
static_assert(kStrata.size() + 1 == kRows.size(), "all but `trajectory` are drawn for any surfaces");

constexpr bool are_in_order() {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (static_cast<std::size_t>(kRows[i].stratum) != i) return false;
  return true;
}
static_assert(are_in_order());

const Row& row_of(Stratum stratum) {
  return kRows[static_cast<std::size_t>(stratum)];
}

}  // namespace

std::string_view name(Stratum stratum) {
  return row_of(stratum).name;
}

std::string strata_names() {
  std::string names;
  for (const Row& row : kRows) {
    if (!names.empty()) names += ", ";
    names += row.name;
  }
  return names;
}

std::optional<Stratum> stratum_named(std::string_view word) {
  for (const Row& row : kRows)
    if (row.name == word) return row.stratum;
  return std::nullopt;
}

bool hard(Stratum stratum) {
  return row_of(stratum).hard;
}

DrawnPose draw_pose(Stratum stratum, const FeaturePair& pair, PoseRandom random) {
  DrawnPose drawn = row_of(stratum).draw(pair, random);
  drawn.velocity = draw_velocity(pair.size(), random);
  return drawn;
}

}  // namespace pcm::compare
