// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The poses that verification draws: the same everywhere, and what their strata promise.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

#include "compare/poses/pairs.h"
#include "compare/poses/rounded_vertices.h"
#include "compare/poses/strata.h"
#include "fast/base/geometry.h"
#include "meshes/exact/exact_signs.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "pcm/check.h"

namespace pcm::compare {
namespace {

/// Changes only with the construction of the poses, and then for every later table too.
constexpr std::uint64_t kGoldenHash = 0x5ec641d99f81f1bb;

const TriangleMesh& cube() {
  static const TriangleMesh mesh = generate::box({1, 1, 1});
  return mesh;
}

const TriangleMesh& ball() {
  static const TriangleMesh mesh = generate::icosphere(0.75, 2);
  return mesh;
}

PoseRandom random_for(Stratum stratum, std::uint64_t pose) {
  return {7, static_cast<std::uint64_t>(stratum), 3, pose};
}

/// FNV-1a over the bits of the pose and velocity.
std::uint64_t hash_of(const DrawnPose& drawn, std::uint64_t hash) {
  const auto mix = [&hash](double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (int k = 0; k < 64; k += 8) hash = (hash ^ (bits >> k & 0xff)) * 0x100000001b3;
  };
  for (int k = 0; k < 9; ++k) mix(drawn.pose.A(k / 3, k % 3));
  for (int k = 0; k < 3; ++k) mix(drawn.pose.r[k]);
  for (int k = 0; k < 3; ++k) mix(drawn.velocity.v[k]);
  for (int k = 0; k < 3; ++k) mix(drawn.velocity.w[k]);
  return hash;
}

TEST(OrderedNormalized, HasLengthOneHoweverLongOrShortTheVectorIs) {
  for (const double size : {0x1p-1060, 0x1p-600, 1.0, 0x1p600, 0x1p1020}) {
    const Eigen::Vector3d direction = ordered_normalized(size * Eigen::Vector3d(2, -3, 6));
    EXPECT_NEAR((direction - Eigen::Vector3d(2, -3, 6) / 7).norm(), 0, 1e-15) << size;
  }
}

/// A tetrahedron one face of which is so narrow that its vector area rounds to 0.
TriangleMesh needle_tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0},
                   {0.5458915783827468, 0.5045419583098644, 0.6864336754504866},
                   {0.36751277671176624, 0.33967480614995127, 0.4621304963902424},
                   {0.3, -0.5, 0.1}};
  mesh.faces = {{1, 0, 2}, {3, 0, 1}, {3, 1, 2}, {2, 0, 3}};
  return mesh;
}

TEST(SurfaceFeatures, FaceWhoseAreaRoundsToZeroHasANormalAcrossItsPlane) {
  const TriangleMesh mesh = needle_tetrahedron();
  const SurfaceFeatures features(mesh);
  const Eigen::Vector3d normal = ordered_normalized(features.face_normal(0));
  for (const Eigen::Vector3d& x : {mesh.vertices[1], mesh.vertices[2]}) EXPECT_NEAR(normal.dot(x), 0, 1e-15);
  EXPECT_LT(features.face_normal(0).norm(), 1e-200);
}

TEST(Strata, NeedlesHugeAndTinySurfacesHaveFinitePoses) {
  TriangleMesh huge = cube(), tiny = cube();
  for (Eigen::Vector3d& x : huge.vertices) x *= 0x1p260;
  for (Eigen::Vector3d& x : tiny.vertices) x *= 0x1p-280;
  for (const TriangleMesh& mesh : {needle_tetrahedron(), huge, tiny}) {
    const FeaturePair pair(mesh, mesh);
    for (const Stratum stratum : {Stratum::generic, Stratum::grazing, Stratum::separated, Stratum::degenerate,
                                  Stratum::near_degenerate, Stratum::adversarial})
      for (std::uint64_t i = 0; i < 60; ++i) {
        const DrawnPose drawn = draw_pose(stratum, pair, random_for(stratum, i));
        ASSERT_TRUE(drawn.pose.A.allFinite() && drawn.pose.r.allFinite()) << i << ", " << name(stratum);
        ASSERT_TRUE(drawn.velocity.v.allFinite() && drawn.velocity.w.allFinite()) << i << ", " << name(stratum);
      }
  }
}

TEST(PoseRandom, UniformNumbersFillTheirRangeEvenly) {
  PoseRandom random(1, 2, 3, 4);
  std::array<int, 8> eighths{};
  for (int k = 0; k < 8000; ++k) {
    const double x = random.uniform();
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    ++eighths[static_cast<std::size_t>(x * 8)];
  }
  // Eight standard deviations of a binomial count of mean 1000.
  for (const int count : eighths) EXPECT_NEAR(count, 1000, 240);
}

