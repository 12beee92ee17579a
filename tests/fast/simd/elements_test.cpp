// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/simd/element_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "fast/base/ascending.h"
#include "fast/base/depth.h"
#include "fast/base/geometry.h"
#include "fast/force/force_problem.h"
#include "fast/predicates/penetration_predicates.h"
#include "fast/simd/overlap_sets.h"

/// Elements computed four at a time against the same computed one by one: bit for bit, on every set of instructions.
namespace pcm::fast {
namespace {

std::uint64_t bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}
void expect_same(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  for (int k = 0; k < 3; ++k) EXPECT_EQ(bits(a[k]), bits(b[k])) << a.transpose() << " against " << b.transpose();
}

/// For faces of size `scale`, no farther than 16 times that from the origin.
DecisionLimits limits_at(double scale) {
  DecisionLimits limits;
  limits.least_share = 0x1p-10;
  limits.max_coordinate = 16 * scale;
  limits.slave_max_coordinate = scale;
  limits.error = 0x1p-30 * scale;
  limits.thick_edges = 0x1p-40;
  limits.thick_area = 1 / scale;
  limits.cone_cosine_square = {0.9, 0.3};
  return limits;
}

/// Calls `visit` with each set of kernels that this processor can run.
template <class Visit>
void for_each_set(const Visit& visit) {
  for (const WideElements* set : all_wide_elements())
    if (set != nullptr) visit(*set);
}

/// Master faces and slave faces somewhere beneath them, of size `scale`.
class WideElementsAt : public testing::TestWithParam<double> {
 protected:
  Eigen::Vector3d draw() { return GetParam() * Eigen::Vector3d(number(random), number(random), number(random)); }
  void draw(ElementLanes& lanes) {
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      const Eigen::Vector3d at = 8 * draw();
      for (std::size_t k = 0; k < 3; ++k) master_points[lane][k] = at + draw();
      const FaceGeometry face(master_points[lane]);
      const Eigen::Vector3d below = -0.5 * GetParam() * number(random) * face.n_Me;
      for (std::size_t k = 0; k < 3; ++k) slave_points[lane][k] = face.points_Me[k] + below + 0.1 * draw();
      lanes.thickness.value[lane] = 4 * GetParam() * number(random);
      for (std::size_t cone = 0; cone < 2; ++cone) {
        lanes.clearance[lane].beneath[cone] = static_cast<float>(std::max(number(random), 0.0));
        lanes.clearance[lane].above[cone] = number(random) > 0;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        lanes.master_corners[k][lane] = master_points[lane][k].data();
        lanes.slave_corners[k][lane] = slave_points[lane][k].data();
      }
    }
  }
  static ContactLaw law_of(int round) {
    ContactLaw law;
    law.damping = round % 2 == 0 ? 1000 : 0;
    law.transition_depth = round % 3 == 0 ? GetParam() : 0;
    law.friction = round % 5 == 0 ? 0 : 0.25;
    law.slip_velocity = round % 4 == 0 ? 0 : GetParam();
    law.damping_mode = static_cast<DampingMode>(round % 3);
    return law;
  }
  static DecisionLimits limits() { return limits_at(GetParam()); }

  // What the lanes last drawn refer to.
  std::array<std::array<Eigen::Vector3d, 3>, kElementLanes> master_points, slave_points;
  std::mt19937_64 random{20047};
  std::uniform_real_distribution<double> number{-1, 1};
};

TEST_P(WideElementsAt, GeometryIsThatOfEachFace) {
  for_each_set([&](const WideElements& set) {
    for (int round = 0; round < 200; ++round) {
      ElementLanes lanes;
      draw(lanes);
      if (round % 7 == 0) master_points[1][2] = master_points[1][0];  // no area
      const LaneBits known = set.geometry(lanes);
      for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
        const FaceGeometry face(master_points[lane]);
        for (std::size_t k = 0; k < 3; ++k) expect_same(lanes.p_Me[k][lane], master_points[lane][k]);
        expect_same(lanes.barycentre_Me[lane], face.barycentre_Me());
        EXPECT_EQ(has_lane(known, lane), face.area > 0 && GetParam() > 0x1p-200 && GetParam() < 0x1p200);
        if (!has_lane(known, lane)) continue;
        EXPECT_EQ(bits(lanes.area.value[lane]), bits(face.area));
        expect_same(lanes.n_Me[lane], face.n_Me);
      }
    }
  });
}

