// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "meshes/generate/parts.h"
#include "tests/fast/engine_support.h"

/// The clipped scheme against closed forms, which it meets to rounding on the given meshes.
namespace pcm::fast::clipped_elements_test {
namespace {

using namespace test;
using degenerate::inverted;
using degenerate::joined;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

Contact clipped(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose = {},
                const ContactLaw& law = stiffness(1), Mode mode = Mode::E, const Velocity& velocity = {}) {
  return answer(E, F, pose, law, mode, velocity, {}, Scheme::clipped);
}

void expect_near(const Vector3d& a, const Vector3d& b, double tolerance) {
  EXPECT_LT((a - b).norm(), tolerance) << a.transpose() << "\n" << b.transpose();
}

TEST(ClippedElements, BoxOnAPlateOfTwoTrianglesIsStiffnessTimesAreaTimesDepthInEveryMode) {
  const TriangleMesh plate = generate::plate(2, 2, 1);
  const TriangleMesh cube = generate::box(Vector3d(-0.25, -0.25, 0), Vector3d(0.25, 0.25, 0.5));
  for (const double angle : {0.0, 0.3, 1.1}) {
    Pose pose = shifted(0.07, 0.05, -0.05);
    pose.A = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
    for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
      const Contact contact = clipped(plate, cube, pose, stiffness(100), mode);
      expect_near(contact.force_Me, {0, 0, -1.25}, 1e-14);
      // Through the box's middle, below Mf.
      expect_near(contact.torque_Me, {0, 0, 0}, 1e-14);
      EXPECT_NEAR(contact.max_penetration, 0.05, 1e-16);
      EXPECT_NEAR(contact.statistics.patch_area, mode == Mode::both ? 0.5 : 0.25, 1e-15);
      EXPECT_EQ(contact.too_deep, 0);
    }
  }
}

TEST(ClippedElements, PlateAsMasterFeelsTheImmersedVolumeThroughItsCentroid) {
  const double K = 7;
  const TriangleMesh plate = generate::plate(8, 8, 3);
  const Eigen::Matrix3d corner_down =
      Eigen::Quaterniond::FromTwoVectors(Vector3d(1.1, 1, 0.9), Vector3d(0, 0, 1)).toRotationMatrix();
  const Eigen::Matrix3d apex_down = Eigen::AngleAxisd(kPi - 0.2, Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Matrix3d any = turned(0.8, Eigen::Vector3d::Zero()).A;
  const std::pair<TriangleMesh, Eigen::Matrix3d> bodies[] = {
      {generate::icosphere(1, 3), any},
      {generate::cone(0.7, 1.5, 24), apex_down},
      {generate::box(Vector3d(1, 0.8, 1.2)), corner_down},
      {generate::gridded_box(Vector3d(1, 0.8, 1.2), {3, 2, 4}), corner_down},
      {generate::bumpy_sphere(1, 0.002, 5, 40, 30), any}};
  for (const auto& [body, A] : bodies) {
    for (const double depth : {0.3, 0.01, 1e-5}) {
      Pose pose;
      pose.A = A;
      pose.r = {0.21, -0.34, 0};
      double lowest = std::numeric_limits<double>::infinity();
      for (const Vector3d& x : body.vertices) lowest = std::min(lowest, (A * x).z());
      pose.r.z() = -lowest - depth;
      const Contact contact = clipped(plate, body, pose, stiffness(K));
      ASSERT_GT(contact.volume, 0);
      const double thickness = contact.volume / contact.E.area;
      EXPECT_NEAR(contact.force_Me.z() / (-K * contact.volume), 1, 1e-14 / thickness);
      EXPECT_EQ(contact.force_Me.head<2>().norm(), 0);
      EXPECT_NEAR(contact.statistics.patch_area / contact.E.area, 1, 1e-14 / depth);
      // Many small master faces sample the same centroid.
      const Contact fine = clipped(generate::plate(8, 8, 3, 16, 16), body, pose, stiffness(K));
      expect_near(fine.torque_Me, contact.torque_Me, 1e-14 / thickness * std::abs(contact.force_Me.z()));
    }
  }
}

TEST(ClippedElements, TorqueOfATetrahedralIndentationIsThatOfItsCentroid) {
  // A corner of a cube, one of its edges' directions symmetric about z, turned about z: the immersed volume is a
  // pyramid with its apex down, the centroid of which lies above the apex.
  Pose pose;
  pose.A = (Eigen::AngleAxisd(0.4, Vector3d::UnitZ()) *
            Eigen::Quaterniond::FromTwoVectors(Vector3d(1, 1, 1), Vector3d(0, 0, 1)))
               .toRotationMatrix();
  const double h = 0.25;
  pose.r = {0.3, 0.2, -h};
  const Contact contact = clipped(generate::plate(8, 8, 3), generate::box(Vector3d(0, 0, 0), Vector3d(1, 1, 1)), pose);
  // Three edges of length h sqrt(3): V = (h sqrt 3)^3 / 6.
  const double volume = std::pow(h * std::sqrt(3.0), 3) / 6;
  EXPECT_NEAR(contact.force_Me.z(), -volume, 1e-15);
  expect_near(contact.torque_Me, {0, 0, 0}, 1e-15);
}

TEST(ClippedElements, WedgeIsPushedSidewaysWithoutFrictionAtAnyDepth) {
  const double K = 3, w = 1;
  for (const double degrees : {15.0, 30.0, 40.0, 45.0, 70.0}) {
    const double p = degrees * kPi / 180;
    const TriangleMesh wedge = generate::wedge(degrees, 1, w);
    const TriangleMesh plate = generate::plate(20, 20, 5);
    for (const double h : {0.5, 0.123, 1e-4}) {
      const double expected_z = K * w * h * h / 2 * (1 / std::sin(p) + 1 / std::cos(p));
      const Contact as_E = clipped(wedge, plate, shifted(0.1, 0.2, h), stiffness(K));
      EXPECT_NEAR(as_E.force_Me.z() / expected_z, 1, 1e-14 / h);
      EXPECT_NEAR(as_E.force_Me.x() / as_E.force_Me.z(), std::tan(p - kPi / 4), 1e-14 / h);
      EXPECT_NEAR(as_E.force_Me.y() / expected_z, 0, 1e-14 / h);
      const Contact as_slave = clipped(plate, wedge, shifted(0.1, 0.2, -h), stiffness(K));
      EXPECT_NEAR(as_slave.force_Me.z() / (-K * as_slave.volume), 1, 1e-14 / h);
      EXPECT_EQ(as_slave.force_Me.head<2>().norm(), 0);
    }
  }
}

TEST(ClippedElements, FlushFlanksCarryNothingWhateverTheTieRule) {
  const TriangleMesh lower = generate::box(Vector3d(0, 0, 0), Vector3d(2, 2, 2));
  const TriangleMesh upper = generate::box(Vector3d(0, 0, 1), Vector3d(2, 2, 3));
  EXPECT_EQ(clipped(lower, upper).force_Me, Vector3d(0, 0, -4));
  EXPECT_EQ(clipped(upper, lower).force_Me, Vector3d(0, 0, 4));
  EXPECT_EQ(clipped(lower, upper, {}, stiffness(1), Mode::F).force_Me, Vector3d(0, 0, -4));
  EXPECT_EQ(clipped(upper, lower, {}, stiffness(1), Mode::F).force_Me, Vector3d(0, 0, 4));
}

TEST(ClippedElements, IdenticalBodiesAtTheIdentityPoseCarryNothing) {
  for (const TriangleMesh& body : {generate::icosphere(1, 2), generate::bubble(), generate::torus(1, 0.3, 12, 8)}) {
    const Contact contact = clipped(body, body, {}, stiffness(1), Mode::both);
    expect_near(contact.force_Me, {0, 0, 0}, 1e-14);
    EXPECT_LT(contact.statistics.patch_area, 1e-13);
  }
}

TEST(ClippedElements, RestingBoxCarriesNothing) {
  const TriangleMesh cube = generate::box(Vector3d(0, 0, 0), Vector3d(1, 1, 1));
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    const Contact contact = clipped(cube, cube, shifted(0.25, 0.25, 1), stiffness(1), mode);
    EXPECT_EQ(contact.force_Me, Vector3d(0, 0, 0));
    EXPECT_EQ(contact.element_count, 0);
  }
}

TEST(ClippedElements, SplittingMasterOrSlaveFacesInTheirPlaneChangesNoElasticForce) {
  const TriangleMesh sphere = generate::icosphere(1, 3);
  const TriangleMesh coarse = generate::plate(4, 4, 1), fine = generate::plate(4, 4, 1, 32, 32);
  const Pose pose = turned(0.4, {0.1, 0.2, -0.8});
  for (const Mode mode : {Mode::E, Mode::F}) {
    const Contact whole = clipped(sphere, coarse, pose, stiffness(1), mode);
    const Contact split = clipped(sphere, fine, pose, stiffness(1), mode);
    ASSERT_GT(whole.element_count, 20);
    expect_near(split.force_Me, whole.force_Me, 1e-14 * whole.force_Me.norm());
    expect_near(split.torque_Me, whole.torque_Me, 1e-14 * whole.force_Me.norm());
  }
}

TEST(ClippedElements, PlateUnderALargeFaceFeelsNothingOfThePinBesideIt) {
  const TriangleMesh floor = generate::box(Vector3d(-8, -8, -4), Vector3d(8, 8, 0));
  const TriangleMesh plate = generate::box(Vector3d(-1, -1, -0.125), Vector3d(1, 1, 1));
  const auto force = [&](double pin_bottom, Mode mode) {
    const TriangleMesh pin = generate::box(Vector3d(2, 0, pin_bottom), Vector3d(2.5, 0.5, 1));
    return clipped(joined(plate, pin), floor, {}, stiffness(1), mode).force_Me.z();
  };
  for (const Mode mode : {Mode::E, Mode::F}) {
    EXPECT_NEAR(force(0.25, mode), 0.125 * 4, 1e-15);
    EXPECT_NEAR(force(0x1p-50, mode), 0.125 * 4, 1e-15);
    EXPECT_NEAR(force(-0x1p-40, mode), 0.125 * 4 + 0x1p-42, 1e-15);
    EXPECT_NEAR(force(-0.0625, mode), 0.125 * 4 + 0.0625 * 0.25, 1e-15);
  }
}

TEST(ClippedElements, ThinPlateAsMasterCarriesOnlyWhereItIsNotLeftFirst) {
  // A wedge of 45 degrees stands on its edge, sunk by h into a plate of thickness t < h: the lines leave the plate
  // first within h - t of the ridge.
  const double h = 0.5, t = 0.125;
  const TriangleMesh wedge = generate::wedge(45, 1, 1);
  const TriangleMesh plate = generate::plate(8, 8, t);
  const Contact contact = clipped(plate, wedge, shifted(0.3, 0.1, -h));
  // Depths from 0 to t remain on both flanks, of slope 1.
  EXPECT_NEAR(contact.force_Me.z(), -t * t, 1e-14);
  EXPECT_NEAR(contact.max_penetration, t, 1e-15);
  const Contact shallow = clipped(plate, wedge, shifted(0.3, 0.1, -0.1));
  EXPECT_NEAR(shallow.force_Me.z(), -0.01, 1e-15);
  EXPECT_EQ(shallow.too_deep, 0);
}

TEST(ClippedElements, FacesWhoseBarycentreIsTooDeepAreCountedAsInTheBarycentricScheme) {
  const TriangleMesh plate = generate::plate(4, 4, 0.125, 16, 16);
  const TriangleMesh ball = generate::icosphere(1, 3);
  const Pose pose = turned(0.7, {0.1, 0.2, 0.6});
  const Contact expected = answer(plate, ball, pose, stiffness(1), Mode::both);
  const Contact contact = clipped(plate, ball, pose, stiffness(1), Mode::both);
  ASSERT_GT(expected.too_deep, 20);
  EXPECT_EQ(contact.too_deep, expected.too_deep);
}

TEST(ClippedElements, EndsOfARodThinnerThanTheLeastDetailAreTooDeepAsTheirLinesTell) {
  const TriangleMesh host = generate::box({4, 4, 4});
  for (const double width : {0x1p-360, 0x1p-520, 0x1p-600}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vector3d extents = Vector3d::Constant(width);
      extents[axis] = 1;
      TriangleMesh rod = generate::box({1, 1, 1});
      for (Vector3d& x : rod.vertices) x = x.cwiseProduct(extents);
      EXPECT_EQ(answer(rod, host, {}, stiffness(1), Mode::E).too_deep, 12) << width << ' ' << axis;
      EXPECT_EQ(clipped(rod, host).too_deep, 12) << width << ' ' << axis;
    }
  }
}

