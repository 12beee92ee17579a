// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison is shown to notice: answers are altered between engine and comparison by faults as an engine makes
// them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "compare/poses/rounded_vertices.h"
#include "compare/verify/bounds/element_law.h"
#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/routes/state_draw.h"
#include "compare/verify/run/verify.h"
#include "tests/compare/small_pair.h"
#include "tests/compare/verify/routes/held_altered.h"

namespace pcm::compare {
namespace {

const AlteringSeam kUnaltered([](fast::Contact&) { return false; });

struct Fault {
  const char* name;
  AlteringSeam::Alteration alter;
};

/// The element that carries most: what an engine that is wrong there could not hide among slivers.
std::vector<fast::Element>::iterator heaviest(fast::Contact& contact) {
  return std::max_element(
      contact.elements.begin(), contact.elements.end(),
      [](const fast::Element& a, const fast::Element& b) { return a.force_Me.stableNorm() < b.force_Me.stableNorm(); });
}

/// Where a body is no thicker than roundings, all elements are slivers: each may be missing, and another be there.
bool may_be_missing(const fast::Element& e) {
  return !(e.area > 0x1p-40 * e.position_Me.squaredNorm());
}

/// Takes an element's share of all sums, so that the answer is in itself consistent.
void weigh(fast::Contact& contact, const fast::Element& e, double factor) {
  contact.force_Me += factor * e.force_Me;
  contact.torque_Me += factor * e.position_Me.cross(e.force_Me);
  contact.statistics.patch_area += factor * e.area;
}

std::vector<Fault> faults() {
  return {{"dropped element",
           [](fast::Contact& contact) {
             if (contact.elements.empty()) return false;
             const auto e = heaviest(contact);
             weigh(contact, *e, -1);
             contact.elements.erase(e);
             --contact.element_count;
             return true;
           }},
          {"doubled element",
           [](fast::Contact& contact) {
             if (contact.elements.empty()) return false;
             const auto e = heaviest(contact);
             weigh(contact, *e, 1);
             contact.elements.insert(e, fast::Element(*e));
             ++contact.element_count;
             return true;
           }},
          {"doubled force",
           [](fast::Contact& contact) {
             contact.force_Me *= 2;
             return !contact.force_Me.isZero(0);
           }},
          {"element on another slave face",
           [](fast::Contact& contact) {
             const auto e = heaviest(contact);
             if (e == contact.elements.end() || may_be_missing(*e)) return false;
             e->slave_face ^= 1;
             return true;
           }},
          {"a hundredth of an element's force missing",
           [](fast::Contact& contact) {
             const auto e = heaviest(contact);
             if (e == contact.elements.end() || e->force_Me.isZero(0)) return false;
             weigh(contact, *e, -0.01);
             e->force_Me *= 0.99;
             e->normal_force *= 0.99;
             e->tangential_force *= 0.99;
             return true;
           }},
          {"area of E a thousandth too large", [](fast::Contact& contact) {
             // Where faces lie in one plane any area up to the overlap is right.
             if (!contact.has_volume || !(contact.volume > 1e-3)) return false;
             contact.E.area *= 1.001;
             contact.E.vector_area_Me *= 1.001;
             return true;
           }}};
}

TEST_P(SeamOverSchemes, FaultsOfAnEngineAreFlaggedInEveryStratum) {
  for (const Stratum stratum : kStrata)
    for (const Fault& fault : faults()) {
      const AlteringSeam seam(fault.alter);
      const Held held = hold_altered(seam, stratum, GetParam(), 6, 60);
      const bool area_is_an_interval = hard(stratum) && std::string(fault.name).find("area") != std::string::npos;
      if (!area_is_an_interval) {
        EXPECT_EQ(held.flagged, held.altered) << fault.name << ", " << name(stratum);
      }
      if (stratum == Stratum::generic) {
        EXPECT_EQ(held.altered, 6) << fault.name;
      }
    }
}

TEST_P(SeamOverSchemes, UnalteredAnswersPassInEveryStratum) {
  for (const Stratum stratum : kStrata) {
    const Held held = hold_altered(kUnaltered, stratum, GetParam(), 1, 20);
    EXPECT_EQ(held.unaltered, 20) << name(stratum);
    EXPECT_EQ(held.unaltered_flagged, 0) << name(stratum);
  }
}

TEST_P(SeamOverSchemes, FaultOnTheDefaultPathAloneIsFlagged) {
  const AlteringSeam seam(
      [](fast::Contact& contact) {
        if (contact.elements.empty()) return false;
        for (fast::Element& e : contact.elements) e.force_Me *= 2;
        contact.force_Me *= 2;
        return !contact.force_Me.isZero(0);
      },
      Route::plain);
  const Held held = hold_altered(seam, Stratum::generic, GetParam(), 10);
  EXPECT_EQ(held.flagged, 10);
}

/// Answers each question as at the pose asked before.
class StaleSeam final : public EngineSeam {
 public:
  const fast::Contact& evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                const Ask& ask, fast::Workspace& workspace) const override {
    if (ask.route == Route::plain) std::swap(stale_, now_);
    now_ = {pose, velocity};
    return EngineSeam::evaluate(pairing, stale_.first, stale_.second, ask, workspace);
  }

