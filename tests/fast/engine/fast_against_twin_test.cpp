// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The engine against the brute-force twin on small meshes: everything discrete to the last item, areas and volume
// within a bound derived from the pose.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <utility>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "pcm/engine.h"
#include "tests/reference/brute_force/combinatorics.h"
#include "tests/reference/brute_force/twin_comparison.h"

namespace pcm::brute_force {
namespace {

/// The engine's answer in the twin's words.
Combinatorics combinatorics_of(const fast::Contact& contact) {
  return brute_force::combinatorics_of(contact, [&](const fast::Polygon& polygon) {
    return std::span(contact.crossings)
        .subspan(static_cast<std::size_t>(polygon.first), static_cast<std::size_t>(polygon.count));
  });
}

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

double length(const Vector& x, const Rational& unit) {
  return rounded({Root{unit, dot(x, x)}});
}

/// Greatest edge of a face.
double longest_edge(const Body& body, Index face, const Rational& unit) {
  double result = 0;
  for (int i = 0; i < 3; ++i)
    result = std::max(result, length(body.corner(face, (i + 1) % 3) - body.corner(face, i), unit));
  return result;
}

/// Greatest distance of a vertex from the origin.
double greatest_length(const Scene& scene) {
  double size = 0;
  for (const Body* body : {&scene.E, &scene.F})
    for (const Vector& x : body->vertices) size = std::max(size, length(x, scene.unit));
  return size;
}

/// How far the engine's areas may be off. With S the greatest coordinate, a vertex is known to eps S about a point of
/// the patch, its height above a face of longest edge L and doubled area N to a few eps S L^2 / N, and the crossing of
/// an edge of length l whose ends are D apart in height to l / D of that (never by more than l: it is clamped into its
/// edge). A crossing moved by dx moves the boundary of the part inside by dx times the length of the adjoining chords.
double area_bound(const Answer& twin) {
  const Scene& scene = twin.scene;
  const double size = greatest_length(scene);
  double bound = 0;
  for (const Body* body : {&scene.E, &scene.F})
    for (Index f = 0; f < std::ssize(body->faces); ++f)
      bound += 16 * kEpsilon * size * longest_edge(*body, f, scene.unit);
  for (const auto& [crossing, position] : twin.positions) {
    const Body& edges = scene.body(crossing.edge_side);
    const Body& faces = scene.body(other(crossing.edge_side));
    const Vector along = edges.vertices[crossing.edge[1]] - edges.vertices[crossing.edge[0]];
    const Vector& N = faces.normals[crossing.face];
    const double l = length(along, scene.unit);
    const double L = longest_edge(faces, crossing.face, scene.unit);
    const double slope = std::abs(rounded(Rational(dot(along, N) * scene.unit * scene.unit * scene.unit)));  // D N
    const double moved = slope > 0 ? std::min(l, 16 * kEpsilon * size * L * L * l / slope) : 16 * kEpsilon * size;
    bound += 4 * moved * (l + L);
  }
  return bound;
}

/// The engine moves coplanar faces as the tie rule has it: between the bounds; without them, the area is one number.
void expect_area(const ActiveArea& twin, const fast::ActiveArea& found, bool closed_other, double bound) {
  if (closed_other) {
    EXPECT_GE(found.area, twin.open - bound);
    EXPECT_LE(found.area, twin.closed + bound);
  }
  EXPECT_NEAR(found.area, twin.perturbed_area, bound);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found.vector_area_Me[i], twin.perturbed_vector_area[i], bound);
}

Answer compare(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  Answer twin = answer(E, F, pose, reference::Problem::rounded, Mode::both);
  fast::Workspace workspace;
  const fast::Pairing pairing(fast::Surface(E), fast::Surface(F), {}, Mode::both);
  const fast::Contact& contact = fast::evaluate(pairing, pose, {}, {}, workspace);
  EXPECT_EQ(difference(combinatorics_of(twin), combinatorics_of(contact)), "");
  const double bound = area_bound(twin);
  expect_area(twin.E, contact.E, twin.scene.F.closed, bound);
  expect_area(twin.F, contact.F, twin.scene.E.closed, bound);
  EXPECT_EQ(contact.has_volume, twin.volume.has_value());
  // A third of the areas' flux about a point of the patch, no farther than both surfaces' size from either area.
  if (twin.perturbed_volume) {
    EXPECT_NEAR(contact.volume, *twin.perturbed_volume, 2 * bound * greatest_length(twin.scene));
  }
  return twin;
}

TEST(FastAgainstTwin, AgreesOnTheDegenerateCatalogue) {
  compare_on_catalogue(compare);
}

/// Open strips stand in a closed body's top: what it has beside them is on neither side. Their borders end within faces
/// whose corners hang together all around.
TEST(FastAgainstTwin, AgreesWhereOpenStripsLeaveFacesAmbiguous) {
  constexpr unsigned kSeed = 5;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const TriangleMesh E = generate::gridded_box({2, 2, 2}, {6, 6, 1});
  int ambiguous = 0;
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", pose " + std::to_string(i));
    TriangleMesh strips;
    for (int k = 0; k < 4; ++k) {
      const Eigen::Matrix3d upright =
          Eigen::AngleAxisd(3 * uniform(random), Eigen::Vector3d::UnitZ()).toRotationMatrix() *
          Eigen::AngleAxisd(1.5 + 0.3 * uniform(random), Eigen::Vector3d::UnitX()).toRotationMatrix();
      const Eigen::Vector3d middle(0.7 * uniform(random), 0.7 * uniform(random), 1);
      TriangleMesh strip = generate::rectangle(0.4 + 0.2 * uniform(random), 0.5);
      for (Eigen::Vector3d& x : strip.vertices) x = upright * x + middle;
      strips = degenerate::joined(std::move(strips), strip);
    }
    ambiguous += compare(E, strips, {}).ambiguous ? 1 : 0;
  }
  EXPECT_GT(ambiguous, 10);
}

TEST(FastAgainstTwin, AgreesWhereFacesLieInAPocket) {
  compare_in_a_pocket(compare);
}

class FastAgainstTwinPoses : public testing::TestWithParam<Series> {};

TEST_P(FastAgainstTwinPoses, Agree) {
  compare_on_trials(GetParam(), 40, compare);
}

INSTANTIATE_TEST_SUITE_P(Kinds, FastAgainstTwinPoses, kAllSeries, series_name);

}  // namespace
}  // namespace pcm::brute_force
