// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <string>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "pcm/bad_input.h"
#include "tests/reference/poses.h"
#include "tests/reference/problems.h"

namespace pcm::reference {
namespace {

TEST(OracleCombinatorics, BoxCornerInBoxGivesOneClosedPolygonThroughSixEdges) {
  const Oracle oracle(generate::box({0, 0, 0}, {2, 2, 2}), generate::box({1, 1, 1}, {3, 3, 3}));
  for (const Problem problem : kProblems) {
    const Answer answer = oracle.answer(problem, {});
    EXPECT_TRUE(answer.touching);
    EXPECT_FALSE(answer.nested);
    ASSERT_EQ(answer.polygons.size(), 1u);
    EXPECT_TRUE(answer.polygons[0].closed);
    EXPECT_GE(answer.polygons[0].points.size(), 6u);
    EXPECT_EQ(answer.patches, 1);
    for (const Crossing& crossing : answer.polygons[0].points)
      for (int i = 0; i < 3; ++i) {
        EXPECT_GE(crossing.position_Me[i], 1);
        EXPECT_LE(crossing.position_Me[i], 2);
      }
  }
}

TEST(OracleCombinatorics, NestedBoxIsInnerAndDoesNotTouch) {
  const Oracle oracle(generate::box({0, 0, 0}, {1, 1, 1}), generate::box({-1, -1, -1}, {2, 2, 2}));
  const Answer answer = oracle.answer(Problem::rounded, {});
  EXPECT_FALSE(answer.touching);
  EXPECT_TRUE(answer.nested);
  EXPECT_EQ(answer.E.inner.size(), 12u);
  EXPECT_TRUE(answer.F.inner.empty());
  EXPECT_EQ(answer.patches, 0);
}

TEST(OracleCombinatorics, BoxInCavityIsOutside) {
  const TriangleMesh hollow =
      with_cavity(generate::box({-2, -2, -2}, {3, 3, 3}), generate::box({-1, -1, -1}, {2, 2, 2}));
  const Oracle oracle(generate::box({0, 0, 0}, {1, 1, 1}), hollow);
  const Answer answer = oracle.answer(Problem::rounded, {});
  EXPECT_FALSE(answer.touching);
  EXPECT_FALSE(answer.nested);
  EXPECT_TRUE(answer.E.inner.empty());
}

TEST(OracleCombinatorics, ApartIsNothing) {
  const Oracle oracle(generate::box({0, 0, 0}, {1, 1, 1}), generate::box({0, 0, 0}, {1, 1, 1}));
  const Answer answer = oracle.answer(Problem::exact, shifted(5, 0, 0));
  EXPECT_FALSE(answer.touching);
  EXPECT_TRUE(answer.polygons.empty());
  EXPECT_TRUE(answer.E.intersected.empty() && answer.E.inner.empty());
}

TEST(OracleCombinatorics, SlabThroughBoxBoundsOnePatchWithTwoPolygons) {
  // A long bar through a box: two polygons, joined by the bar's edges that pass through the box.
  const Oracle oracle(generate::box({0, 0, 0}, {1, 1, 1}), generate::box({-1, 0.25, 0.25}, {2, 0.75, 0.75}));
  const Answer answer = oracle.answer(Problem::rounded, {});
  EXPECT_EQ(answer.polygons.size(), 2u);
  EXPECT_EQ(answer.patches, 1);
}

TEST(OracleCombinatorics, IdenticalBodiesChainOnlyClosedPolygons) {
  const TriangleMesh box = generate::gridded_box(1.0, 2);
  const Oracle oracle(box, box);
  for (const Problem problem : kProblems) {
    const Answer answer = oracle.answer(problem, {});
    for (const Polygon& polygon : answer.polygons) EXPECT_TRUE(polygon.closed);
  }
}

TEST(OracleCombinatorics, BubbleCrossesOpenContainerInClosedPolygons) {
  const Oracle oracle(generate::bubble(), generate::pyramid());
  const Answer answer = oracle.answer(Problem::rounded, shifted(0, 0, 0.1));
  EXPECT_TRUE(answer.touching);
  EXPECT_FALSE(answer.ambiguous);
  EXPECT_FALSE(answer.volume.has_value());
}

/// Two parallel floors, both facing up, cross one box: what lies between them is above one and below the other.
TEST(OracleCombinatorics, FacesBetweenTwoOpenFloorsAreAmbiguous) {
  TriangleMesh floors = generate::rectangle(10, 10);
  const Index offset = static_cast<Index>(floors.vertices.size());
  const std::vector<Triangle> faces = floors.faces;
  for (Index v = 0; v < offset; ++v) floors.vertices.push_back(floors.vertices[v] + Eigen::Vector3d(0, 0, 1));
  for (const Triangle& t : faces) floors.faces.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  // A tower of three storeys whose middle one has faces that neither floor crosses.
  const Oracle oracle(generate::gridded_box({-0.5, -0.5, -1.5}, {0.5, 0.5, 2.5}, {2, 2, 16}), floors);
  for (const Problem problem : {Problem::rounded, Problem::exact}) {
    const Answer answer = oracle.answer(problem, shifted(0.03125, 0.0625, 0.015625));
    EXPECT_TRUE(answer.touching);
    EXPECT_EQ(answer.polygons.size(), 2u);
    EXPECT_TRUE(answer.ambiguous);
    EXPECT_FALSE(answer.volume.has_value());
    EXPECT_FALSE(answer.nested);
  }
}

TEST(OracleInput, BadPoseIsRefused) {
  const Oracle oracle(generate::box({0, 0, 0}, {1, 1, 1}), generate::box({0, 0, 0}, {1, 1, 1}));
  Pose skewed;
  skewed.A(0, 1) = 1e-6;
  EXPECT_THROW(oracle.answer(Problem::rounded, skewed), BadInput);
  Pose mirrored;
  mirrored.A(0, 0) = -1;
  EXPECT_THROW(oracle.answer(Problem::rounded, mirrored), BadInput);
  EXPECT_THROW(oracle.answer(Problem::rounded, shifted(std::numeric_limits<double>::infinity(), 0, 0)), BadInput);
}

TEST(OracleInput, UnfitMeshIsRefused) {
  TriangleMesh box = generate::box({0, 0, 0}, {1, 1, 1});
  TriangleMesh bad = box;
  bad.faces.push_back(bad.faces[0]);
  EXPECT_THROW(Oracle(box, bad), BadInput);
  EXPECT_THROW(Oracle(bad, box), BadInput);
}

TEST(OracleInput, BadLawIsRefused) {
  const TriangleMesh box = generate::box({0, 0, 0}, {1, 1, 1});
  ContactLaw law;
  law.stiffness = 0;
  EXPECT_THROW(Oracle(box, box, law), BadInput);
  law.stiffness = 1;
  law.layers = LayerStiffness{};
  EXPECT_THROW(Oracle(box, box, law), BadInput);
  law.layers = LayerStiffness{1, std::numeric_limits<double>::infinity()};
  law.friction = -1;
  EXPECT_THROW(Oracle(box, box, law), BadInput);
}

TEST(OracleInput, NumbersOfTheLawOutOfTheirRangesAreRefusedByName) {
  const TriangleMesh box = generate::box({0, 0, 0}, {1, 1, 1});
  constexpr double kInf = std::numeric_limits<double>::infinity(), kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto expect_refused = [&box](double ContactLaw::*number, std::initializer_list<double> values,
                                     const char* name) {
    for (const double value : values) {
      ContactLaw law;
      law.stiffness = 1;
      EXPECT_NO_THROW(Oracle(box, box, law));
      law.*number = value;
      try {
        const Oracle oracle(box, box, law);
        ADD_FAILURE() << name << " " << value;
      } catch (const BadInput& error) {
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      }
    }
  };
  expect_refused(&ContactLaw::stiffness, {0, -1, kInf, kNaN}, "law: stiffness");
  expect_refused(&ContactLaw::damping, {-1, kInf, kNaN}, "law: damping");
  expect_refused(&ContactLaw::transition_depth, {-1, kInf, kNaN}, "law: transition depth");
  expect_refused(&ContactLaw::friction, {-1, kInf, kNaN}, "law: friction");
  expect_refused(&ContactLaw::slip_velocity, {-1, kInf, kNaN}, "law: slip velocity");
  expect_refused(&ContactLaw::max_penetration, {0, -1, kNaN}, "law: greatest penetration");
}

TEST(OracleInput, VelocitiesThatAreNoNumbersAreRefused) {
  const Oracle oracle(generate::box({0, 0, 0}, {1, 1, 1}), generate::box({0, 0, 0}, {1, 1, 1}));
  for (Eigen::Vector3d Velocity::*vector : {&Velocity::v, &Velocity::w}) {
    Velocity velocity;
    (velocity.*vector).y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(oracle.answer(Problem::rounded, {}, velocity), BadInput);
  }
}

}  // namespace
}  // namespace pcm::reference
