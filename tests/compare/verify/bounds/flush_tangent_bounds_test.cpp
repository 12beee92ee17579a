// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen beside a side beyond which master or sheet goes on is one face's or the next one's: what no face can
// tell alone, the sum has to have once.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/verdict/tangent_verdict.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/hard_bodies.h"
#include "meshes/generate/parts.h"
#include "pcm/engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

using Eigen::Vector3d;

constexpr double kStiffness = 1000, kDepth = 0.0625;  // N/m^3, m
/// What a border 1 m long makes of the derivative of force, N/m.
constexpr double kOfABorder = kStiffness * kDepth;

/// A box of 1 m on the middle one of 3 x 3 cells, whose walls lean out by that part of their height, or over the end of
/// a plate.
struct Flush {
  TriangleMesh E, F;
  Vector3d r{0, 0, -kDepth};
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
};

void lean(TriangleMesh& mesh, double low, double high, double by) {
  for (Vector3d& x : mesh.vertices)
    if (x.z() < low || x.z() > high) x.head<2>() *= 1 + by;
}

Flush on_the_middle_cell(double by) {
  Flush flush{generate::gridded_box({-1.5, -1.5, -1}, {1.5, 1.5, 0}, {3, 3, 1}),
              generate::box({-0.5, -0.5, 0}, {0.5, 0.5, 1})};
  lean(flush.E, -0.5, 2, by);
  lean(flush.F, -2, 0.5, by);
  return flush;
}

const Velocity kAtRest{}, kMoving{{0.3, -0.2, -1}, {0.5, 0.4, -0.3}};

/// Against the oracle's.
struct Judged {
  fast::Tangent found, truth, allowed;

  bool passes(const fast::Tangent& tangent) const { return ((tangent - truth).array().abs() <= allowed.array()).all(); }
};

Judged judged(const Flush& flush, const Vector3d& off, const ContactLaw& law, const Velocity& velocity = kMoving,
              Mode mode = Mode::E) {
  const HeldPairing held(flush.E, flush.F, law, mode, Scheme::clipped);
  const Pose pose{flush.A, flush.r + off};
  Wanted wanted;
  wanted.tangent = true;
  fast::Workspace workspace;
  const fast::Contact& contact = fast::evaluate(held.engine(), pose, velocity, wanted, workspace);
  reference::Inquiry inquiry(held.oracle(), pose, velocity, {}, law, Scheme::clipped);
  const reference::Tangent truth = inquiry.tangent(reference::Problem::rounded, mode);
  return {*contact.tangent, truth.slope,
          allowed_errors(held.question(pose, velocity), contact.elements,
                         inquiry.answer(reference::Problem::rounded, mode), truth)};
}

ContactLaw elastic() {
  ContactLaw law;
  law.stiffness = kStiffness;
  return law;
}

ContactLaw damped() {
  ContactLaw law = elastic();
  law.damping = 30;
  law.transition_depth = 2 * kDepth;
  return law;
}

void for_each_distance(const std::function<void(const Vector3d& off)>& visit) {
  visit(Vector3d::Zero());
  for (double distance = 0x1p-52; distance < 0x1p-45; distance *= 2)
    for (const double off : {-distance, distance})
      for (const Vector3d& along : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(1, -0.75, 0)}) {
        SCOPED_TRACE(off);
        visit(off * along);
      }
}

TEST(FlushTangentBounds, BesideAnInnerEdgeOfTheMasterHangOnRoundingsAlone) {
  for_each_distance([](const Vector3d& off) {
    const Judged judged_here = judged(on_the_middle_cell(0.25), off, elastic());
    EXPECT_LT(judged_here.allowed.maxCoeff(), 1e-8 * kOfABorder);
    EXPECT_TRUE(judged_here.passes(judged_here.found));
  });
}

