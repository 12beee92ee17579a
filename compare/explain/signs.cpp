// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/signs.h"

#include <utility>

#include "compare/explain/rounded_points.h"
#include "compare/explain/stars.h"
#include "fast/predicates/penetration_predicates.h"

namespace pcm::compare {
namespace {

using reference::Exact;
using reference::ExactPose;
using reference::Vec3;

/// Side of a face that a vertex of the other surface lies on.
Sign side_of_face(const ExactPose& pose, const Feature& face, Index v) {
  const Triangle& t = pose.face(face.side, face.index[0]);
  return orientation_sign(pose, {{{face.side, t[0]}, {face.side, t[1]}, {face.side, t[2]}, {opposite(face.side), v}}});
}

void add_sides(const ExactPose& pose, const Feature& vertex, const Feature& other, std::vector<Sign>& signs) {
  for (const Index f : faces_at(pose.surface(other.side), other))
    signs.push_back(side_of_face(pose, face_feature(other.side, f), vertex.index[0]));
}

std::vector<Sign> vertex_signs(const ExactPose& pose, const Feature& E, const Feature& F) {
  std::vector<Sign> signs;
  if (E.kind == FeatureKind::vertex) add_sides(pose, E, F, signs);
  if (F.kind == FeatureKind::vertex) add_sides(pose, F, E, signs);
  return signs;
}

std::vector<Sign> edge_signs(const ExactPose& pose, const Feature& E, const Feature& F) {
  return {orientation_sign(pose,
                           {{{E.side, E.index[0]}, {E.side, E.index[1]}, {F.side, F.index[0]}, {F.side, F.index[1]}}})};
}

/// Of the vertices of each, an edge or a face, with the other one where that is a face.
std::vector<Sign> face_signs(const ExactPose& pose, const Feature& E, const Feature& F) {
  std::vector<Sign> signs;
  for (const auto& [flat, face] : {std::pair(&F, &E), std::pair(&E, &F)}) {
    if (face->kind != FeatureKind::face) continue;
    if (flat->kind == FeatureKind::edge) {
      for (const Index v : flat->index) signs.push_back(side_of_face(pose, *face, v));
    } else {
      for (const Index v : pose.face(flat->side, flat->index[0])) signs.push_back(side_of_face(pose, *face, v));
    }
  }
  return signs;
}

/// A penetration line as the engine and as the oracle's numbers have it.
class LineSigns {
 public:
  LineSigns(const ExactPose& pose, const Feature& line)
      : pose_(pose),
        line_{FeatureKind::line, line.side, line.index},
        points_(rounded_corners(pose, line.side, line.index[0])),
        engine_(points_[0], points_[1], points_[2]),
        corners_(pose.corners<Exact>(line.side, line.index[0])),
        N_(reference::doubled_normal(corners_[0], corners_[1], corners_[2])) {}

  Sign side(const std::array<Index, 2>& ends) const {
    const Side slave = opposite(line_.side);
    const auto three_times_from_C = [&](Index v) {
      const Vec3<Exact> x = pose_.point<Exact>({slave, v});
      return (x - corners_[0]) + (x - corners_[1]) + (x - corners_[2]);
    };
    Sign sign{Predicate::side_of_line, {line_, edge_feature(slave, ends)}, 0, Stage::filter, 0, {}, 0};
    sign.exact = reference::sign_of(determinant(N_, three_times_from_C(ends[0]), three_times_from_C(ends[1])));
    fast::WorkCounters work;
    sign.decided =
        fast::side_sign(engine_, rounded_point(pose_, {slave, ends[0]}), rounded_point(pose_, {slave, ends[1]}), work);
    sign.stage = stage_of(work);
    if (sign.stage == Stage::tie_rule) sign.shift = is_moved_by_first_shift(ends) ? 1 : 2;
    return sign;
  }
  Sign facing(const Feature& face) const {
    fast::WorkCounters work;
    const int sign = fast::facing(engine_, rounded_corners(pose_, face.side, face.index[0]), work);
    return {Predicate::facing, {line_, face}, sign, stage_of(work), sign, {}, 0};
  }
  Sign distance(const Feature& face) const {
    fast::WorkCounters work;
    const int sign = fast::distance_sign(engine_, rounded_corners(pose_, face.side, face.index[0]), work);
    const Feature barycentre{FeatureKind::barycentre, line_.side, line_.index};
    return {Predicate::distance_along_line, {barycentre, face}, sign, stage_of(work), sign, {}, 0};
  }

 private:
  /// (f_i - f_j) . (N x (p1 - p0)) is not 0.
  bool is_moved_by_first_shift(const std::array<Index, 2>& ends) const {
    const Side slave = opposite(line_.side);
    const Vec3<Exact> edge = pose_.point<Exact>({slave, ends[0]}) - pose_.point<Exact>({slave, ends[1]});
    return reference::sign_of(determinant(edge, N_, corners_[1] - corners_[0])) != 0;
  }

  const ExactPose& pose_;
  Feature line_;
  fast::FacePoints points_;
  fast::PenetrationLine engine_;
  std::array<Vec3<Exact>, 3> corners_;
  Vec3<Exact> N_;
};

std::vector<Sign> through_vertex_signs(const ExactPose& pose, const LineSigns& line, const Feature& vertex) {
  std::vector<Sign> signs;
  for (const auto& ends : edges_at(pose.surface(vertex.side), vertex)) signs.push_back(line.side(ends));
  return signs;
}

}  // namespace

Stage stage_of(const fast::WorkCounters& work) {
  return work.tie_breaks > 0 ? Stage::tie_rule : work.exact_predicates > 0 ? Stage::exact : Stage::filter;
}

std::vector<Sign> signs_of(const ExactPose& pose, const Coincidence& coincidence) {
  const auto& [first, second] = coincidence.features;
  switch (coincidence.kind) {
    case CoincidenceKind::coplanar_faces:
    case CoincidenceKind::edge_in_face:
      return face_signs(pose, first, second);
    case CoincidenceKind::edge_along_edge:
    case CoincidenceKind::edge_across_edge:
      return edge_signs(pose, first, second);
    case CoincidenceKind::vertex_on_vertex:
    case CoincidenceKind::vertex_on_edge:
    case CoincidenceKind::vertex_on_face:
      return vertex_signs(pose, first, second);
    case CoincidenceKind::line_in_face:
      return {LineSigns(pose, first).facing(second)};
    case CoincidenceKind::line_through_vertex:
      return through_vertex_signs(pose, LineSigns(pose, first), second);
    case CoincidenceKind::line_through_edge:
      return {LineSigns(pose, first).side(second.index)};
    case CoincidenceKind::barycentre_on_face:
      return {LineSigns(pose, first).distance(second)};
  }
  return {};
}

}  // namespace pcm::compare
