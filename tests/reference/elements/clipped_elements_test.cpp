// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle's clipped scheme where the answer is worked out on paper, or known from elsewhere as a rational number.
#include "reference/elements/clipped_elements.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/round.h"
#include "reference/oracle.h"
#include "tests/reference/poses.h"
#include "tests/reference/problems.h"

namespace pcm::reference::clipped_elements_test {
namespace {

ContactLaw stiffness(double c_l) {
  ContactLaw law;
  law.stiffness = c_l;
  return law;
}

ContactLaw clamped_at(double max_penetration) {
  ContactLaw law = stiffness(1);
  law.max_penetration = max_penetration;
  return law;
}

Oracle clipped(const TriangleMesh& E, const TriangleMesh& F, Mode mode = Mode::E,
               const ContactLaw& law = stiffness(1)) {
  return Oracle(E, F, law, mode, Scheme::clipped);
}

TriangleMesh box(double x0, double y0, double z0, double x1, double y1, double z1) {
  return generate::box(Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1));
}

/// A convex section in the plane of x and z, counterclockwise seen from -y, drawn out over y0 <= y <= y1.
TriangleMesh prism(const std::vector<Eigen::Vector2d>& section, double y0, double y1) {
  TriangleMesh mesh;
  mesh.name = "prism";
  const Index n = static_cast<Index>(section.size());
  for (const double y : {y0, y1})
    for (const Eigen::Vector2d& p : section) mesh.vertices.emplace_back(p[0], y, p[1]);
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    mesh.faces.push_back({i, i + n, j});
    mesh.faces.push_back({j, i + n, j + n});
    if (i == 0 || j == 0) continue;
    mesh.faces.push_back({0, i, j});
    mesh.faces.push_back({n, j + n, i + n});
  }
  return mesh;
}

/// Vertices moved to multiples of 2^-20, so that midpoints of edges are exact.
TriangleMesh on_grid(TriangleMesh mesh) {
  for (Eigen::Vector3d& v : mesh.vertices)
    for (double& x : v) x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
  return mesh;
}

/// Every face cut in four at the midpoints of its edges.
TriangleMesh split(const TriangleMesh& mesh) {
  TriangleMesh result{mesh.vertices, {}, mesh.name + " split"};
  std::map<std::pair<Index, Index>, Index> midpoints;
  const auto midpoint = [&](Index a, Index b) {
    const auto [found, added] = midpoints.try_emplace(std::minmax(a, b), static_cast<Index>(result.vertices.size()));
    if (added) result.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const Index ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) result.faces.push_back(t);
  }
  return result;
}

/// The integrals of 1, x and y over what of the body F lies below z = 0, where no vertical line leaves and meets it
/// again: each face, cut at z = 0, stands on a prism up to there, counted negative where the face looks up.
struct Immersed {
  Rational volume = 0, x = 0, y = 0;
};

void add_prism(const Vec3<Rational>& a, const Vec3<Rational>& b, const Vec3<Rational>& c, Immersed& sum) {
  const Rational area = ((b.y - a.y) * (c.x - a.x) - (b.x - a.x) * (c.y - a.y)) / 2;  // positive where it looks down
  const Rational depth = -(a.z + b.z + c.z);
  sum.volume += area * depth / 3;
  sum.x += area * ((a.x + b.x + c.x) * depth - a.x * a.z - b.x * b.z - c.x * c.z) / 12;
  sum.y += area * ((a.y + b.y + c.y) * depth - a.y * a.z - b.y * b.z - c.y * c.z) / 12;
}