TEST(FlushTangentBounds, BesideAnInnerEdgeNoBorderMayCountTwiceNorNot) {
  for (const double by : {0.25, 0.0})
    for_each_distance([&](const Vector3d& off) {
      const Judged judged_here = judged(on_the_middle_cell(by), off, elastic());
      EXPECT_TRUE(judged_here.passes(judged_here.found));
      for (const double times : {-1, 1})
        for (const int coordinate : {0, 1}) {
          fast::Tangent altered = judged_here.found;
          altered(2, coordinate) += times * kOfABorder;
          EXPECT_FALSE(judged_here.passes(altered)) << times << " along " << coordinate << ", leaning " << by;
        }
    });
}

/// The truth to one side of a tie is right to the other one as well, as none can tell them apart, but that of another
/// border.
TEST(FlushTangentBounds, HaveRoomForTheTruthToTheOtherSideOfATie) {
  for (const double by : {0.25, 0.0, -0.2})
    for_each_distance([&](const Vector3d& off) {
      const Judged here = judged(on_the_middle_cell(by), off, elastic());
      EXPECT_TRUE(here.passes(judged(on_the_middle_cell(by), -off, elastic()).truth)) << by;
    });
}

/// The lines of faces in one plane but for roundings part at their common side, or cross: a border there is seen by
/// none of them, or by both. Here an edge of the hollow cube lies within an ulp of the cube's diagonal.
TEST(FlushTangentBounds, HaveRoomForWhatFacesInOnePlaneButForRoundingsSee) {
  Flush flush{degenerate::hollow_cube(0.5), generate::box({1, 1, 1})};
  flush.A << 0x1.af286bca1af28p-5, -0x1.435e50d79435ep-2, -0x1.e50d79435e50dp-1,  //
      0x1.435e50d79435ep-2, -0x1.ca1af286bca1bp-1, 0x1.435e50d79435ep-2,          //
      -0x1.e50d79435e50dp-1, -0x1.435e50d79435ep-2, 0x1.af286bca1af28p-5;
  flush.r = {-0x1.1435e50d79436p-1, 0x1.06bca1af286bcp-1, -0x1.435e50d79436p-5};
  const Judged here = judged(flush, Vector3d::Zero(), elastic(), kMoving, Mode::F);
  const Judged beside = judged(flush, {1e-9, 0, 0}, elastic(), kMoving, Mode::F);
  EXPECT_TRUE(here.passes(here.found));
  EXPECT_TRUE(here.passes(beside.truth));
  EXPECT_GT((here.truth - beside.truth).cwiseAbs().maxCoeff(), 0.1 * here.truth.cwiseAbs().maxCoeff());
}

/// Damping fades with the mean depth of an element: it is not the same for whichever element has the border.
TEST(FlushTangentBounds, OfLoadsThatAreNotLinearAreOfEachElement) {
  const Vector3d off(0x1p-52, 0, 0);
  const Flush flush = on_the_middle_cell(0.25);
  EXPECT_GT(judged(flush, off, damped()).allowed.leftCols(6).maxCoeff(), kOfABorder);
  EXPECT_LT(judged(flush, off, damped(), kAtRest).allowed.leftCols(6).maxCoeff(), 1e-8 * kOfABorder);
}

/// No next face sees what lies beyond: which is border, that of the one body or of the other one, is open.
TEST(FlushTangentBounds, BesideTheEndOfAPlateAllowForEitherBorder) {
  Flush flush{generate::box({-0.5, -0.5, -1}, {0.5, 0.5, 0}), generate::box({-0.5, -0.5, 0}, {0.5, 0.5, 1})};
  lean(flush.E, -0.5, 2, 0.25);
  lean(flush.F, -2, 0.5, -0.25);
  for_each_distance([&](const Vector3d& off) {
    const Judged here = judged(flush, off, elastic());
    EXPECT_TRUE(here.passes(here.found));
    if (off.cwiseAbs().maxCoeff() > 0x1p-48) return;
    EXPECT_TRUE(here.passes(judged(flush, -off, elastic()).truth));
    EXPECT_GT(here.allowed(2, off.x() == 0 ? 1 : 0), kOfABorder);
  });
}

}  // namespace
}  // namespace pcm::compare
