// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the oracle answers to one problem does not depend on what it was asked before about the other one.
#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <string>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "pcm/bad_input.h"
#include "reference/oracle.h"
#include "tests/reference/bow_tie.h"
#include "tests/reference/brute_force/trials.h"
#include "tests/reference/poses.h"

namespace pcm::reference {
namespace {

constexpr Mode kModes[] = {Mode::E, Mode::F, Mode::both};
constexpr Scheme kSchemes[] = {Scheme::barycentric, Scheme::clipped};

/// The names of all fields in which two answers differ.
class Difference {
 public:
  std::string names() const { return names_; }

  template <class T>
  void add(const char* name, const T& a, const T& b) {
    if (!(a == b)) names_ += std::string(" ") + name;
  }
  void add(const char* name, const ActiveArea& a, const ActiveArea& b) {
    add(name, a.intersected, b.intersected);
    add(name, a.inner, b.inner);
    add(name, a.area, b.area);
    add(name, a.area_interval.open, b.area_interval.open);
    add(name, a.area_interval.closed, b.area_interval.closed);
    add(name, a.vector_area_Me, b.vector_area_Me);
    add(name, a.limit_area, b.limit_area);
    add(name, a.limit_vector_area_Me, b.limit_vector_area_Me);
  }
  void add(const char* name, const Polygon& a, const Polygon& b) {
    add(name, a.closed, b.closed);
    add(name, a.patch, b.patch);
    add(name, a.points.size(), b.points.size());
    for (std::size_t i = 0; i < std::min(a.points.size(), b.points.size()); ++i) {
      const Crossing &x = a.points[i], &y = b.points[i];
      add(name, x.edge_side, y.edge_side);
      add(name, x.edge, y.edge);
      add(name, x.face, y.face);
      add(name, x.position_Me, y.position_Me);
    }
  }
  void add(const char* name, const Element& a, const Element& b) {
    add(name, a.master, b.master);
    add(name, a.master_face, b.master_face);
    add(name, a.slave_face, b.slave_face);
    add(name, a.area, b.area);
    add(name, a.penetration, b.penetration);
    add(name, a.greatest_penetration, b.greatest_penetration);
    add(name, a.cosine, b.cosine);
    add(name, a.normal_velocity, b.normal_velocity);
    add(name, a.tangential_velocity, b.tangential_velocity);
    add(name, a.normal_force, b.normal_force);
    add(name, a.tangential_force, b.tangential_force);
    add(name, a.normal_Me, b.normal_Me);
    add(name, a.position_Me, b.position_Me);
    add(name, a.force_Me, b.force_Me);
    // No rounding is claimed, and a part may be cut into pieces in more than one way.
    if (std::abs(a.perimeter - b.perimeter) > 1e-12 * a.perimeter) names_ += " perimeter";
  }
  template <class T>
  void add(const char* name, const std::vector<T>& a, const std::vector<T>& b) requires(!std::is_arithmetic_v<T>) {
    add(name, a.size(), b.size());
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) add(name, a[i], b[i]);
  }