Immersed immersed(const ExactPose& pose) {
  Immersed sum;
  for (Index f = 0; f < static_cast<Index>(pose.surface(Side::F).mesh.faces.size()); ++f) {
    const auto corners = pose.corners<Rational>(Side::F, f);
    std::vector<Vec3<Rational>> below;
    for (int i = 0; i < 3; ++i) {
      const Vec3<Rational>&a = corners[i], &b = corners[(i + 1) % 3];
      if (a.z <= 0) below.push_back(a);
      if ((a.z < 0 && b.z > 0) || (a.z > 0 && b.z < 0)) below.push_back(a + Rational(a.z / (a.z - b.z)) * (b - a));
    }
    for (std::size_t i = 2; i < below.size(); ++i) add_prism(below[0], below[i - 1], below[i], sum);
  }
  return sum;
}

/// Integral of the penetration over the master's area with its first moments, from the elements; N must be vertical.
Immersed pressed(const ExactPose& pose) {
  const std::vector<ClippedElement> elements = find_clipped_elements(pose, Side::E, find_combinatorics(pose)).elements;
  ConvertedPose<Rational> points(pose);
  Immersed sum;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const ElementGeometry<Quadratic> g = ClippedElements(elements).geometry(i, points);
    const Rational volume = (g.alpha * g.q * dot(g.N, g.N)).a();
    sum.volume += volume;
    sum.x += volume * g.foot.x.a();
    sum.y += volume * g.foot.y.a();
  }
  return sum;
}

Pose tilted(double degrees, const Eigen::Vector3d& axis, const Eigen::Vector3d& r) {
  const double half = degrees * std::numbers::pi / 360;
  const Eigen::Vector3d q = std::sin(half) * axis.normalized();
  const double w = std::cos(half);
  Pose pose;
  pose.A = (w * w - q.squaredNorm()) * Eigen::Matrix3d::Identity() + 2 * q * q.transpose();
  pose.A(0, 1) -= 2 * w * q.z();
  pose.A(0, 2) += 2 * w * q.y();
  pose.A(1, 2) -= 2 * w * q.x();
  pose.A(1, 0) += 2 * w * q.z();
  pose.A(2, 0) -= 2 * w * q.y();
  pose.A(2, 1) += 2 * w * q.x();
  pose.r = r;
  return pose;
}

TEST(ClippedElements, BoxOnPlateIsStiffnessTimesAreaTimesDepthInEveryMode) {
  // 100 x 1/4 x 1/16; with a patch that lies askew on the plate's two large faces as well.
  const TriangleMesh cube = box(-0.25, -0.25, 0, 0.25, 0.25, 0.5), plate = box(-2, -2, -1, 2, 2, 0);
  for (const Problem problem : kProblems)
    for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
      const Answer answer = clipped(cube, plate, mode, stiffness(100)).answer(problem, shifted(0.125, 0.0625, 0.0625));
      EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 1.5625));
      EXPECT_EQ(answer.torque_Me, Eigen::Vector3d(-0.0625, 0.125, 0) * 1.5625);
      EXPECT_EQ(answer.max_penetration, 0.0625);
      EXPECT_EQ(answer.too_deep, 0);
      for (const Element& element : answer.elements) EXPECT_EQ(element.penetration, 0.0625);
    }
}

TEST(ClippedElements, BoxOnPlateWithDecimalNumbersIsCorrectlyRounded) {
  // L = 0.5, u = 0.05, K = 100: 100 x 1/4 x 0.05 is 25 times the double next to 0.05, 1.25 when rounded.
  const TriangleMesh cube = box(-0.25, -0.25, 0, 0.25, 0.25, 0.5), plate = box(-2, -2, -1, 2, 2, 0);
  for (const Problem problem : kProblems)
    for (const Mode mode : {Mode::E, Mode::F, Mode::both})
      EXPECT_EQ(clipped(cube, plate, mode, stiffness(100)).answer(problem, shifted(0, 0, 0.05)).force_Me,
                Eigen::Vector3d(0, 0, 1.25));
}

