// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle against its brute-force twin on small meshes.
#include <gtest/gtest.h>

#include "meshes/degenerate/catalogue.h"
#include "reference/oracle.h"
#include "tests/reference/brute_force/combinatorics.h"
#include "tests/reference/brute_force/trials.h"

namespace pcm::brute_force {
namespace {

using reference::Problem;

Combinatorics combinatorics_of(const reference::Answer& answer) {
  Combinatorics result;
  result.touching = answer.touching;
  result.nested = answer.nested;
  result.ambiguous = answer.ambiguous;
  result.patches = answer.patches;
  result.undefined_areas = answer.undefined_areas;
  result.too_deep = answer.too_deep;
  for (const reference::Polygon& polygon : answer.polygons) {
    Polygon& copy = result.polygons.emplace_back();
    copy.closed = polygon.closed;
    copy.patch = polygon.patch;
    for (const reference::Crossing& c : polygon.points) copy.points.push_back({c.edge_side, c.edge, c.face});
  }
  result.intersected = {answer.E.intersected, answer.F.intersected};
  result.inner = {answer.E.inner, answer.F.inner};
  for (const reference::Element& element : answer.elements)
    result.elements.emplace_back(element.master, element.master_face, element.slave_face);
  return result;
}

void expect_same(const Answer& twin, const reference::Answer& oracle) {
  EXPECT_EQ(difference(combinatorics_of(twin), combinatorics_of(oracle)), "");
}

/// Whether anything happened in the pose.
bool compare_on(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  const reference::Oracle oracle(E, F, {}, Mode::both);
  bool touching = false;
  for (const Problem problem : {Problem::rounded, Problem::exact}) {
    SCOPED_TRACE(problem == Problem::rounded ? "rounded problem" : "exact problem");
    const Answer twin = answer(E, F, pose, problem, Mode::both);
    expect_same(twin, oracle.answer(problem, pose));
    touching = touching || twin.touching;
  }
  return touching;
}

TEST(BruteTwin, AgreesOnTheDegenerateCatalogue) {
  for (const degenerate::Case& example : degenerate::catalogue()) {
    if (example.E.faces.size() + example.F.faces.size() > 200) continue;
    SCOPED_TRACE(example.name);
    compare_on(example.E, example.F, {example.A, example.r});
  }
}

class BruteTwinPoses : public testing::TestWithParam<std::tuple<Kind, int>> {};

TEST_P(BruteTwinPoses, AgreeWithTheOracle) {
  const auto [kind, count] = GetParam();
  int touching = 0;
  for (int number = 0; number < count && !HasFailure(); ++number) {
    const Trial trial = draw_trial(kind, 20, number);
    SCOPED_TRACE(trial.description);
    if (compare_on(trial.E, trial.F, trial.pose)) ++touching;
  }
  EXPECT_GE(touching, count / 5);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BruteTwinPoses,
                         testing::Values(std::tuple{Kind::generic, 200}, std::tuple{Kind::lattice, 400},
                                         std::tuple{Kind::near_lattice, 300}, std::tuple{Kind::grids, 60},
                                         std::tuple{Kind::open, 300}),
                         [](const testing::TestParamInfo<std::tuple<Kind, int>>& test) {
                           return name_of(std::get<0>(test.param));
                         });

}  // namespace
}  // namespace pcm::brute_force
