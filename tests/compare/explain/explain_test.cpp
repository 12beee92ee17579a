// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Margins, features, signs and other answers, each beside what follows from the coordinates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "compare/explain/explain.h"
#include "fast/predicates/orientation.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "meshes/generate/round.h"

namespace pcm::compare {
namespace {

Explanation explained(const degenerate::Case& named, const Eigen::Vector3d& moved = Eigen::Vector3d::Zero(),
                      const ExplainOptions& options = {}) {
  const Eigen::Vector3d r = named.r + moved;
  return Explainer(named.E, named.F, Mode::both, Scheme::barycentric).explain({named.A, r}, options);
}

double ulp(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
}

/// E's scale in these poses is 4, its block's extent.
constexpr double kUlpOf4 = 0x1p-50;

TEST(Explain, NamesTheFeatures) {
  // The block's corner (4, 4, 2) is the last vertex of its top, F's tip its first vertex.
  const degenerate::Case named = degenerate::find_case("vertex_on_vertex");
  const Explanation explanation = explained(named);
  ASSERT_EQ(explanation.listed.size(), 1U);
  const Coincidence& c = explanation.listed[0].coincidence;
  EXPECT_EQ(named.E.vertices[static_cast<std::size_t>(c.features[0].index[0])], Eigen::Vector3d(4, 4, 2));
  EXPECT_EQ(c.features[0].side, Side::E);
  EXPECT_EQ(c.features[1], vertex_feature(Side::F, 0));
  EXPECT_EQ(c.position_Me, Eigen::Vector3d(4, 4, 2));
  EXPECT_EQ(c.margin, 0);
}

TEST(Explain, NamesEdgesByTheirEndsAndFacesByTheirNumbers) {
  const degenerate::Case edges = degenerate::find_case("edge_across_edge");
  const Explanation crossing = explained(edges);
  ASSERT_EQ(crossing.listed.size(), 1U);
  const auto& [on_E, on_F] = crossing.listed[0].coincidence.features;
  // Of the ridge and the keel the first two vertices are the ends of these edges.
  EXPECT_EQ(on_E, edge_feature(Side::E, {0, 1}));
  EXPECT_EQ(on_F, edge_feature(Side::F, {0, 1}));

  const degenerate::Case faces = degenerate::find_case("vertex_on_face");
  const Explanation inside = explained(faces);
  ASSERT_EQ(inside.listed.size(), 1U);
  const Feature face = inside.listed[0].coincidence.features[0];
  ASSERT_EQ(face.kind, FeatureKind::face);
  // (3, 1, 2) lies in the part of the top with x > y.
  double x = 0, y = 0;
  for (const Index v : faces.E.faces[static_cast<std::size_t>(face.index[0])]) {
    const Eigen::Vector3d& corner = faces.E.vertices[static_cast<std::size_t>(v)];
    EXPECT_EQ(corner.z(), 2);
    x += corner.x();
    y += corner.y();
  }
  EXPECT_GT(x, y);
}

TEST(Explain, MarginsAreNumbersOfUlps) {
  const degenerate::Case on_face = degenerate::find_case("vertex_on_face");
  const degenerate::Case on_vertex = degenerate::find_case("vertex_on_vertex");
  const degenerate::Case across = degenerate::find_case("edge_across_edge");
  const auto expect_margin = [](const degenerate::Case& named, CoincidenceKind kind, double ulps) {
    const Explanation explanation = explained(named, {0, 0, ulps * kUlpOf4});
    EXPECT_EQ(explanation.ulp, kUlpOf4);
    EXPECT_EQ(explanation.total().exact, 0U);
    ASSERT_EQ(explanation.total().near, 1U) << named.name << " moved by " << ulps;
    EXPECT_EQ(explanation.count(kind).near, 1U) << named.name << " moved by " << ulps;
    EXPECT_EQ(explanation.listed[0].coincidence.margin, std::abs(ulps) * kUlpOf4);
  };
  for (const double ulps : {-8.0, -1.0, 0.5, 1.0, 3.0, 8.0})
    expect_margin(on_face, CoincidenceKind::vertex_on_face, ulps);
  // Below the corner lies an edge.
  for (const double ulps : {0.5, 1.0, 3.0, 8.0}) expect_margin(on_vertex, CoincidenceKind::vertex_on_vertex, ulps);
  // The scale of ridge and keel is 1.
  const Explanation near = explained(across, {0, 0, 3 * 0x1p-52});
  EXPECT_EQ(near.ulp, 0x1p-52);
  EXPECT_EQ(near.count(CoincidenceKind::edge_across_edge).near, 1U);
  ASSERT_EQ(near.listed.size(), 1U);
  EXPECT_EQ(near.listed[0].coincidence.margin, 3 * 0x1p-52);
  EXPECT_EQ(near.listed[0].coincidence.apart_Me, Eigen::Vector3d(0, 0, 1));
}

TEST(Explain, ANearVertexIsToldOnce) {
  // The tip is near to edges and faces at the corner as well, where its projections lie.
  const Explanation explanation =
      explained(degenerate::find_case("vertex_on_vertex"), {-kUlpOf4, -2 * kUlpOf4, kUlpOf4});
  EXPECT_EQ(explanation.total().exact, 0U);
  EXPECT_EQ(explanation.total().near, 1U);
  ASSERT_EQ(explanation.count(CoincidenceKind::vertex_on_vertex).near, 1U);
  EXPECT_EQ(explanation.listed[0].coincidence.margin, std::sqrt(6.0) * kUlpOf4);
}

TEST(Explain, BeyondTheLimitNothingIsNear) {
  const degenerate::Case named = degenerate::find_case("vertex_on_face");
  EXPECT_EQ(explained(named, {0, 0, 8.5 * kUlpOf4}).total().near, 0U);
  EXPECT_EQ(explained(named, {0, 0, 8.5 * kUlpOf4}, {.near_ulps = 9}).total().near, 1U);
}

TEST(Explain, NearlyCoplanarFacesAreNamed) {
  const degenerate::Case named = degenerate::find_case("stacked_boxes");
  const Explanation explanation = explained(named, {0, 0, 2 * ulp(2)});
  EXPECT_EQ(explanation.total().exact, 0U);
  EXPECT_EQ(explanation.count(CoincidenceKind::coplanar_faces).near, 2U);
  EXPECT_EQ(explanation.count(CoincidenceKind::edge_along_edge).near, 5U);
  for (const ListedCoincidence& listed : explanation.listed) EXPECT_EQ(listed.coincidence.margin, 2 * ulp(2));
}

TEST(Explain, LinesNearAnEdgeAreNamed) {
  const degenerate::Case named = degenerate::find_case("penetration_line_through_edge");
  // The keel's lower edge lies in y = 0; E's scale is 9.
  const double step = ulp(8);
  const Explanation explanation = explained(named, {0, 2 * step, 0});
  EXPECT_EQ(explanation.ulp, step);
  EXPECT_EQ(explanation.count(CoincidenceKind::line_through_edge).exact, 0U);
  ASSERT_EQ(explanation.count(CoincidenceKind::line_through_edge).near, 1U);
  EXPECT_EQ(explanation.listed[0].coincidence.margin, 2 * step);
}

TEST(Explain, OfAGenericPoseNothingCoincides) {
  const Explainer explainer(generate::icosphere(0.5, 2), generate::icosphere(0.4, 2), Mode::both, Scheme::barycentric);
  const Explanation explanation = explainer.explain({Eigen::Matrix3d::Identity(), {0.31, 0.17, 0.43}});
  EXPECT_TRUE(explanation.answer.touching);
  EXPECT_EQ(explanation.total().exact + explanation.total().near, 0U);
  EXPECT_TRUE(explanation.listed.empty());
  ASSERT_TRUE(explanation.nearest.has_value());
  ASSERT_TRUE(explanation.next.has_value());
  EXPECT_GT(explanation.free_distance, 0);
  EXPECT_LE(explanation.free_distance, explanation.nearest->margin);
  EXPECT_GE(explanation.next->distance, explanation.free_distance);
  EXPECT_FALSE(explanation.next->answer == explanation.answer);
}

TEST(Explain, NoAnswerChangesWithinTheFreeDistance) {
  const Explainer explainer(generate::icosphere(0.5, 1), generate::icosphere(0.4, 1), Mode::both, Scheme::barycentric);
  const Pose pose{Eigen::Matrix3d::Identity(), {0.31, 0.17, 0.43}};
  const Explanation explanation = explainer.explain(pose);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        Pose moved = pose;
        moved.r += 0.999 * explanation.free_distance * Eigen::Vector3d(x, y, z).normalized();
        EXPECT_EQ(explainer.explain(moved).answer, explanation.answer);
      }
}

TEST(Explain, SeparatedBodiesAreFreeAsFarAsTheyAreApart) {
  const Explainer explainer(generate::box({0, 0, 0}, {1, 1, 1}), generate::box({0, 0, 0}, {1, 1, 1}), Mode::E,
                            Scheme::barycentric);
  const double gap = 0x1p-20;
  const Explanation explanation = explainer.explain({Eigen::Matrix3d::Identity(), {0.25, 0.5, 1 + gap}});
  EXPECT_FALSE(explanation.answer.touching);
  ASSERT_TRUE(explanation.nearest.has_value());
  EXPECT_EQ(explanation.nearest->margin, gap);
  EXPECT_NEAR(explanation.free_distance, gap, 1e-14);
  ASSERT_TRUE(explanation.next.has_value());
  // At the gap itself the tie rule lifts E into F: that is the nearest pose with another answer.
  EXPECT_EQ(explanation.next->distance, gap);
  EXPECT_EQ(explanation.next->direction, Eigen::Vector3d(0, 0, -1));
  EXPECT_TRUE(explanation.next->answer.touching);
}

TEST(Explain, UnitCubesTouchAboveAndNotBelow) {
  const TriangleMesh cube = generate::box({0, 0, 0}, {1, 1, 1});
  const Explainer explainer(cube, cube, Mode::E, Scheme::barycentric);
  for (const double z : {1.0, -1.0}) {
    const Explanation explanation = explainer.explain({Eigen::Matrix3d::Identity(), {0, 0, z}});
    EXPECT_EQ(explanation.answer.touching, z > 0);
    EXPECT_EQ(explanation.free_distance, 0);
    ASSERT_TRUE(explanation.next.has_value());
    EXPECT_LE(explanation.next->distance, ulp(1));
    EXPECT_FALSE(explanation.next->answer == explanation.answer);
    for (const ListedCoincidence& listed : explanation.listed)
      for (const Sign& sign : listed.signs) {
        EXPECT_EQ(sign.exact, 0);
        EXPECT_EQ(sign.stage, Stage::tie_rule);
        ASSERT_FALSE(sign.term.empty());
      }
  }
}

TEST(Explain, TheTieRulesTermIsTheFirstThatIsNotZero) {
  // F's tip in the plane z = 2 of E's face: the determinant's first moved coordinate is z of the face's vertex that
  // comes first in E's file. Its coefficient is the orientation of the other three points seen along z, which is not 0.
  const degenerate::Case named = degenerate::find_case("vertex_on_face");
  const Explanation explanation = explained(named);
  ASSERT_EQ(explanation.listed[0].signs.size(), 1U);
  const Sign& sign = explanation.listed[0].signs[0];
  const Triangle& t = named.E.faces[static_cast<std::size_t>(explanation.listed[0].coincidence.features[0].index[0])];
  ASSERT_EQ(sign.term.size(), 1U);
  EXPECT_EQ(sign.term[0], (MovedCoordinate{Side::E, *std::min_element(t.begin(), t.end()), 2}));
  // E's top is lifted above the tip.
  EXPECT_EQ(sign.decided, -1);
  EXPECT_TRUE(explanation.answer.touching);
}

TEST(Explain, SaysWhoDecides) {
  const auto sign_at = [](const Eigen::Vector3d& r) {
    const TriangleMesh corner = degenerate::tetrahedron({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    const Explainer explainer(corner, degenerate::spike(), Mode::E, Scheme::clipped);
    const Explanation explanation =
        explainer.explain({Eigen::Matrix3d::Identity(), r}, {.near_ulps = 1e6, .listed = 1000});
    for (const ListedCoincidence& listed : explanation.listed)
      if (listed.coincidence.kind == CoincidenceKind::vertex_on_face &&
          listed.coincidence.features[1] == vertex_feature(Side::F, 0))
        return std::pair(listed.coincidence.margin, listed.signs.at(0));
    ADD_FAILURE() << "the spike's tip is not near the slanted face";
    return std::pair(0.0, Sign{});
  };
  // The slanted face lies in x + y + z = 1. The doubles 0.1, 0.2 and 0.7 make 1 - 2^-55, 0.3, 0.3 and 0.4 make 1.
  const auto [tie_margin, tie] = sign_at({0.3, 0.3, 0.4});
  EXPECT_EQ(tie_margin, 0);
  EXPECT_EQ(tie.stage, Stage::tie_rule);
  EXPECT_EQ(tie.exact, 0);
  EXPECT_NE(tie.decided, 0);
  const auto [exact_margin, exact] = sign_at({0.1, 0.2, 0.7});
  EXPECT_DOUBLE_EQ(exact_margin, 0x1p-55 / std::sqrt(3.0));
  EXPECT_EQ(exact.stage, Stage::exact);
  EXPECT_EQ(exact.exact, -1);
  EXPECT_EQ(exact.decided, -1);
  EXPECT_TRUE(exact.term.empty());
  const auto [sure_margin, sure] = sign_at({0.1, 0.2, 0.7 + 0x1p-40});
  EXPECT_NEAR(sure_margin, 0x1p-40 / std::sqrt(3.0), 1e-16);
  EXPECT_EQ(sure.stage, Stage::filter);
  EXPECT_EQ(sure.decided, 1);
}

TEST(Explain, AnotherAnswerIsAnUlpAwayFromATie) {
  // F's tip at z = 2 touches by the tie rule; one double higher it does not.
  const Explanation explanation = explained(degenerate::find_case("vertex_on_face"));
  ASSERT_TRUE(explanation.next.has_value());
  EXPECT_LE(explanation.next->distance, ulp(2));
  EXPECT_FALSE(explanation.next->answer.touching);
}

TEST(Explain, ListsTheNearestAndCountsTheRest) {
  const degenerate::Case named = degenerate::find_case("stacked_boxes");
  const Explanation all = explained(named, Eigen::Vector3d::Zero(), {.listed = 1000});
  const Explanation some = explained(named, Eigen::Vector3d::Zero(), {.listed = 3});
  EXPECT_EQ(all.left_out, 0U);
  EXPECT_EQ(some.listed.size(), 3U);
  EXPECT_EQ(some.listed.size() + some.left_out, all.listed.size());
  EXPECT_EQ(some.total().exact, all.total().exact);
  EXPECT_TRUE(
      std::is_sorted(all.listed.begin(), all.listed.end(), [](const ListedCoincidence& a, const ListedCoincidence& b) {
        return a.coincidence.margin < b.coincidence.margin;
      }));
}

}  // namespace
}  // namespace pcm::compare