TEST(ClippedElements, PlaneAsMasterCarriesTheImmersedVolumeAtItsCentroid) {
  // As rational numbers, and rounded in the answer. Only faces that look down are immersed at these heights.
  const struct {
    TriangleMesh body;
    double height;
  } cases[] = {{generate::gridded_box(1, 3), 0.6},
               {generate::icosphere(1, 2), 0.75},
               {generate::wedge(30, 1, 1, 2), -0.0625},
               {generate::bubble(), 0.15}};
  const TriangleMesh plate = generate::plate(6, 6, 4, 3, 2);
  for (const auto& [body, height] : cases)
    for (const Problem problem : kProblems) {
      SCOPED_TRACE(body.name);
      const Pose pose = tilted(20, {1, 2, 0.5}, {0.15, -0.1, height});
      const Surface E = make_surface(plate), F = make_surface(body);
      const ExactPose exact(problem, E, F, pose);
      const Immersed expected = immersed(exact), found = pressed(exact);
      EXPECT_GT(expected.volume, 0);
      EXPECT_EQ(found.volume, expected.volume);
      EXPECT_EQ(found.x, expected.x);
      EXPECT_EQ(found.y, expected.y);

      const Answer answer = clipped(plate, body).answer(problem, pose);
      ASSERT_TRUE(answer.volume);
      EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, -*answer.volume));
      EXPECT_EQ(answer.torque_Me.x(), nearest_double(pose.r.y() * expected.volume - expected.y));
      EXPECT_EQ(answer.torque_Me.y(), nearest_double(expected.x - pose.r.x() * expected.volume));
      EXPECT_EQ(answer.torque_Me.z(), 0);
    }
}

TEST(ClippedElements, WedgeAsMasterIsPushedAside) {
  // F_z = (w h^2 / 2)(1 / sin p + 1 / cos p), F_x / F_z = tan(p - 45 deg). The wedge's corners are rounded.
  const double w = 2, h = 0.25;
  const TriangleMesh plate = box(-8, -8, -4, 8, 8, 0);
  for (const double degrees : {45.0, 40.0, 30.0, 15.0})
    for (const Problem problem : kProblems) {
      const TriangleMesh wedge = generate::wedge(degrees, 1, w, 2);
      const double p = degrees * std::numbers::pi / 180;
      const double F_z = w * h * h / 2 * (1 / std::sin(p) + 1 / std::cos(p));
      const Eigen::Vector3d force = clipped(wedge, plate).answer(problem, shifted(0, 0, h)).force_Me;
      EXPECT_NEAR(force.z(), F_z, 1e-14 * F_z);
      EXPECT_NEAR(force.x(), F_z * std::tan(p - std::numbers::pi / 4), 1e-14 * F_z);
      EXPECT_EQ(force.y(), 0);
      // Plane master: the volume w h^2 / (2 sin p cos p), nothing sideways.
      const Eigen::Vector3d flat = clipped(wedge, plate, Mode::F).answer(problem, shifted(0, 0, h)).force_Me;
      const double volume = w * h * h / (2 * std::sin(p) * std::cos(p));
      EXPECT_NEAR(flat.z(), volume, 1e-14 * volume);
      EXPECT_EQ(flat.x(), 0);
    }
}

TEST(ClippedElements, FlushFlanksCarryNothing) {
  // 4 m^2 of one box's top, 1 m deep, whatever the order of bodies and the master.
  const TriangleMesh lower = box(0, 0, 0, 2, 2, 2), upper = box(0, 0, 1, 2, 2, 3);
  for (const Problem problem : kProblems)
    for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
      EXPECT_EQ(clipped(lower, upper, mode).answer(problem, {}).force_Me, Eigen::Vector3d(0, 0, -4));
      EXPECT_EQ(clipped(upper, lower, mode).answer(problem, {}).force_Me, Eigen::Vector3d(0, 0, 4));
    }
}

TEST(ClippedElements, RestingBoxCarriesNothing) {
  const TriangleMesh lower = box(-2, -2, -1, 2, 2, 0), upper = box(-1, -1, 0, 1, 1, 1);
  for (const Problem problem : kProblems)
    for (const Mode mode : {Mode::E, Mode::F}) {
      const Answer answer = clipped(lower, upper, mode).answer(problem, {});
      EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 0));
      EXPECT_TRUE(answer.elements.empty());
    }
}

