// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// What can be said against a surface (PCM section 2).
enum class MeshIssueKind : std::uint8_t {
  no_faces,
  non_finite_vertices,
  indices_out_of_range,
  repeated_vertices,
  zero_area_faces,
  duplicate_vertices,
  non_manifold_edges,
  pinched_vertices,
  inconsistent_orientation,
  inside_out_components,
  possible_cavities,
  unused_vertices,
  border_edges,
};

/// An error makes a surface unfit for contact, a warning is worth a look, a note describes it.
enum class Severity : std::uint8_t { error, warning, note };

/// One kind of issue as text: how many, the first few by the numbers of an OBJ file (from 1), and what mends them.
struct MeshIssue {
  MeshIssueKind kind = MeshIssueKind::no_faces;
  Severity severity = Severity::error;
  std::size_t count = 0;
  std::string text;
};

/// An edge with the faces at it, ascending.
struct EdgeFaces {
  std::array<Index, 2> edge{};
  std::vector<Index> faces;
};

/// A closed component of the wrong orientation.
struct InsideOutComponent {
  Index component = 0;
  Index first_face = 0;
  Index face_count = 0;
  Index enclosing = 0;  ///< how many other closed components lie around it
  int volume_sign = 0;  ///< of its enclosed volume; 0 where it encloses none at all
};

/// All that check() found, as data; indices count from 0, in ascending order.
struct MeshReport {
  std::string name;
  Index vertex_count = 0;
  Index face_count = 0;

  std::vector<Index> non_finite_vertices;
  std::vector<Index> out_of_range_faces;
  std::vector<Index> repeated_vertex_faces;
  std::vector<Index> zero_area_faces;                    ///< three distinct vertices exactly on one line
  std::vector<std::array<Index, 2>> duplicate_vertices;  ///< the first vertex at a place, and a later one there
  std::vector<EdgeFaces> non_manifold_edges;             ///< more than two faces
  std::vector<Index> pinched_vertices;                   ///< more than one fan of faces
  std::vector<EdgeFaces> flipped_edges;                  ///< two faces that both run along it in the same direction
  std::vector<InsideOutComponent> inside_out;
  /// Closed components that would be inside out, but may be cavities of an open component whose box encloses theirs.
  std::vector<InsideOutComponent> possible_cavities;
  std::vector<Index> unused_vertices;
  std::vector<std::array<Index, 2>> border_edges;  ///< one face; in the direction in which that face runs along it

  /// Connected by shared edges, numbered by their first faces; -1 for faces left out for a bad or repeated index.
  std::vector<Index> component_of_face;
  Index component_count = 0;
  /// Components without a border, each edge of which is shared by two faces that run along it in opposite directions.
  Index closed_component_count = 0;

  /// A surface the model is defined for; it may be open.
  bool fit() const;
  /// Every component is closed.
  bool closed() const;
  /// What there is to say, errors first.
  std::vector<MeshIssue> issues() const;
  /// The whole report as text of several lines, the last one without a line feed.
  std::string summary() const;
};

/// Examines a surface (PCM section 2): at most two faces an edge, one fan a vertex, no repeated vertex in a face, no
/// duplicate vertices (-0 equals 0), no zero-area face, consistent orientation, closed components oriented outward, or
/// inward where an odd number of others encloses them. What an open component encloses isn't defined, so
/// an inward component within the bounding box of an open one is warned of as a possible cavity. Unused vertices are
/// warned of, borders noted: an open surface is fit. A crack shows as duplicate vertices. Self-intersection is not
/// looked for.
///
/// Every verdict is exact. Faces with an index that is bad or repeated are left out of the further tests, and so are
/// vertices that are not finite of those that need coordinates. Never throws BadInput. Cost: O(n log n); a million
/// faces take about half a second. Nothing recursive.
MeshReport check(const TriangleMesh& mesh);

/// Throws BadInput where the surface is unfit, saying in one line what is wrong, where, and what mends it.
void require_fit(const MeshReport& report);
void require_fit(const TriangleMesh& mesh);

}  // namespace pcm
