// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison is shown to notice: answers are altered between engine and comparison, field by field and route by
// route, and by faults as an engine makes them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "compare/poses/rounded_vertices.h"
#include "compare/verify/contact_fields.h"
#include "compare/verify/element_law.h"
#include "compare/verify/held_pairing.h"
#include "compare/verify/state_draw.h"
#include "compare/verify/verify.h"
#include "tests/compare/small_pair.h"
#include "tests/compare/verify/altering_seam.h"

namespace pcm::compare {
namespace {

constexpr std::uint64_t kSeed = 41;

/// Moves a value far from what it is.
void scramble(bool& x) {
  x = !x;
}
void scramble(double& x) {
  x += 1 + 2 * std::abs(x);
}
void scramble(Eigen::Vector3d& x) {
  scramble(x[1]);
}
void scramble(Side& x) {
  x = x == Side::E ? Side::F : Side::E;
}
void scramble(std::array<Index, 2>& x) {
  ++x[0];
}
void scramble(std::vector<Index>& list) {
  if (list.empty())
    list.push_back(0);
  else
    list.pop_back();
}
template <class T>
void scramble(T& x) {
  x = -x - 1;
}

/// Bounds are wrong where they are too small.
void narrow(double& x) {
  x = -1;
}
void narrow(Eigen::Vector3d& x) {
  x[2] = -1;
}
template <class T>
void narrow(T&) {}

/// Alters the first value of the field.
bool alter(fast::Contact& contact, std::string_view field) {
  bool altered = false;
  for_each_field(contact, [&](const Field& known, auto& value) {
    if (altered || known.name != field) return;
    altered = true;
    const bool is_upper_bound = known.asked == Asked::bound && field != "bound.penetration_at_least";
    is_upper_bound ? narrow(value) : scramble(value);
  });
  return altered;
}

struct Held {
  int altered = 0;
  int flagged = 0;
  std::set<Kind> kinds;
};

/// Holds altered answers at drawn poses of the stratum until `enough` have been altered.
Held hold_altered(const AlteringSeam& seam, Stratum stratum, Scheme scheme, int enough, int most_poses = 400) {
  const SurfacePair pair = small_pair();
  static const HeldPairing usual(pair.E, pair.F, ContactLaw{}, HeldPairing::Modes{Mode::E, Mode::F, Mode::both});
  static const HeldPairing nested(*nested_meshes(pair.E, pair.F), ContactLaw{},
                                  HeldPairing::Modes{Mode::E, Mode::F, Mode::both});
  const HeldPairing& pairing = stratum == Stratum::nested ? nested : usual;
  fast::Workspace workspace;
  Held held;
  for (int i = 0; i < most_poses && held.altered < enough; ++i) {
    const auto number = static_cast<std::uint64_t>(i);
    const DrawnPose drawn = draw_pose(stratum, pairing.features(), PoseRandom(kSeed, 0, 0, number));
    const HeldPairing::State state =
        draw_state(pairing, stratum, drawn, scheme, PoseRandom(kSeed, 0, 0, number, Purpose::law),
                   PoseRandom(kSeed, 0, 0, number, Purpose::velocity));
    seam.take_altered();
    const std::vector<PoseOutcome> outcomes = pairing.hold(state, workspace, seam);
    if (!seam.take_altered()) continue;
    ++held.altered;
    bool flagged = false;
    for (const PoseOutcome& outcome : outcomes)
      for (const Disagreement& d : outcome.disagreements) {
        flagged = true;
        held.kinds.insert(d.kind);
      }
    held.flagged += flagged;
  }
  return held;
}

const AlteringSeam kUnaltered([](fast::Contact&) { return false; });

class SeamOverSchemes : public testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, SeamOverSchemes, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const testing::TestParamInfo<Scheme>& scheme) {
                           return scheme.param == Scheme::clipped ? "clipped" : "barycentric";
                         });

TEST_P(SeamOverSchemes, EveryFieldScrambledOnAllPathsAlikeIsFlaggedByTheCheckThatHoldsIt) {
  for (const Field& field : all_fields()) {
    if (field.name == "bound.flipped") continue;  // below
    const AlteringSeam seam([&](fast::Contact& contact) { return alter(contact, field.name); });
    const Held held = hold_altered(seam, Stratum::generic, GetParam(), 3);
    EXPECT_EQ(held.altered, 3) << field.name;
    EXPECT_EQ(held.flagged, held.altered) << field.name;
    EXPECT_TRUE(held.kinds.contains(field.held_by)) << field.name << " is held by " << name(field.held_by);
  }
}