TEST(PoseRandom, LogUniformStaysWithinItsEnds) {
  PoseRandom random(1, 2, 3, 4);
  double least = 1, greatest = 0;
  for (int k = 0; k < 4000; ++k) {
    const double x = random.log_uniform(1e-6, 0.5);
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  }
  EXPECT_GE(least, 1e-6);
  EXPECT_LT(least, 2e-6);
  EXPECT_LE(greatest, 0.5);
  EXPECT_GT(greatest, 0.25);
}

TEST(PoseRandom, RotationsAreOrthogonalToRoundingAndDirectionsUnit) {
  PoseRandom random(1, 2, 3, 4);
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Matrix3d A = random.rotation();
    // Each entry has at most six roundings of terms of at most 2: 24 times 2^-53 in A^T A to first order.
    EXPECT_LT(fast::orthogonality_error(A), 24 * 0x1p-53);
    EXPECT_GT(A.determinant(), 0);
    EXPECT_NEAR(random.direction().norm(), 1, 1e-15);
  }
}

TEST(Strata, NamesReadBack) {
  for (const Stratum stratum : kStrata) EXPECT_EQ(stratum_named(name(stratum)), stratum);
  EXPECT_EQ(stratum_named("trajectory"), Stratum::trajectory);
  EXPECT_EQ(stratum_named("all"), std::nullopt);
}

TEST(Strata, PosesAreTheSameBitsOnEveryMachine) {
  const FeaturePair pair(cube(), ball());
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const Stratum stratum :
       {Stratum::generic, Stratum::grazing, Stratum::separated, Stratum::degenerate, Stratum::near_degenerate})
    for (std::uint64_t i = 0; i < 200; ++i) hash = hash_of(draw_pose(stratum, pair, random_for(stratum, i)), hash);
  EXPECT_EQ(hash, kGoldenHash) << std::hex << "0x" << hash;
}

TEST(Strata, EveryPoseIsARotation) {
  const FeaturePair pair(cube(), ball());
  for (const Stratum stratum :
       {Stratum::generic, Stratum::grazing, Stratum::separated, Stratum::degenerate, Stratum::near_degenerate})
    for (std::uint64_t i = 0; i < 500; ++i) {
      const Pose pose = draw_pose(stratum, pair, random_for(stratum, i)).pose;
      EXPECT_LE(fast::orthogonality_error(pose.A), 1e-9) << name(stratum) << ' ' << i;
      EXPECT_GT(pose.A.determinant(), 0);
      EXPECT_TRUE(pose.r.allFinite());
    }
}

TEST(Strata, SupportPosesOverlapByTheirDepth) {
  // Two cubes are convex: the support heights along the line of the poses overlap by at most half the size.
  const FeaturePair pair(cube(), cube());
  int support = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const DrawnPose drawn = draw_pose(Stratum::generic, pair, random_for(Stratum::generic, i));
    support += drawn.construction == "support points";
  }
  EXPECT_NEAR(support, 200, 80);
}

TEST(Strata, SeparatedBodiesHaveOverlappingBoxesButAPlaneBetween) {
  const FeaturePair pair(cube(), ball());
  int overlapping = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Pose pose = draw_pose(Stratum::separated, pair, random_for(Stratum::separated, i)).pose;
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
    for (const Eigen::Vector3d& x : rounded_vertices(ball(), pose)) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
      // The cube is convex: outside it is beyond one of its faces.
      EXPECT_GT(x.cwiseAbs().maxCoeff(), 0.5) << i;
    }
    overlapping += (low.array() <= 0.5).all() && (high.array() >= -0.5).all();
  }
  EXPECT_GT(overlapping, 190);
}

TEST(Strata, NestedGuestLiesInsideItsHost) {
  const std::optional<NestedMeshes> meshes = nested_meshes(cube(), ball());
  ASSERT_TRUE(meshes);
  const FeaturePair pair(*meshes);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Pose pose = draw_pose(Stratum::nested, pair, random_for(Stratum::nested, i)).pose;
    const std::vector<Eigen::Vector3d> vertices_Me = rounded_vertices(meshes->F, pose);
    if (meshes->host == Side::E) {
      for (const Eigen::Vector3d& x : vertices_Me) EXPECT_LT(x.cwiseAbs().maxCoeff(), 0.5) << i;
      continue;
    }
    for (const Eigen::Vector3d& x_Me : meshes->E.vertices) {
      const Eigen::Vector3d x_Mf = pose.A.transpose() * (x_Me - pose.r);
      EXPECT_LT(x_Mf.norm(), 0.75) << i;
    }
  }
}

