// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Poses at which one term of the clipped scheme's error analysis is nearly all of the error: without it, the bound is
// broken. A narrow master face looks at sheets of the slave far beneath it, so that an error of where something begins
// or ends costs far more than an error of depth.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "compare/random/random.h"
#include "meshes/generate/boxes.h"
#include "pcm/engine.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

constexpr double kNarrow = 0x1p-10;  ///< width of the master face, m

/// An open surface of single triangles.
class Triangles {
 public:
  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const auto first = static_cast<Index>(mesh_.vertices.size());
    for (const Eigen::Vector3d& x : {a, b, c}) mesh_.vertices.push_back(x);
    mesh_.faces.push_back({first, first + 1, first + 2});
  }
  /// Two that look down and meet at x = 0, in one plane.
  void add_ridge(double w, double z) {
    const auto first = static_cast<Index>(mesh_.vertices.size());
    for (const Eigen::Vector3d& x :
         {Eigen::Vector3d(0, -w, z), Eigen::Vector3d(0, w, z), Eigen::Vector3d(w, 0, z), Eigen::Vector3d(-w, 0, z)}) {
      mesh_.vertices.push_back(x);
    }
    mesh_.faces.push_back({first, first + 1, first + 2});
    mesh_.faces.push_back({first + 1, first, first + 3});
  }
  const TriangleMesh& mesh() const { return mesh_; }

 private:
  TriangleMesh mesh_;
};

/// What lies beneath the master face, which is about the origin in the plane z = 0; faces that look down carry.
enum class Scene {
  border,   ///< a sheet that ends in the middle
  hider,    ///< a sheet, and before it one that looks up and ends in the middle
  upright,  ///< a sheet, and before it a face seen edgewise
  entry,    ///< a sheet, and a face that looks up and comes from above the master's plane
  order,    ///< a sheet, and a face that looks up and comes through it
  whole,    ///< nothing but a sheet
  vast,     ///< a sheet that reaches far beyond the master, sloped
  ridge,    ///< two sheets that meet in the middle
  blade,    ///< nothing but a face seen edgewise
};

Triangles slave_of(Scene scene) {
  Triangles slave;
  const auto sheet = [&slave](double x, double z, bool looks_up) {
    const double w = 3 * kNarrow;
    const Eigen::Vector3d a(x * w, -w, z), b(x * w, w, z), c(-w, 0, z);
    if (looks_up) {
      slave.add(a, b, c);
    } else {
      slave.add(b, a, c);
    }
  };
  if (scene == Scene::vast) {
    const double far = 0x1p16 * kNarrow;
    slave.add({far, -0.7 * far, -0.6}, {-far, -0.8 * far, -0.4}, {0.1 * far, far, -0.5});
  } else if (scene == Scene::ridge) {
    slave.add_ridge(3 * kNarrow, -0.5);
  } else if (scene != Scene::blade) {
    sheet(scene == Scene::border ? 0 : 1, -0.5, false);
  }
  const double w = 2 * kNarrow;
  switch (scene) {
    case Scene::hider:
      sheet(0, -0.25, true);
      break;
    case Scene::upright:
      // Shallow, so that what it might carry itself does not matter.
      slave.add({0, -w, -w / 8}, {0, w, -w / 8}, {0, 0, -w / 4});
      break;
    case Scene::entry:
      // Flat, so that errors of its depth move the line where it comes through much farther than its sides.
      slave.add({w, -w, -w / 32}, {w, w, -w / 32}, {-w, 0, w / 32});
      break;
    case Scene::order:
      slave.add({w, -w, -0.5 - w}, {w, w, -0.5 - w}, {-w, 0, -0.5 + w});
      break;
    case Scene::blade:
      slave.add({0, -w, -0.25}, {0, w, -0.25}, {0, 0, -0.5});
      break;
    case Scene::border:
    case Scene::whole:
    case Scene::vast:
    case Scene::ridge:
      break;
  }
  // Makes the master face active: it passes through a corner of it.
  const double v = kNarrow / 64;
  const Eigen::Vector3d corner(-0.45 * kNarrow, 0, 0);
  slave.add(corner + Eigen::Vector3d(v, -v, -v), corner + Eigen::Vector3d(v, v, -v),
            corner + Eigen::Vector3d(-v, 0, v));
  return slave;
}

