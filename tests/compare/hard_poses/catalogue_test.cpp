// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The named degenerate pairs: as they are, and moved by 1 to 8 ulps along each axis.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <tuple>

#include "compare/io/names.h"
#include "compare/poses/greatest_extent.h"
#include "compare/poses/rounded_vertices.h"
#include "compare/verify/routes/held_pairing.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"
#include "tests/compare/law_of_all.h"
#include "tests/meshes/mesh_measures.h"

namespace pcm::compare::catalogue_test {
namespace {

class CatalogueInScheme : public testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, CatalogueInScheme, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& scheme) { return std::string(name(scheme.param)); });

using Moved = std::tuple<Scheme, int>;  ///< along this axis

class MovedCatalogue : public testing::TestWithParam<Moved> {};

std::string name_of(const testing::TestParamInfo<Moved>& moved) {
  return std::string(name(std::get<Scheme>(moved.param))) + "xyz"[std::get<int>(moved.param)];
}

INSTANTIATE_TEST_SUITE_P(Schemes, MovedCatalogue,
                         testing::Combine(testing::Values(Scheme::barycentric, Scheme::clipped),
                                          testing::Values(0, 1, 2)),
                         name_of);

/// In all of the pairing's modes, each an answer, which are counted.
int expect_agreement(const HeldPairing& held, const Pose& pose, const Velocity& velocity, fast::Workspace& workspace) {
  int answers = 0;
  for (const PoseOutcome& outcome : held.hold(pose, velocity, workspace)) {
    ++answers;
    for (const Disagreement& d : outcome.disagreements) ADD_FAILURE() << name(d.kind) << ": " << d.text;
  }
  return answers;
}

TEST_P(MovedCatalogue, EngineAndOracleAgreeAndVolumesAreThoseWorkedOutByHandToUlps) {
  const auto [scheme, axis] = GetParam();
  const Velocity velocity{{0.3, -0.2, 0.1}, {0.5, 0.4, -0.3}};
  fast::Workspace workspace;
  int poses = 0, volumes = 0;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    const HeldPairing held(named.E, named.F, law_of_all(), HeldPairing::Modes{Mode::E, Mode::F, Mode::both}, scheme);
    const Pose plain{named.A, named.r};
    const double scale = coordinate_scale(named.E, named.F, plain), ulp = ulp_of(scale);
    for (int ulps = -8; ulps <= 8; ++ulps) {
      if (ulps == 0 && axis > 0) continue;
      SCOPED_TRACE(named.name + ", " + std::to_string(ulps) + " ulps along " + "xyz"[axis]);
      Pose pose = plain;
      pose.r[axis] += ulps * ulp;
      poses += expect_agreement(held, pose, velocity, workspace);
      if (scheme != Scheme::barycentric || !named.volume) continue;
      const auto volume = held.oracle().answer(reference::Problem::exact, pose, {}).volume;
      ASSERT_TRUE(volume.has_value());
      // What a surface sweeps.
      const double roundings = named.exactly_representable ? 0 : 8;
      EXPECT_NEAR(*volume, *named.volume, (std::abs(ulps) + roundings) * ulp * test::area(named.E));
      ++volumes;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(poses, 2000);
  if (scheme == Scheme::barycentric) {
    EXPECT_GT(volumes, 600);
  }
}

/// Each entry of A in a row by an ulp of 1/2 and by eight, at rest and moving.
TEST_P(MovedCatalogue, EngineAndOracleAgreeWhereTheRotationIsOffByUlps) {
  const auto [scheme, row] = GetParam();
  const Velocity at_rest, moving{{0.3, -0.2, 0.1}, {0.5, 0.4, -0.3}};
  fast::Workspace workspace;
  int poses = 0;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    const HeldPairing held(named.E, named.F, law_of_all(), HeldPairing::Modes{Mode::E, Mode::F, Mode::both}, scheme);
    for (int column = 0; column < 3; ++column)
      for (const int ulps : {column == 0 ? -1 : 1, column == 2 ? 8 : -8}) {
        SCOPED_TRACE(named.name + ", A(" + std::to_string(row) + ", " + std::to_string(column) + ") by " +
                     std::to_string(ulps) + " ulps");
        Pose pose{named.A, named.r};
        pose.A(row, column) += ulps * 0x1p-53;
        poses += expect_agreement(held, pose, ulps == 1 ? at_rest : moving, workspace);
      }
    if (HasFailure()) return;
  }
  EXPECT_GT(poses, 900);
}

