// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The laws and velocities that verification draws: the same everywhere, with the shares promised, and not vacuous.
#include "compare/poses/law_draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "compare/poses/law_thresholds.h"
#include "compare/verify/verdict/question_range.h"
#include "fast/force/law_parameters.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"

namespace pcm::compare::law_draw_test {
namespace {

/// Changes only with the construction of the draws, and then for every later table too.
constexpr std::uint64_t kGoldenHash = 0xa1d5ca962c1098ea;

constexpr double kSize = 0.75;
const std::vector<double> kPenetrations = {0x1.23456789abcdep-9, 0x1.fp-6, 0x1.8p-3, 0.1};
const std::vector<double> kSpeeds = {0x1.3p-8, 0.3, 0x1.23456789abcdep+1};

PoseRandom random_for(std::uint64_t pose, Purpose purpose = Purpose::law) {
  return {7, 2, 3, pose, purpose};
}

ContactLaw law_for(std::uint64_t pose) {
  PoseRandom random = random_for(pose);
  return draw_law(random, kSize, kPenetrations, kSpeeds);
}

std::uint64_t hash_of(const std::vector<double>& numbers, std::uint64_t hash) {
  for (const double x : numbers)
    for (int k = 0; k < 64; k += 8) hash = (hash ^ (std::bit_cast<std::uint64_t>(x) >> k & 0xff)) * 0x100000001b3;
  return hash;
}

std::uint64_t hash_of(const ContactLaw& law, std::uint64_t hash) {
  const LayerStiffness layers = law.layers.value_or(LayerStiffness{0, 0});
  return hash_of({law.stiffness, layers.c_E, layers.c_F, law.damping, law.transition_depth, law.friction,
                  law.slip_velocity, law.max_penetration, static_cast<double>(law.damping_mode)},
                 hash);
}

/// Where a threshold lies among the figures.
std::string place_of(double threshold, double off, const std::vector<double>& figures) {
  if (threshold == off) return "off";
  for (const double figure : figures) {
    // Doubles of one sign are ordered like their bits.
    const auto ulps =
        static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(threshold) - std::bit_cast<std::uint64_t>(figure));
    if (ulps == 0) return "at";
    if (std::abs(ulps) <= 4) return "near";
  }
  return "generic";
}

/// Counts what the draws are, and holds the shares against those of the header by five standard deviations.
class Shares {
 public:
  explicit Shares(int draws) : draws_(draws) {}
  void add(const std::string& what) { ++counts_[what]; }
  void expect(const std::string& what, double share) const {
    const auto found = counts_.find(what);
    const double deviation = std::sqrt(draws_ * share * (1 - share));
    EXPECT_NEAR(found == counts_.end() ? 0 : found->second, draws_ * share, 5 * deviation) << what;
  }

 private:
  int draws_;
  std::map<std::string, int> counts_;
};

TEST(LawDraw, LawsAndVelocitiesAreTheSameBitsOnEveryMachine) {
  const TriangleMesh cube = generate::box({1, 1, 1}), ball = generate::icosphere(0.75, 1);
  const FeaturePair pair(cube, ball);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::uint64_t i = 0; i < 500; ++i) {
    hash = hash_of(law_for(i), hash);
    PoseRandom random = random_for(i, Purpose::velocity);
    const Velocity velocity = draw_velocity(random, pair, Pose{});
    for (const Eigen::Vector3d& x : {velocity.v, velocity.w}) hash = hash_of({x.x(), x.y(), x.z()}, hash);
  }
  EXPECT_EQ(hash, kGoldenHash) << std::hex << "0x" << hash;
}

TEST(LawDraw, EachPurposeOfAPoseHasNumbersOfItsOwn) {
  PoseRandom usual(7, 2, 3, 1), pose = random_for(1, Purpose::pose), law = random_for(1);
  PoseRandom velocity = random_for(1, Purpose::velocity);
  for (int k = 0; k < 100; ++k) {
    const std::uint64_t bits = pose.bits();
    EXPECT_EQ(bits, usual.bits()) << "poses are drawn as ever";
    const std::uint64_t of_law = law.bits();
    EXPECT_NE(bits, of_law);
    EXPECT_NE(of_law, velocity.bits());
  }
}