struct Case {
  const char* name;
  Scene scene;
  enum Law { elastic, damped, spun, faded } law;
  Mode mode;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class ClippedBoundTerm : public testing::TestWithParam<Case> {};

TEST_P(ClippedBoundTerm, IsNeededAndHolds) {
  const Case& c = GetParam();
  ContactLaw law;
  law.stiffness = 1;
  if (c.law != Case::elastic) {
    law.damping = 1;
    law.damping_mode = DampingMode::full;
  }
  // Damping differs from place to place, and is nearly all of the force. It acts where the master face is, about which
  // the slave turns.
  const bool is_spun = c.law == Case::spun || c.law == Case::faded;
  if (is_spun) law.layers = LayerStiffness{HUGE_VAL, 1e-9};
  if (c.law == Case::faded) law.transition_depth = 1;
  const Triangles slave = slave_of(c.scene);
  double greatest_force = 0, greatest_torque = 0;
  for (std::uint64_t number = 0; number < 200; ++number) {
    PoseRandom random(51, static_cast<std::uint64_t>(c.scene), 0, number);
    const Eigen::Matrix3d A = Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 1)
                                  .normalized()
                                  .toRotationMatrix();
    const Eigen::Vector3d r(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    // The master's frame is the one that the other body is turned in.
    Triangles master;
    const auto placed = [&](double x, double y) {
      const Eigen::Vector3d p(x * kNarrow, y * kNarrow, 0);
      return Eigen::Vector3d(c.mode == Mode::E ? A * p + r : p);
    };
    master.add(placed(-0.5, -0.5), placed(0.5, -0.4), placed(-0.4, 0.5));
    TriangleMesh turned = slave.mesh();
    Pose pose;
    pose.A = A;
    pose.r = r;
    if (c.mode == Mode::F) {
      for (Eigen::Vector3d& x : turned.vertices) x = A * x + r;
    }
    const TriangleMesh& E = c.mode == Mode::E ? master.mesh() : turned;
    const TriangleMesh& F = c.mode == Mode::E ? slave.mesh() : master.mesh();
    Velocity velocity{
        c.law == Case::damped ? A * Eigen::Vector3d(0, 0, c.mode == Mode::E ? -1.0 : 1.0) : Eigen::Vector3d(0, 0, 0),
        {0, 0, 0}};
    if (is_spun) velocity.w = A * Eigen::Vector3d(0, 1 / kNarrow, 0);
    fast::Workspace workspace;
    Wanted wanted{false, false, true, true, true};
    const fast::Pairing pairing(fast::Surface(E), fast::Surface(F), law, c.mode, Scheme::clipped);
    const fast::Contact& contact = evaluate(pairing, pose, velocity, wanted, workspace);
    if (c.scene != Scene::blade) {
      ASSERT_GE(contact.element_count, 1);
    }
    wanted.bound = false;
    const reference::Answer truth =
        reference::Oracle(E, F, law, c.mode, Scheme::clipped).answer(reference::Problem::exact, pose, velocity, wanted);
    for (int k = 0; k < 3; ++k) {
      const double force = std::abs(contact.force_Me[k] - truth.force_Me[k]);
      const double torque = std::abs(contact.torque_Me[k] - truth.torque_Me[k]);
      EXPECT_LE(force, contact.bound->force_Me[k] + 0x1p-52 * std::abs(truth.force_Me[k]));
      EXPECT_LE(torque, contact.bound->torque_Me[k] + 0x1p-52 * std::abs(truth.torque_Me[k]));
      greatest_force = std::max(greatest_force, force / contact.bound->force_Me[k]);
      greatest_torque = std::max(greatest_torque, torque / contact.bound->torque_Me[k]);
    }
  }
  std::printf("  %s: greatest error over its bound: force %.3f torque %.3f\n", c.name, greatest_force, greatest_torque);
  EXPECT_GE(greatest_force, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Terms, ClippedBoundTerm,
                         testing::Values(Case{"BorderOfTheCarrier", Scene::border, Case::elastic, Mode::E},
                                         Case{"BorderOfADampedCarrier", Scene::border, Case::damped, Mode::E},
                                         Case{"OutlineOfAHider", Scene::hider, Case::elastic, Mode::E},
                                         Case{"HiderSeenEdgewise", Scene::upright, Case::elastic, Mode::E},
                                         Case{"EntryOfAHider", Scene::entry, Case::elastic, Mode::E},
                                         Case{"OrderOfTwoSheets", Scene::order, Case::elastic, Mode::E},
                                         Case{"TurnedMaster", Scene::whole, Case::elastic, Mode::F},
                                         Case{"VastSheet", Scene::vast, Case::elastic, Mode::F},
                                         Case{"DampedVastSheet", Scene::vast, Case::damped, Mode::F},
                                         Case{"Blade", Scene::blade, Case::elastic, Mode::E},
                                         Case{"BladeOverAMovedMaster", Scene::blade, Case::elastic, Mode::F},
                                         Case{"PassingOverARidge", Scene::ridge, Case::spun, Mode::E},
                                         Case{"PassingVolumeOverARidge", Scene::ridge, Case::faded, Mode::E}),
                         [](const testing::TestParamInfo<Case>& test) { return std::string(test.param.name); });

/// An open surface that winds about a vertex once and `beyond` further, down a spiral staircase of one step a face, so
/// that its last step lies beneath its first. All of it looks up.
TriangleMesh spiral(double beyond) {
  constexpr int kSteps = 11;
  constexpr double kDrop = 0.05;  // m a radian
  constexpr double kWholeTurn = 6.283185307179586;
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, 0);
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = i * (kWholeTurn + beyond) / kSteps;
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), -kDrop * angle);
  }
  for (Index i = 1; i <= kSteps; ++i) mesh.faces.push_back({0, i, i + 1});
  return mesh;
}

