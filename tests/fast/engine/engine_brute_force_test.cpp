// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "fast/posed/transform.h"
#include "fast/predicates/orientation.h"
#include "fast/predicates/penetration_predicates.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "tests/fast/engine_support.h"

/// The engine against the definitions taken literally: every face against every face, every vertex's winding number,
/// every line against every face. Same predicates, but no trees, no floods, no filters, no shared crossings.
namespace pcm::fast {
namespace {

using namespace test;
using CrossingKey = std::tuple<int, Index, Index, Index>;
using ElementKey = std::tuple<int, Index, Index>;

class BruteForce {
 public:
  BruteForce(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) : meshes_{&E, &F} {
    points_[0] = E.vertices;
    for (const Eigen::Vector3d& x : F.vertices) points_[1].push_back(rounded_transform(pose, x));
    for (std::size_t side = 0; side < 2; ++side) find_crossings_of(side);
  }

  std::set<CrossingKey> crossings;
  std::array<std::set<Index>, 2> intersected;

  std::vector<Index> inner(std::size_t side) {
    std::vector<Index> result;
    std::vector<int> winding;
    for (std::size_t v = 0; v < points_[side].size(); ++v)
      winding.push_back(winding_about(side, static_cast<Index>(v)));
    for (std::size_t f = 0; f < meshes_[side]->faces.size(); ++f) {
      const Triangle& t = meshes_[side]->faces[f];
      if (intersected[side].count(static_cast<Index>(f)) != 0) continue;
      if (winding[static_cast<std::size_t>(t[0])] >= 1) result.push_back(static_cast<Index>(f));
    }
    return result;
  }

  std::vector<ElementKey> elements(std::size_t master, const std::vector<Index>& active, Index& too_deep) {
    std::vector<ElementKey> result;
    for (const Index e : active) {
      const FacePoints p = face(master, e);
      const PenetrationLine line(p[0], p[1], p[2]);
      const Index f = first_met(line, 1 - master, -1);
      if (f < 0 || facing(line, face(1 - master, f), work_) > 0) continue;
      const Index own = first_met(line, master, e);
      if (own >= 0 && compare_distance(line, face(master, own), face(1 - master, f), work_) < 0) {
        ++too_deep;
      } else if (distance_sign(line, face(1 - master, f), work_) > 0) {
        result.emplace_back(static_cast<int>(master), e, f);
      }
    }
    return result;
  }

 private:
  RankedPoint point(std::size_t side, Index v) const {
    const auto rank = static_cast<std::int64_t>(side == 0 ? 0 : points_[0].size()) + v;
    return {points_[side][static_cast<std::size_t>(v)].data(), rank};
  }
  FacePoints face(std::size_t side, Index f) const {
    const Triangle& t = meshes_[side]->faces[static_cast<std::size_t>(f)];
    return {points_[side][static_cast<std::size_t>(t[0])], points_[side][static_cast<std::size_t>(t[1])],
            points_[side][static_cast<std::size_t>(t[2])]};
  }
  int passage(const RankedPoint& a, const RankedPoint& b, std::size_t side, Index f) {
    const Triangle& t = meshes_[side]->faces[static_cast<std::size_t>(f)];
    const RankedPoint p = point(side, t[0]), q = point(side, t[1]), s = point(side, t[2]);
    const int above = orientation(p, q, s, a, work_);
    if (above == orientation(p, q, s, b, work_)) return 0;
    const int turn = orientation(a, b, p, q, work_);
    return turn == orientation(a, b, q, s, work_) && turn == orientation(a, b, s, p, work_) ? above : 0;
  }
  void find_crossings_of(std::size_t side) {
    for (std::size_t e = 0; e < meshes_[side]->faces.size(); ++e) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index i = meshes_[side]->faces[e][k], j = meshes_[side]->faces[e][(k + 1) % 3];
        const RankedPoint a = point(side, std::min(i, j)), b = point(side, std::max(i, j));
        for (std::size_t f = 0; f < meshes_[1 - side]->faces.size(); ++f) {
          if (passage(a, b, 1 - side, static_cast<Index>(f)) == 0) continue;
          crossings.emplace(static_cast<int>(side), std::min(i, j), std::max(i, j), static_cast<Index>(f));
          intersected[side].insert(static_cast<Index>(e));
          intersected[1 - side].insert(static_cast<Index>(f));
        }
      }
    }
  }
  int winding_about(std::size_t side, Index v) {
    const RankedPoint a = point(side, v);
    double far = 0;
    for (const auto& points : points_) {
      for (const Eigen::Vector3d& x : points) far = std::max(far, x.cwiseAbs().maxCoeff());
    }
    const Eigen::Vector3d outside = far * Eigen::Vector3d(3.1, 4.7, 5.3);
    const RankedPoint z{outside.data(), std::numeric_limits<std::int64_t>::max()};
    int winding = 0;
    for (std::size_t f = 0; f < meshes_[1 - side]->faces.size(); ++f) {
      winding -= passage(a, z, 1 - side, static_cast<Index>(f));
    }
    return winding;
  }
  Index first_met(const PenetrationLine& line, std::size_t side, Index but) {
    Index first = -1;
    for (std::size_t i = 0; i < meshes_[side]->faces.size(); ++i) {
      const auto f = static_cast<Index>(i);
      const FacePoints points = face(side, f);
      if (f == but || facing(line, points, work_) == 0 || !passes_through(line, points, work_) ||
          distance_sign(line, points, work_) < 0) {
        continue;
      }
      if (first < 0 || compare_distance(line, points, face(side, first), work_) < 0) first = f;
    }
    return first;
  }

