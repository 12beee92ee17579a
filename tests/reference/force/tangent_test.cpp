// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/force/tangent.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "reference/oracle.h"
#include "tests/reference/poses.h"
#include "tests/reference/problems.h"
#include "tests/sunken_blocks.h"

namespace pcm::reference {
namespace {

struct State12 {
  Pose pose;
  Velocity velocity;
};

/// Moved along one of the twelve coordinates: r, a turn about Mf, v, w.
State12 displaced(State12 state, int coordinate, double change) {
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(coordinate % 3);
  if (coordinate < 3) state.pose.r += change * axis;
  if (coordinate / 3 == 1) state.pose.A = Eigen::AngleAxisd(change, axis).toRotationMatrix() * state.pose.A;
  if (coordinate / 3 == 2) state.velocity.v += change * axis;
  if (coordinate >= 9) state.velocity.w += change * axis;
  return state;
}

using Load = Eigen::Matrix<double, 6, 1>;

Load load_of(const Answer& answer) {
  Load load;
  load << answer.force_Me, answer.torque_Me;
  return load;
}

Tangent tangent_of(const Oracle& oracle, Problem problem, const State12& state) {
  Wanted wanted;
  wanted.tangent = true;
  return *oracle.answer(problem, state.pose, state.velocity, wanted).tangent;
}

ContactLaw law_of_all(DampingMode mode) {
  ContactLaw law;
  law.layers = LayerStiffness{3e5, 1e5};
  law.damping = 300;
  law.damping_mode = mode;
  law.transition_depth = 0.1;
  law.friction = 0.3;
  law.slip_velocity = 0.5;
  return law;
}

// Central quotients are off by a sixth of the third derivative times h^2, and by eps / h of the load: both are far
// below 1e-4 of the column's size, which is asked for, unless a barycentre enters or leaves within h.
TEST(OracleTangent, IsTheLimitOfCentralQuotients) {
  const TriangleMesh E = generate::icosphere(1, 2), F = generate::icosphere(0.9, 2);
  const double h = 1e-6;
  std::mt19937_64 random(3);
  std::cout << "seed 3\n";
  int compared = 0;
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
    for (const Mode mode : {Mode::E, Mode::F, Mode::both})
      for (const DampingMode damping : {DampingMode::no_tension, DampingMode::full, DampingMode::compression}) {
        ContactLaw law = law_of_all(damping);
        if (mode == Mode::F) law.max_penetration = 0.15;
        const Oracle oracle(E, F, law, mode, scheme);
        State12 state{random_pose(random, 0), {{0.3, -0.2, 0.1}, {0.5, 0.4, -0.3}}};
        state.pose.r = 1.7 * (state.pose.A * Eigen::Vector3d(0.6, 0.48, 0.64));
        const Tangent tangent = tangent_of(oracle, Problem::exact, state);
        for (int i = 0; i < 12; ++i) {
          const Answer ahead =
                           oracle.answer(Problem::exact, displaced(state, i, h).pose, displaced(state, i, h).velocity),
                       behind = oracle.answer(Problem::exact, displaced(state, i, -h).pose,
                                              displaced(state, i, -h).velocity);
          if (ahead.elements.size() != behind.elements.size()) continue;
          const Load quotient = (load_of(ahead) - load_of(behind)) / (2 * h);
          EXPECT_LT((tangent.slope.col(i) - quotient).norm(), 1e-4 * tangent.slope.col(i).norm()) << i;
          EXPECT_LT(tangent.error.col(i).norm(), 1e-15 * tangent.slope.col(i).norm()) << i;
          ++compared;
        }
      }
  EXPECT_GT(compared, 200);
}

/// A cube of edge 1/2, its bottom at z = 0, on a wide plate whose top is raised by 1/16, both of exact coordinates.
struct CubeOnPlate {
  TriangleMesh cube = generate::box({-0.25, -0.25, 0}, {0.25, 0.25, 0.5}),
               plate = generate::box({-2, -2, -1}, {2, 2, 0});
  State12 state{shifted(0, 0, 0.0625), {}};

