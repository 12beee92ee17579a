// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// On every pose of the degenerate catalogue the reasons are named that its construction has. The table was worked out
// by hand from the coordinates of the bodies (meshes/generate/degenerate/), in mode both: all active faces have
// penetration lines. A box's faces are parted along the diagonal that joins the corners with the smaller and the
// greater coordinates in both directions of the face.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "compare/explain/explain.h"
#include "compare/explain/words.h"
#include "meshes/generate/degenerate/catalogue.h"

namespace pcm::compare::catalogue_test {
namespace {

using Kinds = std::set<CoincidenceKind>;
using enum CoincidenceKind;

const Kinds kNothing;

/// Boxes with a face in common whose diagonals coincide: so do corners, borders, diagonals and barycentres.
const Kinds kSameFaces{vertex_on_vertex, edge_along_edge, coplanar_faces, barycentre_on_face};

const std::map<std::string, Kinds>& reasons() {
  static const std::map<std::string, Kinds> all{
      // What is built to meet does, and nothing else.
      {"vertex_on_vertex", {vertex_on_vertex}},
      {"vertex_on_edge", {vertex_on_edge}},
      {"vertex_on_face", {vertex_on_face}},
      {"vertex_on_flat_edge", {vertex_on_edge}},
      {"vertex_under_edge", {vertex_on_edge}},
      {"edge_across_edge", {edge_across_edge}},
      {"edge_in_face", {vertex_on_face, edge_in_face}},
      {"edge_across_flat_edge", {vertex_on_face, edge_across_edge, edge_in_face}},
      {"edge_over_edge", {vertex_on_face, edge_across_edge, edge_in_face}},
      // The keel's end faces have barycentres (2 -+ 1/3, 4, 8/3) in the plane of E's flank y = 4, and lines that go
      // down
      // in it, through the edge in z = 2.
      {"parallel_coincident_edges", {vertex_on_edge, edge_along_edge, line_through_edge, line_in_face}},
      {"shared_edge", {vertex_on_vertex, edge_along_edge}},
      {"shared_vertex", {vertex_on_vertex}},
      // Besides the corner (2, 2, 2) of E on the edge through it, the edge (1, 1, 1)-(1, 3, 3) of F meets E's edge
      // y = z = 2 in (1, 2, 2); between the two that lies in F's face y = z. The barycentre (5/3, 5/3, 2) of F's face
      // (1, 1, 1), (3, 1, 2), (1, 3, 3) lies on the diagonal of E's top.
      {"edge_through_vertex", {vertex_on_edge, edge_across_edge, edge_in_face, line_through_edge}},
      // E's diagonal passes through two edges of F's face x = y at height 2. From F's lower face the line from
      // (7/3, 5/3, 5/3) along (-1, 1, 1) meets that diagonal in (2, 2, 2).
      {"line_along_flat_edge", {edge_across_edge, edge_in_face, line_through_edge}},
      // E's upper edge crosses the diagonal y = z of F's face x = 0. E's two end faces have barycentres
      // (0, -+1/3, -2/3) in that plane, and lines that stay in it until they leave it by a border.
      {"line_along_edge_of_E",
       {vertex_on_face, edge_across_edge, edge_in_face, barycentre_on_face, line_through_edge, line_in_face}},
      // The same, but the upper edge lies on F's border, and E's lower edge meets F's diagonal in (0, 0, -1).
      {"line_along_edges_of_both",
       {vertex_on_edge, edge_along_edge, edge_across_edge, barycentre_on_face, line_through_edge, line_in_face}},
      {"penetration_line_through_vertex", {line_through_vertex}},
      {"penetration_line_through_edge", {line_through_edge}},
      {"penetration_line_through_sheets", kNothing},
      // In the plane of F's face x = 4 it passes through that face's diagonal in (4, 2, 0) and its lower border.
      {"penetration_line_in_face", {line_through_edge, line_in_face}},
      {"penetration_line_along_edge", {line_through_vertex}},

      {"stacked_boxes", kSameFaces},
      // Both diagonals lie on the line x = y, from (0, 0) to (2, 2) and from (1, 1) to (3, 3). The barycentres of
      // either
      // lie beyond the other.
      {"stacked_boxes_partly", {vertex_on_edge, edge_across_edge, edge_along_edge, edge_in_face, coplanar_faces}},
      {"stacked_boxes_half",
       {vertex_on_edge, edge_across_edge, edge_along_edge, edge_in_face, coplanar_faces, barycentre_on_face}},
      {"small_box_on_large", {vertex_on_face, edge_in_face, coplanar_faces, barycentre_on_face}},
      // A barycentre (1/3, -1/3) lies on the other diagonal, y = -x.
      {"stacked_boxes_quarter_turn",
       {vertex_on_vertex, edge_along_edge, edge_across_edge, edge_in_face, coplanar_faces, line_through_edge}},
      // The same about x.
      {"stacked_boxes_half_turn",
       {vertex_on_vertex, edge_along_edge, edge_across_edge, edge_in_face, coplanar_faces, line_through_edge}},
      // E's barycentres are thirds into its squares of 3 m, as F's vertices are: (-2, -1), (1, 2) and so on.
      {"grids_a_third_apart",
       {vertex_on_face, edge_across_edge, edge_in_face, coplanar_faces, barycentre_on_face, line_through_vertex}},
      {"stacked_boxes_tiny", kSameFaces},
      {"stacked_boxes_huge", kSameFaces},
      {"stacked_boxes_far", kSameFaces},
      {"flush_flanks",
       {vertex_on_edge, edge_along_edge, edge_across_edge, edge_in_face, coplanar_faces, barycentre_on_face}},
      // E's barycentre (0, 2/3, 4/3) lies on the diagonal z = 2 y of F's flank.
      {"flush_flank_partly", {vertex_on_face, edge_across_edge, edge_in_face, coplanar_faces, line_through_edge}},
      {"identical_boxes", kSameFaces},
      {"identical_tetrahedra", kSameFaces},
      // About the z axis turned by a right angle, x flanks fall on flanks with the same diagonals or with crossing
      // ones.
      {"identical_boxes_quarter_turn",
       {vertex_on_vertex, edge_along_edge, edge_across_edge, edge_in_face, coplanar_faces, barycentre_on_face,
        line_through_edge}},
      {"identical_boxes_less_than_an_ulp_apart", kSameFaces},
      {"sliver", kNothing},
      // From the long flanks' barycentres at x = 11/3, z = 11/6 lines pass through the diagonals z = x / 2 of E's.
      {"sliver_flush",
       {vertex_on_face, edge_across_edge, edge_in_face, coplanar_faces, barycentre_on_face, line_through_edge}},
      {"needle", kNothing},

      {"nested_box", kNothing},
      {"nested_in_box", kNothing},
      {"box_in_cavity", kNothing},
      {"box_filling_cavity", kSameFaces},
      // F's edges x = y = 2 and so on meet the diagonals of the cavity's walls, the cavity's edges those of F's faces.
      // F's
      // barycentre (2, 3/2, 1) lies in the plane of a wall, and so does its line.
      {"box_through_cavity_wall", {edge_across_edge, barycentre_on_face, line_through_edge, line_in_face}},
      {"nested_in_cavity_wall", kNothing},
      {"ring_on_plate", kNothing},
      // Two of the ring's four lower edges cross the plate's diagonal, in (1, 1, 0) and (-1, -1, 0).
      {"ring_resting_on_plate", {vertex_on_face, edge_across_edge, edge_in_face}},
      // E's barycentres (11/3, 2/3) and (4/3, 7/3) lie above the diagonals of F's squares, F's (4/3, 2/3) and
      // (11/3, 7/3) below E's diagonal, 7 (y + 1) = 5 (x + 1).
      {"holed_plate_in_plate", {line_through_edge}},
      {"holed_plate_resting_on_plate",
       {vertex_on_face, edge_across_edge, edge_in_face, coplanar_faces, barycentre_on_face, line_through_edge}},
      // Each flank of a pin, from z = -1 to 1/2, has a barycentre in z = 0, the plane of E's lower face, and its line
      // there.
      {"two_pins_under_plate", {barycentre_on_face, line_through_edge, line_in_face}},
      {"open_border_inside_patch", kNothing},
      {"open_border_on_face", {vertex_on_face, edge_in_face}},
      // F's diagonal passes through E's edge in (4, 1, 2).
      {"open_border_across_edge", {edge_across_edge}},
      {"bubble_in_open_container", kNothing},
  };
  return all;
}

Kinds exact_kinds(const Explanation& explanation) {
  Kinds kinds;
  for (std::size_t k = 0; k < kCoincidenceKinds; ++k)
    if (explanation.counts[k].exact > 0) kinds.insert(static_cast<CoincidenceKind>(k));
  return kinds;
}

std::string text(const Kinds& kinds) {
  std::string list;
  for (const CoincidenceKind kind : kinds) list += std::string(words(kind).key) + " ";
  return list;
}

Explanation explained(const degenerate::Case& named, Scheme scheme = Scheme::barycentric) {
  return Explainer(named.E, named.F, Mode::both, scheme).explain({named.A, named.r});
}

TEST(ExplainCatalogue, NamesTheReasonOnEveryEntry) {
  std::size_t entries = 0;
  for (const degenerate::Case& named : degenerate::catalogue()) {
    ASSERT_TRUE(reasons().contains(named.name)) << named.name << " is not in the table";
    const Explanation explanation = explained(named);
    EXPECT_EQ(text(exact_kinds(explanation)), text(reasons().at(named.name))) << named.name;
    EXPECT_TRUE(explanation.oracle_agrees) << named.name;
    ++entries;
  }
  EXPECT_EQ(entries, reasons().size());
}

TEST(ExplainCatalogue, ClippedContactsHaveNoLinesToName) {
  const Explanation explanation = explained(degenerate::find_case("penetration_line_through_edge"), Scheme::clipped);
  EXPECT_EQ(text(exact_kinds(explanation)), "");
}

/// Numbers of coincidences by kind.
using Counts = std::map<CoincidenceKind, std::size_t>;

TEST(ExplainCatalogue, CountsWhatCoincides) {
  const std::map<std::string, Counts> expected{
      {"vertex_on_face", {{vertex_on_face, 1}}},
      {"edge_across_edge", {{edge_across_edge, 1}}},
      // Both ends of the edge, from (1, 2, 2) to (3, 2, 2), and the diagonal that parts the two faces.
      {"edge_across_flat_edge", {{vertex_on_face, 2}, {edge_across_edge, 1}, {edge_in_face, 2}}},
      {"shared_edge", {{vertex_on_vertex, 2}, {edge_along_edge, 1}}},
      {"small_box_on_large", {{vertex_on_face, 4}, {edge_in_face, 5}, {coplanar_faces, 2}, {barycentre_on_face, 3}}},
      // Four sides and the diagonal.
      {"stacked_boxes", {{vertex_on_vertex, 4}, {edge_along_edge, 5}, {coplanar_faces, 2}, {barycentre_on_face, 4}}},
      {"ring_resting_on_plate", {{vertex_on_face, 4}, {edge_across_edge, 2}, {edge_in_face, 6}}},
  };
  for (const auto& [name, counts] : expected) {
    const Explanation explanation = explained(degenerate::find_case(name));
    for (std::size_t k = 0; k < kCoincidenceKinds; ++k) {
      const auto found = counts.find(static_cast<CoincidenceKind>(k));
      EXPECT_EQ(explanation.counts[k].exact, found == counts.end() ? 0 : found->second)
          << name << ", " << words(static_cast<CoincidenceKind>(k)).key;
    }
  }
}

TEST(ExplainCatalogue, TellsOppositeFromEqualNormals) {
  for (const auto& [name, equal] : {std::pair("stacked_boxes", false), std::pair("identical_boxes", true)}) {
    const Explanation explanation = explained(degenerate::find_case(name));
    ASSERT_FALSE(explanation.listed.empty());
    const Coincidence& first = explanation.listed.front().coincidence;
    ASSERT_EQ(first.kind, coplanar_faces) << name;
    EXPECT_EQ(first.equal_normals, equal) << name;
  }
}

}  // namespace
}  // namespace pcm::compare::catalogue_test