TEST(LawDraw, ChoicesHaveTheSharesPromised) {
  constexpr int kDraws = 20000;
  Shares shares(kDraws);
  int clamp_between = 0;
  for (std::uint64_t i = 0; i < kDraws; ++i) {
    const ContactLaw law = law_for(i);
    ASSERT_NO_THROW(fast::require_valid(law)) << i;
    shares.add("damping mode " + std::to_string(static_cast<int>(law.damping_mode)));
    if (!law.layers) {
      shares.add("plain");
    } else if (std::isinf(law.layers->c_E)) {
      shares.add("E rigid");
    } else if (std::isinf(law.layers->c_F)) {
      shares.add("F rigid");
    } else {
      const double ratio = law.layers->c_F / law.layers->c_E;
      ASSERT_LE(std::abs(std::log2(ratio)), 40);
      shares.add(std::abs(std::log2(ratio)) > 20 ? ratio > 1 ? "F much stiffer" : "E much stiffer" : "layers alike");
      if (ratio == 1) shares.add("equal layers");
      if (std::abs(std::log2(ratio)) == 40) shares.add("greatest ratio");
    }
    shares.add(law.damping == 0 ? "undamped" : "damped");
    shares.add(law.friction == 0 ? "frictionless" : "friction");
    shares.add("u_d " + place_of(law.transition_depth, 0, kPenetrations));
    shares.add("clamp " + place_of(law.max_penetration, std::numeric_limits<double>::infinity(), kPenetrations));
    const auto [least, greatest] = std::minmax_element(kPenetrations.begin(), kPenetrations.end());
    clamp_between += law.max_penetration > *least && law.max_penetration < *greatest;
    shares.add("v_eps " + place_of(law.slip_velocity, 0, kSpeeds));
  }
  for (const char* mode : {"damping mode 0", "damping mode 1", "damping mode 2"}) shares.expect(mode, 1.0 / 3);
  shares.expect("plain", 1.0 / 2);
  for (const char* rigid : {"E rigid", "F rigid"}) shares.expect(rigid, 1.0 / 8);
  // Of 41 exponents 20, and half of the others' range of 40.
  for (const char* stiffer : {"F much stiffer", "E much stiffer"})
    shares.expect(stiffer, 1.0 / 8 * (20.0 / 41 + 1.0 / 2) / 2);
  for (const char* end : {"equal layers", "greatest ratio"}) shares.expect(end, 1.0 / 4 * 1.0 / 2 * 1.0 / 41);
  shares.expect("undamped", 1.0 / 4);
  shares.expect("frictionless", 1.0 / 4);
  for (const char* threshold : {"u_d ", "v_eps "})
    for (const char* place : {"off", "generic", "at", "near"}) shares.expect(std::string(threshold) + place, 1.0 / 4);
  shares.expect("clamp off", 1.0 / 2);
  shares.expect("clamp generic", 1.0 / 4);
  // Of four penetrations two differ in three draws of four; at or near one of the two in the middle in half the others.
  EXPECT_GE(clamp_between, kDraws * (0.95 * 3 / 16 + 1.0 / 8));
  for (const char* place : {"clamp at", "clamp near"}) shares.expect(place, 1.0 / 8);
}

TEST(LawDraw, WithoutFiguresOrWithUselessOnesThresholdsAreGeneric) {
  const std::vector<double> useless = {0, -1, std::numeric_limits<double>::infinity(),
                                       std::numeric_limits<double>::quiet_NaN()};
  for (std::uint64_t i = 0; i < 2000; ++i)
    for (const std::vector<double>& figures : {std::vector<double>{}, useless}) {
      PoseRandom random = random_for(i);
      const ContactLaw law = draw_law(random, kSize, figures, figures);
      ASSERT_NO_THROW(fast::require_valid(law)) << i;
      ASSERT_TRUE(law.transition_depth == 0 || law.transition_depth >= 0x1p-20 * kSize) << i;
      ASSERT_LE(law.transition_depth, kSize) << i;
    }
}

TEST(LawDraw, ThresholdsStayWhereTheVerdictsBoundsHoldWhateverTheFigures) {
  const std::vector<double> ends = {std::numeric_limits<double>::denorm_min(),
                                    0x3p-1074,
                                    kLeastThreshold,
                                    std::nextafter(kLeastThreshold, 1),
                                    std::nextafter(kGreatestThreshold, 1),
                                    kGreatestThreshold,
                                    std::numeric_limits<double>::max()};
  for (std::uint64_t i = 0; i < 2000; ++i) {
    PoseRandom random = random_for(i);
    ASSERT_NO_THROW(require_in_range(draw_law(random, kSize, ends, ends))) << i;
  }
}

TEST(LawDraw, VelocitiesHaveTheSharesPromised) {
  const TriangleMesh cube = generate::box({1, 1, 1}), ball = generate::icosphere(0.75, 1);
  const FeaturePair pair(cube, ball);
  constexpr int kDraws = 8000;
  Shares shares(kDraws);
  for (std::uint64_t i = 0; i < kDraws; ++i) {
    PoseRandom random = random_for(i, Purpose::velocity);
    const Pose pose{random_for(i, Purpose::pose).rotation(), Eigen::Vector3d::Zero()};
    const Velocity velocity = draw_velocity(random, pair, pose);
    const bool moves = !velocity.v.isZero(0), turns = !velocity.w.isZero(0);
    shares.add(moves ? turns ? "both" : "v alone" : turns ? "w alone" : "rest");
    if (!moves) continue;
    const double speed = velocity.v.norm();
    ASSERT_GE(speed, 0x1p-15 * pair.size());
    ASSERT_LE(speed, 0x1p8 * pair.size());
    const auto along_a_normal = [&](const SurfaceFeatures& surface, const Eigen::Vector3d& v) {
      for (Index f = 0; f < static_cast<Index>(surface.mesh.faces.size()); ++f)
        if (std::abs(surface.face_normal(f).normalized().dot(v)) >= (1 - 1e-12) * speed) return true;
      return false;
    };
    // All faces of the cube are orthogonal to axes, all draws of one are exact: a quarter along the axes.
    if (!turns && (velocity.v.array() != 0).count() == 1) shares.add("axis");
    if (!turns && along_a_normal(pair.F, pose.A.transpose() * velocity.v)) shares.add("normal of F");
  }
  shares.expect("rest", 1.0 / 8);
  shares.expect("w alone", 1.0 / 8);
  shares.expect("v alone", 5.0 / 8);
  shares.expect("both", 1.0 / 8);
  shares.expect("axis", 2.0 / 8);
  shares.expect("normal of F", 1.0 / 8);
}

