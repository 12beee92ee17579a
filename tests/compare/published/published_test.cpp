// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The published algorithms: right where nothing is degenerate, and wrong where it is said that they are.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "compare/poses/pairs.h"
#include "compare/wrong_answers/tested_engine.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "pcm/bad_input.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

constexpr std::array kPublished = {Engine::published_2003, Engine::published_2023};

/// One pairing as all of them see it.
class Trio {
 public:
  Trio(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Mode mode)
      : Trio(mesh_E, mesh_F, mode, verification_law(0, mesh_E, mesh_F)) {}
  Trio(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Mode mode, const ContactLaw& law)
      : oracle_(mesh_E, mesh_F, law, mode) {
    for (const Engine engine : kEngines)
      tested_.push_back(make_tested_engine(engine, mesh_E, mesh_F, law, mode, Scheme::barycentric));
  }

  fast::Contact ask(Engine engine, const Pose& pose, const Velocity& velocity = {}) {
    return tested_[static_cast<std::size_t>(engine)]->evaluate(pose, velocity, {}, workspace_);
  }
  reference::Answer truth(const Pose& pose, const Velocity& velocity = {}) const {
    return oracle_.answer(reference::Problem::rounded, pose, velocity);
  }

 private:
  reference::Oracle oracle_;
  std::vector<std::unique_ptr<const TestedEngine>> tested_;
  TestedEngineWorkspace workspace_;
};

Pose at(const Eigen::Vector3d& r) {
  Pose pose;
  pose.r = r;
  return pose;
}

/// A rotation about no axis of anything.
Pose turned_at(const Eigen::Vector3d& r) {
  Pose pose = at(r);
  pose.A = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return pose;
}

void expect_same_elements(const fast::Contact& contact, const fast::Contact& engine) {
  ASSERT_EQ(contact.elements.size(), engine.elements.size());
  for (std::size_t k = 0; k < engine.elements.size(); ++k) {
    const fast::Element& ours = contact.elements[k];
    const fast::Element& theirs = engine.elements[k];
    EXPECT_EQ(std::tie(ours.master, ours.master_face, ours.slave_face),
              std::tie(theirs.master, theirs.master_face, theirs.slave_face));
  }
}

void expect_same_force(const fast::Contact& contact, const reference::Answer& truth) {
  EXPECT_LE((contact.force_Me - truth.force_Me).norm(), 1e-9 * truth.force_scale);
  EXPECT_LE((contact.torque_Me - truth.torque_Me).norm(), 1e-9 * truth.torque_scale);
}

void expect_same_polygons(const fast::Contact& contact, const fast::Contact& engine) {
  ASSERT_EQ(contact.polygons.size(), engine.polygons.size());
  ASSERT_EQ(contact.crossings.size(), engine.crossings.size());
  EXPECT_EQ(contact.patches, engine.patches);
  for (std::size_t k = 0; k < engine.polygons.size(); ++k) {
    EXPECT_EQ(contact.polygons[k].closed, engine.polygons[k].closed);
    EXPECT_EQ(contact.polygons[k].count, engine.polygons[k].count);
    EXPECT_EQ(contact.polygons[k].patch, engine.polygons[k].patch);
  }
  for (std::size_t k = 0; k < engine.crossings.size(); ++k) {
    const fast::Crossing& ours = contact.crossings[k];
    const fast::Crossing& theirs = engine.crossings[k];
    EXPECT_EQ(std::tie(ours.edge_side, ours.edge, ours.face), std::tie(theirs.edge_side, theirs.edge, theirs.face));
    EXPECT_LE((ours.position_Me - theirs.position_Me).norm(), 1e-12);
  }
}

/// At an ordinary pose both algorithms give the engine's answer, as far as they have one.
void expect_agreement(Trio& trio, const Pose& pose) {
  const Velocity velocity{.v = {0.1, -0.2, 0.3}, .w = {0.3, 0.2, -0.1}};
  const fast::Contact engine = trio.ask(Engine::fast, pose, velocity);
  const reference::Answer truth = trio.truth(pose, velocity);
  ASSERT_TRUE(engine.touching);
  ASSERT_GT(engine.elements.size(), 0u);
  for (const Engine published : kPublished) {
    SCOPED_TRACE(name(published));
    const fast::Contact contact = trio.ask(published, pose, velocity);
    expect_same_elements(contact, engine);
    expect_same_force(contact, truth);
  }
  const fast::Contact paper = trio.ask(Engine::published_2003, pose, velocity);
  EXPECT_EQ(paper.E.intersected, engine.E.intersected);
  EXPECT_EQ(paper.F.intersected, engine.F.intersected);
  EXPECT_EQ(paper.E.inner, engine.E.inner);
  EXPECT_EQ(paper.F.inner, engine.F.inner);
  expect_same_polygons(paper, engine);
}

