// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "meshes/generate/degenerate/hard_bodies.h"
#include "tests/reference/brute_force/brute_force.h"
#include "tests/reference/brute_force/trials.h"

/// The poses on which oracle and engine are held against the twin. A test brings what it compares: a function of E, F
/// and pose that holds what is tested against the twin and returns the twin's answer to the rounded problem.
namespace pcm::brute_force {

/// How much of what is compared was there at all, in poses.
struct Seen {
  int touching = 0;
  int elements = 0;
  int too_deep = 0;
  int folded = 0;  ///< faces about which the other surface winds more than once, or less than no times

  void add(const Answer& twin) {
    touching += twin.touching ? 1 : 0;
    elements += twin.elements.empty() ? 0 : 1;
    too_deep += twin.too_deep > 0 ? 1 : 0;
    const auto is_wound = [](const Share& share) { return share.perturbed < 0 || share.perturbed > 1; };
    folded += std::ranges::any_of(twin.E.shares, is_wound) || std::ranges::any_of(twin.F.shares, is_wound) ? 1 : 0;
  }
};

/// All cases of the degenerate catalogue that are small enough for the twin.
template <class Compare>
void compare_on_catalogue(const Compare& compare) {
  Seen seen;
  for (const degenerate::Case& example : degenerate::catalogue()) {
    if (example.E.faces.size() + example.F.faces.size() > 200) continue;
    SCOPED_TRACE(example.name);
    seen.add(compare(example.E, example.F, Pose{example.A, example.r}));
  }
  EXPECT_GE(seen.touching, 10);
}

/// Whether the other surface winds about less than no times all of some face that is not crossed.
inline bool lies_in_a_pocket(const ActiveArea& active) {
  for (std::size_t face = 0; face < active.shares.size(); ++face) {
    const bool crossed = std::ranges::binary_search(active.intersected, static_cast<Index>(face));
    if (!crossed && active.shares[face].perturbed < 0) return true;
  }
  return false;
}

/// A column that sticks out of that loop of a figure of eight which is wound about -1 times: faces that are not crossed
/// lie in it, and are not active.
template <class Compare>
void compare_in_a_pocket(const Compare& compare) {
  const TriangleMesh column = generate::gridded_box({0.1, 0.1, 0.4}, {2, 2, 6});
  const TriangleMesh eight = degenerate::figure_of_eight();
  const Eigen::Vector3d apart(0.17, 0.01, -0.25);
  for (const double angle : {0.0, 0.3}) {
    SCOPED_TRACE(angle);
    const Eigen::Matrix3d A = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    EXPECT_TRUE(lies_in_a_pocket(compare(column, eight, {A, A * apart}).E));
    EXPECT_TRUE(lies_in_a_pocket(compare(eight, column, {A, -apart}).F));
  }
}

/// A kind of trial, and how many of it.
using Series = std::tuple<Kind, int>;

/// Every kind, for INSTANTIATE_TEST_SUITE_P, and the name of each.
inline const auto kAllSeries =
    testing::Values(Series{Kind::generic, 200}, Series{Kind::lattice, 400}, Series{Kind::near_lattice, 300},
                    Series{Kind::grids, 60}, Series{Kind::open, 300}, Series{Kind::folded, 120});
inline std::string series_name(const testing::TestParamInfo<Series>& test) {
  return name_of(std::get<Kind>(test.param));
}

/// The trials of one series up to the first failure.
template <class Compare>
void compare_on_trials(const Series& series, std::uint64_t seed, const Compare& compare) {
  const int count = affordable(std::get<int>(series));
  Seen seen;
  for (int number = 0; number < count && !testing::Test::HasFailure(); ++number) {
    const Trial trial = draw_trial(std::get<Kind>(series), seed, number);
    SCOPED_TRACE(trial.description);
    seen.add(compare(trial.E, trial.F, trial.pose));
  }
  EXPECT_GE(seen.touching, count / 5);
  EXPECT_GE(seen.elements, count / 20);
  EXPECT_GE(seen.too_deep, 1);
  if (std::get<Kind>(series) == Kind::folded) {
    EXPECT_GE(seen.folded, count / 6);
  }
}

}  // namespace pcm::brute_force