 private:
  std::string names_;
};

std::string difference(const Answer& a, const Answer& b) {
  Difference d;
  d.add("touching", a.touching, b.touching);
  d.add("nested", a.nested, b.nested);
  d.add("ambiguous", a.ambiguous, b.ambiguous);
  d.add("polygons", a.polygons, b.polygons);
  d.add("patches", a.patches, b.patches);
  d.add("E", a.E, b.E);
  d.add("F", a.F, b.F);
  d.add("volume", a.volume, b.volume);
  d.add("elements", a.elements, b.elements);
  d.add("undefined_areas", a.undefined_areas, b.undefined_areas);
  d.add("too_deep", a.too_deep, b.too_deep);
  d.add("max_penetration", a.max_penetration, b.max_penetration);
  d.add("penetration_exceeded", a.penetration_exceeded, b.penetration_exceeded);
  d.add("force", a.force_Me, b.force_Me);
  d.add("torque", a.torque_Me, b.torque_Me);
  d.add("certified", a.certified, b.certified);
  // The scales are near enough for what they are for.
  if (std::abs(a.force_scale - b.force_scale) > 1e-12 * a.force_scale) d.add("force_scale", 0, 1);
  if (std::abs(a.torque_scale - b.torque_scale) > 1e-12 * a.torque_scale) d.add("torque_scale", 0, 1);
  return d.names();
}

struct Scene {
  TriangleMesh E, F;
  Pose pose;
};

Velocity some_velocity() {
  Velocity velocity;
  velocity.v = {0.25, -0.5, 0.125};
  velocity.w = {0.5, 0.25, -1};
  return velocity;
}

ContactLaw some_law() {
  ContactLaw law;
  law.stiffness = 8;
  law.damping = 0.5;
  law.friction = 0.25;
  return law;
}

/// Asks both problems in either order and each alone, all modes of a problem after one another.
void expect_same_in_any_order(const Scene& scene, const ContactLaw& law = some_law()) {
  for (const Scheme scheme : kSchemes) {
    SCOPED_TRACE(scheme == Scheme::clipped ? "clipped" : "barycentric");
    const Oracle oracle(scene.E, scene.F, law, Mode::E, scheme);
    for (const Problem first : {Problem::rounded, Problem::exact}) {
      SCOPED_TRACE(first == Problem::rounded ? "exact after rounded" : "rounded after exact");
      const Problem second = first == Problem::rounded ? Problem::exact : Problem::rounded;
      Inquiry both(oracle, scene.pose, some_velocity());
      for (const Mode mode : kModes) both.answer(first, mode);
      for (const Mode mode : kModes) {
        Inquiry alone(oracle, scene.pose, some_velocity());
        EXPECT_EQ(difference(alone.answer(second, mode), both.answer(second, mode)), "") << static_cast<int>(mode);
      }
    }
  }
}

/// E's left side lies 1 m outside F, before the side of the bow tie where its winding number is -1: a line leaves F
/// there that has not entered it. A spike of F's reaches that side of E's in the rounded problem and stays 2^-105 m
/// from it in the exact one, so E's face is active in the former only.
Scene folded_slave_reached_by_rounding() {
  Scene scene;
  scene.E = generate::box({-0x1p-105, -1, -1}, {1.5, 1, 1});
  // (1 + 2^-52) (1 - 2^-52) - 1 is -2^-104, or 0 when rounded.
  const TriangleMesh spike =
      degenerate::tetrahedron({{{1 - 0x1p-52, -0.5, 0.25}, {0.5, -0.75, 0.25}, {0.5, -0.25, 0.25}, {0.5, -0.5, 0.5}}});
  scene.F = degenerate::joined(bow_tie(4), spike);
  scene.pose = shifted(-1, 0, 0);
  scene.pose.A(0, 0) = 1 + 0x1p-52;
  return scene;
}

TEST(Inquiry, FaceThatOnlyRoundingMakesActiveBeforeAFoldOfTheSlaveHasAnElementInTheRoundedProblemOnly) {
  const Scene scene = folded_slave_reached_by_rounding();
  const Oracle oracle(scene.E, scene.F, some_law());
  EXPECT_EQ(oracle.answer(Problem::rounded, scene.pose).elements.size(), 1u);
  EXPECT_EQ(oracle.answer(Problem::exact, scene.pose).elements.size(), 0u);
  EXPECT_FALSE(oracle.answer(Problem::rounded, scene.pose).certified);
  EXPECT_FALSE(oracle.answer(Problem::exact, scene.pose).certified);
  expect_same_in_any_order(scene);
}

/// The bottom of F has three faces, one of them 2^-60 m wide, which rounding to multiples of 2^-52 takes away.
Scene master_face_without_area_when_rounded() {
  Scene scene;
  scene.E = generate::box({-4, -4, -4}, {4, 4, 0.25});
  scene.F.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0x1p-60, 0}, {0.5, -0.5, 1}};
  scene.F.faces = {{1, 0, 3}, {2, 1, 3}, {0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}};
  scene.pose = shifted(0, 1, 0);
  return scene;
}

TEST(Inquiry, FaceThatHasAreaInTheExactProblemOnlyHasAnElementThere) {
  const Scene scene = master_face_without_area_when_rounded();
  const Oracle oracle(scene.E, scene.F, some_law(), Mode::F);
  EXPECT_EQ(oracle.answer(Problem::rounded, scene.pose).elements.size(), 0u);
  EXPECT_EQ(oracle.answer(Problem::exact, scene.pose).elements.size(), 1u);
  expect_same_in_any_order(scene);
}