/// Two vertices of F by an ulp of the coordinate, while what damps would pull.
TEST_P(MovedCatalogue, EngineAndOracleAgreeWhereAVertexIsOffByAnUlp) {
  const auto [scheme, axis] = GetParam();
  const Velocity parting{{0, 0, 4}, {0.5, 0.4, -0.3}};
  fast::Workspace workspace;
  int poses = 0;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    if (named.name == "needle") continue;  // two ulps thick, it would be inside out
    for (std::size_t v = 0; v < 2; ++v)
      for (const int ulps : {-1, 1}) {
        SCOPED_TRACE(named.name + ", vertex " + std::to_string(v) + " by " + std::to_string(ulps) + " ulps");
        TriangleMesh moved = named.F;
        double& x = moved.vertices[v][axis];
        x += ulps * ulp_of(x == 0 ? greatest_extent(named.F) : x);
        const HeldPairing held(named.E, moved, law_of_all(), HeldPairing::Modes{Mode::E, Mode::both}, scheme);
        poses += expect_agreement(held, {named.A, named.r}, parting, workspace);
        if (HasFailure()) return;
      }
  }
  EXPECT_GT(poses, 350);
}

/// By a rational rotation and five times as large, so that slanting faces lie in one plane exactly.
TriangleMesh turned_by_integers(TriangleMesh mesh, const Eigen::Matrix3d& turn) {
  for (Eigen::Vector3d& x : mesh.vertices) x = turn * x;
  return mesh;
}

TEST_P(CatalogueInScheme, PairsTurnedByIntegerMatricesAreHeldAndHaveTheSameVolumes) {
  Eigen::Matrix3d about_x, about_y;  // five times those of the quaternions (2, 1, 0, 0) and (1, 0, 2, 0)
  about_x << 5, 0, 0, 0, 3, -4, 0, 4, 3;
  about_y << -3, 0, 4, 0, 5, 0, -4, 0, -3;
  const Velocity velocity{{0.3, -0.2, 0.1}, {0.5, 0.4, -0.3}};
  fast::Workspace workspace;
  int volumes = 0;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    // Coordinates of few digits stay exact.
    if (!named.A.isIdentity(0) || !named.exactly_representable || !named.volume) continue;
    for (const Eigen::Matrix3d& turn : {about_x, about_y}) {
      SCOPED_TRACE(named.name);
      const HeldPairing held(turned_by_integers(named.E, turn), turned_by_integers(named.F, turn), law_of_all(),
                             HeldPairing::Modes{Mode::E, Mode::F, Mode::both}, GetParam());
      const Pose pose{Eigen::Matrix3d::Identity(), turn * named.r};
      expect_agreement(held, pose, velocity, workspace);
      const auto volume = held.oracle().answer(reference::Problem::exact, pose, {}).volume;
      ASSERT_TRUE(volume.has_value());
      EXPECT_NEAR(*volume, 125 * *named.volume, 0x1p-40 * *named.volume);
      if (*named.volume == 0) {
        EXPECT_EQ(*volume, 0);
      }
      ++volumes;
    }
  }
  EXPECT_GT(volumes, 60);
}

/// What is decided of a named pair.
struct Decided {
  bool touching = true;
  Index polygons = 1, patches = 1;
  bool nested = false, ambiguous = false;

  bool operator==(const Decided&) const = default;
};

void PrintTo(const Decided& decided, std::ostream* out) {
  *out << "touching " << decided.touching << ", polygons " << decided.polygons << ", patches " << decided.patches
       << ", nested " << decided.nested << ", ambiguous " << decided.ambiguous;
}

/// Where the bodies only touch, the tie rule moves E into F or away from it; in all of these F lies where E is moved
/// to: above it, at its side of greater y or x.
const std::map<std::string, Decided> kUnlikeMost = {
    {"nested_box", {false, 0, 0, true}},
    {"nested_in_box", {false, 0, 0, true}},
    {"nested_in_cavity_wall", {false, 0, 0, true}},
    {"box_in_cavity", {false, 0, 0}},
    {"ring_on_plate", {true, 2, 1}},          // an inner and an outer border
    {"ring_resting_on_plate", {true, 2, 1}},  // the same
    {"holed_plate_in_plate", {true, 3, 1}},
    {"holed_plate_resting_on_plate", {true, 3, 1}},
    {"two_pins_under_plate", {true, 2, 2}},
    {"bubble_in_open_container", {true, 4, 4}},
    // One border ends within E: faces beyond it are reached from both sides of the sheet.
    {"open_border_across_edge", {true, 1, 1, false, true}},
};