TEST(PublishedAlgorithms, CubeInCubeIsTheEnginesAnswer) {
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    Trio trio(generate::gridded_box(1, 4), generate::gridded_box(1, 3), mode);
    expect_agreement(trio, turned_at({0.6, 0.5, 0.9}));
  }
}

TEST(PublishedAlgorithms, ClampPenetrationsAsTheEngineDoes) {
  const TriangleMesh cube = generate::gridded_box(1, 4);
  ContactLaw law = verification_law(0, cube, cube);
  law.max_penetration = 0.02;
  Trio trio(cube, cube, Mode::both, law);
  ASSERT_TRUE(trio.ask(Engine::fast, turned_at({0.6, 0.5, 0.9})).penetration_exceeded);
  expect_agreement(trio, turned_at({0.6, 0.5, 0.9}));
}

TEST(PublishedAlgorithms, SphereOnPlateIsTheEnginesAnswer) {
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    Trio trio(generate::icosphere(0.5, 3), generate::gridded_box(2, 12), mode);
    expect_agreement(trio, turned_at({0.011, 0.023, -1.45}));
  }
}

TEST(PublishedAlgorithms, BubblesThatTouchInSeveralPlacesAreTheEnginesAnswer) {
  Trio trio(generate::bubble(), generate::bubble(), Mode::both);
  expect_agreement(trio, turned_at({0.13, 0.02, 0.1}));
}

TEST(PublishedAlgorithms, AnEdgeThatPassesInAndOutHasBothEndsOutside) {
  // An edge of E grazes one of F: every crossed edge near it is crossed twice.
  Trio trio(generate::gridded_box(1, 1), generate::gridded_box(1, 1), Mode::both);
  Pose pose = at({0.93, 0.0, 0.91});
  pose.A = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitZ()))
               .toRotationMatrix();
  const fast::Contact engine = trio.ask(Engine::fast, pose);
  const fast::Contact paper = trio.ask(Engine::published_2003, pose);
  std::set<std::pair<Side, std::array<Index, 2>>> edges;
  for (const fast::Crossing& crossing : engine.crossings) edges.insert({crossing.edge_side, crossing.edge});
  ASSERT_LT(edges.size(), engine.crossings.size());  // some edge is crossed more than once
  EXPECT_EQ(paper.E.inner, engine.E.inner);
  EXPECT_EQ(paper.F.inner, engine.F.inner);
  expect_same_polygons(paper, engine);
}

TEST(PublishedAlgorithms, SeparatedBodiesHaveNoContact) {
  Trio trio(generate::icosphere(0.5, 2), generate::icosphere(0.5, 2), Mode::both);
  for (const Engine published : kPublished) {
    const fast::Contact contact = trio.ask(published, at({0.7, 0.7, 0.7}));
    EXPECT_FALSE(contact.touching);
    EXPECT_EQ(contact.element_count, 0);
    EXPECT_EQ(contact.force_Me, Eigen::Vector3d::Zero());
  }
}

TEST(PublishedAlgorithms, AnAnswerDoesNotDependOnTheOneBefore) {
  Trio trio(generate::bubble(), generate::bubble(), Mode::both);
  for (const Engine published : kPublished) {
    const fast::Contact once = trio.ask(published, turned_at({0.13, 0.02, 0.1}));
    trio.ask(published, turned_at({0.1, 0.05, 0.02}));
    const fast::Contact again = trio.ask(published, turned_at({0.13, 0.02, 0.1}));
    EXPECT_EQ(once.force_Me, again.force_Me);
    EXPECT_EQ(once.crossings.size(), again.crossings.size());
    EXPECT_EQ(once.work.box_tests, again.work.box_tests);
  }
}

TEST(PublishedAlgorithms, RefuseWhatTheyDoNotKnow) {
  const TriangleMesh box = generate::gridded_box(1, 1);
  for (const Engine published : kPublished) {
    EXPECT_THROW(make_tested_engine(published, box, box, {}, Mode::E, Scheme::clipped), BadInput);
    const auto tested = make_tested_engine(published, box, box, {}, Mode::E, Scheme::barycentric);
    TestedEngineWorkspace workspace;
    Wanted wanted;
    wanted.bound = true;
    EXPECT_THROW(tested->evaluate({}, {}, wanted, workspace), BadInput);
    Pose mirror;
    mirror.A(0, 0) = -1;
    EXPECT_THROW(tested->evaluate(mirror, {}, {}, workspace), BadInput);
  }
  EXPECT_THROW(engine_named("published"), BadInput);
}

