// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/stability.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "compare/stability/stability_report.h"
#include "pcm/bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::stability {
namespace {

constexpr SweepPoint kPoint{Sweep::depth, -10};
constexpr std::int64_t kPoses = 4;

/// The engine with a fault: asks it, and alters its answer.
template <class Alter>
AskEngine altered(const Alter& alter) {
  return [alter](const fast::Pairing& pairing, const Pose& pose, fast::Workspace& workspace) -> const fast::Contact& {
    thread_local fast::Contact contact;
    contact = ask_engine(pairing, pose, workspace);
    alter(contact);
    return contact;
  };
}

std::vector<PointFigures> asked(const AskEngine& ask) {
  KeptValues none;
  return figures_at_point(kPoint, kPoses, 1, ask, none);
}

StabilityReport report_of(std::vector<PointFigures> points) {
  return {1, kPoses, std::move(points)};
}

/// In both schemes.
void expect_each(const std::vector<PointFigures>& points, const std::function<bool(const PointFigures&)>& is_so) {
  ASSERT_EQ(points.size(), 2U);
  for (const PointFigures& figures : points) EXPECT_TRUE(is_so(figures));
}

TEST(Stability, EngineHasErrorsAboutAsGreatAsTheConditionWithinItsBound) {
  const std::vector<PointFigures> points = asked(ask_engine);
  expect_each(points, [](const PointFigures& figures) {
    const GroupFigures::OfQuantity& force = figures.settled.of(Quantity::force);
    return figures.settled.poses == kPoses && figures.outside_bound.empty() && force.condition.median > 1e-15 &&
           force.condition.median < 1e-12 && force.error_over_condition.greatest < 4 &&
           force.bound.median > force.error.greatest;
  });
  EXPECT_TRUE(report_of(points).met());
}

TEST(Stability, APlantedErrorShowsAndIsOutsideItsBound) {
  constexpr double kFault = 0x1p-30;
  const std::vector<PointFigures> points =
      asked(altered([](fast::Contact& contact) { contact.force_Me *= 1 + kFault; }));
  expect_each(points, [](const PointFigures& figures) {
    const GroupFigures& settled = figures.settled;
    return std::abs(settled.of(Quantity::force).error.median / kFault - 1) < 1e-3 &&
           settled.of(Quantity::force).error_over_condition.median > 1e3 &&
           settled.of(Quantity::torque).error.median < 1e-11 &&
           static_cast<std::int64_t>(figures.outside_bound.size()) == kPoses;
  });
  const StabilityReport report = report_of(points);
  EXPECT_FALSE(report.met());
  EXPECT_NE(stability_verdict(report).find("NOT met: 8 answers at 1 points of 6 sweeps, 0 flipped, 8 outside"),
            std::string::npos)
      << stability_verdict(report);
  EXPECT_NE(stability_summary(report).find("outside its bound: depth 2^-10, clipped, pose 3: force"),
            std::string::npos);
}

TEST(Stability, APlantedErrorWithinTheBoundShowsInErrorOverConditionOnly) {
  const std::vector<PointFigures> points =
      asked(altered([](fast::Contact& contact) { contact.force_Me += 0.5 * contact.bound->force_Me; }));
  expect_each(points, [](const PointFigures& figures) {
    const GroupFigures::OfQuantity& force = figures.settled.of(Quantity::force);
    return figures.outside_bound.empty() && force.error.median > 0.3 * force.bound.median &&
           force.bound_over_error.median < 3 &&
           force.error.median > 2 * figures.settled.of(Quantity::force).of_vertices.median;
  });
}

TEST(Stability, EveryQuantityShowsAFaultOfItsOwn) {
  const std::vector<PointFigures> points = asked(altered([](fast::Contact& contact) {
    contact.torque_Me *= 1 + 0x1p-20;
    contact.E.area *= 1 + 0x1p-21;
    contact.max_penetration *= 1 + 0x1p-22;
  }));
  expect_each(points, [](const PointFigures& figures) {
    return figures.settled.of(Quantity::force).error.median < 1e-11 &&
           figures.settled.of(Quantity::torque).error.median > 0x1p-24 &&
           std::abs(figures.settled.of(Quantity::area).error.median / 0x1p-21 - 1) < 1e-3 &&
           std::abs(figures.settled.of(Quantity::penetration).error.median / 0x1p-22 - 1) < 1e-3;
  });
}

TEST(Stability, BoundsThatPromiseTooMuchAreFound) {
  const auto outside = [](const auto& alter) {
    std::size_t found = 0;
    for (const PointFigures& figures : asked(altered(alter))) found += figures.outside_bound.size();
    return found;
  };
  EXPECT_EQ(outside([](fast::Contact&) {}), 0U);
  EXPECT_GE(outside([](fast::Contact& contact) { contact.bound->force_Me *= 1e-4; }), 6U);
  EXPECT_GE(outside([](fast::Contact& contact) { contact.bound->torque_Me *= 1e-4; }), 6U);
  EXPECT_EQ(outside([](fast::Contact& c) { c.bound->penetration_at_least = c.bound->penetration_at_most * 1.01; }), 8U);
  EXPECT_EQ(outside([](fast::Contact& c) { c.bound->penetration_at_most = c.bound->penetration_at_least * 0.99; }), 8U);
}

TEST(Stability, WhatIsNotFiniteIsNoAnswer) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const AskEngine& ask :
       {altered([nan](fast::Contact& contact) { contact.force_Me.y() = nan; }),
        altered([](fast::Contact& contact) { contact.E.area = std::numeric_limits<double>::infinity(); }),
        altered([nan](fast::Contact& contact) { contact.max_penetration = nan; }),
        altered([](fast::Contact&) { throw BadInput("refused"); })}) {
    const std::vector<PointFigures> points = asked(ask);
    expect_each(points, [](const PointFigures& figures) {
      return figures.unanswered == kPoses && figures.settled.poses == 0 && figures.flipped.poses == 0;
    });
    EXPECT_FALSE(report_of(points).met());
    EXPECT_NE(stability_verdict(report_of(points)).find("8 not finite"), std::string::npos);
  }
}