TEST(ClippedElements, GuestFarFromItsHostIsTooDeepAndLooksAtNoFaceOfTheHostButWhereALineLeavesIt) {
  // Under each face of the guest lie some 40 faces of the host, with as many vertices to look at.
  const TriangleMesh host = generate::icosphere(1, 4), guest = generate::box({0.3, 0.3, 0.3});
  const Pose pose = turned(0.7, {0.1, 0.2, -0.1});
  for (const bool with_bound : {false, true}) {
    Wanted wanted;
    wanted.bound = with_bound;
    const Contact contact = answer(host, guest, pose, stiffness(1), Mode::both, {}, wanted, Scheme::clipped);
    EXPECT_TRUE(contact.nested);
    EXPECT_EQ(contact.element_count, 0);
    EXPECT_EQ(contact.too_deep, 12);
    EXPECT_LT(contact.work.predicates, 12 * 20);
    EXPECT_EQ(contact.bound.value_or(ForceBound{}).force_Me, Eigen::Vector3d::Zero());
  }
}

TEST(ClippedElements, RoomOfTheHostWithinItsGuestIsSeenDownToTheGuestsFarSide) {
  // From the guest's upper side 2.4 m of 4 m below, from its lower side 0.4 m; from the four others 1.5 m.
  const TriangleMesh guest = generate::box(Vector3d(-2, -2, -2), Vector3d(2, 2, 2));
  for (const double lift : {-0.3, 0.0, 1.5}) {
    const TriangleMesh room = generate::box(Vector3d(-0.5, -0.5, -1.6 + lift), Vector3d(0.5, 0.5, -0.4 + lift));
    const Contact contact = clipped(guest, joined(generate::box({16, 16, 16}), inverted(room)));
    EXPECT_TRUE(contact.nested);
    const double from_above = 2.4 - lift, from_below = 0.4 + lift;
    EXPECT_NEAR(contact.force_Me.z(), from_below - from_above, 1e-14);
    double sum = 0;
    for (const Element& element : contact.elements) sum += element.area * element.penetration;
    EXPECT_NEAR(sum, from_above + from_below + 4 * 1.2 * 1.5, 1e-13);
  }
}