// Where they are wrong, and the engine right. All numbers below are exact in doubles.

double force_z(Trio& trio, Engine engine, const Pose& pose) {
  return trio.ask(engine, pose).force_Me.z();
}

Index open_polygons(const fast::Contact& contact) {
  return static_cast<Index>(std::count_if(contact.polygons.begin(), contact.polygons.end(),
                                          [](const fast::Polygon& polygon) { return !polygon.closed; }));
}

TEST(PublishedAlgorithms, PaperLosesElementsWhoseLineMeetsAnEdgeOfTheSlave) {
  // Cubes of edge 6 sunk into one another by 1/4. Barycentres lie over the diagonals of the other cube's side, and (10)
  // counts the inside of a face only.
  Trio trio(generate::gridded_box(6, 1), generate::gridded_box(6, 1), Mode::E);
  const Pose pose = at({1, -1, 5.75});
  const double right = trio.truth(pose).force_Me.z();
  EXPECT_EQ(force_z(trio, Engine::fast, pose), right);
  EXPECT_EQ(force_z(trio, Engine::published_2023, pose), right);
  EXPECT_EQ(force_z(trio, Engine::published_2003, pose), right / 2);
}

TEST(PublishedAlgorithms, PapersPolygonsFallApartWhereEdgesMeetEdges) {
  // Grids upon grids: the engine has one closed polygon. What does not chain no longer bounds the flood.
  Trio trio(generate::gridded_box(2, 4), generate::gridded_box(2, 4), Mode::E);
  const Pose pose = at({0.5, 0.5, 1.75});
  const reference::Answer truth = trio.truth(pose);
  const fast::Contact engine = trio.ask(Engine::fast, pose);
  const fast::Contact paper = trio.ask(Engine::published_2003, pose);
  EXPECT_EQ(truth.polygons.size(), 1u);
  EXPECT_EQ(engine.polygons.size(), 1u);
  EXPECT_EQ(open_polygons(engine), 0);
  EXPECT_GT(paper.polygons.size(), 1u);
  EXPECT_GT(open_polygons(paper), 0);
  EXPECT_EQ(engine.E.inner, truth.E.inner);
  EXPECT_EQ(paper.E.intersected.size() + paper.E.inner.size(), 192u) << "the flood reaches every face";
}

TEST(PublishedAlgorithms, PapersFloodRunsRoundTheBorderOfAnOpenSurface) {
  // A sphere that hangs over both borders of a strip: all of it counts as inside, and its far side presses as well. The
  // engine flags the answer and takes the intersected faces only.
  Trio trio(generate::icosphere(1, 2), generate::rectangle(1, 4, 1, 4), Mode::E);
  const Pose pose = at({0.03, 0.02, -0.8});
  const fast::Contact engine = trio.ask(Engine::fast, pose);
  const fast::Contact paper = trio.ask(Engine::published_2003, pose);
  EXPECT_TRUE(engine.ambiguous);
  EXPECT_EQ(engine.E.inner.size(), 0u);
  EXPECT_EQ(paper.E.intersected.size() + paper.E.inner.size(), 320u);
  EXPECT_GT(paper.force_Me.z(), 1.5 * engine.force_Me.z());
}

TEST(PublishedAlgorithms, VariantLosesWhatLiesDeeperThanItsLinesAreLong) {
  Trio trio(generate::gridded_box(1, 4), generate::gridded_box(1, 3), Mode::E);
  const Pose pose = turned_at({0.4, 0.3, 0.9});
  const reference::Answer truth = trio.truth(pose);
  EXPECT_GT(truth.max_penetration, 0.5);
  EXPECT_EQ(trio.ask(Engine::fast, pose).elements.size(), truth.elements.size());
  EXPECT_EQ(trio.ask(Engine::published_2003, pose).elements.size(), truth.elements.size());
  EXPECT_LT(trio.ask(Engine::published_2023, pose).elements.size(), truth.elements.size());
}

TEST(PublishedAlgorithms, NeitherSeesThatTheMasterIsThinnerThanThePenetration) {
  // A plate that has passed wholly into a box: its line leaves the plate before it reaches the box's side.
  Trio trio(generate::plate(1, 1, 0.0625, 4, 4), generate::gridded_box(2, 4), Mode::E);
  const Pose pose = at({0.1, 0.2, -0.9});
  EXPECT_EQ(force_z(trio, Engine::fast, pose), 0);
  EXPECT_EQ(trio.truth(pose).force_Me.z(), 0);
  EXPECT_EQ(force_z(trio, Engine::published_2003, pose), 0) << "nothing collides";
  EXPECT_GT(force_z(trio, Engine::published_2023, pose), 0);
}

}  // namespace
}  // namespace pcm::compare