/// Whether the line passes through the face from within its body, exactly.
bool leaves_through(const FacePoints& master, const FacePoints& slave) {
  WorkCounters work;
  const PenetrationLine line(master[0], master[1], master[2]);
  return facing(line, slave, work) < 0 && passes_through(line, slave, work);
}

TEST_P(WideElementsAt, LeavingIsSaidWhereItIsSoAndNotWhereItIsNot) {
  const auto [portable, wide] = all_wide_elements();
  int surely = 0, surely_not = 0;
  for (int round = 0; round < 1000; ++round) {
    ElementLanes lanes;
    draw(lanes);
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      auto& slave = slave_points[lane];
      if (round % 3 != 0) std::swap(slave[0], slave[2]);  // To look the other way.
      if (round % 2 == 0) continue;
      // The line passes through a corner or an edge of the slave's face, but for the roundings of these two lines.
      const FaceGeometry face(master_points[lane]);
      const Eigen::Vector3d on_line = face.barycentre_Me() - GetParam() * face.n_Me;
      slave[1] = round % 4 == 1 ? on_line : 2 * on_line - slave[0];
    }
    portable->geometry(lanes);
    const LeavingLanes leaving = portable->leave(lanes, limits());
    EXPECT_EQ(leaving.surely & leaving.surely_not, 0U);
    surely += std::popcount(leaving.surely);
    surely_not += std::popcount(leaving.surely_not);
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      const bool leaves = leaves_through(master_points[lane], slave_points[lane]);
      EXPECT_FALSE(has_lane(leaving.surely, lane) && !leaves);
      EXPECT_FALSE(has_lane(leaving.surely_not, lane) && leaves);
    }
    if (wide == nullptr) continue;
    const LeavingLanes again = wide->leave(lanes, limits());
    EXPECT_EQ(leaving.surely, again.surely);
    EXPECT_EQ(leaving.surely_not, again.surely_not);
  }
  // Near the ends of the range of doubles the bound of the side tests says nothing.
  const bool usual = GetParam() > 0x1p-200 && GetParam() < 0x1p200;
  EXPECT_EQ(surely > 500, usual) << surely;
  EXPECT_EQ(surely_not > 500, usual) << surely_not;
}

/// Four times the same two faces.
ElementLanes lanes_of(const FacePoints& master, const FacePoints& slave) {
  ElementLanes lanes;
  for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
    for (std::size_t k = 0; k < 3; ++k) {
      lanes.master_corners[k][lane] = master[k].data();
      lanes.slave_corners[k][lane] = slave[k].data();
    }
  }
  return lanes;
}

TEST(WideElements, LinesThroughAnEdgeOfTheSlavesFaceAreNotDecidedUntilTheyAreSurelyOffIt) {
  // The line is x = y = 1, and an edge of the slave's face lies on x = 1 + off.
  const FacePoints master{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(0, 3, 0)};
  // D of the edge is 63 times its distance; 128 u M |a| |b| W is 2^-36.8 with M = 16, |a| = |b| = 3 and W = 4.
  for (const double off : {0.0, 0x1p-52, 0x1.2p-43, 0x1p-42, 0x1p-40}) {
    for (const double x : {1 + off, 1 - off}) {
      const FacePoints slave{Eigen::Vector3d(x, 5, -1), Eigen::Vector3d(4, 0, -1), Eigen::Vector3d(x, -2, -1)};
      ElementLanes lanes = lanes_of(master, slave);
      for_each_set([&](const WideElements& set) {
        set.geometry(lanes);
        const LeavingLanes leaving = set.leave(lanes, limits_at(1));
        const bool decided = off >= 0x1p-42;
        EXPECT_EQ(leaving.surely, decided && leaves_through(master, slave) ? 0xfU : 0U) << x - 1;
        EXPECT_EQ(leaving.surely_not, decided && !leaves_through(master, slave) ? 0xfU : 0U) << x - 1;
      });
    }
  }
}