 private:
  mutable std::pair<Pose, Velocity> stale_, now_;
};

TEST_P(SeamOverSchemes, AnswersToThePoseBeforeAreFlagged) {
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, ContactLaw{}, Mode::both, GetParam());
  const StaleSeam seam;
  fast::Workspace workspace;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const DrawnPose drawn = draw_pose(Stratum::generic, held.features(), PoseRandom(kSeed, 0, 0, i));
    EXPECT_FALSE(held.hold(drawn.pose, drawn.velocity, workspace, seam).front().disagreements.empty()) << i;
  }
}

/// A scene counts one more of something.
class CounterSeam final : public EngineSeam {
 public:
  explicit CounterSeam(std::int64_t& (*counter)(fast::SceneCounters&)) : counter_(counter) {}

  fast::SceneCounters counters_of(const fast::Scene& scene) const override {
    fast::SceneCounters counters = EngineSeam::counters_of(scene);
    ++counter_(counters);
    return counters;
  }

 private:
  std::int64_t& (*counter_)(fast::SceneCounters&);
};

TEST_P(SeamOverSchemes, SceneThatCountsOneMoreIsFlagged) {
  using Counters = fast::SceneCounters;
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, ContactLaw{}, Mode::both, GetParam());
  const DrawnPose drawn = draw_pose(Stratum::generic, held.features(), PoseRandom(kSeed, 0, 0, 0));
  fast::Workspace workspace;
  for (std::int64_t& (*const counter)(Counters&) : std::initializer_list<std::int64_t& (*)(Counters&)>{
           [](Counters& c) -> auto& { return c.apart_by_boxes;
}
, [](Counters& c) -> auto& {
  return c.apart_by_certificate;
}
, [](Counters& c) -> auto& {
  return c.evaluated;
}
, [](Counters& c) -> auto& {
  return c.work.box_tests;
}
, [](Counters& c) -> auto& {
  return c.work.tie_breaks;
}
, [](Counters& c) -> auto& {
  return c.work.elements;
}
}  // namespace
) {
  const CounterSeam seam(counter);
  const PoseOutcome outcome = held.hold(drawn.pose, drawn.velocity, workspace, seam).front();
  ASSERT_FALSE(outcome.disagreements.empty());
  EXPECT_EQ(outcome.disagreements.front().kind, Kind::work);
}
}  // namespace pcm::compare

/// What a scene says of one of its bodies is wrong by an ulp.
class LoadSeam final : public EngineSeam {
 public:
  LoadSeam(std::size_t body, Eigen::Vector3d fast::BodyLoad::*part) : body_(body), part_(part) {}

  std::vector<fast::BodyLoad> body_loads_in(fast::Scene& scene) const override {
    std::vector<fast::BodyLoad> loads = EngineSeam::body_loads_in(scene);
    Eigen::Vector3d& load = loads[body_].*part_;
    Eigen::Index greatest = 0;
    has_altered_ |= load.cwiseAbs().maxCoeff(&greatest) > 0;
    load[greatest] = std::nextafter(load[greatest], 2 * load[greatest]);
    return loads;
  }

  bool take_altered() const { return std::exchange(has_altered_, false); }

 private:
  std::size_t body_;
  Eigen::Vector3d fast::BodyLoad::*part_;
  mutable bool has_altered_ = false;
};

TEST_P(SeamOverSchemes, LoadOnABodyOfASceneThatIsOffByAnUlpIsFlagged) {
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, ContactLaw{}, Mode::both, GetParam());
  fast::Workspace workspace;
  for (const std::size_t body : {0U, 1U})
    for (Eigen::Vector3d fast::BodyLoad::*const part : {&fast::BodyLoad::force_W, &fast::BodyLoad::torque_W}) {
      const LoadSeam seam(body, part);
      int altered = 0;
      for (std::uint64_t i = 0; i < 400 && altered < 10; ++i) {
        const DrawnPose drawn = draw_pose(Stratum::generic, held.features(), PoseRandom(kSeed, 0, 0, i));
        const PoseOutcome outcome = held.hold(drawn.pose, drawn.velocity, workspace, seam).front();
        if (!seam.take_altered()) {
          EXPECT_TRUE(outcome.disagreements.empty()) << i;
          continue;
        }
        ++altered;
        ASSERT_FALSE(outcome.disagreements.empty()) << i;
        EXPECT_EQ(outcome.disagreements.front().kind, Kind::paths);
      }
      EXPECT_EQ(altered, 10);  // the scene remembers at half of the poses, few of which have an element
    }
}