TEST(ClippedElements, SubmergedPlateDoesNotFeelThePin) {
  // A plate wholly below F's top and a pin of 1/4 m^2 beside it, one surface.
  const TriangleMesh F = box(-8, -8, -4, 8, 8, 0);
  for (const double depth : {0x1p-40, 0.125}) {
    const TriangleMesh pin = box(3, 3, -depth, 3.5, 3.5, 4), above = box(3, 3, 1, 3.5, 3.5, 4);
    const TriangleMesh closed_plate = box(-2, -2, -0.5, 2, 2, -0.25);
    // Open and facing down: it carries 16 m^2 times 1/4 m.
    const TriangleMesh sheet = degenerate::inverted(generate::rectangle(4, 4));
    TriangleMesh open_plate = sheet;
    for (Eigen::Vector3d& v : open_plate.vertices) v.z() = -0.25;
    for (const Problem problem : kProblems) {
      for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
        EXPECT_EQ(clipped(degenerate::joined(closed_plate, above), F, mode).answer(problem, {}).force_Me.z(), 0);
        EXPECT_EQ(clipped(degenerate::joined(closed_plate, pin), F, mode).answer(problem, {}).force_Me.z(), depth / 4);
      }
      EXPECT_EQ(clipped(degenerate::joined(open_plate, above), F).answer(problem, {}).force_Me.z(), 4);
      EXPECT_EQ(clipped(degenerate::joined(open_plate, pin), F).answer(problem, {}).force_Me.z(), 4 + depth / 4);
    }
  }
}

TEST(ClippedElements, SplittingFacesInTheirPlanesChangesNothing) {
  // Master E's vertices are on a grid, so its split is in its faces' planes in both problems; slave F's in the exact.
  std::mt19937_64 random(5);
  SCOPED_TRACE("seed 5");
  const TriangleMesh meshes[] = {on_grid(generate::icosphere(1, 1)), on_grid(generate::torus(1, 0.375, 6, 5)),
                                 on_grid(generate::box(Eigen::Vector3d(1, 1.5, 0.5)))};
  int pushing = 0, clamped = 0;
  for (int i = 0; i < 12; ++i) {
    const TriangleMesh &E = meshes[i % 3], &F = meshes[(i / 3) % 3];
    const Pose pose = random_pose(random, 0.75);
    const ContactLaw law = i % 4 == 3 ? stiffness(1) : clamped_at(0.125);
    const Answer plain = clipped(E, F, Mode::E, law).answer(Problem::exact, pose);
    for (const auto& [split_E, split_F] : {std::pair{split(E), F}, {E, split(F)}, {split(E), split(F)}}) {
      const Answer answer = clipped(split_E, split_F, Mode::E, law).answer(Problem::exact, pose);
      EXPECT_EQ(answer.force_Me, plain.force_Me);
      EXPECT_EQ(answer.torque_Me, plain.torque_Me);
      EXPECT_EQ(answer.max_penetration, plain.max_penetration);
    }
    pushing += plain.force_scale > 0;
    clamped += plain.penetration_exceeded;
  }
  EXPECT_GE(pushing, 8);
  EXPECT_GE(clamped, 4);
}

TEST(ClippedElements, SplittingTheMasterChangesNothingInTheRoundedProblem) {
  std::mt19937_64 random(6);
  SCOPED_TRACE("seed 6");
  const TriangleMesh E = on_grid(generate::icosphere(1, 1)), F = generate::bubble(1.5);
  for (int i = 0; i < 3; ++i) {
    const Pose pose = random_pose(random, 0.75);
    EXPECT_EQ(clipped(E, F).answer(Problem::rounded, pose).force_Me,
              clipped(split(E), F).answer(Problem::rounded, pose).force_Me);
  }
}