TEST(ClippedElements, SecondSheetBehindTheFirstCarriesNothing) {
  // Two boxes pushed into a floor at different depths, and a third one wholly inside, beneath both.
  const TriangleMesh floor = generate::box(Vector3d(-8, -8, -4), Vector3d(8, 8, 0));
  const TriangleMesh two = joined(generate::box(Vector3d(-2, -1, -0.25), Vector3d(-0.5, 1, 1)),
                                  generate::box(Vector3d(0.5, -1, -0.5), Vector3d(1, 1, 1)));
  const double expected = -(0.25 * 3 + 0.5 * 1);
  EXPECT_NEAR(clipped(floor, two).force_Me.z(), expected, 1e-14);
  const TriangleMesh three = joined(two, generate::box(Vector3d(-3, -2, -2), Vector3d(3, 2, -1)));
  EXPECT_NEAR(clipped(floor, three).force_Me.z(), expected, 1e-14);
}

TEST(ClippedElements, FoldOfTheSlaveHidesWhatIsBehindItExactlyByHalves) {
  // A torus standing upright in the floor with its hole beneath the floor's surface: above the hole its lower half is
  // hidden. Each of many small master faces samples the same as two large ones.
  const TriangleMesh torus = generate::torus(1, 0.3, 24, 12);
  Pose pose;
  pose.A = Eigen::AngleAxisd(kPi / 2 - 0.1, Vector3d(1, 0.3, 0).normalized()).toRotationMatrix();
  pose.r = {0.1, 0.07, -0.9};
  const Contact coarse = clipped(generate::plate(8, 8, 4), torus, pose);
  const Contact fine = clipped(generate::plate(8, 8, 4, 37, 41), torus, pose);
  ASSERT_TRUE(coarse.touching);
  EXPECT_LT(coarse.force_Me.z(), -0.01);
  EXPECT_GT(coarse.force_Me.z(), -0.9 * coarse.volume);
  expect_near(fine.force_Me, coarse.force_Me, 1e-13 * coarse.force_Me.norm());
  expect_near(fine.torque_Me, coarse.torque_Me, 1e-13 * coarse.force_Me.norm());
  const Contact barycentric = answer(generate::plate(8, 8, 4, 70, 70), torus, pose);
  EXPECT_NEAR(barycentric.force_Me.z() / coarse.force_Me.z(), 1, 5e-2);
}

