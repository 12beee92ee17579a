// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/joined_features.h"

#include <algorithm>
#include <map>
#include <utility>

#include "compare/explain/nearest_points.h"
#include "compare/explain/stars.h"

namespace pcm::compare {
namespace {

using reference::ExactPose;
using reference::Surface;

using FeaturePair = std::array<Feature, 2>;
/// Places by the pair of features that have them in common, nearest ones first.
using CommonPlaces = std::map<FeaturePair, std::vector<const Coincidence*>>;

/// The edges and faces that a feature belongs to, itself included.
std::vector<Feature> star_of(const Feature& feature, const Surface& surface) {
  std::vector<Feature> star;
  for (const auto& ends : edges_at(surface, feature)) star.push_back(edge_feature(feature.side, ends));
  for (const Index f : faces_at(surface, feature)) star.push_back(face_feature(feature.side, f));
  return star;
}

CommonPlaces common_places(const ExactPose& pose, const std::vector<Coincidence>& places) {
  std::vector<const Coincidence*> nearest_first;
  for (const Coincidence& place : places) nearest_first.push_back(&place);
  std::stable_sort(nearest_first.begin(), nearest_first.end(),
                   [](const Coincidence* a, const Coincidence* b) { return a->margin < b->margin; });
  CommonPlaces common;
  for (const Coincidence* place : nearest_first) {
    const std::vector<Feature> star_E = star_of(place->features[0], pose.surface(Side::E));
    const std::vector<Feature> star_F = star_of(place->features[1], pose.surface(Side::F));
    for (const Feature& on_E : star_E)
      for (const Feature& on_F : star_F) common[{on_E, on_F}].push_back(place);
  }
  return common;
}

/// The nearest places, each different from those before; `count` of them, or none.
std::vector<const Coincidence*> different_places(const std::vector<const Coincidence*>& places, std::size_t count,
                                                 double width) {
  std::vector<const Coincidence*> different;
  for (const Coincidence* place : places) {
    const bool is_new = std::all_of(different.begin(), different.end(), [&](const Coincidence* other) {
      return are_different_places(*place, *other, width);
    });
    if (is_new) different.push_back(place);
    if (different.size() == count) return different;
  }
  return {};
}

ExactPoint doubled_normal_of(const ExactPose& pose, const Feature& face) {
  const auto [p0, p1, p2] = pose.corners<reference::Exact>(face.side, face.index[0]);
  return reference::doubled_normal(p0, p1, p2);
}

/// Rounded, of length 1.
Eigen::Vector3d unit_normal_of(const ExactPose& pose, const Feature& face) {
  NearestPoints across;
  across.apart = doubled_normal_of(pose, face);
  return across.unit_apart();
}

Coincidence joined(CoincidenceKind kind, const FeaturePair& features, const std::vector<const Coincidence*>& places) {
  Coincidence c{kind, features, places.back()->margin, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), {}};
  for (const Coincidence* place : places) c.position_Me += place->position_Me / static_cast<double>(places.size());
  return c;
}

bool has_edge(const ExactPose& pose, const Feature& face, const Feature& edge) {
  const Triangle& t = pose.face(face.side, face.index[0]);
  return std::count(t.begin(), t.end(), edge.index[0]) + std::count(t.begin(), t.end(), edge.index[1]) == 2;
}

/// By edge, the edges of the other surface that lie along it.
using EdgesAlong = std::map<Feature, std::vector<Feature>>;

bool lies_along_a_side(const ExactPose& pose, const EdgesAlong& along, const Feature& edge, const Feature& face) {
  const auto found = along.find(edge);
  return found != along.end() && std::any_of(found->second.begin(), found->second.end(),
                                             [&](const Feature& side) { return has_edge(pose, face, side); });
}

void add_edge_in_face(const ExactPose& pose, const FeaturePair& pair, const std::vector<const Coincidence*>& two,
                      std::vector<Coincidence>& found) {
  Coincidence c = joined(CoincidenceKind::edge_in_face, pair, two);
  const bool face_first = pair[0].kind == FeatureKind::face;
  c.apart_Me = face_first ? unit_normal_of(pose, pair[0]) : Eigen::Vector3d(-unit_normal_of(pose, pair[1]));
  found.push_back(c);
}

void add_coplanar_faces(const ExactPose& pose, const FeaturePair& pair, const std::vector<const Coincidence*>& three,
                        std::vector<Coincidence>& found) {
  Coincidence c = joined(CoincidenceKind::coplanar_faces, pair, three);
  c.apart_Me = unit_normal_of(pose, pair[0]);
  c.equal_normals = reference::sign_of(dot(doubled_normal_of(pose, pair[0]), doubled_normal_of(pose, pair[1]))) > 0;
  found.push_back(c);
}

}  // namespace

std::vector<Coincidence> joined_features(const ExactPose& pose, const std::vector<Coincidence>& places, double width) {
  const CommonPlaces common = common_places(pose, places);
  std::vector<Coincidence> found;
  EdgesAlong along;
  const auto edges_of = [](const FeaturePair& pair) {
    return std::count_if(pair.begin(), pair.end(), [](const Feature& x) { return x.kind == FeatureKind::edge; });
  };
  for (const auto& [pair, all] : common) {
    if (edges_of(pair) != 2) continue;
    const auto two = different_places(all, 2, width);
    if (two.empty()) continue;
    found.push_back(joined(CoincidenceKind::edge_along_edge, pair, two));
    along[pair[0]].push_back(pair[1]);
    along[pair[1]].push_back(pair[0]);
  }
  for (const auto& [pair, all] : common) {
    if (edges_of(pair) == 1) {
      const std::size_t edge = pair[0].kind == FeatureKind::edge ? 0 : 1;
      const auto two = different_places(all, 2, width);
      if (!two.empty() && !lies_along_a_side(pose, along, pair[edge], pair[1 - edge]))
        add_edge_in_face(pose, pair, two, found);
    } else if (edges_of(pair) == 0) {
      const auto three = different_places(all, 3, width);
      if (!three.empty()) add_coplanar_faces(pose, pair, three, found);
    }
  }
  return found;
}

}  // namespace pcm::compare