TEST(ClippedElements, ThinPlateIsLeftFirst) {
  const TriangleMesh F = box(-8, -8, -4, 8, 8, 0.5), plate = box(-1, -1, 0, 1, 1, 0.25);
  for (const Problem problem : kProblems) {
    const Answer answer = clipped(plate, F).answer(problem, {});
    EXPECT_TRUE(answer.elements.empty());
    EXPECT_GE(answer.too_deep, 2);
  }
}

TEST(ClippedElements, MasterThinInPartsCarriesWhereItIsThick) {
  // A wedge z <= x over 0 <= x <= 1, 0 <= y <= 1, half a metre deep: its bottom pushes where x > 1/2.
  const TriangleMesh F = box(-8, -8, -4, 8, 8, 0.5), wedge = prism({{0, 0}, {1, 0}, {1, 1}}, 0, 1);
  for (const Problem problem : kProblems) {
    const Answer answer = clipped(wedge, F).answer(problem, {});
    EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 0.25));
    EXPECT_EQ(answer.torque_Me, Eigen::Vector3d(0.5, -0.75, 0) * 0.25);
    double area = 0;
    for (const Element& element : answer.elements) area += element.area;
    EXPECT_EQ(area, 0.5);
  }
}

TEST(ClippedElements, OnlyTheFirstSlaveSheetCounts) {
  // Where x < 0 the cube's bottom (2 m^2) lies 1/4 deep in one slab; above it, and over x > 0, hangs another. The
  // cube's flank at x = -1 is in the first slab over 1/2 m^2 and 1 m from where that ends.
  const TriangleMesh cube = box(-1, -1, -0.75, 1, 1, 4);
  const TriangleMesh slabs = degenerate::joined(box(-4, -4, -1, 0, 4, -0.5), box(-8, -8, -0.25, 8, 8, 0.25));
  for (const Problem problem : kProblems) {
    const Answer answer = clipped(cube, slabs).answer(problem, {});
    EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0.5, 0, 0.5));
    EXPECT_EQ(answer.max_penetration, 1);
  }
}

TEST(ClippedElements, OverhangingSlaveIsNotReachedPastItsFold) {
  // A leaning prism, 2 m wide. At z = 0 it covers 1/2 <= x <= 3/2; the line from there leaves by its left flank z = 2 x
  // - 1 up to x = 1, then by its top z = 1: 2 (1/4 + 1/2). Over 3/2 < x < 2 hangs its right flank.
  const TriangleMesh master = box(-4, -4, 0, 4, 4, 4), leaning = prism({{0, -1}, {1, -1}, {2, 1}, {1, 1}}, -1, 1);
  for (const Problem problem : kProblems) {
    const Answer answer = clipped(master, leaning).answer(problem, {});
    EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 1.5));
    // 2 times the integral of x u: (1/4) (5/6) + (1/2) (5/4).
    EXPECT_EQ(answer.torque_Me.y(), -2 * (5.0 / 24 + 5.0 / 8));
    EXPECT_EQ(answer.max_penetration, 1);
  }
}

TEST(ClippedElements, RidgeIsIntegratedFaceByFace) {
  // u = 1/2 - |x| under a flat master, 2 m wide: 2 x 1/4.
  const TriangleMesh master = box(-4, -4, 0, 4, 4, 4), roof = prism({{-1, -0.5}, {1, -0.5}, {0, 0.5}}, -1, 1);
  for (const Problem problem : kProblems) {
    const Answer answer = clipped(master, roof).answer(problem, {});
    EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 0.5));
    EXPECT_EQ(answer.torque_Me, Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(answer.max_penetration, 0.5);
  }
}

