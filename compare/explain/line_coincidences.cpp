// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/line_coincidences.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "compare/explain/grown_boxes.h"
#include "compare/explain/nearest_points.h"
#include "compare/explain/rounded_points.h"
#include "compare/explain/stars.h"
#include "reference/lines/penetration_line.h"

namespace pcm::compare {
namespace {

using reference::Box;
using reference::BoxTree;
using reference::Exact;
using reference::ExactPose;

/// The faces of the slave that the line may be near to, no farther than the first that it meets.
struct FacesInTheWay {
  std::vector<Index> faces;
  std::optional<Index> first;
  double farthest = std::numeric_limits<double>::infinity();  ///< q at that first one, in units of |N|, at most
};

FacesInTheWay faces_in_the_way(const ExactPose& pose, Side master, Index face, const BoxTree& slave_tree) {
  const Side slave = opposite(master);
  reference::PenetrationLine line(pose, master, face);
  FacesInTheWay found;
  slave_tree.look_along(
      [&](const Box& box) { return line.begin_of(box); },
      [&](Index f) {
        found.faces.push_back(f);
        if (line.meets(slave, f).met && (!found.first || line.compare(slave, f, slave, *found.first) < 0)) {
          found.first = f;
          found.farthest = line.farthest(slave, f);
        }
        return found.farthest;
      });
  return found;
}

/// Three times a point of the pose: with coordinates as large as that the barycentre is exact without a division.
class ThriceAsLarge {
 public:
  explicit ThriceAsLarge(const ExactPose& pose) : pose_(pose) {}
  ExactPoint point(Side side, Index v) const { return Exact(3) * pose_.point<Exact>({side, v}); }
  ExactTriangle corners(Side side, Index f) const {
    const Triangle& t = pose_.face(side, f);
    return {point(side, t[0]), point(side, t[1]), point(side, t[2])};
  }
  /// The ray's direction is -N, so that places along it are thrice q.
  ExactRay line(Side side, Index f) const {
    const auto [p0, p1, p2] = pose_.corners<Exact>(side, f);
    return {p0 + p1 + p2, Exact(-1) * reference::doubled_normal(p0, p1, p2)};
  }

 private:
  const ExactPose& pose_;
};

/// What one line is near to.
class LineSearch {
 public:
  LineSearch(const ExactPose& pose, Side master, Index face, const FacesInTheWay& way, double width)
      : pose_(pose), large_(pose), master_(master), face_(face), way_(way), width_(3 * width) {
    const auto [p0, p1, p2] = rounded_corners(pose, master, face);
    C_Me_ = (p0 + p1 + p2) / 3;
    N_Me_ = (p1 - p0).cross(p2 - p0);
    ray_ = large_.line(master, face);
  }

  void look() {
    const Side slave = opposite(master_);
    std::set<Feature> seen;
    for (const Index f : way_.faces) {
      barycentre_on(f);
      const Triangle& t = pose_.face(slave, f);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
        if (const Feature vertex = vertex_feature(slave, t[k]); seen.insert(vertex).second) through_vertex(vertex);
        if (const Feature edge = edge_feature(slave, {low, high}); seen.insert(edge).second) through_edge(edge);
      }
    }
  }
  std::vector<Coincidence> found;

 private:
  Feature line() const { return {FeatureKind::line, master_, {face_, -1}}; }
  void add(CoincidenceKind kind, const Feature& first, const Feature& second, const NearestPoints& nearest,
           const Eigen::Vector3d& position_Me) {
    found.push_back({kind, {first, second}, nearest.distance(), position_Me, nearest.unit_apart(), {}});
  }
  /// Back to true size; the place along the line is q.
  static NearestPoints third_of(NearestPoints nearest) {
    nearest.squared_denominator = Exact(9) * nearest.squared_denominator;
    nearest.place_denominator = Exact(3) * nearest.place_denominator;
    return nearest;
  }
  /// Whether it belongs to the first face that is met: that may be met a little before its border.
  bool is_at_first(const Feature& feature) const {
    if (!way_.first) return false;
    const std::vector<Index> faces = faces_at(pose_.surface(feature.side), feature);
    return std::find(faces.begin(), faces.end(), *way_.first) != faces.end();
  }
  void add_if_near(CoincidenceKind kind, const Feature& feature, const std::optional<NearestPoints>& nearest) {
    if (!nearest || !nearest->within(width_)) return;
    const NearestPoints third = third_of(*nearest);
    if (third.place() <= way_.farthest || is_at_first(feature))
      add(kind, line(), feature, third, C_Me_ - third.place() * N_Me_);
  }
  void through_vertex(const Feature& vertex) {
    add_if_near(CoincidenceKind::line_through_vertex, vertex,
                nearest_points(ray_, large_.point(vertex.side, vertex.index[0])));
  }
  void through_edge(const Feature& edge) {
    const ExactSegment ends{large_.point(edge.side, edge.index[0]), large_.point(edge.side, edge.index[1])};
    add_if_near(CoincidenceKind::line_through_edge, edge, nearest_points(ray_, ends));
  }
  void barycentre_on(Index f) {
    const Side slave = opposite(master_);
    const auto nearest = nearest_points(ray_.origin, large_.corners(slave, f));
    if (!nearest || !nearest->within(width_)) return;
    add(CoincidenceKind::barycentre_on_face, {FeatureKind::barycentre, master_, {face_, -1}}, face_feature(slave, f),
        third_of(*nearest), C_Me_);
  }

  const ExactPose& pose_;
  ThriceAsLarge large_;
  Side master_;
  Index face_;
  const FacesInTheWay& way_;
  Exact width_;
  Eigen::Vector3d C_Me_, N_Me_;
  ExactRay ray_;
};

/// A line with two places in common with a face lies in its plane.
void add_lines_in_faces(const ExactPose& pose, double width, std::vector<Coincidence>& found) {
  std::map<Index, std::vector<Coincidence>> by_face;
  for (const Coincidence& place : found)
    for (const Index f : faces_at(pose.surface(place.features[1].side), place.features[1])) by_face[f].push_back(place);
  for (auto& [f, places] : by_face) {
    sort_by_margin(places);  // exact ones first: any two of them are different
    const Coincidence& first = places[0];
    const auto second = std::find_if(places.begin() + 1, places.end(), [&](const Coincidence& place) {
      return are_different_places(place, first, width);
    });
    if (second == places.end()) continue;
    const Feature& master = places[0].features[0];
    const Side slave = opposite(master.side);
    found.push_back({CoincidenceKind::line_in_face,
                     {Feature{FeatureKind::line, master.side, master.index}, face_feature(slave, f)},
                     second->margin,
                     (places[0].position_Me + second->position_Me) / 2,
                     Eigen::Vector3d::Zero(),
                     {}});
  }
}

}  // namespace

std::vector<Coincidence> line_coincidences(const ExactPose& pose, Side master, const std::vector<Index>& faces,
                                           double width) {
  const BoxTree slave_tree = grown_tree(pose, opposite(master), width);
  std::vector<Coincidence> all;
  for (const Index face : faces) {
    const FacesInTheWay way = faces_in_the_way(pose, master, face, slave_tree);
    LineSearch search(pose, master, face, way, width);
    search.look();
    leave_out_told_by_parts(search.found, pose.surface(Side::E).mesh, pose.surface(Side::F).mesh);
    add_lines_in_faces(pose, width, search.found);
    all.insert(all.end(), search.found.begin(), search.found.end());
  }
  return all;
}

}  // namespace pcm::compare
