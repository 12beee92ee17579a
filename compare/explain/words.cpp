// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/words.h"

#include <fmt/core.h>

#include <array>

#include "compare/io/names.h"

namespace pcm::compare {
namespace {

constexpr std::array<KindWords, kCoincidenceKinds> kKinds{{
    {"coplanar_faces", "pair of faces in one plane", "pairs of faces in one plane"},
    {"edge_in_face", "edge in a face", "edges in faces"},
    {"edge_along_edge", "edge along an edge", "edges along edges"},
    {"vertex_on_vertex", "vertex on a vertex", "vertices on vertices"},
    {"vertex_on_edge", "vertex on an edge", "vertices on edges"},
    {"edge_across_edge", "edge across an edge", "edges across edges"},
    {"vertex_on_face", "vertex on a face", "vertices on faces"},
    {"line_in_face", "penetration line in the plane of a face", "penetration lines in planes of faces"},
    {"line_through_vertex", "penetration line through a vertex", "penetration lines through vertices"},
    {"line_through_edge", "penetration line through an edge", "penetration lines through edges"},
    {"barycentre_on_face", "barycentre on a face", "barycentres on faces"},
}};

/// Whether an orientation is that of a vertex against a face: the first three vertices are of one body.
bool is_against_plane(const Sign& sign) {
  return sign.predicate == Predicate::orientation && sign.of[0].side == sign.of[2].side;
}

std::string value_text(const Sign& sign, int value) {
  if (sign.predicate == Predicate::distance_along_line) return value > 0 ? "ahead" : "behind";
  if (sign.predicate == Predicate::facing) return value > 0 ? "enters" : "leaves";
  if (is_against_plane(sign)) return value > 0 ? "above" : "below";
  return value > 0 ? "+1" : "-1";
}

std::string subject(const Sign& sign) {
  const auto number = [&](std::size_t k) { return sign.of[k].index[0]; };
  if (is_against_plane(sign))
    return fmt::format("{} against the plane of vertices {}, {}, {} of {}", text(sign.of[3]), number(0), number(1),
                       number(2), name(sign.of[0].side));
  switch (sign.predicate) {
    case Predicate::orientation:
      return fmt::format("orientation of vertices {}, {} of {} and {}, {} of {}", number(0), number(1),
                         name(sign.of[0].side), number(2), number(3), name(sign.of[3].side));
    case Predicate::side_of_line:
      return fmt::format("side of {} that {} passes on", text(sign.of[0]), text(sign.of[1]));
    case Predicate::facing:
      return fmt::format("whether {} leaves or enters by {}", text(sign.of[0]), text(sign.of[1]));
    case Predicate::distance_along_line:
      return fmt::format("distance from {} to {} along the line", text(sign.of[0]), text(sign.of[1]));
  }
  return "";
}

}  // namespace

std::string text(const Feature& feature) {
  switch (feature.kind) {
    case FeatureKind::vertex:
      return fmt::format("vertex {} of {}", feature.index[0], name(feature.side));
    case FeatureKind::edge:
      return fmt::format("edge {}-{} of {}", feature.index[0], feature.index[1], name(feature.side));
    case FeatureKind::face:
      return fmt::format("face {} of {}", feature.index[0], name(feature.side));
    case FeatureKind::line:
      return fmt::format("the penetration line of face {} of {}", feature.index[0], name(feature.side));
    case FeatureKind::barycentre:
      return fmt::format("the barycentre of face {} of {}", feature.index[0], name(feature.side));
  }
  return "";
}

const KindWords& words(CoincidenceKind kind) {
  return kKinds[static_cast<std::size_t>(kind)];
}

std::string_view key(Predicate predicate) {
  constexpr std::array<std::string_view, 4> kNames{"orientation", "side_of_line", "facing", "distance_along_line"};
  return kNames[static_cast<std::size_t>(predicate)];
}

std::string_view key(Stage stage) {
  constexpr std::array<std::string_view, 3> kNames{"filter", "exact", "tie_rule"};
  return kNames[static_cast<std::size_t>(stage)];
}

std::string_view key(FeatureKind kind) {
  constexpr std::array<std::string_view, 5> kNames{"vertex", "edge", "face", "line", "barycentre"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string text(const std::vector<MovedCoordinate>& term) {
  std::string joined;
  for (const MovedCoordinate& moved : term)
    joined += fmt::format("{}{} of vertex {} of {}", joined.empty() ? "" : " times ", "xyz"[moved.coordinate],
                          moved.vertex, name(moved.side));
  return joined;
}

std::string text(const Sign& sign) {
  const std::string line = subject(sign) + ": ";
  if (sign.stage == Stage::filter) return line + value_text(sign, sign.decided) + ", the filter is sure";
  if (sign.exact != 0) return line + value_text(sign, sign.exact) + ", by exact arithmetic, the filter can't tell";
  if (sign.stage == Stage::exact) return line + "exactly 0, by exact arithmetic, which no rule changes";
  return line + "exactly 0; tie rule: " + value_text(sign, sign.decided) + ", by " +
         (sign.predicate == Predicate::orientation ? text(sign.term)
          : sign.shift == 1                        ? "the barycentre's shift along its face's first side"
                                                   : "the barycentre's shift along its face's second side");
}

}  // namespace pcm::compare
