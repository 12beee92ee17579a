// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/tangent_verdict.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "compare/poses/rounded_vertices.h"
#include "compare/verify/bounds/tangent_bounds.h"
#include "compare/verify/routes/held_pairing.h"
#include "compare/verify/run/recorded_scenes.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/hard_bodies.h"
#include "meshes/generate/degenerate/sunken_blocks.h"
#include "meshes/generate/round.h"
#include "tests/compare/law_of_all.h"
#include "tests/compare/small_pair.h"
#include "tests/sunken_blocks.h"

namespace pcm::compare {
namespace {

constexpr std::uint64_t kSeed = 31;

/// Poses of two small bodies that move, the engine's tangent there and the oracle's.
template <class Visit>
void for_each_tangent(Scheme scheme, Stratum stratum, Mode mode, int count, const Visit& visit) {
  const SurfacePair pair = small_pair();
  const ContactLaw law = law_of_all();
  const Velocity velocity{{0.3, -0.2, 0.1}, {0.5, 0.4, -0.3}};
  const HeldPairing held(pair.E, pair.F, law, mode, scheme);
  fast::Workspace workspace;
  Wanted wanted;
  wanted.tangent = true;
  int found = 0;
  for (std::uint64_t i = 0; found < count; ++i) {
    ASSERT_LT(i, 10000U);
    const Pose pose = draw_pose(stratum, held.features(), PoseRandom(kSeed, 2, 0, i)).pose;
    const fast::Contact& subj = fast::evaluate(held.engine(), pose, velocity, wanted, workspace);
    if (subj.element_count == 0) continue;
    ++found;
    reference::Inquiry inquiry(held.oracle(), pose, velocity, {}, law, scheme);
    visit(held.question(pose, velocity), subj, inquiry.answer(reference::Problem::rounded, mode),
          inquiry.tangent(reference::Problem::rounded, mode));
  }
}

bool is_flagged(const Question& question, const fast::Contact& subj, const reference::Answer& answer,
                const reference::Tangent& truth) {
  Checks checks;
  check_tangent(subj, truth, allowed_errors(question, subj.elements, answer, truth), checks);
  return !checks.disagreements().empty();
}

class TangentVerdict : public testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, TangentVerdict, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& scheme) {
                           return scheme.param == Scheme::clipped ? "clipped" : "barycentric";
                         });

TEST_P(TangentVerdict, PassesTheEnginesAndFlagsEveryBlockThatIsOff) {
  // Parts of faces are off by their outlines, faces by nothing.
  const double off = GetParam() == Scheme::clipped ? 1e-6 : 1e-9;
  int blocks = 0, flagged = 0;
  for (const Mode mode : {Mode::E, Mode::F, Mode::both})
    for_each_tangent(GetParam(), Stratum::generic, mode, 60,
                     [&](const Question& question, const fast::Contact& subj, const reference::Answer& answer,
                         const reference::Tangent& truth) {
                       EXPECT_FALSE(is_flagged(question, subj, answer, truth));
                       const bool shallow = !(coordinate_scale(question.E.mesh, question.F.mesh, question.pose) <
                                              1e3 * mean_thickness(answer));
                       if (shallow) return;
                       for (int row = 0; row < 6; row += 3)
                         for (int column = 0; column < 12; column += 3) {
                           fast::Contact altered = subj;
                           const auto block = altered.tangent->block<3, 3>(row, column);
                           if (block.isZero(0)) continue;
                           altered.tangent->block<3, 3>(row, column) = (1 + off) * block;
                           ++blocks;
                           flagged += is_flagged(question, altered, answer, truth);
                         }
                     });
  EXPECT_GT(blocks, 400);
  EXPECT_GE(flagged, 0.97 * blocks) << "of " << blocks;
}

TEST_P(TangentVerdict, PassesTheEnginesAtKinks) {
  for (const Stratum stratum : {Stratum::degenerate, Stratum::near_degenerate, Stratum::adversarial})
    for (const Mode mode : {Mode::E, Mode::F, Mode::both})
      for_each_tangent(GetParam(), stratum, mode, 12,
                       [&](const Question& question, const fast::Contact& subj, const reference::Answer& answer,
                           const reference::Tangent& truth) {
                         EXPECT_FALSE(is_flagged(question, subj, answer, truth)) << name(stratum);
                       });
}