  Tangent tangent(const ContactLaw& law, Problem problem = Problem::exact) const {
    return tangent_of(Oracle(cube, plate, law), problem, state);
  }
};

/// Area, penetration and position, as the master's frame has them, of an element.
Eigen::Matrix<double, 5, 1> seen_by_master(const Element& e, const Pose& pose) {
  Eigen::Matrix<double, 5, 1> seen;
  seen << e.area, e.penetration,
      (e.master == Side::E ? e.position_Me : Eigen::Vector3d(pose.A.transpose() * (e.position_Me - pose.r)));
  return seen;
}

TEST(OracleTangent, TellsHowElementsMoveAsTheirMasterSeesThem) {
  const TriangleMesh E = generate::icosphere(1, 2), F = generate::icosphere(0.9, 2);
  const double h = 1e-6;
  std::mt19937_64 random(4);
  std::cout << "seed 4\n";
  int compared = 0;
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const Oracle oracle(E, F, law_of_all(DampingMode::full), Mode::both, scheme);
    State12 state{random_pose(random, 0), {}};
    state.pose.r = 1.7 * (state.pose.A * Eigen::Vector3d(0.6, 0.48, 0.64));
    Inquiry inquiry(oracle, state.pose);
    const Answer here = inquiry.answer(Problem::exact);
    const Tangent tangent = inquiry.tangent(Problem::exact, Mode::both);
    ASSERT_EQ(tangent.elements.size(), here.elements.size());
    for (int i = 0; i < 6; ++i) {
      const Pose pose_ahead = displaced(state, i, h).pose, pose_behind = displaced(state, i, -h).pose;
      const Answer ahead = oracle.answer(Problem::exact, pose_ahead),
                   behind = oracle.answer(Problem::exact, pose_behind);
      if (ahead.elements.size() != here.elements.size() || behind.elements.size() != here.elements.size()) continue;
      for (std::size_t k = 0; k < here.elements.size(); ++k) {
        auto slope = tangent.elements[k].slope.col(i).eval();
        // Positions are told in Me's axes.
        if (here.elements[k].master == Side::F) slope.tail<3>() = state.pose.A.transpose() * slope.tail<3>();
        const auto quotient =
            ((seen_by_master(ahead.elements[k], pose_ahead) - seen_by_master(behind.elements[k], pose_behind)) /
             (2 * h))
                .eval();
        // Small parts have small areas that grow quickly.
        EXPECT_LT((slope - quotient).norm(), 1e-3 * (1 + slope.norm())) << i << " " << k << "\n"
                                                                        << slope.transpose() << "\n"
                                                                        << quotient.transpose();
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 200);
}

TEST(OracleTangent, IsEnclosedAsNarrowlyWherePartsEndAtFacesThatHardlyCross) {
  const TriangleMesh E = generate::box({4, 4, 1}), F = generate::gridded_box({1, 1, 1}, {2, 2, 1});
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
    for (int exponent = 10; exponent <= 45; exponent += 5) {
      ContactLaw law = law_of_all(DampingMode::full);
      law.friction = 0;
      const Oracle oracle(E, F, law, Mode::both, scheme);
      State12 state{{}, {{0.3, -0.2, 0.1}, {0.5, 0.4, -0.3}}};
      state.pose.A =
          Eigen::AngleAxisd(std::ldexp(1, -exponent), Eigen::Vector3d(1, 2, 0).normalized()).toRotationMatrix();
      state.pose.r = {0.25, 0.125, 1};
      const Tangent tangent = tangent_of(oracle, Problem::exact, state);
      // But for what rounding a slope to a double makes.
      const Eigen::Matrix<double, 6, 12> open = tangent.error - 0x1p-53 * tangent.slope.cwiseAbs();
      for (const int row : {0, 3})
        for (const int column : {0, 3, 6, 9}) {
          const double size = tangent.slope.block<3, 6>(row, column < 6 ? 0 : 6).cwiseAbs().maxCoeff();
          EXPECT_LE((open.block<3, 3>(row, column).maxCoeff()), 0x1p-58 * size) << exponent << ": " << row << column;
        }
    }
}

TEST(OracleTangent, OfACubeOnAPlateIsStiffnessTimesArea) {
  ContactLaw law;
  law.stiffness = 100;
  for (const Problem problem : kProblems) {
    const Tangent tangent = CubeOnPlate().tangent(law, problem);
    // The plate rises by dz and presses the cube up: 100 times the area 1/4. About Mf, below the cube, no torque.
    Eigen::Matrix<double, 6, 12> expected = Eigen::Matrix<double, 6, 12>::Zero();
    const double N = 100 * 0.25 * 0.0625;
    expected(2, 2) = 25;
    // The arm from Mf loses dr, N up.
    expected(3, 1) = -N;
    expected(4, 0) = N;
    // Two elements with their barycentres at +-1/12 in x and y, an area of 1/8 each; the elements' positions stay.
    const double tilt = 2 * 100 * 0.125 / 144;
    expected(3, 3) = expected(4, 4) = tilt;
    expected(3, 4) = expected(4, 3) = tangent.slope(3, 4);  // of the diagonal's sign
    EXPECT_EQ(std::abs(tangent.slope(3, 4)), tilt);
    EXPECT_TRUE(tangent.slope.isApprox(expected, 1e-14)) << tangent.slope - expected;
    EXPECT_LT(tangent.error.maxCoeff(), 1e-14);
  }
}

/// Where the square's border is that of a cell, and the sheet of the cells goes on while the square's ends.
TEST(OracleTangent, OfASquareOnACellOfItsSizeIsAsIfNoEdgesLayOnOneAnother) {
  const TriangleMesh square_above = generate::box({-0.5, -0.5, 0}, {0.5, 0.5, 1}),
                     square_below = generate::box({-0.5, -0.5, -1}, {0.5, 0.5, 0});
  const TriangleMesh cells_below = generate::gridded_box({-1.5, -1.5, -1}, {1.5, 1.5, 0}, {3, 3, 1}),
                     cells_above = generate::gridded_box({-1.5, -1.5, 0}, {1.5, 1.5, 1}, {3, 3, 1});
  ContactLaw law;
  law.stiffness = 1000;
  Pose pose;
  pose.r = {0, 0, -0.0625};
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    for (const Problem problem : {Problem::exact, Problem::rounded}) {
      const auto expect = [&](const Oracle& oracle, double dM_y_dx) {
        const Tangent tangent = tangent_of(oracle, problem, {pose, {}});
        const auto expect_entry = [&](int row, int column, double expected) {
          EXPECT_LT(tangent.error(row, column), 1e-20);
          EXPECT_LE(std::abs(tangent.slope(row, column) - expected), tangent.error(row, column))
              << "mode " << static_cast<int>(mode) << ", " << row << ", " << column;
        };
        expect_entry(4, 0, dM_y_dx);
        expect_entry(2, 0, 0);
        expect_entry(2, 1, 0);
        expect_entry(2, 2, 1000);
      };
      // 62.5 N at F's own middle, wherever that is; and at E's, which F's marker leaves.
      expect(Oracle(cells_below, square_above, law, mode, Scheme::clipped), 0);
      expect(Oracle(square_below, cells_above, law, mode, Scheme::clipped), -62.5);
    }
  }
}

/// By the coordinates of the pose, or the first of them, of a plate E and blocks F.
void expect_differences(const TriangleMesh& plate, const TriangleMesh& blocks, const Pose& pose, int coordinates = 6) {
  const double h = 0x1p-20;
  ContactLaw law;
  law.stiffness = 7;
  const Oracle oracle(plate, blocks, law, Mode::E, Scheme::clipped);
  const State12 state{pose, {}};
  const Tangent tangent = tangent_of(oracle, Problem::rounded, state);
  for (int i = 0; i < coordinates; ++i) {
    const auto load = [&](double by) {
      return load_of(oracle.answer(Problem::rounded, displaced(state, i, by).pose, {}));
    };
    const Load quotient = (load(h) - load(-h)) / (2 * h);
    EXPECT_LT((tangent.slope.col(i) - quotient).norm(), 1e-3 + 1e-5 * quotient.norm()) << i;
  }
}

/// What e sees of a face is cut along the line of one edge, and ends beyond that at another one, deeper or less deep.
TEST(OracleTangent, WhereTheLineOfAnEdgeGoesOnAlongOtherEdgesIsThatOfDifferences) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    const pcm::test::SunkenBlocks bodies(seed);
    SCOPED_TRACE(seed);
    expect_differences(bodies.plate, bodies.blocks, bodies.pose);
  }
}

