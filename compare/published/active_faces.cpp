// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/active_faces.h"

#include <algorithm>
#include <iterator>

namespace pcm::compare::published {
namespace {

void unite(std::vector<Index>& patch_of, Index a, Index b) {
  const Index root_a = root_of(patch_of, a), root_b = root_of(patch_of, b);
  patch_of[static_cast<std::size_t>(std::max(root_a, root_b))] = std::min(root_a, root_b);
}

}  // namespace

Index root_of(std::vector<Index>& patch_of, Index chain) {
  Index root = chain;
  while (patch_of[static_cast<std::size_t>(root)] != root) root = patch_of[static_cast<std::size_t>(root)];
  while (chain != root) {
    Index& parent = patch_of[static_cast<std::size_t>(chain)];
    chain = parent;
    parent = root;
  }
  return root;
}

void ActiveFaces::note_crossings(const Surface& surface, Side side, const std::vector<Segment>& segments,
                                 const std::vector<SegmentChain>& chains, std::vector<Index>& patch_of) {
  crossed_.start(surface.edges.size());
  crossed_edges_.clear();
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (std::size_t s = chains[c].first; s < chains[c].first + chains[c].count; ++s)
      for (const Crossing& crossing : segments[s].ends) {
        if (crossing.edge_side != side) continue;
        if (!crossed_.contains(crossing.edge)) crossed_edges_.push_back(crossing.edge);
        CrossedEdge& edge = crossed_[crossing.edge];
        if (edge.chain < 0) edge.chain = static_cast<Index>(c);
        unite(patch_of, edge.chain, static_cast<Index>(c));
        if (crossing.along < edge.along_first) {
          edge.along_first = crossing.along;
          edge.first_inside = crossing.first_end_below;
        }
        if (crossing.along > edge.along_second) {
          edge.along_second = crossing.along;
          edge.second_inside = !crossing.first_end_below;
        }
      }
}

void ActiveFaces::reach(Index vertex, Index chain, std::vector<Index>& patch_of) {
  if (chain_of_vertex_.contains(vertex)) {
    unite(patch_of, chain_of_vertex_[vertex], chain);
    return;
  }
  chain_of_vertex_[vertex] = chain;
  inner_vertices_.push_back(vertex);
}

void ActiveFaces::flood(const Surface& surface, std::vector<Index>& patch_of) {
  chain_of_vertex_.start(surface.mesh.vertices.size());
  inner_vertices_.clear();
  for (const Index e : crossed_edges_) {
    const CrossedEdge& edge = crossed_[e];
    if (edge.first_inside) reach(surface.edge(e)[0], edge.chain, patch_of);
    if (edge.second_inside) reach(surface.edge(e)[1], edge.chain, patch_of);
  }
  // The list grows while it is walked.
  for (std::size_t k = 0; k < inner_vertices_.size(); ++k) {
    const Index vertex = inner_vertices_[k];
    const auto [first, last] = surface.vertex_edges[vertex];
    for (const Index* e = first; e != last; ++e) {
      if (crossed_.contains(*e)) continue;
      const std::array<Index, 2>& ends = surface.edge(*e);
      reach(ends[0] == vertex ? ends[1] : ends[0], chain_of_vertex_[vertex], patch_of);
    }
  }
}

void ActiveFaces::list_faces(const Surface& surface) {
  for (const Index vertex : inner_vertices_) {
    const auto [first, last] = surface.vertex_faces[vertex];
    for (const Index* f = first; f != last; ++f) {
      if (seen_faces_.contains(*f)) continue;
      seen_faces_[*f] = true;
      inner_.push_back(*f);
    }
  }
  std::sort(intersected_.begin(), intersected_.end());
  std::sort(inner_.begin(), inner_.end());
  active_.clear();
  std::merge(intersected_.begin(), intersected_.end(), inner_.begin(), inner_.end(), std::back_inserter(active_));
}

void ActiveFaces::find(const Surface& surface, Side side, const std::vector<Segment>& segments,
                       const std::vector<SegmentChain>& chains, std::vector<Index>& patch_of) {
  seen_faces_.start(surface.mesh.faces.size());
  intersected_.clear();
  inner_.clear();
  for (const Segment& segment : segments) {
    const Index face = side == Side::E ? segment.face_E : segment.face_F;
    if (seen_faces_.contains(face)) continue;
    seen_faces_[face] = true;
    intersected_.push_back(face);
  }
  note_crossings(surface, side, segments, chains, patch_of);
  flood(surface, patch_of);
  list_faces(surface);
}

}  // namespace pcm::compare::published