TEST(ClippedBound, CountsWhatAnOpenSurfaceHidesWhereItWindsAboutAVertexMoreThanOnce) {
  // The first step sees the last one in part from a little less than a whole turn on, since its lines are not upright.
  const TriangleMesh box = generate::box({6, 6, 6});
  ContactLaw law;
  law.stiffness = 1;
  Pose pose;
  pose.A = Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.r = {0.1, 0.2, 0.3};
  for (const double beyond : {-0.3, -0.01, 0.01, 0.1, 0.2, 0.3, 0.5}) {
    SCOPED_TRACE(beyond);
    for (const Mode mode : {Mode::E, Mode::F}) {
      const TriangleMesh E = mode == Mode::E ? spiral(beyond) : box, F = mode == Mode::E ? box : spiral(beyond);
      fast::Workspace workspace;
      Wanted wanted{false, false, true, true, true};
      const fast::Pairing pairing(fast::Surface(E), fast::Surface(F), law, mode, Scheme::clipped);
      const fast::Contact& contact = evaluate(pairing, pose, Velocity{}, wanted, workspace);
      ASSERT_GE(contact.element_count, 10);
      wanted.bound = false;
      const reference::Answer truth =
          reference::Oracle(E, F, law, mode, Scheme::clipped).answer(reference::Problem::exact, pose, {}, wanted);
      for (int k = 0; k < 3; ++k) {
        EXPECT_LE(std::abs(contact.force_Me[k] - truth.force_Me[k]),
                  contact.bound->force_Me[k] + 0x1p-53 * std::abs(truth.force_Me[k]));
        EXPECT_LE(std::abs(contact.torque_Me[k] - truth.torque_Me[k]),
                  contact.bound->torque_Me[k] + 0x1p-53 * std::abs(truth.torque_Me[k]));
      }
      EXPECT_LT(contact.bound->force_Me.norm(), 1e-12);
    }
  }
}

/// Where F is master, against the oracle: the greatest component of the force's error over its bound.
double held_on_F(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  ContactLaw law;
  law.stiffness = 1;
  fast::Workspace workspace;
  Wanted wanted{false, false, true, true, true};
  const fast::Pairing pairing(fast::Surface(E), fast::Surface(F), law, Mode::F, Scheme::clipped);
  const fast::Contact& contact = evaluate(pairing, pose, Velocity{}, wanted, workspace);
  EXPECT_GE(contact.element_count, 1);
  EXPECT_FALSE(contact.bound->flipped);
  wanted.bound = false;
  const reference::Answer truth =
      reference::Oracle(E, F, law, Mode::F, Scheme::clipped).answer(reference::Problem::exact, pose, {}, wanted);
  double greatest = 0;
  for (int k = 0; k < 3; ++k) {
    const double force = std::abs(contact.force_Me[k] - truth.force_Me[k]);
    EXPECT_LE(force, contact.bound->force_Me[k] + 0x1p-53 * std::abs(truth.force_Me[k]));
    EXPECT_LE(std::abs(contact.torque_Me[k] - truth.torque_Me[k]),
              contact.bound->torque_Me[k] + 0x1p-53 * std::abs(truth.torque_Me[k]));
    if (contact.bound->force_Me[k] > 0) greatest = std::max(greatest, force / contact.bound->force_Me[k]);
  }
  return greatest;
}