/// The walls of the last block end in the floor of the first; with each side of its faces first in turn.
TEST(OracleTangent, WhereTheLineOfAnEdgeGoesOnAlongWallsThatEndInTheFloorIsThatOfDifferences) {
  using degenerate::leaning_block;
  TriangleMesh one = leaning_block({-5, 3}, {-4, 4}, -0.5, 6, 0.5), other = leaning_block({-1, 1}, {1, 3}, -1, 6, 0.5);
  const auto begin_with_the_next = [](TriangleMesh& mesh) {
    for (Triangle& face : mesh.faces) face = {face[1], face[2], face[0]};
  };
  for (int i = 0; i < 9; ++i) {
    SCOPED_TRACE(i);
    begin_with_the_next(one);
    if (i % 3 == 0) begin_with_the_next(other);
    const TriangleMesh blocks =
        degenerate::joined(degenerate::joined(leaning_block({-6, -6}, {6, 6}, -1, 4, 1.25), one), other);
    expect_differences(generate::box({-16, -17, -5}, {16, 16, 0}), blocks, shifted(0.125, 0.25, 0));
  }
}

TEST(OracleTangent, WhereAnEdgeOfTheMastersOwnLiesInTheSlavesFloorIsThatOfDifferences) {
  for (const double slope : {-0.125, 0.125})
    for (const double width : {1.0, 1.75}) {
      SCOPED_TRACE(testing::Message() << slope << ", " << width);
      const auto [plate, floor, pose] = pcm::test::BlockAndSlopingTop(slope, width);
      expect_differences(plate, floor, pose);
      expect_differences(plate, floor, {}, 3);  // along the floor's diagonal
    }
}