TEST_P(CatalogueInScheme, DecisionsAreThoseExpectedOfEachByEngineAndOracle) {
  fast::Workspace workspace;
  std::size_t unlike = 0;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    SCOPED_TRACE(named.name);
    const auto found = kUnlikeMost.find(named.name);
    unlike += found != kUnlikeMost.end();
    const Decided expected = found == kUnlikeMost.end() ? Decided{} : found->second;
    const HeldPairing held(named.E, named.F, ContactLaw{}, Mode::both, GetParam());
    const Pose pose{named.A, named.r};
    const fast::Contact& contact = fast::evaluate(held.engine(), pose, {}, {}, workspace);
    EXPECT_EQ((Decided{contact.touching, static_cast<Index>(contact.polygons.size()), contact.patches, contact.nested,
                       contact.ambiguous}),
              expected);
    const reference::Answer truth = held.oracle().answer(reference::Problem::rounded, pose, {});
    EXPECT_EQ((Decided{truth.touching, static_cast<Index>(truth.polygons.size()), truth.patches, truth.nested,
                       truth.ambiguous}),
              expected);
  }
  EXPECT_EQ(unlike, kUnlikeMost.size());
}

// Pairs that only touch, with F above E. Exact in the rounded problem, where one ulp of r is one ulp of every
// coordinate of F's that counts.
TEST_P(CatalogueInScheme, BodiesThatTouchAreApartOneUlpAwayAndMeetInAVolumeOneUlpNearer) {
  fast::Workspace workspace;
  for (const char* const name :
       {"vertex_on_face", "vertex_on_edge", "vertex_on_vertex", "vertex_on_flat_edge", "edge_in_face", "edge_over_edge",
        "edge_across_flat_edge", "parallel_coincident_edges", "stacked_boxes", "stacked_boxes_partly",
        "stacked_boxes_half", "small_box_on_large", "stacked_boxes_quarter_turn", "stacked_boxes_half_turn",
        "grids_a_third_apart", "ring_resting_on_plate", "holed_plate_resting_on_plate"}) {
    SCOPED_TRACE(name);
    const degenerate::Case named = degenerate::find_case(name);
    const HeldPairing held(named.E, named.F, ContactLaw{}, Mode::both, GetParam());
    const double ulp = ulp_of(coordinate_scale(named.E, named.F, {named.A, named.r}));
    for (int ulps = 1; ulps <= 8; ++ulps) {
      Pose away{named.A, named.r}, nearer{named.A, named.r};
      away.r.z() += ulps * ulp;
      nearer.r.z() -= ulps * ulp;
      EXPECT_FALSE(fast::evaluate(held.engine(), away, {}, {}, workspace).touching) << ulps;
      EXPECT_FALSE(held.oracle().answer(reference::Problem::rounded, away, {}).touching) << ulps;
      EXPECT_TRUE(fast::evaluate(held.engine(), nearer, {}, {}, workspace).touching) << ulps;
      const reference::Answer met = held.oracle().answer(reference::Problem::rounded, nearer, {});
      EXPECT_TRUE(met.touching) << ulps;
      ASSERT_TRUE(met.volume.has_value());
      EXPECT_GT(*met.volume, 0) << ulps;
    }
  }
}

/// A box of 1 m sunk 1/2 m into a larger one; the depth of its lower side is to be at most `max_penetration`.
TEST_P(CatalogueInScheme, ADepthBeyondTheLawsByAnUlpIsClampedAndFlaggedAndNoneBefore) {
  const TriangleMesh large = generate::box({0, 0, 0}, {4, 4, 2}), small = generate::box({1, 1, 1});
  fast::Workspace workspace;
  ContactLaw law = law_of_all();
  law.max_penetration = 0.5;
  const HeldPairing held(large, small, law, HeldPairing::Modes{Mode::F, Mode::both}, GetParam());
  for (int ulps = -8; ulps <= 8; ++ulps) {
    SCOPED_TRACE(ulps);
    const Pose pose{Eigen::Matrix3d::Identity(), {2.5, 1.25, 2 - ulps * 0x1p-52}};
    expect_agreement(held, pose, {}, workspace);
    const fast::Contact& contact = fast::evaluate(held.engine(), pose, {}, {}, workspace);
    EXPECT_EQ(contact.penetration_exceeded, ulps > 0);
    EXPECT_EQ(held.oracle().answer(reference::Problem::rounded, pose, {}).penetration_exceeded, ulps > 0);
  }
}

