// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/surface/prepare_surface.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "fast/base/geometry.h"
#include "fast/surface/clearance.h"
#include "fast/surface/exit_depth.h"
#include "fast/surface/thickness.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"

namespace pcm::fast {

namespace {

/// Groups `pairs` (item, entry) by item, keeping the order of the entries.
template <class Pairs>
Incidence incidence(std::size_t items, const Pairs& for_each_pair) {
  Incidence result;
  result.offset.assign(items + 1, 0);
  for_each_pair([&](Index item, Index) { ++result.offset[static_cast<std::size_t>(item) + 1]; });
  for (std::size_t i = 0; i < items; ++i) result.offset[i + 1] += result.offset[i];
  result.entries.resize(static_cast<std::size_t>(result.offset.back()));
  std::vector<Index> next(result.offset.begin(), result.offset.end() - 1);
  for_each_pair([&](Index item, Index entry) {
    result.entries[static_cast<std::size_t>(next[static_cast<std::size_t>(item)]++)] = entry;
  });
  return result;
}

struct HalfEdge {
  std::array<Index, 2> ends;  ///< the smaller first
  Index face;
  int corner;

  bool operator<(const HalfEdge& other) const { return ends != other.ends ? ends < other.ends : face < other.face; }
};

void connect_edges(PreparedSurface& surface) {
  std::vector<HalfEdge> half_edges;
  half_edges.reserve(3 * surface.mesh.faces.size());
  for (Index f = 0; f < static_cast<Index>(surface.mesh.faces.size()); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index a = surface.face(f)[static_cast<std::size_t>(k)];
      const Index b = surface.face(f)[static_cast<std::size_t>((k + 1) % 3)];
      half_edges.push_back({{std::min(a, b), std::max(a, b)}, f, k});
    }
  }
  std::sort(half_edges.begin(), half_edges.end());
  surface.face_edges.resize(surface.mesh.faces.size());
  surface.face_neighbours.resize(surface.mesh.faces.size());
  const auto enter = [&surface](const HalfEdge& half_edge, Index neighbour) {
    const auto face = static_cast<std::size_t>(half_edge.face), corner = static_cast<std::size_t>(half_edge.corner);
    surface.face_edges[face][corner] = static_cast<Index>(surface.edges.size()) - 1;
    surface.face_neighbours[face][corner] = neighbour;
  };
  for (std::size_t i = 0; i < half_edges.size();) {
    const HalfEdge& first = half_edges[i++];
    const bool border = i == half_edges.size() || half_edges[i].ends != first.ends;
    surface.edges.push_back(first.ends);
    surface.border_edges.push_back(border);
    if (border) {
      enter(first, first.face);
      continue;
    }
    const HalfEdge& second = half_edges[i++];
    enter(first, second.face);
    enter(second, first.face);
  }
  surface.closed =
      std::find(surface.border_edges.begin(), surface.border_edges.end(), true) == surface.border_edges.end();
}

void find_components(PreparedSurface& surface) {
  surface.face_component.assign(surface.mesh.faces.size(), -1);
  Index components = 0;
  std::vector<Index> stack;
  for (Index seed = 0; seed < static_cast<Index>(surface.mesh.faces.size()); ++seed) {
    if (surface.face_component[static_cast<std::size_t>(seed)] >= 0) continue;
    surface.face_component[static_cast<std::size_t>(seed)] = components;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const Index f = stack.back();
      stack.pop_back();
      for (const Index g : surface.neighbours_of(f)) {
        if (surface.face_component[static_cast<std::size_t>(g)] >= 0) continue;
        surface.face_component[static_cast<std::size_t>(g)] = components;
        stack.push_back(g);
      }
    }
    ++components;
  }
  surface.component_faces = incidence(static_cast<std::size_t>(components), [&](auto&& pair) {
    for (std::size_t f = 0; f < surface.mesh.faces.size(); ++f) pair(surface.face_component[f], static_cast<Index>(f));
  });
  for (Index c = 0; c < components; ++c) {
    const Incidence::Span faces = surface.component_faces[c];
    surface.component_boxes.push_back(box_of_faces(surface.mesh, faces.begin(), faces.size()));
  }
}

