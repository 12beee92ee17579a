// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison is shown to notice: answers are altered between engine and comparison, field by field and route by
// route.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "compare/verify/routes/contact_fields.h"
#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/run/verify.h"
#include "tests/compare/small_pair.h"
#include "tests/compare/verify/routes/held_altered.h"

namespace pcm::compare {
namespace {

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
void scramble(fast::Tangent& x) {
  scramble(x(4, 7));
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
  for (const Route route :
       {Route::bounded, Route::force, Route::touch, Route::tangent, Route::drawn, Route::known_pose, Route::scene})
    for (const Field& field : all_fields()) {
      if (field.asked == Asked::work || field.asked == Asked::bound) continue;
      const AlteringSeam seam([&](fast::Contact& contact) { return alter(contact, field.name); }, route);
      const Held held = hold_altered(seam, Stratum::generic, GetParam(), 1, 12);
      EXPECT_EQ(held.flagged, held.altered) << field.name << " on " << name(route);
      // What every route answers, and what that of the force is for: so there is such a route.
      if (field.name == "touching" || (field.name == "force_Me" && route == Route::force)) {
        EXPECT_EQ(held.altered, 1) << field.name << " on " << name(route);
      }
      // Held against the oracle first, and others against it.
      const bool is_first = route == Route::tangent && field.asked == Asked::tangent;
      EXPECT_TRUE(held.altered == 0 || held.kinds.contains(is_first ? Kind::tangent : Kind::paths))
          << field.name << " on " << name(route);
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

TEST(Seam, ClippedElementOnAFaceThatIsNotActiveIsFlaggedUnlessAFlipIsAnnounced) {
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, ContactLaw{}, HeldPairing::Modes{Mode::both}, Scheme::clipped);
  const Question question = held.question(Pose{}, Velocity{});
  ASSERT_EQ(question.scheme, Scheme::clipped);
  for (const Side master : {Side::E, Side::F})
    for (const Index face : {2, 3, 5, 9}) {
      fast::Contact subj;
      subj.elements.push_back({.master = master, .master_face = face});
      subj.bound.emplace();
      reference::Answer true_rounded, true_exact;
      reference::ActiveArea& area = master == Side::E ? true_exact.E : true_exact.F;
      reference::ActiveArea& other = master == Side::E ? true_exact.F : true_exact.E;
      area.intersected = {2, 7};
      area.inner = {3};
      other.inner = {5};
      const bool active = face == 2 || face == 3;
      EXPECT_EQ(broken_bounds(question, subj, true_rounded, true_exact).disagreements().size(), active ? 0U : 1U)
          << (master == Side::E ? "E " : "F ") << face;
      subj.bound->flipped = true;
      EXPECT_TRUE(broken_bounds(question, subj, true_rounded, true_exact).disagreements().empty());
    }
}

TEST(Seam, EveryKindOfDisagreementIsRaisedBySomeField) {
  std::set<Kind> raised{Kind::failure, Kind::history, Kind::paths};  // seam_test.cpp, above
  for (const Field& field : all_fields()) raised.insert(field.held_by);
  raised.insert(Kind::polygon_count);  // verdict_test.cpp
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

TEST_P(SeamOverSchemes, GreatestPenetrationOffInTheEighthDigitIsFlagged) {
  for (const double factor : {1 - 0x1p-26, 1 + 0x1p-26}) {
    const AlteringSeam seam([&](fast::Contact& contact) {
      contact.max_penetration *= factor;
      return contact.max_penetration > 0;
    });
    const Held held = hold_altered(seam, Stratum::generic, GetParam(), 20);
    EXPECT_EQ(held.flagged, 20) << factor;
    EXPECT_TRUE(held.kinds.contains(Kind::penetration)) << factor;
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
      // In the clipped scheme the exact problem may have a sliver that is deeper than all that the engine has.
      const bool by_sliver = GetParam() == Scheme::clipped && std::string_view(fault.name) == "lower above own";
      // Where bodies are as large as 2^240 m it may overflow, and be right.
      const bool by_size = stratum == Stratum::extreme && std::string_view(fault.name).starts_with("infinite");
      EXPECT_GE(held.flagged, by_sliver || by_size ? 4 : 5) << fault.name << ", " << name(stratum);
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

}  // namespace
}  // namespace pcm::compare