constexpr double kWidth = 0x1p-6;  ///< of a master face over something deep, m

/// No rotation, and not quite: upright lines of F lean by twice this against its faces' normals.
Pose sheared(Eigen::Index axis, double shear) {
  Pose pose;
  pose.A = Eigen::Matrix3d::Identity();
  pose.A(axis, 2) = pose.A(2, axis) = shear;
  return pose;
}

TEST(ClippedBound, CountsWhatTheWallsOfAShearedBodyLeanOver) {
  // A column that stands through a slab: beneath its top the lines go down between its walls.
  const TriangleMesh slab = generate::box({-1, -1, -1}, {1, 1, 0.25});
  const TriangleMesh column =
      generate::gridded_box({-kWidth / 2, -kWidth / 2, -1.5}, {kWidth / 2, kWidth / 2, 0}, {1, 1, 2});
  double greatest = 0;
  for (const double shear : {-0x1p-49, -0x1.8p-51, 0.0, 0x1p-53, 0x1p-50, 0x1p-49, 0x1p-40}) {
    for (const Eigen::Index axis : {0, 1}) {
      SCOPED_TRACE(testing::Message() << "shear " << shear << " axis " << axis);
      const double ratio = held_on_F(slab, column, sheared(axis, shear));
      if (std::abs(shear) == 0x1p-49) greatest = std::max(greatest, ratio);
    }
  }
  std::printf("  sheared: greatest error over its bound %.3f\n", greatest);
  EXPECT_GE(greatest, 0.01);
  // Rotations but for rounding.
  for (std::uint64_t number = 0; number < 20; ++number) {
    SCOPED_TRACE(number);
    PoseRandom random(52, 0, 0, number);
    Pose pose;
    pose.A = Eigen::AngleAxisd(random.uniform(-0.1, 0.1), random.direction()).toRotationMatrix();
    pose.r = Eigen::Vector3d(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0);
    held_on_F(slab, column, pose);
  }
}

TEST(ClippedBound, CountsFacesOfTheMasterThatTheElementsWereMadeWithout) {
  // A little above the slave's sheet a face of the master ends flush with the prism, so that it leans over it where
  // the pose shears it. A sheet of the slave seen edgewise reaches deeper than the master's own floor, so that the
  // bound alone has to hear of the master's faces.
  constexpr double w = kWidth;
  Triangles master;
  master.add({0, 0, 0}, {w, 0, 0}, {0, w, 0});
  master.add({0, -w, -0.9}, {0, 2 * w, -0.9}, {-w, w / 2, -0.9});
  master.add({-w, -w, -1.5}, {4 * w, -w, -1.5}, {-w, 4 * w, -1.5});
  double greatest[2] = {0, 0};
  for (const bool is_deep : {false, true}) {
    Triangles slave;
    slave.add({-w, -w, -1}, {-w, 4 * w, -1}, {4 * w, -w, -1});
    if (is_deep) slave.add({0.125 * w, 0.75 * w, -1.1}, {0.126 * w, 0.75 * w, -1.1}, {0.125 * w, 0.75 * w, -2});
    // Makes the master face active.
    const double v = w / 64;
    slave.add({w / 4 + v, w / 4 - v, -v}, {w / 4 + v, w / 4 + v, -v}, {w / 4 - v, w / 4, v});
    for (const double shear : {-0x1p-49, -0x1p-50, 0x1p-50, 0x1p-49}) {
      SCOPED_TRACE(testing::Message() << "shear " << shear << " deep " << is_deep);
      double& ratio = greatest[is_deep ? 1 : 0];
      ratio = std::max(ratio, held_on_F(slave.mesh(), master.mesh(), sheared(0, shear)));
    }
  }
  std::printf("  greatest error over its bound: leaning %.3f, unheard %.3f\n", greatest[0], greatest[1]);
  EXPECT_GE(greatest[0], 0.07);
  EXPECT_GE(greatest[1], 0.3);
}

}  // namespace
}  // namespace pcm::compare