TEST_P(TangentVerdict, FlagsOneThatIsMissingOrNoNumber) {
  for_each_tangent(GetParam(), Stratum::generic, Mode::both, 5,
                   [&](const Question& question, const fast::Contact& subj, const reference::Answer& answer,
                       const reference::Tangent& truth) {
                     fast::Contact altered = subj;
                     (*altered.tangent)(5, 11) = std::nan("");
                     EXPECT_TRUE(is_flagged(question, altered, answer, truth));
                     altered.tangent.reset();
                     EXPECT_TRUE(is_flagged(question, altered, answer, truth));
                   });
}

TEST_P(TangentVerdict, BoundsHangOnRoundingsAlone) {
  const double widest = GetParam() == Scheme::clipped ? 1e-3 : 1e-6;
  for_each_tangent(GetParam(), Stratum::generic, Mode::both, 40,
                   [&](const Question& question, const fast::Contact&, const reference::Answer& answer,
                       const reference::Tangent& truth) {
                     const fast::Tangent bounds = tangent_bounds(question, answer, truth.elements);
                     EXPECT_GT(bounds.maxCoeff(), 0);
                     EXPECT_LT(bounds.leftCols(6).norm(), widest * truth.slope.leftCols(6).norm());
                   });
}

struct PosedPair {
  TriangleMesh E, F;
  Pose pose;
  ContactLaw law = law_of_all();
  Velocity velocity = {{0.3, -0.2, 0.1}, {0.5, 0.4, -0.3}};
  Mode mode = Mode::both;

  bool is_flagged() const {
    const HeldPairing held(E, F, law, mode, Scheme::clipped);
    fast::Workspace workspace;
    Wanted wanted;
    wanted.tangent = true;
    const fast::Contact& subj = fast::evaluate(held.engine(), pose, velocity, wanted, workspace);
    EXPECT_GT(subj.element_count, 0);
    reference::Inquiry inquiry(held.oracle(), pose, velocity, {}, law, Scheme::clipped);
    return compare::is_flagged(held.question(pose, velocity), subj, inquiry.answer(reference::Problem::rounded, mode),
                               inquiry.tangent(reference::Problem::rounded, mode));
  }
};

/// Here what is left of a face has more vertices than the engine keeps in one piece. Two of them are those of an edge
/// of a face that hides all on one side of it (`pcm verify`, seed 19, adversarial pose 2622 of this pair).
TEST(ClippedTangentVerdict, PassesTheEnginesWhereAPieceInPartsHasTwoVerticesOfAnEdge) {
  PosedPair pair;
  pair.E = generate::box({1, 1, 1});
  pair.F = degenerate::hollow_cube(0.5);
  pair.pose.A << 0x1.23840455d1c52p-1, 0x1.2ddcc34bae813p-1, 0x1.255425098f0f6p-1,  //
      0x1.9b8ee10c8c75cp-1, -0x1.0346e6e3a80a4p-2, -0x1.139ab8fb006a4p-1,           //
      -0x1.60dfce6398cd6p-3, 0x1.88b4675bddb47p-1, -0x1.3c74c7084b618p-1;
  pair.pose.r = {0x1.fb4f5cb9aea16p-5, -0x1.15a7800c71dd1p-2, -0x1.adc43609c3bcdp-2};
  EXPECT_FALSE(pair.is_flagged());
}

/// Here two of them lie in one place but for roundings, so that a line from one to a third is nearly a side
/// (adversarial pose 2763 of this pair).
TEST(ClippedTangentVerdict, PassesTheEnginesWhereAPieceInPartsHasASideOfNoLength) {
  PosedPair pair;
  pair.E = generate::torus(1, 0.25, 4, 4);
  pair.F = degenerate::torus_chain(3, 1, 0.25, 4, 4);
  pair.pose.A << -0x1.685b7dec88ac4p-1, 0x1.140a502708e25p-4, -0x1.6a125e5c7fdcp-1,  //
      -0x1.a5b9cc6082e98p-2, -0x1.b31cbea3ab02ap-1, 0x1.50cc2a8da3e47p-2,            //
      -0x1.2859a182e24a3p-1, 0x1.0ba39de6287e8p-1, 0x1.4073e117a17b4p-1;
  pair.pose.r = {-0x1.512eae9283e78p-4, 0x1.079931c36dcb6p+1, -0x1.9d5c1a10f9b76p-2};
  EXPECT_FALSE(pair.is_flagged());
}

