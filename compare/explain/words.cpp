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

/// "edge 1-2 of F passes", from a line's side.
std::string value_text(Predicate predicate, int sign) {
  if (sign == 0) return "0";
  switch (predicate) {
    case Predicate::orientation:
      return sign > 0 ? "above" : "below";
    case Predicate::side_of_line:
      return sign > 0 ? "+1" : "-1";
    case Predicate::facing:
      return sign > 0 ? "enters" : "leaves";
    case Predicate::distance_along_line:
      return sign > 0 ? "ahead" : "behind";
  }
  return "";
}

std::string subject(const Sign& sign) {
  const auto plane = [&] {
    return fmt::format("plane ({}, {}, {})", text(sign.of[0]), text(sign.of[1]), text(sign.of[2]));
  };
  switch (sign.predicate) {
    case Predicate::orientation:
      return fmt::format("{} against the {}", text(sign.of[3]), plane());
    case Predicate::side_of_line:
      return fmt::format("side of {} that {} passes on", text(sign.of[0]), text(sign.of[1]));
    case Predicate::facing:
      return fmt::format("whether {} leaves or enters by {}", text(sign.of[0]), text(sign.of[1]));
    case Predicate::distance_along_line:
      return fmt::format("distance from {} to {}", text(sign.of[0]), text(sign.of[1]));
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
  std::string line = subject(sign) + ": ";
  if (sign.stage == Stage::filter) return line + value_text(sign.predicate, sign.decided) + ", the filter is sure";
  line += sign.exact == 0 ? "exactly 0" : value_text(sign.predicate, sign.exact) + " by exact arithmetic";
  line += ", the filter can't tell";
  if (sign.stage != Stage::tie_rule) return line;
  line += "; tie rule: " + value_text(sign.predicate, sign.decided);
  if (sign.predicate == Predicate::orientation) return line + ", by " + text(sign.term);
  return line +
         (sign.shift == 1 ? ", by the shift along the face's first side" : ", by the shift along its second side");
}

}  // namespace pcm::compare
