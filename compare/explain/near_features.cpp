// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/near_features.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "compare/explain/grown_boxes.h"
#include "compare/explain/nearest_points.h"
#include "compare/explain/rounded_points.h"
#include "reference/crossings/candidates.h"

namespace pcm::compare {
namespace {

using reference::Box;
using reference::ExactPose;
using reference::IndexPair;

/// Which features of the two surfaces have boxes at most `width` apart: numbers in E and in F, each pair once.
struct FeaturePairs {
  std::vector<IndexPair> vertices, vertices_edges, edges_vertices, vertices_faces, faces_vertices, edges;
};

Box vertex_box(const ExactPose& pose, Side side, Index v) {
  return pose.enclosure({side, v});
}

Box edge_box(const ExactPose& pose, Side side, Index edge) {
  const auto& ends = pose.surface(side).edges[static_cast<std::size_t>(edge)];
  Box box = vertex_box(pose, side, ends[0]);
  box.include(vertex_box(pose, side, ends[1]));
  return box;
}

/// Features with their boxes, of a face.
using Boxes = std::array<std::pair<Index, Box>, 3>;

Boxes vertex_boxes(const ExactPose& pose, Side side, Index face, double width) {
  Boxes boxes;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index v = pose.face(side, face)[k];
    boxes[k] = {v, grown(vertex_box(pose, side, v), width)};
  }
  return boxes;
}

Boxes edge_boxes(const ExactPose& pose, Side side, Index face, double width) {
  Boxes boxes;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index edge = pose.surface(side).face_edges[static_cast<std::size_t>(face)][k];
    boxes[k] = {edge, grown(edge_box(pose, side, edge), width)};
  }
  return boxes;
}

void add_meeting(const Boxes& on_E, const Boxes& on_F, std::vector<IndexPair>& pairs) {
  for (const auto& [i, box_E] : on_E)
    for (const auto& [j, box_F] : on_F)
      if (box_E.meets(box_F)) pairs.emplace_back(i, j);
}

void keep_each_once(std::vector<IndexPair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

std::vector<IndexPair> faces_with_boxes_near(const ExactPose& pose, double width) {
  return reference::meeting_boxes(pose.surface(Side::E).tree, grown_tree(pose, Side::F, width));
}

FeaturePairs pairs_with_boxes_near(const ExactPose& pose, double width) {
  FeaturePairs pairs;
  for (const auto& [e, f] : faces_with_boxes_near(pose, width)) {
    const Boxes vertices_E = vertex_boxes(pose, Side::E, e, width), vertices_F = vertex_boxes(pose, Side::F, f, 0);
    const Boxes edges_E = edge_boxes(pose, Side::E, e, width), edges_F = edge_boxes(pose, Side::F, f, 0);
    add_meeting(vertices_E, vertices_F, pairs.vertices);
    add_meeting(vertices_E, edges_F, pairs.vertices_edges);
    add_meeting(edges_E, vertices_F, pairs.edges_vertices);
    add_meeting(edges_E, edges_F, pairs.edges);
    const Box face_E = grown(pose.face_box(Side::E, e), width), face_F = pose.face_box(Side::F, f);
    for (const auto& [v, box] : vertices_E)
      if (box.meets(face_F)) pairs.vertices_faces.emplace_back(v, f);
    for (const auto& [v, box] : vertices_F)
      if (box.meets(face_E)) pairs.faces_vertices.emplace_back(e, v);
  }
  for (auto* list : {&pairs.vertices, &pairs.vertices_edges, &pairs.edges_vertices, &pairs.vertices_faces,
                     &pairs.faces_vertices, &pairs.edges})
    keep_each_once(*list);
  return pairs;
}

/// Looks at pairs one by one and keeps what is near.
class NearSearch {
 public:
  NearSearch(const ExactPose& pose, double width) : pose_(pose), width_(width) {}

  void vertices(Index i, Index j) {
    add(CoincidenceKind::vertex_on_vertex, nearest_points(point(Side::E, i), point(Side::F, j)),
        vertex_feature(Side::E, i), vertex_feature(Side::F, j), rounded(Side::E, i));
  }
  void vertex_edge(Side side, Index v, Index edge) {
    const auto& ends = edges_of(opposite(side))[static_cast<std::size_t>(edge)];
    add(CoincidenceKind::vertex_on_edge, nearest_points(point(side, v), segment(opposite(side), ends)),
        vertex_feature(side, v), edge_feature(opposite(side), ends), rounded(side, v));
  }
  void vertex_face(Side side, Index v, Index face) {
    const auto corners = pose_.corners<reference::Exact>(opposite(side), face);
    add(CoincidenceKind::vertex_on_face, nearest_points(point(side, v), corners), vertex_feature(side, v),
        face_feature(opposite(side), face), rounded(side, v));
  }
  void edges(Index i, Index j) {
    const auto& ends_E = edges_of(Side::E)[static_cast<std::size_t>(i)];
    const auto& ends_F = edges_of(Side::F)[static_cast<std::size_t>(j)];
    const auto nearest = nearest_points(segment(Side::E, ends_E), segment(Side::F, ends_F));
    if (!nearest || !nearest->within(width_)) return;
    const Eigen::Vector3d a = rounded(Side::E, ends_E[0]), b = rounded(Side::E, ends_E[1]);
    add(CoincidenceKind::edge_across_edge, nearest, edge_feature(Side::E, ends_E), edge_feature(Side::F, ends_F),
        a + nearest->place() * (b - a));
  }
  std::vector<Coincidence> take() { return std::move(found_); }

 private:
  void add(CoincidenceKind kind, const std::optional<NearestPoints>& nearest, const Feature& first,
           const Feature& second, const Eigen::Vector3d& position_Me) {
    if (!nearest || !nearest->within(width_)) return;
    Coincidence c{kind, {first, second}, nearest->distance(), position_Me, nearest->unit_apart(), {}};
    if (first.side == Side::F) {
      std::swap(c.features[0], c.features[1]);
      c.apart_Me = -c.apart_Me;
    }
    found_.push_back(c);
  }
  ExactPoint point(Side side, Index v) const { return pose_.point<reference::Exact>({side, v}); }
  ExactSegment segment(Side side, const std::array<Index, 2>& ends) const {
    return {point(side, ends[0]), point(side, ends[1])};
  }
  Eigen::Vector3d rounded(Side side, Index v) const { return rounded_point(pose_, {side, v}); }
  const std::vector<std::array<Index, 2>>& edges_of(Side side) const { return pose_.surface(side).edges; }

  const ExactPose& pose_;
  reference::Exact width_;
  std::vector<Coincidence> found_;
};

}  // namespace

std::vector<Coincidence> near_features(const ExactPose& pose, double width) {
  const FeaturePairs pairs = pairs_with_boxes_near(pose, width);
  NearSearch search(pose, width);
  for (const auto& [i, j] : pairs.vertices) search.vertices(i, j);
  for (const auto& [v, edge] : pairs.vertices_edges) search.vertex_edge(Side::E, v, edge);
  for (const auto& [edge, v] : pairs.edges_vertices) search.vertex_edge(Side::F, v, edge);
  for (const auto& [v, f] : pairs.vertices_faces) search.vertex_face(Side::E, v, f);
  for (const auto& [e, v] : pairs.faces_vertices) search.vertex_face(Side::F, v, e);
  for (const auto& [i, j] : pairs.edges) search.edges(i, j);
  return search.take();
}

}  // namespace pcm::compare