TEST(Seam, EngineThatThrowsIsAFailure) {
  const AlteringSeam seam([](fast::Contact&) -> bool { throw std::runtime_error("engine is out of order"); });
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, ContactLaw{}, Mode::E);
  fast::Workspace workspace;
  const PoseOutcome outcome = held.hold(Pose{}, Velocity{}, workspace, seam).front();
  ASSERT_EQ(outcome.disagreements.size(), 1U);
  EXPECT_EQ(outcome.disagreements.front().kind, Kind::failure);
}

TEST(Seam, OracleThatAnswersOtherwiseAfreshIsFlagged) {
  reference::Answer asked, afresh;
  EXPECT_TRUE(hold_history(asked, afresh).disagreements().empty());
  afresh.force_Me.x() = 18;
  ASSERT_EQ(hold_history(asked, afresh).disagreements().size(), 1U);
  EXPECT_EQ(hold_history(asked, afresh).disagreements().front().kind, Kind::history);
}

/// Adds an element to an answer, with its own sums.
void insert(fast::Contact& contact, const Pose& pose, const fast::Element& e, double share) {
  const auto before = [](const fast::Element& a, const fast::Element& b) {
    return std::tuple(a.master, a.master_face, a.slave_face) < std::tuple(b.master, b.master_face, b.slave_face);
  };
  contact.elements.insert(std::upper_bound(contact.elements.begin(), contact.elements.end(), e, before), e);
  ++contact.element_count;
  ++contact.work.elements;
  ++contact.work.velocities;
  contact.force_Me += share * e.force_Me;
  contact.torque_Me += share * (e.position_Me - pose.r).cross(e.force_Me);
}

struct Invention {
  const char* name;
  Kind kind;
  std::function<void(fast::Element&)> alter;
};

TEST(Seam, SliverThatNoRightEngineHasIsFlagged) {
  const std::vector<Invention> inventions = {
      {"deep", Kind::element_penetration, [](fast::Element& e) { e.penetration = 1e6; }},
      {"flat", Kind::element_penetration, [](fast::Element& e) { e.penetration = 0; }},
      {"no area", Kind::elements, [](fast::Element& e) { e.area = -e.area; }},
      {"long normal", Kind::element_normal, [](fast::Element& e) { e.normal_Me *= 8.7; }},
      {"turned normal", Kind::element_normal,
       [](fast::Element& e) { e.normal_Me = Eigen::Vector3d(e.normal_Me.y(), e.normal_Me.z(), e.normal_Me.x()); }},
      {"far away", Kind::element_position, [](fast::Element& e) { e.position_Me += Eigen::Vector3d(9, 0, 0); }},
      {"off the plane", Kind::element_position, [](fast::Element& e) { e.position_Me += 1e-9 * e.normal_Me; }},
      {"fast", Kind::element_velocity, [](fast::Element& e) { e.normal_velocity += 1e-9; }},
      {"slipping", Kind::element_velocity, [](fast::Element& e) { e.tangential_velocity += 1e-9; }},
      {"strong", Kind::element_force, [](fast::Element& e) { e.force_Me = Eigen::Vector3d(1e20, 0, 0); }},
      {"doubled", Kind::element_force, [](fast::Element& e) { e.force_Me *= 2; }},
      {"pressing", Kind::element_force, [](fast::Element& e) { e.normal_force = 1; }},
      {"rubbing", Kind::element_force, [](fast::Element& e) { e.tangential_force = 1; }}};
  const SurfacePair pair = small_pair();
  ContactLaw law;
  law.friction = 0.5;
  law.damping = 3;
  const HeldPairing held(pair.E, pair.F, law, Mode::both, Scheme::clipped);
  fast::Workspace workspace;
  int tried = 0;
  for (std::uint64_t i = 0; tried < 20; ++i) {
    ASSERT_LT(i, 400U);
    const DrawnPose drawn = draw_pose(Stratum::generic, held.features(), PoseRandom(kSeed, 4, 0, i));
    const Question question{held.features().E, held.features().F, law,           Mode::both,
                            Scheme::clipped,   drawn.pose,        drawn.velocity};
    reference::Inquiry inquiry(held.oracle(), drawn.pose, drawn.velocity, {}, law, Scheme::clipped);
    const reference::Answer truth = inquiry.answer(reference::Problem::rounded, Mode::both);
    fast::Contact right = fast::evaluate(held.engine(), drawn.pose, drawn.velocity, {}, workspace);
    if (right.elements.empty()) continue;
    ++tried;
    // Like the heaviest element, through a slave face that it does not see.
    reference::Element sliver;
    const fast::Element like = *heaviest(right);
    sliver.master = like.master;
    sliver.master_face = like.master_face;
    while (std::any_of(right.elements.begin(), right.elements.end(), [&](const fast::Element& e) {
      return e.master == sliver.master && e.master_face == sliver.master_face && e.slave_face == sliver.slave_face;
    }))
      ++sliver.slave_face;
    sliver.area = 1e-40;
    sliver.penetration = 1e-40;
    sliver.normal_Me = like.normal_Me;
    sliver.position_Me = like.position_Me - 0.5 * like.penetration * like.normal_Me;
    sliver = after_law(question, sliver);
    fast::Element base = like;
    base.slave_face = sliver.slave_face;
    base.area = sliver.area;
    base.penetration = sliver.penetration;
    base.position_Me = sliver.position_Me;
    base.normal_velocity = sliver.normal_velocity;
    base.tangential_velocity = sliver.tangential_velocity;
    base.normal_force = sliver.normal_force;
    base.tangential_force = sliver.tangential_force;
    base.force_Me = sliver.force_Me;
    const auto kinds_with = [&](const fast::Element& e) {
      fast::Contact subj = right;
      insert(subj, drawn.pose, e, 0.5);
      std::set<Kind> kinds;
      for (const Disagreement& d : disagreements(question, subj, truth)) kinds.insert(d.kind);
      return kinds;
    };
    const std::set<Kind> of_base = kinds_with(base);
    for (const Invention& invention : inventions) {
      fast::Element e = base;
      invention.alter(e);
      if (e.force_Me.isZero(0) && invention.name == std::string("doubled")) continue;
      EXPECT_FALSE(of_base.contains(invention.kind)) << invention.name << " at " << i;
      EXPECT_TRUE(kinds_with(e).contains(invention.kind)) << invention.name << " at " << i;
    }
  }
}