TEST(Strata, OpenSurfaceIsNeverTheHost) {
  const std::optional<NestedMeshes> meshes = nested_meshes(generate::pyramid(), ball());
  ASSERT_TRUE(meshes);
  EXPECT_EQ(meshes->host, Side::F);
  EXPECT_FALSE(nested_meshes(generate::pyramid(), generate::pyramid()));
}

/// True if a vertex of one surface lies exactly in the plane of a face of the other, in the rounded problem.
bool has_vertex_in_a_plane(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  const std::vector<Eigen::Vector3d> F_Me = rounded_vertices(F, pose);
  const auto any = [](const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& corners,
                      const std::vector<Triangle>& faces) {
    return std::any_of(faces.begin(), faces.end(), [&](const Triangle& face) {
      return std::any_of(points.begin(), points.end(), [&](const Eigen::Vector3d& x) {
        return side_sign(corners[face[0]], corners[face[1]], corners[face[2]], x) == 0;
      });
    });
  };
  return any(F_Me, E.vertices, E.faces) || any(E.vertices, F_Me, F.faces);
}

TEST(Strata, DegeneratePosesOfTheSmallPairsCoincideExactly) {
  std::vector<std::string> missing;
  std::map<std::string, int> constructions;
  for (const SurfacePair& pair : built_in_pairs("", missing)) {
    if (!pair.for_hard_strata) continue;
    EXPECT_LE(pair.faces(), 200U) << pair.name;
    for (std::uint64_t i = 0; i < 100; ++i) {
      const std::size_t variant = i % (pair.variants.size() + 1);
      const TriangleMesh& E = variant == 0 ? pair.E : pair.variants[variant - 1][0];
      const TriangleMesh& F = variant == 0 ? pair.F : pair.variants[variant - 1][1];
      const FeaturePair features(E, F);
      const DrawnPose drawn = draw_pose(Stratum::degenerate, features, random_for(Stratum::degenerate, i));
      EXPECT_TRUE(drawn.exact) << pair.name << ' ' << i << ' ' << drawn.construction;
      ++constructions[std::string(drawn.construction)];
      // Stacked are the boxes about the bodies: these meet for certain where they are boxes themselves.
      const bool boxes =
          features.E.axis_faces.size() == E.faces.size() && features.F.axis_faces.size() == F.faces.size();
      const bool of_points = drawn.construction == "edge across edge" || (drawn.construction == "stacked" && !boxes);
      if (!of_points && drawn.pose.A.cwiseAbs().sum() == 3) {
        EXPECT_TRUE(has_vertex_in_a_plane(E, F, drawn.pose)) << pair.name << ' ' << i << drawn.construction;
      }
    }
  }
  for (const char* construction :
       {"vertex on vertex", "vertex on edge", "vertex on face", "edge across edge", "edge in face",
        "coplanar faces, opposed", "coplanar faces, flush", "identical bodies", "slid along an edge", "stacked"})
    EXPECT_GT(constructions[construction], 5) << construction;
}

TEST(Strata, NearDegeneratePosesAreMovedByAFewUlpsOnly) {
  const FeaturePair pair(cube(), cube());
  for (std::uint64_t i = 0; i < 200; ++i) {
    PoseRandom random = random_for(Stratum::near_degenerate, i);
    const Pose exact = detail::draw_degenerate(pair, random).pose;
    const DrawnPose moved = draw_pose(Stratum::near_degenerate, pair, random_for(Stratum::near_degenerate, i));
    const double distance = (moved.pose.r - exact.r).cwiseAbs().maxCoeff();
    EXPECT_GT(distance, 0);
    EXPECT_LE(distance, 8 * 0x1p-51);
    EXPECT_FALSE(moved.exact);
  }
}

TEST(RoundedVertices, BackwardErrorIsZeroForExactPosesAndAFewUlpsElse) {
  Pose pose;
  EXPECT_EQ(backward_error_ulps(cube(), pose), 0);
  const FeaturePair pair(cube(), ball());
  double greatest = 0;
  for (std::uint64_t i = 0; i < 200; ++i)
    greatest = std::max(
        greatest, backward_error_ulps(ball(), draw_pose(Stratum::generic, pair, random_for(Stratum::generic, i)).pose));
  EXPECT_GT(greatest, 0.5);
  EXPECT_LT(greatest, 4);
}

