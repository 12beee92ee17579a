// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/master_advice.h"

#include <gtest/gtest.h>

#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare::master_advice_test {
namespace {

Pose at(double x, double y, double z) {
  Pose pose;
  pose.r = {x, y, z};
  return pose;
}

MasterAdvice advise(TriangleMesh E, TriangleMesh F, const std::vector<Pose>& poses, const ContactLaw& law = {}) {
  MasterAdviser adviser(fast::Surface(std::move(E)), fast::Surface(std::move(F)), law);
  for (const Pose& pose : poses) adviser.add(pose);
  return adviser.advice();
}

TEST(MasterAdvice, FineSphereOnCoarsePlateIsTheMasterWhicheverBodyItIs) {
  const TriangleMesh sphere = generate::icosphere(0.5, 4), plate = generate::plate(2, 2, 1, 4, 4);
  const std::vector<Pose> above{at(0, 0, 0.45), at(0.125, 0.0625, 0.4), at(0.3, 0.1, 0.42)};
  const std::vector<Pose> below{at(0, 0, -0.45), at(0.125, 0.0625, -0.4), at(0.3, 0.1, -0.42)};
  for (const bool sphere_is_F : {true, false}) {
    const MasterAdvice advice = sphere_is_F ? advise(plate, sphere, above) : advise(sphere, plate, below);
    ASSERT_TRUE(advice.master);
    EXPECT_EQ(advice.master, sphere_is_F ? Mode::F : Mode::E);
    const MasterSummary &fine = advice.masters[sphere_is_F ? 1 : 0], &coarse = advice.masters[sphere_is_F ? 0 : 1];
    EXPECT_LT(fine.median_error, 0.05);
    EXPECT_GT(fine.across, 5);
    EXPECT_LT(coarse.across, 2);
    EXPECT_GT(coarse.greatest_element, fine.greatest_element);
    EXPECT_EQ(advice.in_contact, 3);
    // A whole cell of 1/2 m is wider than the contact, so that some pose has no barycentre in it.
    EXPECT_GT(coarse.lost, 0);
    EXPECT_EQ(fine.lost, 0);
  }
}

TEST(MasterAdvice, ErrorsAreThoseWorkedOutByHand) {
  // The box covers one and a half of the plate's cells, of two triangles each, whose barycentres lie at 1/3 and 2/3 of
  // the cell: three of them, which is right, or four, moved by a quarter. The box's own bottom counts as it is.
  const double cell = 0.25;
  const TriangleMesh plate = generate::plate(2, 2, 1, 8, 8);
  const TriangleMesh box = generate::box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1.5 * cell, cell, 1));
  const MasterAdvice advice = advise(plate, box, {at(0, 0, -0.0625)});
  EXPECT_NEAR(advice.masters[0].median_error, 0, 1e-12);
  EXPECT_NEAR(advice.masters[1].median_error, 0, 1e-12);
  const MasterAdvice shifted = advise(plate, box, {at(0.25 * cell, 0, -0.0625)});
  EXPECT_NEAR(shifted.masters[0].median_error, 4.0 / 3 - 1, 1e-12);
  EXPECT_NEAR(shifted.masters[1].median_error, 0, 1e-12);
  EXPECT_NEAR(shifted.masters[2].median_error, (4.0 / 3 - 1) / 2, 1e-12);
  EXPECT_EQ(shifted.masters[0].elements, 4);
  EXPECT_NEAR(shifted.masters[0].greatest_element, 0.25, 1e-12);
  EXPECT_NEAR(shifted.model_gap, 0, 1e-12);
  EXPECT_EQ(shifted.master, Mode::F);
}

TEST(MasterAdvice, DoesNotDependOnTheStiffness) {
  const TriangleMesh sphere = generate::icosphere(0.5, 2);
  const auto with_stiffness = [&](double stiffness) {
    ContactLaw law;
    law.stiffness = stiffness;
    return advise(sphere, sphere, {at(0.3, 0.01, 0.82)}, law);
  };
  const MasterAdvice usual = with_stiffness(1);
  EXPECT_GT(usual.masters[0].median_error, 0);
  for (const double stiffness : {0x1p-560, 0x1p560}) {
    const MasterAdvice scaled = with_stiffness(stiffness);
    EXPECT_EQ(scaled.in_contact, 1);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(scaled.masters[i].median_error, usual.masters[i].median_error, 1e-12);
  }
}