TEST(WideElements, OfALineFromANeedleNothingIsSaid) {
  const FacePoints master{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(1.5, 0x1p-12, 0)};
  for (const double x : {-4.0, 4.0}) {
    const FacePoints slave{Eigen::Vector3d(x, 5, -1), Eigen::Vector3d(8, 0, -1), Eigen::Vector3d(x, -2, -1)};
    ElementLanes lanes = lanes_of(master, slave);
    for_each_set([&](const WideElements& set) {
      set.geometry(lanes);
      const LeavingLanes leaving = set.leave(lanes, limits_at(1));
      EXPECT_EQ(leaving.surely | leaving.surely_not, 0U) << x;
    });
  }
}

TEST(WideElements, ALineFindsWhatItLeavesWhereNoOtherFaceIsMetSoFar) {
  const FacePoints master{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(0, 3, 0)};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double depth : {1.0, -1.0}) {
    const FacePoints slave{Eigen::Vector3d(0, 0, -depth), Eigen::Vector3d(0, 3, -depth), Eigen::Vector3d(3, 0, -depth)};
    for (const double free : {0.0, 0.5, 1.0, 1 + 0x1p-31, 1 + 0x1p-29, 2.0, kInfinity}) {
      ElementLanes lanes = lanes_of(master, slave);
      lanes.thickness.value.fill(4);
      lanes.slave_free.value.fill(free);
      for_each_set([&](const WideElements& set) {
        set.geometry(lanes);
        const DecidedLanes decided = set.decide(lanes, limits_at(1));
        EXPECT_EQ(decided.left, depth > 0 ? 0xfU : 0U);
        EXPECT_EQ(decided.element, depth > 0 && free > 1 + 0x1p-30 ? 0xfU : 0U) << free;
        EXPECT_EQ(decided.nothing, depth < 0 && free == kInfinity ? 0xfU : 0U) << free;
      });
    }
  }
}

TEST(WideElements, WhatAFaceIsClearOfIsTakenFromTheNarrowestConeThatTheLineLiesIn) {
  const FacePoints master{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(0, 3, 0)};
  const std::array<double, 2> cosine_square = limits_at(1).cone_cosine_square;
  for (const double tilt : {0.0, 0.1, 0.31, 0.34, 0.6, 0.98, 1.0, 1.2, 1.3, 1.35}) {
    for (const double distance : {1.0, -1.0}) {
      // Its normal is tilted out of the line's direction, and the line meets it at the distance.
      const double slope = std::tan(tilt);
      const FacePoints slave{Eigen::Vector3d(1, -2, -distance), Eigen::Vector3d(-2, 4, -distance - 3 * slope),
                             Eigen::Vector3d(4, 4, -distance + 3 * slope)};
      const double cosine = std::cos(tilt);
      std::size_t cone = 0;
      while (cone < 2 && cosine * cosine < cosine_square[cone]) ++cone;
      for (std::size_t clear = 0; clear < 2; ++clear) {
        for (const double depth : {0.999 * cosine, 1.001 * cosine}) {
          ElementLanes lanes = lanes_of(master, slave);
          lanes.thickness.value.fill(4);
          lanes.slave_free.value.fill(0);
          for (Clearance& clearance : lanes.clearance) {
            clearance.beneath[clear] = static_cast<float>(depth);
            clearance.above[clear] = true;
          }
          for_each_set([&](const WideElements& set) {
            set.geometry(lanes);
            const DecidedLanes decided = set.decide(lanes, limits_at(1));
            EXPECT_EQ(decided.left, distance > 0 && cosine > 0.25 ? 0xfU : 0U) << tilt;
            EXPECT_EQ(decided.element, distance > 0 && clear == cone && depth > cosine ? 0xfU : 0U) << tilt;
            EXPECT_EQ(decided.nothing, distance < 0 && clear == cone ? 0xfU : 0U) << tilt;
          });
        }
      }
    }
  }
}

