// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <span>
#include <utility>

#include "meshes/base/floating_point_environment.h"
#include "meshes/base/union_find.h"
#include "meshes/exact/exact_signs.h"
#include "meshes/validity/edge_table.h"
#include "meshes/validity/enclosure.h"

namespace pcm {
namespace {

bool is_out_of_range(const Triangle& face, std::size_t vertex_count) {
  return std::any_of(face.begin(), face.end(),
                     [&](Index v) { return v < 0 || static_cast<std::size_t>(v) >= vertex_count; });
}

/// Sorts out the faces with bad or repeated indices; the others are usable.
std::vector<bool> find_usable_faces(const TriangleMesh& mesh, MeshReport& report) {
  std::vector<bool> usable(mesh.faces.size(), true);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    if (is_out_of_range(mesh.faces[f], mesh.vertices.size())) {
      report.out_of_range_faces.push_back(static_cast<Index>(f));
      usable[f] = false;
    } else if (a == b || b == c || c == a) {
      report.repeated_vertex_faces.push_back(static_cast<Index>(f));
      usable[f] = false;
    }
  }
  return usable;
}

void find_vertex_issues(const TriangleMesh& mesh, MeshReport& report) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Triangle& face : mesh.faces)
    for (const Index v : face)
      if (v >= 0 && static_cast<std::size_t>(v) < used.size()) used[v] = true;

  struct Place {
    Eigen::Vector3d position;
    Index vertex = 0;
  };
  std::vector<Place> places;
  places.reserve(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!used[v]) report.unused_vertices.push_back(static_cast<Index>(v));
    if (mesh.vertices[v].allFinite()) {
      places.push_back({mesh.vertices[v], static_cast<Index>(v)});
    } else {
      report.non_finite_vertices.push_back(static_cast<Index>(v));
    }
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    for (int k = 0; k < 3; ++k)
      if (a.position[k] != b.position[k]) return a.position[k] < b.position[k];
    return a.vertex < b.vertex;
  });
  for (std::size_t i = 0, first = 0; i < places.size(); ++i) {
    if (places[i].position != places[first].position) first = i;
    if (i != first) report.duplicate_vertices.push_back({places[first].vertex, places[i].vertex});
  }
  std::sort(report.duplicate_vertices.begin(), report.duplicate_vertices.end());
}

void find_zero_area_faces(const TriangleMesh& mesh, const std::vector<bool>& usable, MeshReport& report) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!usable[f]) continue;
    const Eigen::Vector3d& a = mesh.vertices[mesh.faces[f][0]];
    const Eigen::Vector3d& b = mesh.vertices[mesh.faces[f][1]];
    const Eigen::Vector3d& c = mesh.vertices[mesh.faces[f][2]];
    if (a.allFinite() && b.allFinite() && c.allFinite() && are_collinear(a, b, c))
      report.zero_area_faces.push_back(static_cast<Index>(f));
  }
}

EdgeFaces edge_with_faces(const EdgeTable& edges, std::size_t i) {
  EdgeFaces result{edges.ends(i), {}};
  for (const EdgeUse& use : edges.uses(i)) result.faces.push_back(use.face);
  return result;
}

void find_edge_issues(const EdgeTable& edges, MeshReport& report) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::span<const EdgeUse> uses = edges.uses(i);
    const auto& [low, high] = edges.ends(i);
    if (uses.size() == 1) {
      report.border_edges.push_back(uses[0].forward ? std::array{low, high} : std::array{high, low});
    } else if (uses.size() > 2) {
      report.non_manifold_edges.push_back(edge_with_faces(edges, i));
    } else if (uses[0].forward == uses[1].forward) {
      report.flipped_edges.push_back(edge_with_faces(edges, i));
    }
  }
}

/// A vertex has one fan where its corners, joined across the edges at the vertex, form one set.
void find_pinched_vertices(const TriangleMesh& mesh, const std::vector<bool>& usable, const EdgeTable& edges,
                           MeshReport& report) {
  std::vector<Index> fans(mesh.vertices.size(), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (usable[f])
      for (const Index v : mesh.faces[f]) ++fans[v];

  UnionFind corners(3 * mesh.faces.size());
  const auto corner_at_low_end = [](const EdgeUse& use) {
    return 3 * static_cast<std::size_t>(use.face) + (use.forward ? use.corner : (use.corner + 1U) % 3);
  };
  const auto corner_at_high_end = [](const EdgeUse& use) {
    return 3 * static_cast<std::size_t>(use.face) + (use.forward ? (use.corner + 1U) % 3 : use.corner);
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::span<const EdgeUse> uses = edges.uses(i);
    for (std::size_t k = 1; k < uses.size(); ++k) {
      if (corners.unite(corner_at_low_end(uses[0]), corner_at_low_end(uses[k]))) --fans[edges.ends(i)[0]];
      if (corners.unite(corner_at_high_end(uses[0]), corner_at_high_end(uses[k]))) --fans[edges.ends(i)[1]];
    }
  }
  for (std::size_t v = 0; v < fans.size(); ++v)
    if (fans[v] > 1) report.pinched_vertices.push_back(static_cast<Index>(v));
}

void find_components(const std::vector<bool>& usable, const EdgeTable& edges, MeshReport& report) {
  const std::size_t face_count = usable.size();
  UnionFind faces(face_count);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const EdgeUse& use : edges.uses(i)) faces.unite(edges.uses(i)[0].face, use.face);
  report.component_of_face.assign(face_count, -1);
  for (std::size_t f = 0; f < face_count; ++f) {
    if (!usable[f]) continue;
    const std::size_t first = faces.find(f);
    report.component_of_face[f] = first == f ? report.component_count++ : report.component_of_face[first];
  }
}