double median_edge(const PreparedSurface& surface) {
  std::vector<double> lengths;
  lengths.reserve(surface.edges.size());
  for (const auto& [a, b] : surface.edges) lengths.push_back(length(surface.vertex(a) - surface.vertex(b)));
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// Of all components that with the fewest.
Index vertices_of_least_component(const PreparedSurface& surface) {
  std::vector<Index> last_seen_in(surface.mesh.vertices.size(), -1);
  Index fewest = std::numeric_limits<Index>::max();
  for (Index c = 0; c < static_cast<Index>(surface.component_faces.items()); ++c) {
    Index count = 0;
    for (const Index face : surface.component_faces[c]) {
      for (const Index v : surface.face(face)) {
        if (std::exchange(last_seen_in[static_cast<std::size_t>(v)], c) != c) ++count;
      }
    }
    fewest = std::min(fewest, count);
  }
  return fewest;
}

[[noreturn]] void refuse(const TriangleMesh& mesh, const std::string& why) {
  throw BadInput((mesh.name.empty() ? std::string("surface") : mesh.name) + ": " + why);
}

/// Lists of up to six entries a face, both ends of its edges where it shares none, are counted by Index.
void require_countable(const TriangleMesh& mesh) {
  constexpr auto kMostFaces = static_cast<std::size_t>(std::numeric_limits<Index>::max()) / 6;
  if (mesh.faces.size() > kMostFaces) {
    refuse(mesh, "has " + std::to_string(mesh.faces.size()) + " triangles, more than the " +
                     std::to_string(kMostFaces) + " the engine can count; divide it");
  }
}

}  // namespace

Eigen::Vector3d max_coordinates_of(const TriangleMesh& mesh) {
  Eigen::Vector3d greatest = Eigen::Vector3d::Zero();
  for (const Triangle& triangle : mesh.faces) {
    for (const Index v : triangle) greatest = greatest.cwiseMax(mesh.vertices[static_cast<std::size_t>(v)].cwiseAbs());
  }
  return greatest;
}

std::string out_of_range(double max_coordinate) {
  if (max_coordinate >= kLeastMaxCoordinate && max_coordinate <= kGreatestCoordinate) return {};
  std::ostringstream why;
  why << "its greatest |coordinate| is " << max_coordinate
      << " m, not between 2^-300 and 2^300 (5e-91 and 2e90); choose a " << (max_coordinate < 1 ? "smaller" : "larger")
      << " unit of length";
  return why.str();
}

[[gnu::noinline]] PreparedSurface prepare_surface(TriangleMesh mesh) {
  require_fit(mesh);
  require_countable(mesh);
  PreparedSurface surface;
  surface.max_coordinates = max_coordinates_of(mesh);
  if (const std::string why = out_of_range(surface.max_coordinates.maxCoeff()); !why.empty()) refuse(mesh, why);
  surface.mesh = std::move(mesh);
  connect_edges(surface);
  surface.vertex_edges = incidence(surface.mesh.vertices.size(), [&surface](auto&& pair) {
    for (std::size_t e = 0; e < surface.edges.size(); ++e) {
      for (const Index v : surface.edges[e]) pair(v, static_cast<Index>(e));
    }
  });
  surface.vertex_faces = incidence(surface.mesh.vertices.size(), [&surface](auto&& pair) {
    for (std::size_t f = 0; f < surface.mesh.faces.size(); ++f) {
      for (const Index v : surface.mesh.faces[f]) pair(v, static_cast<Index>(f));
    }
  });
  find_components(surface);
  surface.usual_edge = median_edge(surface);
  surface.fewest_vertices = vertices_of_least_component(surface);
  surface.tree = BoxTree(surface.mesh);
  surface.wide_tree = WideTree(surface.mesh, surface.tree);
  const std::size_t faces = surface.mesh.faces.size();
  surface.known_thickness = OnDemand<double>(faces);
  surface.known_thickness_everywhere = OnDemand<ThicknessEverywhere>(faces);
  surface.known_exit_depth = OnDemand<double>(faces);
  surface.known_clearance = OnDemand<Clearance>(faces);
  return surface;
}

[[gnu::noinline]] void look_around_all_faces(const PreparedSurface& surface) {
  for (Index face = 0; face < static_cast<Index>(surface.mesh.faces.size()); ++face) {
    thickness(surface, face);
    thickness_everywhere(surface, face);
    exit_depth(surface, face);
    clearance(surface, face);
  }
}

}  // namespace pcm::fast