/// A vertex 1e-9 m deep in an upright edge, so that the directions of the sides are off by 1e-7. Moved along that edge
/// they stay, but for that (`pcm verify`, seed 3, grazing pose 31 of this pair).
TEST(ClippedTangentVerdict, PassesTheEnginesWhereTinySidesMoveAlongThemselves) {
  PosedPair pair;
  pair.E = generate::box({1, 1, 1});
  pair.F = degenerate::pentagram();
  pair.pose.A << -0x1.af1111d5d854p-3, 0x1.6f7a42ffd522ap-1, -0x1.53d6cafc062c2p-1,  //
      -0x1.a523b820446f2p-1, 0x1.e531b016c42f4p-3, 0x1.08b6235842684p-1,             //
      0x1.0e80c0edb5e44p-1, 0x1.4f3f5ccf1c211p-1, 0x1.14bbb30d851d4p-1;
  pair.pose.r = {0x1.8ad7d4d871475p-1, 0x1.906453177a04cp-1, -0x1.cc6f4cc7d3d43p-1};
  pair.velocity = {{-0x1.3ed25da43eca5p-13, 0x1.cd2d6555101cp-14, 0x1.c24f49cb040fdp-15},
                   {-0x1.965447b2844f6p-8, -0x1.8661e4e25e259p-11, -0x1.0bb80952e7083p-10}};
  pair.law.layers = LayerStiffness{std::numeric_limits<double>::infinity(), 0x1.8f63a96b76995p+15};
  pair.law.damping = 0x1.8000c203b854cp+17;
  pair.law.damping_mode = DampingMode::compression;
  pair.law.transition_depth = 0x1.78b79f4c6ceeap-10;
  pair.law.friction = 0x1.76f195e04b644p-1;
  pair.law.slip_velocity = 0x1.88c7af49a965fp-9;
  pair.mode = Mode::F;
  EXPECT_FALSE(pair.is_flagged());
}

/// A wall of the cylinder stands so nearly upright on the cube's face that an edge of it is seen 1e-12 m long; the line
/// of that edge parts what is seen 0.3 m away from it (extreme pose 25918 of this pair).
TEST(ClippedTangentVerdict, PassesTheEnginesWhereTheLineOfAnEdgeSeenOnEndPartsWhatIsSeen) {
  PosedPair pair;
  pair.E = generate::cylinder(0.5, 1, 12);
  for (Eigen::Vector3d& x : pair.E.vertices) x = (0x1p12 * x).array().round() * 0x1p-12;
  pair.F = generate::box({1, 1, 1});
  pair.pose.A << -0x1.9999999999a7ep-1, 0x1.b5699f223cc04p-36, -0x1.3333333333337p-1,  //
      0x1.5207fc95bd878p-50, 0x1.ffffffffe7e6ep-1, -0x1.ed522e65d4f4ep-39,             //
      0x1.33333333333ep-1, 0x1.111a18442c256p-44, -0x1.999999999950ap-1;
  pair.pose.r = {-0x1.c42666662fc74p-2, 0x1.aedffffff7ce7p-1, 0x1.6666666666586p-1};
  pair.velocity = {{0, -0x1.8f368c1b2523ep-3, 0}, {0, 0, 0}};
  pair.law = {};
  pair.law.stiffness = 0x1.dae8f0da21ff4p+25;
  pair.law.damping = 0x1.0b0296ef307c6p+27;
  pair.law.transition_depth = 0x1.d5bcbd5bc2c28p-16;
  pair.law.friction = 0x1.f1d52729bda1ap-1;
  pair.law.slip_velocity = 0x1.07f772d1c4d12p-14;
  pair.law.max_penetration = 0x1.659e9c9e422e6p-5;
  pair.law.damping_mode = DampingMode::compression;
  EXPECT_FALSE(pair.is_flagged());
}

