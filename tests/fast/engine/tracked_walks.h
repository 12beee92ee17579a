// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "compare/poses/pairs.h"
#include "compare/random/random.h"
#include "compare/verify/routes/wanted_presets.h"
#include "pcm/engine.h"
#include "pcm/pairing_memory.h"
#include "tests/fast/same_answer.h"
#include "tests/fast/varied_questions.h"

/// Ways of poses through the strata of `pcm verify`, asked one after the other of a memory that follows what crosses
/// from pose to pose, and of the engine that knows nothing of the past.
namespace pcm::fast::test {

struct WalkTally {
  std::int64_t evaluations = 0, touching = 0;
  std::int64_t followed = 0;  ///< of those touching: without a search from the roots of the trees
  std::int64_t different = 0;
  std::string first_difference;

  void add(const WalkTally& other) {
    evaluations += other.evaluations;
    touching += other.touching;
    followed += other.followed;
    different += other.different;
    if (first_difference.empty()) first_difference = other.first_difference;
  }
};

/// A walk starts at a pose of a stratum. Its steps have lengths from a fraction of an ulp to what is no longer
/// followed, a random one for some steps on end; they go on, turn back, lead to the start again to the last bit, move
/// single coordinates by single ulps, or stay and change the velocity.
class Walk {
 public:
  Walk(const compare::DrawnPose& start, double size, compare::PoseRandom& random)
      : random_(random), size_(size), start_(start.pose), pose_(start.pose), velocity_(start.velocity) {
    choose_length();
  }

  const Pose& pose() const { return pose_; }
  const Velocity& velocity() const { return velocity_; }

  void go_on() {
    switch (random_.below(12)) {
      case 0:
        return choose_length();
      case 1:
        pose_ = start_;
        return;
      case 2:
        way_ = -way_;
        axis_ = -axis_;
        break;
      case 3:
        velocity_.v = random_.direction();
        return;
      case 4: {
        double& x = pose_.r[static_cast<Eigen::Index>(random_.below(3))];
        x = std::nextafter(x, random_.coin() ? size_ : -size_);
        return;
      }
      default:
        break;
    }
    pose_.r += length_ * way_;
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(length_ / size_, axis_) * pose_.A;
    if (random_.below(3) == 0) pose_.A = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
  }

 private:
  void choose_length() {
    length_ = size_ * std::exp2(random_.uniform(-54, -6));
    way_ = random_.direction();
    axis_ = random_.direction();
  }

  compare::PoseRandom& random_;
  double size_;
  Pose start_, pose_;
  Velocity velocity_;
  double length_ = 0;
  Eigen::Vector3d way_ = Eigen::Vector3d::Zero(), axis_ = Eigen::Vector3d::UnitX();
};

/// What is asked along a walk: the same for a while, as memories are, mostly force alone.
inline Wanted wanted_on_walk(compare::PoseRandom& random) {
  return random.below(3) != 0 ? compare::kForceOnly : wanted_by_number(random.below(kAllWanted));
}

/// `number` of a walk of a pair: each has its own random numbers.
inline WalkTally take_walk(const compare::SurfacePair& pair, compare::Stratum stratum, const Pairing& pairing,
                           const compare::FeaturePair& features, std::uint64_t seed, std::uint64_t number, int steps) {
  compare::PoseRandom random(seed, static_cast<std::uint64_t>(stratum), number, 0);
  const compare::DrawnPose start = compare::draw_pose(stratum, features, random);
  compare::PoseRandom way(seed, static_cast<std::uint64_t>(stratum), number, 1);
  Walk walk(start, features.size(), way);
  WalkTally tally;
  PairingMemory memory(pairing);
  Workspace one, other;
  Wanted wanted = wanted_on_walk(way);
  for (int step = 0; step < steps; ++step) {
    const Contact& followed = memory.evaluate(walk.pose(), walk.velocity(), wanted, one);
    const Contact& anew = evaluate(pairing, walk.pose(), walk.velocity(), wanted, other);
    ++tally.evaluations;
    tally.touching += anew.touching;
    tally.followed += followed.touching && followed.work.candidate_pairs == 0;
    if (!same(followed, anew)) {
      ++tally.different;
      if (tally.first_difference.empty())
        tally.first_difference = pair.name + ", " + std::string(compare::name(stratum)) + ", seed " +
                                 std::to_string(seed) + ", walk " + std::to_string(number) + ", step " +
                                 std::to_string(step);
    }
    walk.go_on();
    if (way.below(16) == 0) wanted = wanted_on_walk(way);
  }
  return tally;
}

/// Walks of all varied pairs from all strata that suit them, in both schemes and all modes.
inline WalkTally take_walks(std::uint64_t seed, int walks, int steps) {
  WalkTally tally;
  std::uint64_t number = 0;
  for (const compare::SurfacePair& pair : varied_pairs()) {
    const compare::FeaturePair features(pair.E, pair.F);
    const Surface E(pair.E), F(pair.F);
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
        const Pairing pairing(E, F, pair.law, mode, scheme);
        for (const compare::Stratum stratum : {compare::Stratum::generic, compare::Stratum::grazing,
                                               compare::Stratum::degenerate, compare::Stratum::near_degenerate}) {
          if (compare::hard(stratum) && !pair.for_hard_strata) continue;
          for (int walk = 0; walk < walks; ++walk)
            tally.add(take_walk(pair, stratum, pairing, features, seed, number++, steps));
        }
      }
    }
  }
  return tally;
}

}  // namespace pcm::fast::test