TEST(Pairs, AThirdOfThePosesFallsToLargePairs) {
  std::vector<std::string> missing;
  const std::vector<SurfacePair> pairs = built_in_pairs("", missing);
  EXPECT_EQ(missing.size(), 5U);
  double general = 0, large = 0;
  for (const SurfacePair& pair : pairs) {
    if (!pair.for_all_strata) continue;
    general += static_cast<double>(pair.share(Stratum::generic, Scheme::barycentric));
    if (pair.faces() >= 2000) large += static_cast<double>(pair.share(Stratum::generic, Scheme::barycentric));
  }
  EXPECT_GE(pairs.size(), 12U);
  // Four of six strata spread evenly over the general pairs.
  EXPECT_GE(large / general * 4 / 6, 1.0 / 3);
}

TEST(Pairs, AreFitForContactAndHaveNamesOfTheirOwn) {
  std::vector<std::string> missing;
  std::set<std::string> names;
  for (const SurfacePair& pair : built_in_pairs("", missing)) {
    EXPECT_TRUE(names.insert(pair.name).second) << pair.name;
    EXPECT_TRUE(pair.for_hard_strata || pair.for_all_strata) << pair.name;
    EXPECT_NO_THROW(require_fit(pair.E)) << pair.name;
    EXPECT_NO_THROW(require_fit(pair.F)) << pair.name;
    for (const auto& [E, F] : pair.variants) {
      EXPECT_NO_THROW(require_fit(E)) << pair.name << ' ' << E.name;
      EXPECT_NO_THROW(require_fit(F)) << pair.name << ' ' << F.name;
    }
  }
}

TEST(Pairs, ThatHurtComeInBothOrders) {
  std::vector<std::string> missing;
  const std::vector<SurfacePair> pairs = built_in_pairs("", missing);
  const auto named = [&](const std::string& name) -> const SurfacePair* {
    const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.name == name; });
    return found == pairs.end() ? nullptr : &*found;
  };
  int both = 0, open_slaves = 0, both_open = 0;
  for (const auto& [one, other] : {std::pair{"spike", "thin plate"},
                                   {"spike", "gridded cube"},
                                   {"needle", "cube"},
                                   {"thin plate", "cube"},
                                   {"shrinking cubes", "cube"},
                                   {"cube", "sheet"},
                                   {"cube", "tray"},
                                   {"tray", "sheet"},
                                   {"cube without a face", "small wedge"},
                                   {"hollow cube", "cube"},
                                   {"pentagram", "cube"},
                                   {"figure of eight", "cube"},
                                   {"pentagram", "figure of eight"},
                                   {"square chain", "square ring"},
                                   {"torus chain", "torus"}}) {
    const SurfacePair* pair = named(std::string(one) + "-" + other);
    const SurfacePair* exchanged = named(std::string(other) + "-" + one);
    ASSERT_TRUE(pair && exchanged) << one << ' ' << other;
    EXPECT_EQ(pair->E.vertices, exchanged->F.vertices) << one << ' ' << other;
    EXPECT_EQ(pair->F.faces, exchanged->E.faces) << one << ' ' << other;
    EXPECT_EQ(pair->for_hard_strata, exchanged->for_hard_strata) << one << ' ' << other;
    for (const Stratum stratum : kStrata)
      for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
        EXPECT_EQ(pair->share(stratum, scheme), exchanged->share(stratum, scheme)) << one << ' ' << other;
    const bool closed_E = check(pair->E).closed(), closed_F = check(pair->F).closed();
    ++both;
    open_slaves += closed_E != closed_F;
    both_open += !closed_E && !closed_F;
  }
  EXPECT_EQ(both, 15);
  EXPECT_EQ(open_slaves, 3);
  EXPECT_EQ(both_open, 1);
  const SurfacePair* tetrahedra = named("lattice tetrahedra");
  ASSERT_TRUE(tetrahedra);
  EXPECT_EQ(tetrahedra->variants.size(), 47U);
  EXPECT_GT(tetrahedra->share(Stratum::degenerate, Scheme::clipped), kWholeShare);
  const SurfacePair* blocks = named("sunken blocks");
  ASSERT_TRUE(blocks);
  ASSERT_EQ(blocks->variants.size(), 47U);
  EXPECT_EQ(blocks->variants[0][0].vertices, blocks->F.vertices);
  EXPECT_EQ(blocks->variants[0][1].vertices, blocks->E.vertices);
}

}  // namespace
}  // namespace pcm::compare