/// Both sides of each threshold are met on one body or another, so that no branch of the law goes untried.
TEST(LawDraw, OnPosesOfACubeAndABallThresholdsDecideSomething) {
  const TriangleMesh cube = generate::gridded_box(1, 4), ball = generate::icosphere(0.75, 2);
  const FeaturePair pair(cube, ball);
  const fast::Surface surface_E(cube), surface_F(ball);
  fast::Workspace workspace;
  int poses = 0, faded = 0, not_faded = 0, clamped = 0, partly_clamped = 0, sticking = 0, slipping = 0, no_tension = 0;
  int at_transition = 0, at_clamp = 0, at_slip = 0, without_speed = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Pose pose = draw_pose(Stratum::generic, pair, random_for(i, Purpose::pose)).pose;
    PoseRandom of_velocity = random_for(i, Purpose::velocity), of_law = random_for(i);
    const Velocity velocity = draw_velocity(of_velocity, pair, pose);
    ContactLaw law = draw_law_without_thresholds(of_law);
    const auto evaluated = [&]() -> const fast::Contact& {
      return fast::evaluate(fast::Pairing(surface_E, surface_F, law, Mode::both, Scheme::barycentric), pose, velocity,
                            {}, workspace);
    };
    std::vector<double> penetrations, speeds;
    for (const fast::Element& element : evaluated().elements) penetrations.push_back(element.penetration);
    if (penetrations.empty()) continue;
    ++poses;
    draw_depths(of_law, pair.size(), penetrations, law);
    for (const fast::Element& element : evaluated().elements) speeds.push_back(element.tangential_velocity);
    draw_slip_velocity(of_law, pair.size(), speeds, law);
    without_speed += std::none_of(speeds.begin(), speeds.end(), [](double v) { return v > 0; });
    const std::vector<fast::Element>& elements = evaluated().elements;
    const auto any = [&](const auto& condition) { return std::any_of(elements.begin(), elements.end(), condition); };
    const bool damped = law.damping > 0 && !(velocity.v.isZero(0) && velocity.w.isZero(0));
    const bool rough = law.friction > 0;
    faded += damped && any([&](const fast::Element& e) { return e.penetration < law.transition_depth; });
    not_faded += damped && any([&](const fast::Element& e) { return e.penetration >= law.transition_depth; });
    const auto deeper =
        std::count_if(penetrations.begin(), penetrations.end(), [&](double u) { return u > law.max_penetration; });
    clamped += deeper > 0;
    partly_clamped += deeper > 0 && deeper < std::ssize(penetrations);
    sticking += rough && any([&](const fast::Element& e) {
                  return e.tangential_velocity > 0 && e.tangential_velocity < law.slip_velocity;
                });
    slipping += rough && any([&](const fast::Element& e) {
                  return e.tangential_velocity > 0 && e.tangential_velocity >= law.slip_velocity;
                });
    at_transition += any([&](const fast::Element& e) { return e.penetration == law.transition_depth; });
    at_clamp += std::find(penetrations.begin(), penetrations.end(), law.max_penetration) != penetrations.end();
    at_slip += law.slip_velocity > 0 &&
               any([&](const fast::Element& e) { return e.tangential_velocity == law.slip_velocity; });
    no_tension += damped && any([&](const fast::Element& e) { return e.normal_force == 0; });
  }
  std::printf(
      "%d poses with elements: faded %d, not faded %d, clamped %d (partly %d), sticking %d, slipping %d, no tension "
      "%d; "
      "exactly at the transition %d, the clamp %d, the slip velocity %d; without tangential speed %d\n",
      poses, faded, not_faded, clamped, partly_clamped, sticking, slipping, no_tension, at_transition, at_clamp,
      at_slip, without_speed);
  EXPECT_GE(poses, 400);
  for (const int count : {faded, not_faded, clamped, sticking, slipping}) EXPECT_GE(count, poses / 6);
  for (const int count : {at_transition, at_slip}) EXPECT_GE(count, poses / 8);
  EXPECT_GE(at_clamp, poses / 12);
  for (const int count : {partly_clamped, no_tension}) EXPECT_GE(count, poses / 20);
  EXPECT_LE(without_speed, poses / 4);
}

}  // namespace
}  // namespace pcm::compare::law_draw_test