TEST_P(SeamOverSchemes, EveryFieldScrambledOnOnePathAloneIsFlagged) {
  for (const Route route : {Route::bounded, Route::force, Route::touch, Route::drawn, Route::scene})
    for (const Field& field : all_fields()) {
      if (field.asked == Asked::work || field.asked == Asked::bound) continue;
      const AlteringSeam seam([&](fast::Contact& contact) { return alter(contact, field.name); }, route);
      const Held held = hold_altered(seam, Stratum::generic, GetParam(), 1, 12);
      EXPECT_EQ(held.flagged, held.altered) << field.name << " on " << name(route);
      EXPECT_TRUE(held.altered == 0 || held.kinds.contains(Kind::paths)) << field.name << " on " << name(route);
    }
}

TEST(Seam, FlipThatIsNotAnnouncedIsFlagged) {
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, ContactLaw{}, Mode::E);
  const Question question = held.question(Pose{}, Velocity{});
  fast::Contact subj;
  reference::Answer true_rounded, true_exact;
  true_exact.elements.emplace_back();
  subj.bound.emplace().flipped = true;
  EXPECT_TRUE(broken_bounds(question, subj, true_rounded, true_exact).disagreements().empty());
  subj.bound->flipped = false;
  ASSERT_EQ(broken_bounds(question, subj, true_rounded, true_exact).disagreements().size(), 1U);
  EXPECT_EQ(broken_bounds(question, subj, true_rounded, true_exact).disagreements().front().kind, Kind::bound);
}

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
             if (contact.elements.empty()) return false;
             heaviest(contact)->slave_face ^= 1;
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
    EXPECT_EQ(held.altered, 0);
    EXPECT_TRUE(held.kinds.empty());
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

TEST(Seam, EveryKindOfDisagreementIsRaisedBySomeField) {
  std::set<Kind> raised{Kind::failure, Kind::history, Kind::paths};  // above
  for (const Field& field : all_fields()) raised.insert(field.held_by);
  raised.insert(Kind::polygon_count);  // verify_test.cpp
  raised.insert(Kind::sums);           // below
  for (int k = 0; k < kKinds; ++k) EXPECT_TRUE(raised.contains(static_cast<Kind>(k))) << name(static_cast<Kind>(k));
}

TEST_P(SeamOverSchemes, SumsThatAreNotThoseOfTheElementsAreFlagged) {
  const AlteringSeam seam([](fast::Contact& contact) {
    contact.torque_Me *= 1 + 0x1p-30;
    return !contact.torque_Me.isZero(0) && !contact.elements.empty();
  });
  const Held held = hold_altered(seam, Stratum::generic, GetParam(), 20);
  EXPECT_EQ(held.flagged, 20);
  EXPECT_TRUE(held.kinds.contains(Kind::sums));
}

TEST_P(SeamOverSchemes, ListsLongerOrShorterAreFlagged) {
  const auto change = [](auto& list, bool longer) {
    if (list.empty()) return false;
    if (longer)
      list.push_back(list.back());
    else
      list.pop_back();
    return true;
  };
  const std::vector<std::function<bool(fast::Contact&, bool)>> lists = {
      [&](fast::Contact& contact, bool longer) { return change(contact.crossings, longer); },
      [&](fast::Contact& contact, bool longer) { return change(contact.polygons, longer); },
      [&](fast::Contact& contact, bool longer) { return change(contact.elements, longer); },
      [&](fast::Contact& contact, bool longer) { return change(contact.E.intersected, longer); },
      [&](fast::Contact& contact, bool longer) { return change(contact.F.intersected, longer); },
      [&](fast::Contact& contact, bool longer) { return change(contact.E.inner, longer); },
      [&](fast::Contact& contact, bool longer) { return change(contact.F.inner, longer); }};
  for (std::size_t k = 0; k < lists.size(); ++k)
    for (const bool longer : {true, false}) {
      const AlteringSeam seam([&](fast::Contact& contact) { return lists[k](contact, longer); });
      const Held held = hold_altered(seam, Stratum::generic, GetParam(), 5);
      EXPECT_EQ(held.altered, 5) << k;
      EXPECT_EQ(held.flagged, 5) << k << (longer ? " longer" : " shorter");
    }
  const AlteringSeam far([](fast::Contact& contact) {
    contact.crossings.emplace_back().position_Me.setConstant(1e99);
    return true;
  });
  const Held held = hold_altered(far, Stratum::generic, GetParam(), 5);
  EXPECT_EQ(held.flagged, 5);
  EXPECT_TRUE(held.kinds.contains(Kind::polygon_cycle));
}