/// The part of the sheet that is seen ends at an edge of its own, beyond which it goes on unseen.
TEST(OracleTangent, WhereASheetIsHiddenFromAnInnerEdgeOnIsThatOfDifferences) {
  for (const double slope : {0.0, -0.25, 0.25}) {
    SCOPED_TRACE(slope);
    const pcm::test::BlockThroughCells bodies(slope);
    expect_differences(bodies.plate, bodies.blocks, bodies.pose);
  }
}

TEST(OracleTangent, AtAKinkIsThatOfOneSide) {
  ContactLaw law;
  law.stiffness = 100;
  law.max_penetration = 0.0625;  // as deep as the cube is
  EXPECT_EQ(CubeOnPlate().tangent(law).slope(2, 2), 0);
  law.max_penetration = 0.125;
  EXPECT_EQ(CubeOnPlate().tangent(law).slope(2, 2), 25);

  law.max_penetration = std::numeric_limits<double>::infinity();
  law.damping = 8;
  law.transition_depth = 0.0625;
  EXPECT_EQ(CubeOnPlate().tangent(law).slope(2, 8), 8 * 0.25);
  law.damping_mode = DampingMode::compression;  // at rest it counts as approaching
  EXPECT_EQ(CubeOnPlate().tangent(law).slope(2, 8), 8 * 0.25);

  CubeOnPlate parting;
  parting.state.velocity.v.z() = -1;
  EXPECT_EQ(parting.tangent(law).slope(2, 8), 0);
  law.damping_mode = DampingMode::no_tension;
  law.transition_depth = 0;
  parting.state.velocity.v.z() = -100 * 0.0625 / 8;  // the pull of damping is the push of stiffness
  EXPECT_EQ(parting.tangent(law).slope(2, 8), 8 * 0.25);
  parting.state.velocity.v.z() *= 2;
  EXPECT_EQ(parting.tangent(law).slope(2, 8), 0);
}

TEST(OracleTangent, WhereOnlyTheBorderOfAPartIsAtTheClampIsThatOfPenetrationsBelowIt) {
  // An edge a quarter deep in a plate, between two faces that rise by 45 degrees: 1/2 wide, and 1 long.
  const TriangleMesh plate = generate::box({-2, -2, -1}, {2, 2, 0}), wedge = generate::wedge(45, 1, 1);
  ContactLaw law;
  law.stiffness = 100;
  for (const double most : {0.25, 0.5}) {
    law.max_penetration = most;
    for (const Problem problem : kProblems)
      EXPECT_NEAR(tangent_of(Oracle(plate, wedge, law, Mode::E, Scheme::clipped), problem, {shifted(0, 0, -0.25), {}})
                      .slope(2, 2),
                  50, 1e-12)
          << most;
  }
}

TEST(OracleTangent, OfFrictionAtRestIsItsSlopeThereAndWithoutSlipVelocityNone) {
  ContactLaw law;
  law.stiffness = 100;
  law.friction = 0.5;
  EXPECT_EQ(CubeOnPlate().tangent(law).slope(0, 6), 0);
  law.slip_velocity = 0.25;
  EXPECT_EQ(CubeOnPlate().tangent(law).slope(0, 6), 2 * 0.5 * 100 * 0.25 * 0.0625 / 0.25);
  CubeOnPlate sliding;
  sliding.state.velocity.v.x() = 0.25;  // as fast as that: sliding
  EXPECT_EQ(sliding.tangent(law).slope(0, 6), 0);
  EXPECT_EQ(sliding.tangent(law).slope(1, 7), 0.5 * 100 * 0.25 * 0.0625 / 0.25);
}

}  // namespace
}  // namespace pcm::reference