/// An edge of the hand ends, and with it what hides, where another hiding face's edge begins: the cut along the one
/// takes a corner alone, and yet lies along the side that the other has left (trajectory poses 6161 and 6599 of this
/// pair; in the latter the corner is what is left).
TEST(ClippedTangentVerdict, PassesTheEnginesWhereACutAlongASideTakesACornerAlone) {
  PosedPair pair;
  for (const SurfacePair& recorded : recorded_pairs()) {
    if (recorded.name != "hand_right-car") continue;
    pair.E = recorded.E;
    pair.F = recorded.F;
    pair.law = recorded.law;
  }
  ASSERT_FALSE(pair.E.faces.empty());
  pair.pose.A << -0x1.410aa5b460fp-7, 0x1.fde1d118bc46bp-1, 0x1.72007bc6c1ae5p-4,  //
      -0x1.f5aa1eee2865fp-1, -0x1.c430f6b1b59cp-6, 0x1.95809acda5b0cp-3,           //
      0x1.98ee51c26dd2ep-3, -0x1.62964d22ca1d4p-4, 0x1.f3ba5325c7efdp-1;
  pair.pose.r = {-0x1.08f9df3592d21p-4, -0x1.504a6bf527952p-7, -0x1.9c0252b4b4dc3p-1};
  pair.velocity = {{-0x1.0eea0157025b7p+2, -0x1.6e3d72181b461p+3, 0x1.483dffb756f5cp+0},
                   {-0x1.ec1b2b77b6d61p+3, 0x1.74bad0405b18dp+2, -0x1.120701b6fb843p+0}};
  EXPECT_FALSE(pair.is_flagged());
  pair.pose.A << -0x1.411bc3d89578p-7, 0x1.fde30f72b555bp-1, 0x1.719282c1f1d12p-4,  //
      -0x1.f5b1490fd71d5p-1, -0x1.c37e7843dadcp-6, 0x1.94f5cc43635f2p-3,            //
      0x1.98618a232923dp-3, -0x1.62320452625c6p-4, 0x1.f3c2a188045e1p-1;
  pair.pose.r = {-0x1.08aaed90440bap-4, -0x1.49a20b575c11dp-7, -0x1.9c054ef2458e3p-1};
  pair.velocity = {{-0x1.0e6320472a64dp+2, -0x1.6e122ed4f6811p+3, 0x1.4747dd3362c2ep+0},
                   {-0x1.ebf70ce954dd1p+3, 0x1.73fdaf536313ap+2, -0x1.11fdd4ba9a2d6p+0}};
  EXPECT_FALSE(pair.is_flagged());
}

/// Two wedges, the one's ridge in a side of the other: there both its sides touch that side, and the one beyond the
/// ridge is 2^-32 off its plane. Moved one way it comes to light 4e9 times as fast as it moves, moved the other way the
/// ridge is covered at half the speed: the oracle's derivative is of the one, the engine's moves the ridge (`pcm
/// verify`, seed 2026, extreme pose 14805 of the wedges).
TEST(ClippedTangentVerdict, PassesTheEnginesWhereAHiddenFaceIsNearlyLevelWithWhatHidesIt) {
  PosedPair pair;
  pair.E.vertices = {{0, -0.5, 0}, {1, -0.5, 1}, {-1, -0.5, 1}, {0, 0.5, 0}, {-1, 0.5, 1}, {1, 0.5, 1}};
  pair.E.faces = {{0, 1, 2}, {3, 4, 5}, {0, 3, 5}, {0, 5, 1}, {0, 2, 4}, {0, 4, 3}, {1, 5, 4}, {1, 4, 2}};
  pair.F = pair.E;
  for (Eigen::Vector3d& x : pair.F.vertices) x += Eigen::Vector3d::Constant(0x1p21);
  pair.pose.A << -0x1.ffffffffe1bbcp-1, 0x1.40939771ffcbp-52, -0x1.2cc6b2a0ca348p-39,  //
      -0x1.c82380a76984dp-49, -0x1.0000000000343p+0, -0x1.ba44c4626c3f8p-45,           //
      0x1.bb72979df389p-34, -0x1.13cd492095fe8p-48, 0x1.0000000000006p+0;
  pair.pose.r = {0x1.fffff3ffe66ebp+20, 0x1.fffffc000085dp+20, -0x1.fffff400ddb7ep+20};
  pair.velocity = {};
  pair.law = {};
  EXPECT_FALSE(pair.is_flagged());
}