TEST(ClippedElements, MaxPenetrationClampsPointByPointAndFlagsTheGreatest) {
  // Half a ridge: u = 1/2 - x over 0 <= x <= 1/2, 2 m wide. With u_max = 1/4 the integrals of min(u, u_max) and of its
  // product with x are 1/16 + 1/32 and 1/128 + 1/96 a metre. No mean over an element is greater than u_max.
  const TriangleMesh master = box(-4, -4, 0, 4, 4, 4), roof = prism({{0, -0.5}, {1, -0.5}, {0, 0.5}}, -1, 1);
  for (const Problem problem : kProblems) {
    const Answer answer = clipped(master, roof, Mode::E, clamped_at(0.25)).answer(problem, {});
    EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 3.0 / 16));
    EXPECT_EQ(answer.torque_Me, Eigen::Vector3d(0, -7.0 / 192, 0));
    EXPECT_TRUE(answer.penetration_exceeded);
    EXPECT_EQ(answer.max_penetration, 0.5);
    double integral = 0;
    for (const Element& element : answer.elements) {
      EXPECT_LT(element.penetration, 0.25);
      EXPECT_LE(element.penetration, element.greatest_penetration);
      integral += element.area * element.penetration;
    }
    EXPECT_DOUBLE_EQ(integral, 3.0 / 16);
  }
}

TEST(ClippedElements, ClampedSlopeWhoseNormalIsNoRationalNumberLong) {
  // The keel of half a metre: on either flank u goes from 0 to sqrt2 / 2 along sqrt2 / 2 m, 1 m wide. The integral of
  // min(u, 1/4) is sqrt2 / 8 - 1/32, of which 1 / sqrt2 pushes upwards.
  for (const Problem problem : kProblems) {
    const Answer answer = clipped(degenerate::keel(), generate::plate(8, 8, 4), Mode::E, clamped_at(0.25))
                              .answer(problem, shifted(0, 0, 0.5));
    EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, static_cast<double>(0.25L - std::sqrt(2.0L) / 32)));
    EXPECT_EQ(answer.max_penetration, std::sqrt(0.5));
  }
}

TEST(ClippedElements, ClampedSpikeLosesTheConeBeyondTheClamp) {
  // The plate's top over a spike: what is deeper than half of its depth h is a spike of half its size.
  const TriangleMesh plate = generate::plate(4, 4, 1);
  const Pose pose = shifted(0.125, 0.0625, -0.625);
  for (const Problem problem : kProblems) {
    const Answer free = clipped(plate, degenerate::spike()).answer(problem, pose);
    const Answer answer = clipped(plate, degenerate::spike(), Mode::E, clamped_at(0.3125)).answer(problem, pose);
    EXPECT_DOUBLE_EQ(answer.force_Me.z(), -7.0 / 8 * *free.volume);
    EXPECT_EQ(answer.max_penetration, 0.625);
  }
}

TEST(ClippedElements, ClampAtADepthOfTheMeshesAndAnUlpBesideIt) {
  const TriangleMesh master = box(-4, -4, 0, 4, 4, 4), roof = prism({{-1, -0.5}, {1, -0.5}, {0, 0.5}}, -1, 1);
  const TriangleMesh cube = box(-0.25, -0.25, 0, 0.25, 0.25, 0.5), plate = box(-2, -2, -1, 2, 2, 0);
  for (const Problem problem : kProblems) {
    // A ridge: only its edge is 1/2 deep.
    for (const double u_max : {std::nextafter(0.5, 0.0), 0.5, std::nextafter(0.5, 1.0)}) {
      const Answer answer = clipped(master, roof, Mode::E, clamped_at(u_max)).answer(problem, {});
      EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 0.5));
      EXPECT_EQ(answer.penetration_exceeded, u_max < 0.5);
    }
    // A flat bottom, all of which is 1/16 deep.
    for (const double u_max : {std::nextafter(0.0625, 0.0), 0.0625, std::nextafter(0.0625, 1.0)})
      for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
        const Answer answer = clipped(cube, plate, mode, clamped_at(u_max)).answer(problem, shifted(0, 0, 0.0625));
        EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, std::min(u_max, 0.0625) / 4));
        for (const Element& element : answer.elements) EXPECT_EQ(element.penetration, std::min(u_max, 0.0625));
      }
  }
}