/// Whether each component is closed: every edge shared by two faces that run along it in opposite directions.
std::vector<bool> find_closed_components(const EdgeTable& edges, MeshReport& report) {
  std::vector<bool> closed(static_cast<std::size_t>(report.component_count), true);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::span<const EdgeUse> uses = edges.uses(i);
    if (uses.size() != 2 || uses[0].forward == uses[1].forward) closed[report.component_of_face[uses[0].face]] = false;
  }
  report.closed_component_count = static_cast<Index>(std::count(closed.begin(), closed.end(), true));
  return closed;
}

/// The bounding box of each component; one with a vertex that is not finite may have any.
std::vector<Eigen::AlignedBox3d> find_boxes(const TriangleMesh& mesh, const MeshReport& report) {
  std::vector<Eigen::AlignedBox3d> boxes(static_cast<std::size_t>(report.component_count));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (report.component_of_face[f] >= 0)
      for (const Index v : mesh.faces[f]) boxes[report.component_of_face[f]].extend(mesh.vertices[v]);
  return boxes;
}

/// Tells from the inside-out components those that may be cavities of an open one.
void set_possible_cavities_apart(const TriangleMesh& mesh, const std::vector<bool>& closed, MeshReport& report) {
  if (report.inside_out.empty() || report.closed_component_count == report.component_count) return;
  const std::vector<Eigen::AlignedBox3d> boxes = find_boxes(mesh, report);
  std::vector<InsideOutComponent> certain;
  for (const InsideOutComponent& component : report.inside_out) {
    bool in_open_one = false;
    for (std::size_t c = 0; c < boxes.size() && !in_open_one; ++c)
      in_open_one = !closed[c] && boxes[c].contains(boxes[component.component]);
    (in_open_one && component.volume_sign < 0 ? report.possible_cavities : certain).push_back(component);
  }
  report.inside_out = std::move(certain);
}

/// Closed components of finite vertices must enclose a positive volume, cavities a negative one.
void find_inside_out_components(const TriangleMesh& mesh, std::vector<bool> closed, MeshReport& report) {
  // Faces grouped by component, in file order within each.
  const std::size_t component_count = closed.size();
  std::vector<std::size_t> starts(component_count + 1, 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Index component = report.component_of_face[f];
    if (component < 0) continue;
    ++starts[static_cast<std::size_t>(component) + 1];
    for (const Index v : mesh.faces[f])
      if (!mesh.vertices[v].allFinite()) closed[component] = false;
  }
  for (std::size_t c = 0; c < component_count; ++c) starts[c + 1] += starts[c];
  std::vector<Triangle> grouped(starts.back());
  std::vector<Index> first_face(component_count, -1);
  std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
  std::vector<Index> closed_component_of_face = report.component_of_face;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Index component = report.component_of_face[f];
    if (component < 0) continue;
    if (first_face[component] < 0) first_face[component] = static_cast<Index>(f);
    grouped[next[component]++] = mesh.faces[f];
    if (!closed[component]) closed_component_of_face[f] = -1;
  }

  const std::vector<Index> enclosing =
      count_enclosing_components(mesh, closed_component_of_face, report.component_count);
  for (std::size_t c = 0; c < component_count; ++c) {
    if (!closed[c]) continue;
    const std::size_t face_count = starts[c + 1] - starts[c];
    const int sign = volume_sign(mesh.vertices, std::span(grouped).subspan(starts[c], face_count));
    if (sign != (enclosing[c] % 2 == 0 ? 1 : -1))
      report.inside_out.push_back(
          {static_cast<Index>(c), first_face[c], static_cast<Index>(face_count), enclosing[c], sign});
  }
}

}  // namespace

MeshReport check(const TriangleMesh& mesh) {
  const DefaultFloatingPoint environment;
  MeshReport report;
  report.name = mesh.name;
  report.vertex_count = static_cast<Index>(mesh.vertices.size());
  report.face_count = static_cast<Index>(mesh.faces.size());
  const std::vector<bool> usable = find_usable_faces(mesh, report);
  find_vertex_issues(mesh, report);
  find_zero_area_faces(mesh, usable, report);
  const EdgeTable edges(mesh.vertices.size(), mesh.faces, usable);
  find_edge_issues(edges, report);
  find_pinched_vertices(mesh, usable, edges, report);
  find_components(usable, edges, report);
  const std::vector<bool> closed = find_closed_components(edges, report);
  find_inside_out_components(mesh, closed, report);
  set_possible_cavities_apart(mesh, closed, report);
  return report;
}

}  // namespace pcm