// Damping does not ask how deep an element is. Of a plate as large the integral of such a depth is less than any
// double.
TEST(ClippedElements, BoxInALargePlateIsDampedAllOverAtAnyDepth) {
  const double denormal = std::numeric_limits<double>::denorm_min();
  const TriangleMesh plate = generate::plate(0x1p21, 0x1p21, 1);
  const TriangleMesh cube = generate::box(Vector3d(-0.5, -0.5, 0), Vector3d(0.5, 0.5, 1));
  ContactLaw law = stiffness(1);
  law.damping = 8;
  const Velocity approaching{{0, 0, -3}, {0, 0, 0}};
  for (const double d : {denormal, 3 * denormal, 0x1p-1022, 0x1p-960, 0x1p-701, 0x1p-700, 0x1p-699, 0x1p-100}) {
    for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
      // Beside the plate's diagonal, and across it.
      for (const double x : {0x1p19, 0.25}) {
        const Contact contact = clipped(plate, cube, shifted(x, 0, -d), law, mode, approaching);
        expect_near(contact.force_Me, {0, 0, -24}, 1e-6);
        expect_near(contact.torque_Me, {0, 0, 0}, 1e-6);
        EXPECT_EQ(contact.max_penetration, d);
        for (const Element& element : contact.elements) EXPECT_EQ(element.penetration, d) << d;
      }
    }
  }
}