  std::array<const TriangleMesh*, 2> meshes_;
  std::array<std::vector<Eigen::Vector3d>, 2> points_;
  WorkCounters work_;
};

/// Returns how many elements there are.
Index expect_same(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose, Workspace& workspace) {
  const Pairing pairing(Surface(E), Surface(F), stiffness(1), Mode::both);
  const Contact& contact = evaluate(pairing, pose, {}, {}, workspace);
  BruteForce brute(E, F, pose);
  std::set<CrossingKey> crossings;
  for (const Crossing& c : contact.crossings) {
    crossings.emplace(static_cast<int>(c.edge_side), c.edge[0], c.edge[1], c.face);
  }
  EXPECT_EQ(crossings.size(), contact.crossings.size());
  EXPECT_EQ(crossings, brute.crossings);
  EXPECT_TRUE(std::equal(contact.E.intersected.begin(), contact.E.intersected.end(), brute.intersected[0].begin(),
                         brute.intersected[0].end()));
  EXPECT_TRUE(std::equal(contact.F.intersected.begin(), contact.F.intersected.end(), brute.intersected[1].begin(),
                         brute.intersected[1].end()));
  const bool closed[2] = {pairing.surface_E().closed(), pairing.surface_F().closed()};
  if (closed[1]) {
    EXPECT_EQ(contact.E.inner, brute.inner(0));
  }
  if (closed[0]) {
    EXPECT_EQ(contact.F.inner, brute.inner(1));
  }
  Index too_deep = 0;
  std::vector<ElementKey> elements;
  for (std::size_t side = 0; side < 2; ++side) {
    const ActiveArea& area = side == 0 ? contact.E : contact.F;
    std::vector<Index> active = area.intersected;
    active.insert(active.end(), area.inner.begin(), area.inner.end());
    std::sort(active.begin(), active.end());
    const std::vector<ElementKey> found = brute.elements(side, active, too_deep);
    elements.insert(elements.end(), found.begin(), found.end());
  }
  std::vector<ElementKey> engine_elements;
  for (const Element& e : contact.elements) {
    engine_elements.emplace_back(static_cast<int>(e.master), e.master_face, e.slave_face);
  }
  EXPECT_EQ(engine_elements, elements);
  EXPECT_EQ(contact.too_deep, too_deep);
  return static_cast<Index>(elements.size());
}

TEST(EngineAgainstBruteForce, RandomPosesOfSmallBodies) {
  const unsigned seed = 20260;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::vector<TriangleMesh> bodies{generate::box(Eigen::Vector3d(2, 2, 2)), generate::icosphere(1, 1),
                                         generate::torus(1, 0.4, 8, 6),           generate::gridded_box(2, 3),
                                         generate::plate(3, 3, 0.25, 2, 2),       generate::pyramid()};
  Workspace workspace;
  for (int i = 0; i < 300; ++i) {
    const TriangleMesh& E = bodies[random() % bodies.size()];
    const TriangleMesh& F = bodies[random() % bodies.size()];
    const Eigen::Vector3d r(uniform(random), uniform(random), uniform(random));
    expect_same(E, F, turned(3 * uniform(random), 1.7 * r), workspace);
    if (HasFailure()) FAIL() << "pose " << i;
  }
}