TEST_P(CatalogueInScheme, BodiesThatMeetInNoVolumeHaveNoElementsAndNoForce) {
  int empty = 0;
  fast::Workspace workspace;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    if (!named.volume || *named.volume != 0) continue;
    SCOPED_TRACE(named.name);
    ++empty;
    const Pose pose{named.A, named.r};
    for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
      const HeldPairing held(named.E, named.F, ContactLaw{}, mode, GetParam());
      const fast::Contact& contact = fast::evaluate(held.engine(), pose, {}, {}, workspace);
      const reference::Answer truth = held.oracle().answer(reference::Problem::exact, pose, {});
      EXPECT_EQ(truth.elements.size(), 0U);
      EXPECT_TRUE(truth.force_Me.isZero(0));
      if (!named.exactly_representable) continue;
      EXPECT_EQ(contact.element_count, 0);
      EXPECT_TRUE(contact.force_Me.isZero(0)) << contact.force_Me.transpose();
    }
  }
  EXPECT_GT(empty, 15);
}

/// What engine and oracle answer, by an elastic law of 1 N/m^3.
struct Answered {
  fast::Contact engine;
  reference::Answer oracle;
};
Answered answered(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose, Mode mode, Scheme scheme) {
  ContactLaw law;
  law.stiffness = 1;
  const HeldPairing held(E, F, law, mode, scheme);
  fast::Workspace workspace;
  EXPECT_TRUE(held.hold(pose, {}, workspace).front().disagreements.empty());
  return {fast::evaluate(held.engine(), pose, {}, {}, workspace),
          held.oracle().answer(reference::Problem::rounded, pose, {})};
}

TEST_P(CatalogueInScheme, OneTriangleUponItselfTouchesNothingWhicheverWayItIsWound) {
  TriangleMesh one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0.25, 1, 0.5}};
  one.faces = {{0, 1, 2}};
  for (const Triangle& winding : {Triangle{0, 1, 2}, Triangle{1, 2, 0}, Triangle{2, 0, 1}, Triangle{0, 2, 1},
                                  Triangle{2, 1, 0}, Triangle{1, 0, 2}})
    for (const Mode mode : {Mode::E, Mode::F}) {
      TriangleMesh other = one;
      other.faces = {winding};
      const Answered same = answered(one, other, {}, mode, GetParam());
      EXPECT_FALSE(same.engine.touching);
      EXPECT_FALSE(same.oracle.touching);
      EXPECT_EQ(same.engine.element_count, 0);
      EXPECT_EQ(same.oracle.elements.size(), 0U);
    }
}

/// Barycentric: the area of the one face of the master whose barycentre lies in F, 27 or 18 m^2, times the depth at
/// which its line meets F for the first time. Clipped, what of F lies beneath what is cut of F there counts: of the
/// spike, which widens upwards, all; of the keel, cut in a square of 1 m^2, the prism under its lower sides, 1/2 - |y|
/// deep, without the ends that lie under nothing; of the clamp's arm 4 m^2, 1/2 m deep, and of what joins the arms
/// 2 m^2, 5/2 m deep.
TEST_P(CatalogueInScheme, PenetrationLinesThroughFeaturesAndSheetsHaveTheirForceExactly) {
  struct Line {
    const char* name;
    double barycentric, clipped;  ///< N
  };
  for (const auto& [name, barycentric, clipped] :
       {Line{"penetration_line_through_vertex", 13.5, 1.0 / 12}, Line{"penetration_line_through_edge", 13.5, 0.25},
        Line{"penetration_line_through_sheets", 9, 9}, Line{"penetration_line_in_face", 18, 4.5},
        Line{"penetration_line_along_edge", 18, 1}}) {
    SCOPED_TRACE(name);
    const degenerate::Case named = degenerate::find_case(name);
    const Answered found = answered(named.E, named.F, {named.A, named.r}, Mode::E, GetParam());
    const double force = GetParam() == Scheme::barycentric ? barycentric : clipped;
    EXPECT_EQ(found.oracle.force_Me, Eigen::Vector3d(0, 0, -force));
    EXPECT_LT((found.engine.force_Me - Eigen::Vector3d(0, 0, -force)).norm(), 0x1p-48 * force);
  }
}