TEST_P(SeamOverSchemes, GreatestPenetrationAtOddsWithItsElementsOrFlagIsFlagged) {
  const AlteringSeam half([](fast::Contact& contact) {
    double greatest = 0;
    for (const fast::Element& e : contact.elements) greatest = std::max(greatest, e.penetration);
    contact.max_penetration = greatest / 2;
    return greatest > 0;
  });
  const Held halved = hold_altered(half, Stratum::generic, GetParam(), 20);
  EXPECT_EQ(halved.flagged, 20);
  EXPECT_TRUE(halved.kinds.contains(Kind::sums));
  for (const Stratum stratum : kStrata) {
    const AlteringSeam flag([](fast::Contact& contact) {
      contact.penetration_exceeded = !contact.penetration_exceeded;
      return true;
    });
    const Held held = hold_altered(flag, stratum, GetParam(), 20);
    EXPECT_EQ(held.flagged, 20) << name(stratum);
    EXPECT_TRUE(held.kinds.contains(Kind::exceeded)) << name(stratum);
  }
}

TEST_P(SeamOverSchemes, BoundThatPromisesNothingOrContradictsItselfIsFlagged) {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  struct BoundFault {
    const char* name;
    Kind kind;
    std::function<void(fast::Contact&)> alter;
  };
  const std::vector<BoundFault> bound_faults = {
      {"infinite force", Kind::bound, [](fast::Contact& c) { c.bound->force_Me.setConstant(kInfinity); }},
      {"infinite torque", Kind::bound, [](fast::Contact& c) { c.bound->torque_Me[1] = kInfinity; }},
      {"no number", Kind::bound,
       [](fast::Contact& c) { c.bound->torque_Me[2] = std::numeric_limits<double>::quiet_NaN(); }},
      {"lower above own", Kind::penetration_bound,
       [](fast::Contact& c) { c.bound->penetration_at_least = std::nextafter(c.max_penetration, kInfinity); }},
      {"upper below lower", Kind::penetration_bound,
       [](fast::Contact& c) { c.bound->penetration_at_most = -0x1p-1074; }},
      {"lower below 0", Kind::penetration_bound, [](fast::Contact& c) { c.bound->penetration_at_least = -1; }}};
  for (const BoundFault& fault : bound_faults)
    for (const Stratum stratum : kStrata) {
      const AlteringSeam seam([&](fast::Contact& contact) {
        if (!contact.bound) return false;
        fault.alter(contact);
        return true;
      });
      const Held held = hold_altered(seam, stratum, GetParam(), 5);
      EXPECT_EQ(held.flagged, 5) << fault.name << ", " << name(stratum);
      EXPECT_TRUE(held.kinds.contains(fault.kind)) << fault.name << ", " << name(stratum);
    }
}

TEST(Seam, FlipsAnnouncedAndBoundsOfPenetrationShowInTheTally) {
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, ContactLaw{}, Mode::E);
  const AlteringSeam seam([](fast::Contact& contact) {
    if (!contact.bound) return false;
    contact.bound->flipped = true;
    contact.bound->penetration_at_most = 1e300;
    return true;
  });
  fast::Workspace workspace;
  for (const bool altered : {false, true}) {
    Tally tally;
    for (std::uint64_t i = 0; i < 20; ++i) {
      const DrawnPose drawn = draw_pose(Stratum::generic, held.features(), PoseRandom(kSeed, 3, 0, i));
      tally.add(held.hold(drawn.pose, drawn.velocity, workspace, altered ? seam : EngineSeam::none()).front(), "");
    }
    EXPECT_EQ(tally.announced, altered ? 20 : 0);
    const Widths& widths = tally.widths[static_cast<std::size_t>(Kind::penetration_bound)];
    EXPECT_EQ(widths.wider + widths.of_zero == 20, altered);
    EXPECT_EQ(Tally::from_json(tally.to_json()).announced, tally.announced);
  }
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
    const fast::Pairing& fixed = held.engine();
    const fast::Pairing pairing(fixed.surface_E(), fixed.surface_F(), state.law, Mode::both, state.scheme);
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