TEST_P(WideElementsAt, DepthIsThatOfEachPair) {
  const auto [portable, wide] = all_wide_elements();
  int depths = 0;
  for (int round = 0; round < 1000; ++round) {
    ElementLanes lanes;
    draw(lanes);
    portable->geometry(lanes);
    ElementLanes wide_lanes = lanes;
    const DecidedLanes decided = portable->decide(lanes, limits());
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      if (!has_lane(decided.element & decided.nearest_known, lane)) continue;
      ++depths;
      const DepthBelow depth(FaceGeometry(master_points[lane]), slave_points[lane]);
      EXPECT_EQ(bits(lanes.depth.value[lane]), bits(depth.value()));
    }
    if (wide == nullptr) continue;
    const DecidedLanes again = wide->decide(wide_lanes, limits());
    EXPECT_EQ(decided.nothing, again.nothing);
    EXPECT_EQ(decided.left, again.left);
    EXPECT_EQ(decided.element, again.element);
    EXPECT_EQ(decided.nearest_known, again.nearest_known);
    for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
      EXPECT_EQ(bits(lanes.depth.value[lane]), bits(wide_lanes.depth.value[lane]));
    }
  }
  // Near the ends of the range of doubles the kernels know no geometry, and say so.
  EXPECT_EQ(depths > 0, GetParam() > 0x1p-200 && GetParam() < 0x1p200);
}

TEST_P(WideElementsAt, ForceIsThatOfEachElement) {
  for_each_set([&](const WideElements& set) {
    int compared = 0;
    for (int round = 0; round < 400; ++round) {
      ElementLanes lanes;
      draw(lanes);
      const LaneBits with_geometry = set.geometry(lanes);
      for (double& depth : lanes.depth.value) depth = GetParam() * (number(random) + 1);
      const ContactLaw law = law_of(round);
      const Pose pose{Eigen::Matrix3d::Identity(), draw()};
      Velocity velocity;
      if (round % 11 != 0) velocity = {draw(), draw() / GetParam()};
      ForceProblem problem(law, pose, velocity, {});
      problem.with_velocities = round % 6 != 0;
      const Side master = round % 2 == 0 ? Side::E : Side::F;
      const LaneBits known = with_geometry & set.force(lanes, force_limits(problem, master));
      for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
        if (!has_lane(known, lane)) continue;
        ++compared;
        Element element;
        element.master = master;
        element.area = lanes.area.value[lane];
        element.penetration = lanes.depth.value[lane];
        element.normal_Me = -lanes.n_Me[lane];
        apply_force(problem, lanes.barycentre_Me[lane], element);
        EXPECT_EQ(bits(lanes.normal_velocity.value[lane]), bits(element.normal_velocity));
        EXPECT_EQ(bits(lanes.tangential_velocity.value[lane]), bits(element.tangential_velocity));
        EXPECT_EQ(bits(lanes.normal_force.value[lane]), bits(element.normal_force));
        EXPECT_EQ(bits(lanes.tangential_force.value[lane]), bits(element.tangential_force));
        expect_same(lanes.position_Me[lane], element.position_Me);
        expect_same(lanes.force_Me[lane], element.force_Me);
        expect_same(lanes.torque_Me[lane], (element.position_Me - pose.r).cross(element.force_Me));
      }
    }
    // Near the ends of the range of doubles the kernels know no geometry, and say so.
    EXPECT_EQ(compared > 500, GetParam() > 0x1p-200 && GetParam() < 0x1p200) << compared;
  });
}