TEST_P(CatalogueInScheme, ABoxSmallerByTheThirtiethPowerOfTwoHasItsForceExactly) {
  const TriangleMesh large = generate::box({0x1p11, 0x1p11, 0x1p11}),
                     small = generate::box({0x1p-20, 0x1p-20, 0x1p-20});
  // On the large one's top, off its diagonals and axes.
  const Pose pose{Eigen::Matrix3d::Identity(), {0x1p9, 0x1p8, 0x1p10 + 0x1p-21 - 0x1p-22}};
  const Answered found = answered(large, small, pose, Mode::F, GetParam());
  EXPECT_EQ(found.engine.force_Me, Eigen::Vector3d(0, 0, -0x1p-62));
  EXPECT_EQ(found.oracle.force_Me, Eigen::Vector3d(0, 0, -0x1p-62));
}

TEST_P(CatalogueInScheme, OrientationsAreTakenByBothWhereTheyAreRotationsTo1e9AndRefusedBeyond) {
  const TriangleMesh box = generate::box({1, 1, 1});
  Pose pose;
  pose.r = {0.25, 0.125, 0.75};
  pose.A(0, 0) = 1 + 4.9e-10;
  const Answered taken = answered(box, box, pose, Mode::E, GetParam());
  EXPECT_TRUE(taken.engine.touching);
  EXPECT_TRUE(taken.oracle.touching);
  const HeldPairing held(box, box, ContactLaw{}, Mode::E, GetParam());
  fast::Workspace workspace;
  for (const double no_rotation : {1 + 5.1e-10, std::nan("")}) {
    pose.A(0, 0) = no_rotation;
    EXPECT_THROW(fast::evaluate(held.engine(), pose, {}, {}, workspace), BadInput);
    EXPECT_THROW(held.oracle().answer(reference::Problem::rounded, pose, {}), BadInput);
  }
}

/// An edge of the box is split for the face of its lower side alone.
TEST_P(CatalogueInScheme, ABoxWithATJunctionIsOpenAndItsLowerSideCarriesTheForceOfItsArea) {
  TriangleMesh split = generate::box({1, 1, 1});
  const auto is_low = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](Index v) { return split.vertices[static_cast<std::size_t>(v)].z() < 0; });
  };
  const auto found = std::find_if(split.faces.begin(), split.faces.end(), is_low);
  ASSERT_NE(found, split.faces.end());
  // The side of this face that is an edge of the box: its ends differ in one coordinate.
  const Triangle face = *found;
  std::size_t k = 0;
  const auto at = [&](Index v) { return split.vertices[static_cast<std::size_t>(v)]; };
  while ((at(face[k]) - at(face[(k + 1) % 3])).cwiseAbs().sum() != 1) ++k;
  const auto middle = static_cast<Index>(split.vertices.size());
  split.vertices.emplace_back(0.5 * (at(face[k]) + at(face[(k + 1) % 3])));
  *found = {face[k], middle, face[(k + 2) % 3]};
  split.faces.push_back({middle, face[(k + 1) % 3], face[(k + 2) % 3]});
  const MeshReport report = check(split);
  EXPECT_TRUE(report.fit()) << report.summary();
  EXPECT_FALSE(report.closed());
  EXPECT_EQ(report.border_edges.size(), 3U);
  const Pose pose{Eigen::Matrix3d::Identity(), {0.0625, 0.03125, 0.5 + 0.5 - 0.125}};
  const Answered on_plate = answered(generate::box({4, 4, 1}), split, pose, Mode::F, GetParam());
  EXPECT_EQ(on_plate.engine.force_Me, Eigen::Vector3d(0, 0, -0.125));
  EXPECT_EQ(on_plate.oracle.force_Me, Eigen::Vector3d(0, 0, -0.125));
  EXPECT_FALSE(on_plate.engine.has_volume);
}

}  // namespace
}  // namespace pcm::compare::catalogue_test