TEST(MasterAdvice, SaysWhereTheChosenMasterIsFarOff) {
  // Most of the sphere lies in the box and is too deep; the box's bottom has two faces.
  const MasterAdvice advice =
      advise(generate::icosphere(0.5, 3), generate::box(Eigen::Vector3d(1, 1, 1)), {at(0, 0, 0.14)});
  EXPECT_EQ(advice.master, Mode::F);
  EXPECT_GT(advice.masters[1].median_error, 0.5);
  EXPECT_NE(advice.reason.find("That is not near"), std::string::npos) << advice.reason;
}

TEST(MasterAdvice, MasterThinnerThanThePenetrationIsNotChosen) {
  // The sphere comes out of the plate below: there the plate's lines leave the plate first.
  const TriangleMesh plate = generate::plate(2, 2, 0.0625, 64, 64), sphere = generate::icosphere(0.5, 3);
  const MasterAdvice advice = advise(plate, sphere, {at(0, 0, 0.42)});
  EXPECT_EQ(advice.in_contact, 1);
  EXPECT_GT(advice.masters[0].too_deep, 0);
  EXPECT_EQ(advice.masters[1].too_deep, 0);
  EXPECT_EQ(advice.masters[2].too_deep, advice.masters[0].too_deep);
  EXPECT_EQ(advice.master, Mode::F);
  EXPECT_NE(advice.reason.find("for its thickness"), std::string::npos) << advice.reason;
}

TEST(MasterAdvice, WhereAllIsTooDeepThereIsNone) {
  const MasterAdvice advice = advise(generate::plate(2, 2, 0.0625, 8, 8), generate::gridded_box(4, 4), {at(0, 0, 1.9)});
  EXPECT_EQ(advice.in_contact, 1);
  EXPECT_GT(advice.masters[0].too_deep, 0);
  EXPECT_FALSE(advice.master);
  EXPECT_NE(advice.reason.find("thinner than they penetrate"), std::string::npos);
}

TEST(MasterAdvice, WithoutAForceThereIsNone) {
  const MasterAdvice advice =
      advise(generate::box(Eigen::Vector3d(1, 1, 1)), generate::box(Eigen::Vector3d(1, 1, 1)), {at(5, 0, 0)});
  EXPECT_FALSE(advice.master);
  EXPECT_EQ(advice.poses, 1);
  EXPECT_EQ(advice.in_contact, 0);
  EXPECT_NE(master_advice_text(advice).find("there is nothing to choose by"), std::string::npos);
}

TEST(AdviceProgram, PrintsATableAndOneSentenceInPlaceOfJson) {
  const TemporaryFolder scratch;
  const std::string plate = scratch.path("plate.obj"), sphere = scratch.path("sphere.obj");
  ASSERT_EQ(run_pcm({"mesh", "make", "plate", "-o", plate}).status, 0);
  ASSERT_EQ(run_pcm({"mesh", "make", "icosphere", "--radius=0.25", "-o", sphere}).status, 0);
  const std::string poses = scratch.write("poses.txt", "1 0 0 0 1 0 0 0 1 0 0 0.2\n1 0 0 0 1 0 0 0 1 0.1 0 0.22\n");
  const Outcome outcome = run_pcm({"contact", plate, sphere, "--poses", poses, "--advise"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("2 poses, 2 in contact"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nUse --mode "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find('{'), std::string::npos);
}

TEST(AdviceProgram, OptionsThatItWouldNotHeedAreRefused) {
  const TemporaryFolder scratch;
  const std::string box = scratch.path("box.obj");
  ASSERT_EQ(run_pcm({"mesh", "make", "box", "-o", box}).status, 0);
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{
           {"--mode", "F"}, {"--scheme", "clipped"}, {"--engine", "fast"}, {"--problem", "exact"}, {"--bound"}}) {
    std::vector<std::string> arguments{"contact", box, box, "--advise"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Outcome outcome = run_pcm(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("--advise"), std::string::npos) << outcome.err;
  }
  const std::string poses = scratch.write("poses.txt", "1 0 0 0 1 0 0 0 1 0 0 0\n1 0 0 0 1 0 0 0 1 1e200 0 0\n");
  const Outcome far = run_pcm({"contact", box, box, "--poses", poses, "--advise"});
  EXPECT_EQ(far.status, 2);
  EXPECT_EQ(far.out, "");
  EXPECT_NE(far.err.find("poses.txt:2"), std::string::npos) << far.err;
}

}  // namespace
}  // namespace pcm::compare::master_advice_test