// Flanks slid along each other that are out of one plane by a few times d alone, some crossing: where their planes meet
// is a matter of ratios, so that it is the same line whatever d is. F's vertices round to other sides of E's flank.
TEST(ClippedElements, FlanksOutOfOnePlaneByDenormalsAreVisibleInPartAsByMore) {
  const double denormal = std::numeric_limits<double>::denorm_min();
  for (const double d : {0x1p-70, 0x1p-500, 0x1p-960, 0x1p-1020, 0x1p-1072, denormal}) {
    TriangleMesh wedge;
    wedge.vertices = {{d, -0.5, 0}, {1, -0.5, 1}, {-1, -0.5, 1}, {-3 * d, 0.5, 0}, {-1, 0.5, 1}, {1, 0.5, 1}};
    wedge.faces = {{0, 1, 2}, {3, 4, 5}, {0, 3, 5}, {0, 5, 1}, {0, 2, 4}, {0, 4, 3}, {1, 5, 4}, {1, 4, 2}};
    const Contact contact = clipped(wedge, wedge, shifted(3 * d, -0.75, 0));
    double whole = 0, half = 0, all = 0;
    for (const Element& element : contact.elements) {
      if (element.slave_face == 6 && element.master_face == 5) whole = element.area;
      if (element.slave_face == 6 && element.master_face == 4) half = element.area;
      if (element.master_face == 4 || element.master_face == 5) all += element.area;
    }
    // Beneath F's lower flank as a whole, and the part above the line where E's upper flank meets F's lower one.
    EXPECT_NEAR(whole, std::sqrt(2) / 32, 1e-15) << d;
    EXPECT_NEAR(half, 3 * std::sqrt(2) / 32, 1e-15) << d;
    EXPECT_NEAR(all, whole + half, 1e-15) << d;
  }
}

TEST(ClippedElements, AreOrderedByMasterThenMasterFaceThenSlaveFace) {
  const Contact contact =
      clipped(generate::icosphere(1, 2), generate::icosphere(1, 2), turned(0.3, {1.1, 0.9, 0.9}), {}, Mode::both);
  ASSERT_GT(contact.elements.size(), 10u);
  EXPECT_EQ(static_cast<Index>(contact.elements.size()), contact.element_count);
  for (std::size_t i = 1; i < contact.elements.size(); ++i) {
    const Element& a = contact.elements[i - 1];
    const Element& b = contact.elements[i];
    EXPECT_LT(std::tie(a.master, a.master_face, a.slave_face), std::tie(b.master, b.master_face, b.slave_face));
  }
}

}  // namespace
}  // namespace pcm::fast::clipped_elements_test