TEST(ClippedElements, ClampThroughACornerOfAPiece) {
  // The same half of a ridge, its slope divided at x = 1/4, where u = u_max: 2 (1/16) and 2 (1/32), no piece cut.
  const TriangleMesh master = box(-4, -4, 0, 4, 4, 4),
                     roof = prism({{0, -0.5}, {1, -0.5}, {0.25, 0.25}, {0, 0.5}}, -1, 1);
  for (const Problem problem : kProblems) {
    const Answer answer = clipped(master, roof, Mode::E, clamped_at(0.25)).answer(problem, {});
    EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 3.0 / 16));
    EXPECT_EQ(answer.torque_Me, Eigen::Vector3d(0, -7.0 / 192, 0));
  }
}

TEST(ClippedElements, EnclosuresThatDoNotTellTheSideOfTheClampHoldTheTruth) {
  // The same slope under bottoms 6 m wide, so that (s, t) and the clamp are no sums of doubles. The corners at x = 1/4
  // are those of the slope's division, or where the other bottom's diagonal passes y = 1: a corner between corners on
  // both sides of the clamp.
  const TriangleMesh divided = prism({{0, -0.5}, {1, -0.5}, {0.25, 0.25}, {0, 0.5}}, -1, 1);
  const TriangleMesh whole = prism({{0, -0.5}, {1, -0.5}, {0, 0.5}}, -1, 1);
  for (const auto& [master, roof] :
       {std::pair{box(-3, -3, 0, 3, 3, 4), divided}, {box(-2.75, -2, 0, 3.25, 4, 4), whole}})
    for (const Problem problem : kProblems) {
      EXPECT_EQ(clipped(master, roof, Mode::E, clamped_at(0.25)).answer(problem, {}).torque_Me,
                Eigen::Vector3d(0, -7.0 / 192, 0));
      const Surface E = make_surface(master), F = make_surface(roof);
      const ExactPose pose(problem, E, F, {});
      const std::vector<ClippedElement> elements =
          find_clipped_elements(pose, Side::E, find_combinatorics(pose)).elements;
      ASSERT_GE(elements.size(), 2u);
      for (const double u_max : {0.125, 0.25, 0.5}) {
        ConvertedPose<DoubleDouble> shortly(pose);
        ConvertedPose<Rational> exactly(pose);
        for (std::size_t i = 0; i < elements.size(); ++i) {
          const ElementGeometry<DoubleDouble> g = ClippedElements(elements, u_max).geometry(i, shortly);
          const ElementGeometry<Quadratic> truth = ClippedElements(elements, u_max).geometry(i, exactly);
          ASSERT_TRUE(truth.q.rational());
          EXPECT_TRUE(g.q.holds(truth.q.a()));
          for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(g.foot[axis].holds(truth.foot[axis].a()));
        }
      }
    }
}

TEST(ClippedElements, IdenticalBodiesAtTheIdentityPoseCarryNothing) {
  // Every line meets the slave at once, where it enters: u = 0 (C7).
  const TriangleMesh cube = generate::gridded_box(1, 2);
  for (const Problem problem : kProblems)
    EXPECT_EQ(clipped(cube, cube).answer(problem, {}).force_Me, Eigen::Vector3d(0, 0, 0));
}