TEST(Seam, ClippedElementsOutOfOrderAreFlagged) {
  const AlteringSeam seam([](fast::Contact& contact) {
    if (contact.elements.size() < 2) return false;
    std::swap(contact.elements.front(), contact.elements.back());
    return true;
  });
  const Held held = hold_altered(seam, Stratum::generic, Scheme::clipped, 20);
  EXPECT_EQ(held.flagged, 20);
  EXPECT_TRUE(held.kinds.contains(Kind::elements));
}

TEST_P(SeamOverSchemes, ForceOffByABillionthIsFlaggedIn99Of100AnswersThatAreNotShallow) {
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, ContactLaw{}, Mode::both, GetParam());
  fast::Workspace workspace;
  int altered = 0, flagged = 0;
  for (std::uint64_t i = 0; altered < 300; ++i) {
    ASSERT_LT(i, 3000U);
    const DrawnPose drawn = draw_pose(Stratum::generic, held.features(), PoseRandom(kSeed, 2, 0, i));
    const HeldPairing::State state =
        draw_state(held, Stratum::generic, drawn, GetParam(), PoseRandom(kSeed, 2, 0, i, Purpose::law),
                   PoseRandom(kSeed, 2, 0, i, Purpose::velocity));
    reference::Inquiry inquiry(held.oracle(), state.pose, state.velocity, {}, state.law, state.scheme);
    const reference::Answer truth = inquiry.answer(reference::Problem::rounded, Mode::both);
    const double p = mean_thickness(truth), S = coordinate_scale(pair.E, pair.F, state.pose);
    if (!(S < 1e3 * p)) continue;
    const fast::Pairing pairing = held.engine_under(state.law, Mode::both, state.scheme);
    fast::Contact subj = fast::evaluate(pairing, state.pose, state.velocity, {}, workspace);
    if (subj.force_Me.isZero(0)) continue;
    // All of it, as a wrong factor of the law would: the answer's own sums still agree.
    subj.force_Me *= 1 + 1e-9;
    subj.torque_Me *= 1 + 1e-9;
    for (fast::Element& e : subj.elements) {
      e.force_Me *= 1 + 1e-9;
      e.normal_force *= 1 + 1e-9;
      e.tangential_force *= 1 + 1e-9;
    }
    ++altered;
    const Question question{held.features().E, held.features().F, state.law,     Mode::both,
                            state.scheme,      state.pose,        state.velocity};
    const std::vector<Disagreement> found = disagreements(question, subj, truth);
    flagged += std::any_of(found.begin(), found.end(), [](const Disagreement& d) { return d.kind == Kind::force; });
  }
  EXPECT_GE(flagged, 297) << "of " << altered;
}

}  // namespace
}  // namespace pcm::compare