TEST(Stability, FlippedPosesAreApart) {
  const std::vector<PointFigures> points = asked(altered([](fast::Contact& c) { c.bound->flipped = true; }));
  expect_each(points, [](const PointFigures& figures) {
    return figures.flipped.poses == kPoses && figures.settled.poses == 0 &&
           figures.flipped.of(Quantity::force).error.any() && !figures.settled.of(Quantity::force).error.any();
  });
  EXPECT_TRUE(flatness(report_of(points)).empty());
  EXPECT_TRUE(report_of(points).met());
}

TEST(Stability, InfiniteBoundsAreCountedAndHold) {
  const std::vector<PointFigures> points = asked(altered(
      [](fast::Contact& contact) { contact.bound->force_Me.setConstant(std::numeric_limits<double>::infinity()); }));
  expect_each(points, [](const PointFigures& figures) {
    return figures.unbounded == kPoses && figures.outside_bound.empty() &&
           std::isinf(figures.settled.of(Quantity::force).bound.median);
  });
  EXPECT_EQ(json(stability_table(report_of(points)))[0]["bound_median"], nullptr);
}

TEST(Stability, ScaleChangesNoFigure) {
  const auto errors = [](int step) {
    std::vector<double> all;
    KeptValues none;
    for (const PointFigures& figures : figures_at_point({Sweep::scale, step}, 3, 1, ask_engine, none))
      for (const Quantity quantity : kQuantities) {
        all.push_back(figures.settled.of(quantity).error.median);
        all.push_back(figures.settled.of(quantity).condition.median);
        all.push_back(figures.settled.of(quantity).bound.median);
      }
    return all;
  };
  EXPECT_EQ(errors(240), errors(0));
  EXPECT_EQ(errors(-200), errors(0));
  // Errors of torques are about 2^-1020 N m there, and have few bits as doubles.
  const std::vector<double> tiny = errors(-240), ordinary = errors(0);
  for (std::size_t k = 0; k < tiny.size(); ++k) EXPECT_NEAR(tiny[k], ordinary[k], 0x1p-5 * ordinary[k]) << k;
}

TEST(Stability, ThreadsChangeNoFigure) {
  const auto on = [](int threads) {
    oneapi::tbb::task_arena arena(threads);
    return arena.execute([] { return csv(stability_table(report_of(asked(ask_engine)))); });
  };
  EXPECT_EQ(on(1), on(3));
}

TEST(Stability, PointsThatAreKeptGiveTheSameTablesAndAreNotAskedAgain) {
  const TemporaryFolder scratch;
  const auto table = [&](const AskEngine& ask) {
    KeptValues kept(scratch.path("stability.kept"), {{"format", "kept"}});
    return csv(stability_table(report_of(figures_at_point(kPoint, kPoses, 1, ask, kept))));
  };
  const std::string first = table(ask_engine);
  EXPECT_EQ(table([](const fast::Pairing&, const Pose&, fast::Workspace&) -> const fast::Contact& {
              throw std::logic_error("nothing is to be asked");
            }),
            first);
}

TEST(Stability, PublishedAlgorithmsAreMeasuredInTheBarycentricScheme) {
  KeptValues none;
  const std::vector<PointFigures> points = figures_at_point({Sweep::depth, -1}, 3, 1, ask_engine, none);
  const GroupFigures& barycentric = points[0].settled;
  ASSERT_EQ(barycentric.poses, 3);
  EXPECT_LT(barycentric.published[0].error[0].greatest, 1e-14);
  EXPECT_EQ(barycentric.published[0].other_elements, 0);
  // The variant of 2023 loses what lies deeper than half a size.
  EXPECT_EQ(barycentric.published[1].other_elements, 3);
  EXPECT_GT(barycentric.published[1].error[0].median, 0.1);
}

TEST(Spread, OfNumbers) {
  EXPECT_FALSE(spread_of({}).any());
  EXPECT_EQ(spread_of({3}).median, 3);
  EXPECT_EQ(spread_of({4, 1, 2}).median, 2);
  EXPECT_EQ(spread_of({4, 1, 2, 8}).median, 3);
  EXPECT_EQ(spread_of({4, 1, 2, 8}).greatest, 8);
  EXPECT_TRUE(std::isinf(spread_of({1, std::numeric_limits<double>::infinity()}).greatest));
}

TEST(Flatness, IsOverTheMediansOfThePointsWithSettledPoses) {
  const auto point = [](int step, double ratio, std::int64_t poses) {
    PointFigures figures;
    figures.point = {Sweep::offset, step};
    figures.settled.poses = poses;
    for (GroupFigures::OfQuantity& of : figures.settled.quantities) {
      of.condition = {1e-15, 1e-15};
      of.error_over_condition = {ratio, 3 * ratio};
      of.bound_over_condition = {5 * ratio, 5 * ratio};
    }
    return figures;
  };
  const std::vector<Flatness> flat = flatness(report_of({point(0, 0.5, 4), point(4, 2, 4), point(8, 100, 0)}));
  ASSERT_EQ(flat.size(), 3U);  // no area in the barycentric scheme
  EXPECT_EQ(flat[0].least, 0.5);
  EXPECT_EQ(flat[0].greatest, 2);
  EXPECT_EQ(flat[0].greatest_of_all, 6);
  EXPECT_EQ(flat[0].greatest_bound, 10);
}

}  // namespace
}  // namespace pcm::compare::stability