/// A face of the slave in the plane of the sheet that hides it, to the bit, where the sheet's other face is nearly
/// level with both but lies beside the master: nothing of that comes to light, and the verdict demands as much as ever.
TEST(ClippedTangentVerdict, DemandsNoLessWhereTheNearlyLevelFaceIsNotOverTheFlushOne) {
  PosedPair pair;
  pair.E.vertices = {{0, 0, -1}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  pair.E.faces = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                  {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  const double z = -0.125;
  pair.F.vertices = {{-1, -1, z},   {4, -1, z},     {-1, 4, z},  {4, 4, z + 0x1p-31},
                     {.25, .25, z}, {.625, .25, z}, {.25, .5, z}};
  pair.F.faces = {{0, 2, 1}, {1, 2, 3}, {4, 6, 5}};
  ContactLaw law;
  law.stiffness = 1;
  const HeldPairing held(pair.E, pair.F, law, Mode::E, Scheme::clipped);
  fast::Workspace workspace;
  const fast::Contact& subj = fast::evaluate(held.engine(), Pose{}, {}, {}, workspace);
  reference::Inquiry inquiry(held.oracle(), Pose{});
  const fast::Tangent allowed =
      allowed_errors(held.question({}, {}), subj.elements, inquiry.answer(reference::Problem::rounded, Mode::E),
                     inquiry.tangent(reference::Problem::rounded, Mode::E));
  EXPECT_GT(subj.element_count, 0);
  EXPECT_LT(allowed.topLeftCorner(3, 3).maxCoeff(), 1e-6);
}

/// A wall stands upright as the master sees it, and leans over the face beside it by roundings, or not: what that face
/// is seen of ends at the wall's line in the master's plane, or at their common edge (`pcm verify`, seed 2026,
/// degenerate pose 12779 of the lattice tetrahedra).
TEST(ClippedTangentVerdict, PassesTheEnginesWhereAnUprightWallLeansOverItsNeighbourByRoundings) {
  PosedPair pair;
  pair.E.vertices = {{1, 0, -1}, {-1, 1, -1}, {2, -1, 2}, {-1, 2, -1}};
  pair.E.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  pair.F.vertices = {{1, 2, 1}, {2, -1, -1}, {2, -2, -2}, {-2, -1, 2}};
  pair.F.faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  pair.pose.A << -0x1p+0, 0x0p+0, 0x0p+0,                   //
      0x0p+0, -0x1.89d89d89d89d9p-2, 0x1.d89d89d89d89ep-1,  //
      0x0p+0, 0x1.d89d89d89d89ep-1, 0x1.89d89d89d89d9p-2;
  pair.pose.r = {0x1.4p+0, 0x1.313b13b13b13bp-1, -0x1.3d89d89d89d8ap+1};
  pair.velocity = {};
  pair.law = {};
  pair.law.stiffness = 1e4;
  EXPECT_FALSE(pair.is_flagged());
}

/// A pose of sunken blocks, plate and blocks swapped or not.
struct SunkenPose {
  std::uint64_t number;
  bool swapped;
  Pose pose;
};

PosedPair pair_of(const SunkenPose& sunken) {
  PosedPair pair;
  std::array<TriangleMesh, 2> bodies = degenerate::sunken_blocks(sunken.number);
  if (sunken.swapped) std::swap(bodies[0], bodies[1]);
  pair.E = bodies[0];
  pair.F = bodies[1];
  pair.pose = sunken.pose;
  pair.velocity = {{0.3, -0.2, 0.1}, {0, 0, 0}};
  return pair;
}

/// A floor's edge lies off the master's plane, or off another floor, by ulps: there the planes of the two meet as near
/// to the edge as can't be told from roundings of places, but not the faces, and forces would grow up to 10^5 times as
/// fast as they do (`pcm verify`, seed 2026, near-degenerate poses 12877, 11704, 14065 and 9964).
TEST(ClippedTangentVerdict, PassesTheEnginesWhereAFloorIsOffFlushByUlps) {
  const std::array<SunkenPose, 4> poses{{
      {6, true, {Eigen::Matrix3d{{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {0x1.1cp+2, 0x1.0ap+2, -0x1.4f7fffffffff9p+1}}},
      {20,
       false,
       {Eigen::Matrix3d{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}},
        {0x1.9fffffffffff8p+3, 0x1.b7fffffffffffp+3, -0x1.2fffffffffffep+2}}},
      {0, true, {Eigen::Matrix3d{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}, {-0x1.4p+1, 0x1.7fffffffffff8p+3, 0x1.c8p+2}}},
      {14,
       false,
       {Eigen::Matrix3d{{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}, {-0x1.2p-2, -0x1.c84p+2, -0x1.0bfffffffffffp+2}}},
  }};
  for (const SunkenPose& sunken : poses) EXPECT_FALSE(pair_of(sunken).is_flagged()) << sunken.number;
}

/// A face of the slave comes out of one of the master's own within ulps of its edge, beyond which the sheet goes on
/// hidden by the same face: its part moves as the two faces meet, not as the face beyond the edge does with that one.
/// Where it touches that face with its edge alone, it is the other way round (`pcm verify`, seed 2026, near-degenerate
/// poses 10672, 11344, 12012, 9888 and 14596; 13488 and 13683).
TEST(ClippedTangentVerdict, PassesTheEnginesWhereAFaceIsHiddenFromWithinUlpsOfItsEdgeOn) {
  const std::array<SunkenPose, 7> poses{{
      {8,
       false,
       {Eigen::Matrix3d{{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
        {-0x1.ebffffffffff8p+3, -0x1.5680000000008p+4, -0x1.5200000000008p+1}}},
      {8, false, {Eigen::Matrix3d{{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}, {0x1.e4p+3, -0x1.ep+3, -0x1.0000000000014p+0}}},
      {6,
       false,
       {Eigen::Matrix3d{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
        {-0x1.46ffffffffffep+4, -0x1.e6bfffffffff9p+3, -0x1.7bffffffffff9p+2}}},
      {0, false, {Eigen::Matrix3d{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, {-0x1.7fffffffffff6p+3, 0x1.7p+2, -0x1.28p+2}}},
      {2,
       false,
       {Eigen::Matrix3d{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {-0x1.51fffffffffe8p+2, 0x1.c00000000008p+0, 0x1.2p+1}}},
      {0, false, {Eigen::Matrix3d{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, {0x1.fp+2, -0x1.b4ffffffffffp+2, -0x1.e8p+2}}},
      {1, true, {Eigen::Matrix3d{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}, {0x1.ecp+2, 0x1.47p+2, 0x1.8800000000001p+1}}},
  }};
  for (const SunkenPose& sunken : poses) EXPECT_FALSE(pair_of(sunken).is_flagged()) << sunken.pose.r.transpose();
}

/// Edges of blocks lie on the lines of others at other depths, beyond their ends. Taken for these they would move
/// forces and torques by up to 30,000 N/m and N.
TEST(ClippedTangentVerdict, DoesNotTakeAnEdgeForABorderBeyondItsEnds) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const pcm::test::SunkenBlocks bodies(seed);
    ContactLaw law;
    law.stiffness = 7;
    const HeldPairing held(bodies.plate, bodies.blocks, law, Mode::E, Scheme::clipped);
    reference::Inquiry inquiry(held.oracle(), bodies.pose, {}, {}, law, Scheme::clipped);
    const fast::Tangent bounds =
        tangent_bounds(held.question(bodies.pose, {}), inquiry.answer(reference::Problem::rounded, Mode::E),
                       inquiry.tangent(reference::Problem::rounded, Mode::E).elements);
    EXPECT_LT(bounds.leftCols(6).maxCoeff(), 1e-2) << "seed " << seed;
  }
}

TEST(ClippedTangentVerdict, MayBeRefusedWhereWhatIsAllowedReachesBeyondAllDoubles) {
  constexpr double kMost = std::numeric_limits<double>::max();
  reference::Tangent truth;
  fast::Tangent allowed = fast::Tangent::Constant(1);
  EXPECT_FALSE(may_overflow(truth, allowed));
  truth.slope(3, 9) = -kMost / kGreatestOnTheWay;
  EXPECT_FALSE(may_overflow(truth, allowed));
  allowed(3, 9) = kMost / kGreatestOnTheWay / 2;
  EXPECT_TRUE(may_overflow(truth, allowed));
  truth.slope(3, 9) = 0;
  EXPECT_FALSE(may_overflow(truth, allowed));
  allowed(5, 11) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(may_overflow(truth, allowed));
}

}  // namespace
}  // namespace pcm::compare