/// Bodies of corners on small integers, most of them folded, and poses that round: F's corners, in units of 1 + 2^-52
/// or less, lie 2^-104 of their coordinates off where they are rounded to, beside E's 0 or 2^-105.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  /// Any two bodies, or what `folded_slave_reached_by_rounding` is one of: a box, and a spike beside any body.
  Scene scene() {
    Scene scene;
    const bool reached = integer(0, 1) == 0;
    do {
      scene.E = reached ? box_at_zero() : any_mesh();
      beside_zero(scene.E);
      scene.F = reached ? degenerate::joined(any_mesh(), spike_at_one()) : any_mesh();
      beside_integers(scene.F);
      scene.pose = reached ? shifted(-1, 0, 0) : any_pose();
      for (int i = 0; i < 3; ++i) scene.pose.A.row(i) *= 1 + integer(-1, 1) * 0x1p-52;
    } while (!fit(scene));
    return scene;
  }

 private:
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }

  Eigen::Vector3d corner() {
    const int x = integer(-3, 3), y = integer(-3, 3), z = integer(-3, 3);
    return {double(x), double(y), double(z)};
  }

  /// A tetrahedron, an octahedron or a box with corners anywhere, a bow tie, two bodies in one; one in eight open.
  TriangleMesh any_mesh() {
    const int shape = integer(0, 8);
    if (shape == 0) return bow_tie(integer(-2, 4));
    if (shape == 1) return degenerate::joined(any_mesh(), any_mesh());
    TriangleMesh mesh = generate::box(Eigen::Vector3d(1, 1, 1));
    if (shape < 4) mesh = degenerate::tetrahedron({corner(), corner(), corner(), corner()});
    if (shape >= 4 && shape < 8) {
      mesh.vertices.resize(6);
      mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    }
    if (shape >= 4)
      for (Eigen::Vector3d& x : mesh.vertices) x = corner();
    if (integer(0, 7) == 0) mesh.faces.erase(mesh.faces.begin() + integer(0, 3));
    return mesh;
  }

  TriangleMesh box_at_zero() {
    return generate::box(Eigen::Vector3d(0, -integer(1, 3), -integer(1, 3)),
                         Eigen::Vector3d(integer(1, 6) / 2.0, integer(1, 3), integer(1, 3)));
  }

  TriangleMesh spike_at_one() {
    const double y = integer(-8, 8) / 8.0, z = integer(-8, 8) / 8.0;
    return degenerate::tetrahedron({{{1, y, z}, {0.5, y - 0.25, z}, {0.5, y + 0.25, z}, {0.5, y, z + 0.25}}});
  }

  Pose any_pose() {
    const int x = integer(-2, 2), y = integer(-2, 2), z = integer(-2, 2);
    Pose pose = shifted(x, y, z);
    Eigen::Matrix3d quarter_x, quarter_z;
    quarter_x << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    quarter_z << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    for (int turns = integer(0, 3); turns > 0; --turns) pose.A = (integer(0, 1) == 0 ? quarter_x : quarter_z) * pose.A;
    return pose;
  }

  void beside_zero(TriangleMesh& mesh) {
    const double offset = integer(-1, 1) * 0x1p-105;
    for (Eigen::Vector3d& vertex : mesh.vertices)
      for (double& x : vertex)
        if (x == 0) x = offset;
  }

  void beside_integers(TriangleMesh& mesh) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
      for (double& x : vertex) x *= 1 + integer(-1, 1) * 0x1p-52;
  }

  static bool fit(const Scene& scene) {
    try {
      const Oracle oracle(scene.E, scene.F);
      return true;
    } catch (const BadInput&) {
      return false;
    }
  }

  std::mt19937_64 engine_;
};

TEST(Inquiry, AnswersOfFoldedBodiesDoNotDependOnWhatWasAskedBefore) {
  constexpr std::uint64_t kSeed = 15;
  std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
  int pressing = 0, of_other_faces = 0, of_other_elements = 0;
  for (int number = 0; number < brute_force::affordable(220) && !HasFailure(); ++number) {
    SCOPED_TRACE("number " + std::to_string(number));
    const Scene scene = Draw(kSeed * 1000003 + static_cast<std::uint64_t>(number)).scene();
    ContactLaw law = some_law();
    if (number % 8 == 0) law.max_penetration = 0.75;
    expect_same_in_any_order(scene, law);
    const Oracle oracle(scene.E, scene.F, some_law(), Mode::both);
    Inquiry inquiry(oracle, scene.pose);
    const Answer rounded = inquiry.answer(Problem::rounded), exact = inquiry.answer(Problem::exact);
    EXPECT_EQ(rounded.certified, exact.certified);
    pressing += !rounded.elements.empty();
    of_other_faces += rounded.E.intersected != exact.E.intersected || rounded.F.intersected != exact.F.intersected;
    of_other_elements += rounded.elements.size() != exact.elements.size();
  }
  std::printf("%d press; rounded and exact problem differ %d times in crossed faces, %d in elements\n", pressing,
              of_other_faces, of_other_elements);
  EXPECT_GE(pressing, brute_force::affordable(220) / 4);
  EXPECT_GE(of_other_faces, brute_force::affordable(220) / 15);
}

}  // namespace
}  // namespace pcm::reference