// Corners of parts lie at depth 0, which 240 bits do not tell from 1e-200: neither pressure nor its centre is enclosed.
TEST(ClippedElements, SlidesAtTheSpeedOfItsPlaceHoweverSmallTheBoundOfPenetration) {
  ContactLaw law = clamped_at(1e-200);
  law.friction = 0.5;
  const TriangleMesh sphere = generate::icosphere(1, 1), plate = generate::plate(8, 8, 4);
  const Pose pose = tilted(40, {1, -1, 0.5}, {0.1, 0.2, -0.5});
  for (const Eigen::Vector3d& w : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.5, -0.25, 0.75)}) {
    Velocity velocity;
    velocity.v = {0.75, -0.5, 0.25};
    velocity.w = w;
    for (const Mode mode : {Mode::E, Mode::F})
      for (const Problem problem : kProblems) {
        const Answer answer = clipped(sphere, plate, mode, law).answer(problem, pose, velocity);
        EXPECT_GT(answer.elements.size(), 10u);
        double forces = 0, moments = 0;
        for (const Element& e : answer.elements) {
          forces += e.force_Me.stableNorm();
          moments += (e.position_Me - pose.r).norm() * e.force_Me.stableNorm();
          const Eigen::Vector3d v_k = velocity.v + w.cross(e.position_Me - pose.r);          // (17)
          const double v_t = (v_k - v_k.dot(e.normal_Me) * e.normal_Me).norm();              // (19)
          EXPECT_NEAR(v_t, e.tangential_velocity, 1e-14);                                    // some roundings
          EXPECT_NEAR(1, e.penetration / 1e-200, 1e-12);                                     // all of it deeper
          EXPECT_NEAR(1, e.normal_force / (e.area * 1e-200), 1e-12);                         // c_l = 1
          EXPECT_NEAR(0.5, e.tangential_force / e.normal_force, 1e-14);                      // (20)
          EXPECT_NEAR(std::hypot(1, 0.5), e.force_Me.stableNorm() / e.normal_force, 1e-14);  // (21)
        }
        EXPECT_NEAR(1, answer.force_scale / forces, 1e-12);
        EXPECT_NEAR(1, answer.torque_scale / moments, 1e-12);
      }
  }
}

TEST(ClippedElements, ExchangedBodiesGiveTheOppositeForce) {
  const TriangleMesh torus = generate::torus(1, 0.4, 9, 7), ball = generate::icosphere(0.75, 1);
  const Pose pose = shifted(0.3125, 0.125, 0.75);
  Pose inverse = pose;
  inverse.r = -pose.r;
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    const Mode exchanged = mode == Mode::E ? Mode::F : mode == Mode::F ? Mode::E : Mode::both;
    const Answer a = clipped(torus, ball, mode).answer(Problem::exact, pose);
    const Answer b = clipped(ball, torus, exchanged).answer(Problem::exact, inverse);
    EXPECT_GT(a.force_scale, 0);
    EXPECT_EQ(b.force_Me, -a.force_Me);
    EXPECT_EQ(b.elements.size(), a.elements.size());
    EXPECT_EQ(b.max_penetration, a.max_penetration);
  }
}

TEST(ClippedElements, ModeBothIsTheMean) {
  const TriangleMesh sphere = generate::icosphere(1, 2), bubble = generate::bubble(1.5);
  ContactLaw law = stiffness(1e5);
  law.damping = 100;
  law.friction = 0.25;
  law.slip_velocity = 0.01;
  Velocity velocity;
  velocity.v = {0.5, 0.25, -0.125};
  velocity.w = {0.1, -0.2, 0.3};
  const Pose pose = tilted(50, {1, -1, 0.5}, {0.3, 0.2, 1.25});
  std::map<Mode, Answer> answers;
  for (const Mode mode : {Mode::E, Mode::F, Mode::both})
    answers[mode] = clipped(sphere, bubble, mode, law).answer(Problem::rounded, pose, velocity);
  const Answer &E = answers[Mode::E], &F = answers[Mode::F], &both = answers[Mode::both];
  EXPECT_GT(E.force_scale, 0);
  ASSERT_EQ(both.elements.size(), E.elements.size() + F.elements.size());
  EXPECT_EQ(both.elements.back().master, Side::F);
  EXPECT_NEAR(0, (both.force_Me - (E.force_Me + F.force_Me) / 2).norm(), 1e-15 * both.force_scale);
  EXPECT_NEAR(0, (both.torque_Me - (E.torque_Me + F.torque_Me) / 2).norm(), 1e-15 * both.torque_scale);
}

}  // namespace
}  // namespace pcm::reference::clipped_elements_test