/// Lanes by the bits of all numbers that a tangent is made of; what is no number has no sign.
std::vector<std::uint64_t> bits_of(const ElementLanes& lanes, const TangentLanes& sums) {
  std::vector<std::uint64_t> all;
  const auto add = [&all](double x) { all.push_back(std::isnan(x) ? ~std::uint64_t{0} : bits(x)); };
  for (const DoubleLanes& gradient : lanes.depth_gradient_Me.component)
    for (const double x : gradient.value) add(x);
  for (const MatrixLanes* matrix :
       {&sums.force_by_position, &sums.force_by_rotation, &sums.force_by_velocity, &sums.force_by_lever,
        &sums.torque_by_position, &sums.torque_by_rotation, &sums.torque_by_velocity, &sums.torque_by_lever})
    for (const DoubleLanes& entry : *matrix)
      for (const double x : entry.value) add(x);
  return all;
}

TEST_P(WideElementsAt, TangentIsThatOfEachSetAndOfTheLanesAskedForAlone) {
  const auto [portable, wide] = all_wide_elements();
  for (int round = 0; round < 400; ++round) {
    ElementLanes lanes;
    draw(lanes);
    portable->geometry(lanes);
    for (double& depth : lanes.depth.value) depth = GetParam() * (number(random) + 1);
    const ContactLaw law = law_of(round);
    const Pose pose{Eigen::Matrix3d::Identity(), draw()};
    const Velocity velocity{draw(), draw() / GetParam()};
    ForceProblem problem(law, pose, velocity, {});
    problem.with_velocities = round % 6 != 0;
    const ForceLimits limits = force_limits(problem, round % 2 == 0 ? Side::E : Side::F);
    portable->force(lanes, limits);
    const auto which = static_cast<LaneBits>(round % 16);
    ElementLanes spoilt = lanes;
    for (std::size_t lane = 0; lane < kElementLanes; ++lane)
      if (!has_lane(which, lane)) spoilt.position_Me.set(lane, Eigen::Vector3d::Constant(std::nan("")));
    ElementLanes again = lanes;
    TangentLanes sums, spoilt_sums, again_sums;
    portable->gradient(lanes);
    portable->gradient(spoilt);
    portable->tangent(lanes, limits, which, sums);
    portable->tangent(spoilt, limits, which, spoilt_sums);
    EXPECT_EQ(bits_of(lanes, sums), bits_of(spoilt, spoilt_sums));
    if (wide == nullptr) continue;
    wide->gradient(again);
    wide->tangent(again, limits, which, again_sums);
    EXPECT_EQ(bits_of(lanes, sums), bits_of(again, again_sums));
  }
}

std::string name_of(const testing::TestParamInfo<double>& info) {
  return info.param > 1 ? "Great" : info.param == 1 ? "Usual" : "Small";
}
INSTANTIATE_TEST_SUITE_P(Units, WideElementsAt, testing::Values(1.0, 0x1p260, 0x1p-280), name_of);

// Elsewhere comparisons with the wide kernels have nothing to compare.
TEST(WideElements, AreThereWhereBuildAndProcessorHaveThem) {
  const auto [portable, wide] = all_wide_elements();
  ASSERT_NE(portable, nullptr);
#if defined(PCM_BUILT_WIDE)
  if (__builtin_cpu_supports("avx2")) {
    EXPECT_NE(wide, nullptr);
    EXPECT_NE(all_wide_tests()[1], nullptr);
    EXPECT_EQ(&fastest_wide_elements(), wide);
    return;
  }
#endif
  EXPECT_EQ(wide, nullptr);
  GTEST_SKIP() << "this processor or build has no wide instructions";
}

TEST(SortAscending, DenseAndSparseIndicesComeInOrder) {
  std::mt19937 random{20048};
  SCOPED_TRACE("seed 20048");
  std::vector<std::uint64_t> marks;
  for (const Index spread : {1, 3, 100, 5000}) {
    for (const Index count : {0, 1, 2, 64, 65, 700}) {
      std::vector<Index> indices;
      for (Index i = 0; i < count; ++i) indices.push_back(1000 + spread * i + (spread > 1 ? i % 2 : 0));
      const std::vector<Index> sorted = indices;
      std::shuffle(indices.begin(), indices.end(), random);
      sort_ascending(indices, marks);
      EXPECT_EQ(indices, sorted) << spread << ' ' << count;
    }
  }
}

}  // namespace
}  // namespace pcm::fast