TEST(EngineAgainstBruteForce, GridUponGridWithQuarterTurns) {
  const unsigned seed = 71;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<TriangleMesh> bodies{generate::box(Eigen::Vector3d(2, 2, 2)), generate::gridded_box(2, 2),
                                         generate::plate(2, 2, 1, 2, 2), generate::icosphere(1, 0)};
  Workspace workspace;
  for (int i = 0; i < 200; ++i) {
    const TriangleMesh& E = bodies[random() % bodies.size()];
    const TriangleMesh& F = bodies[random() % bodies.size()];
    Pose pose;
    if (random() % 2 == 0) pose.A << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    if (random() % 2 == 0) pose.A = pose.A * (Eigen::Matrix3d() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
    const auto step = [&] { return 0.5 * (static_cast<double>(random() % 9) - 4); };
    pose.r = {step(), step(), step()};
    expect_same(E, F, pose, workspace);
    if (HasFailure()) FAIL() << "pose " << i;
  }
}

TEST(EngineAgainstBruteForce, CatalogueOfDegeneratePairs) {
  Workspace workspace;
  for (const degenerate::Case& c : degenerate::catalogue()) {
    SCOPED_TRACE(c.name);
    expect_same(c.E, c.F, {c.A, c.r}, workspace);
    expect_same(c.F, c.E, {c.A.transpose(), -c.A.transpose() * c.r}, workspace);
  }
}

TEST(EngineAgainstBruteForce, FarFromTheOriginWhereVerticesCoincide) {
  Workspace workspace;
  const TriangleMesh big = generate::gridded_box(2e12, 2);
  Index elements = 0;
  for (const double size : {1e-12, 1e-5, 1e-4, 1e-3, 1e-2, 1.0}) {
    SCOPED_TRACE(size);
    elements += expect_same(big, generate::icosphere(size, 1), turned(0.3, {1e12, 0.3e12, 0.5e12}), workspace);
    elements += expect_same(big, generate::icosphere(size, 1), turned(0.3, {1e12, 1e12, 0}), workspace);
    elements += expect_same(big, generate::box({size, size, size}), shifted(1e12, 1e12, 1e12), workspace);
  }
  EXPECT_GT(elements, 20);
}

/// A body of two boxes, one upon the other: where they touch, a line leaves one and enters the other at one point, and
/// the smaller index decides.
TEST(EngineAgainstBruteForce, FacesThatCoincideInWhateverOrder) {
  const unsigned seed = 33;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const TriangleMesh E = generate::gridded_box({-0.3125, -0.3125, -1}, {0.3125, 0.3125, 1}, {3, 3, 1});
  TriangleMesh F = degenerate::joined(generate::gridded_box({-1, -1, 0.5}, {1, 1, 0.75}, {4, 4, 1}),
                                      generate::gridded_box({-1.25, -1.5, 0.75}, {1.5, 1.25, 1.5}, {3, 5, 1}));
  Workspace workspace;
  Index elements = 0;
  for (int i = 0; i < 20; ++i) {
    std::shuffle(F.faces.begin(), F.faces.end(), random);
    elements += expect_same(E, F, {}, workspace);
    if (HasFailure()) FAIL() << "order " << i;
  }
  EXPECT_GT(elements, 100);
}

/// Narrow faces of a body, rotated so that their corners are rounded, through the barycentres of a row of another's:
/// what rounding makes of a distance is many times greater than the distance.
TEST(EngineAgainstBruteForce, NarrowFacesWithinRoundingsOfBarycentres) {
  const unsigned seed = 47;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const TriangleMesh plain_E = generate::gridded_box({2, 2, 2}, {3, 12, 1});
  const TriangleMesh plain_F = generate::gridded_box({3, 3, 3}, {1, 200, 1});
  Workspace workspace;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Matrix3d any = turned(3 * uniform(random), Eigen::Vector3d::Zero()).A *
                                Eigen::AngleAxisd(uniform(random), Eigen::Vector3d::UnitX()).toRotationMatrix();
    const Eigen::Matrix3d tilt = Eigen::AngleAxisd(0.9 * uniform(random), Eigen::Vector3d::UnitY()).toRotationMatrix();
    // Through the barycentres of one of the two faces in each cell of the middle column of E's top, by turns.
    const Eigen::Vector3d row(i % 2 == 0 ? 1.0 / 9 : -1.0 / 9, 0, 1);
    TriangleMesh E = plain_E, F = plain_F;
    for (Eigen::Vector3d& x : E.vertices) x = any * x;
    for (Eigen::Vector3d& x : F.vertices) x = any * (tilt * (x + Eigen::Vector3d(0, 0, 1.5)) + row);
    EXPECT_GT(expect_same(E, F, {}, workspace), 0);
    if (HasFailure()) FAIL() << "pose " << i;
  }
}

}  // namespace
}  // namespace pcm::fast
