// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "tests/reference/brute_force/steps.h"

namespace pcm::brute_force {
namespace {

/// Disjoint sets of 0 ... n - 1, as plain as can be: every element carries its set's name.
class Sets {
 public:
  explicit Sets(Index n) : name_(n) { std::iota(name_.begin(), name_.end(), 0); }
  void join(Index a, Index b) { std::ranges::replace(name_, Index{name_[b]}, Index{name_[a]}); }
  Index name(Index a) const { return name_[a]; }

 private:
  std::vector<Index> name_;
};

/// Winding number of a closed surface about a point, by a segment to a point far outside. The far point takes the last
/// rank of the tie rule: it may move as it likes without entering the surface, but needs a rank to break ties with.
int winding_number(const RankedPoint& point, const RankedPoint& far, const Body& surface) {
  int entered = 0;
  for (Index f = 0; f < std::ssize(surface.faces); ++f) entered += passage(point, far, ranked_face(surface, f));
  return -entered;  // the far point's winding number is 0
}

/// A point in the direction given, at least twice as far out as anything of the scene.
Vector far_point(const Scene& scene, const Vector& direction) {
  Rational size = 1;
  for (const Body* body : {&scene.E, &scene.F})
    for (const Vector& x : body->vertices)
      for (const Rational& c : x) size = std::max(size, Rational(abs(c)));
  return size * direction;
}

std::vector<bool> used_vertices(const Body& body) {
  std::vector<bool> used(body.vertices.size(), false);
  for (const Triangle& face : body.faces)
    for (const Index v : face) used[v] = true;
  return used;
}

/// PCM section 5, closed other surface.
void label_against_closed(Answer& answer, Steps& steps, Side side) {
  const Body& body = answer.scene.body(side);
  const Body& surface = answer.scene.body(other(side));
  const int s = index_of(side);
  // Two generic directions; each has a component of at least 2, so the points lie outside.
  const Vector far_points[] = {
      far_point(answer.scene, {Rational(-1618033, 524288), Rational(2718281, 1048576), Rational(1414213, 2097152)}),
      far_point(answer.scene, {Rational(577215, 1048576), Rational(-1732050, 2097152), Rational(-3141592, 1048576)})};
  const std::vector<bool> used = used_vertices(body);
  steps.winding[s].assign(body.vertices.size(), 0);
  for (Index v = 0; v < std::ssize(body.vertices); ++v) {
    if (!used[v]) continue;
    const int w = winding_number(ranked(body, v), {&far_points[0], answer.scene.rank_count}, surface);
    if (w != winding_number(ranked(body, v), {&far_points[1], answer.scene.rank_count}, surface))
      throw std::logic_error("twin: two rays disagree about a vertex");
    steps.winding[s][v] = w;
    steps.vertex_inside[s][v] = w >= 1;
    steps.vertex_outside[s][v] = w < 1;
  }
  for (const auto& [edge, faces] : body.faces_of_edge)
    if (steps.winding[s][edge[1]] - steps.winding[s][edge[0]] != change_along(steps, side, edge[0], edge[1]))
      throw std::logic_error("twin: winding numbers disagree with the crossings of an edge");

  Sets components(static_cast<Index>(body.faces.size()));
  for (const auto& [edge, faces] : body.faces_of_edge)
    for (const Index f : faces) components.join(faces.front(), f);
  std::set<Index> crossed;
  for (Index f = 0; f < std::ssize(body.faces); ++f)
    if (steps.intersected[s][f]) crossed.insert(components.name(f));
  ActiveArea& active = side == Side::E ? answer.E : answer.F;
  for (Index f = 0; f < std::ssize(body.faces); ++f) {
    const bool inside = std::ranges::all_of(body.faces[f], [&](Index v) { return steps.vertex_inside[s][v]; });
    if (steps.intersected[s][f] || !inside) continue;
    active.inner.push_back(f);
    if (!crossed.contains(components.name(f))) answer.nested = true;
  }
}

/// PCM section 5, open other surface: only an edge whose signed sum is not zero labels its ends.
void label_against_open(Answer& answer, Steps& steps, Side side) {
  const Body& body = answer.scene.body(side);
  const int s = index_of(side);
  for (const auto& [edge, faces] : body.faces_of_edge) {
    const int change = change_along(steps, side, edge[0], edge[1]);
    if (change == 0) continue;
    steps.vertex_inside[s][edge[change > 0 ? 1 : 0]] = true;
    steps.vertex_outside[s][edge[change > 0 ? 0 : 1]] = true;
  }
  Sets sets(static_cast<Index>(body.faces.size()));
  for (const auto& [edge, faces] : body.faces_of_edge)
    if (faces.size() == 2 && !steps.intersected[s][faces[0]] && !steps.intersected[s][faces[1]])
      sets.join(faces[0], faces[1]);
  std::set<Index> labelled_inside;
  std::set<Index> labelled_outside;
  for (Index f = 0; f < std::ssize(body.faces); ++f) {
    if (steps.intersected[s][f]) continue;
    for (const Index v : body.faces[f]) {
      if (steps.vertex_inside[s][v]) labelled_inside.insert(sets.name(f));
      if (steps.vertex_outside[s][v]) labelled_outside.insert(sets.name(f));
    }
  }
  ActiveArea& active = side == Side::E ? answer.E : answer.F;
  for (Index f = 0; f < std::ssize(body.faces); ++f) {
    if (steps.intersected[s][f]) continue;
    const bool inside = labelled_inside.contains(sets.name(f));
    const bool outside = labelled_outside.contains(sets.name(f));
    if (inside && outside) answer.ambiguous = true;
    if (inside && !outside) active.inner.push_back(f);
    for (const Index v : body.faces[f]) {
      if (inside && !outside) steps.vertex_inside[s][v] = true;
      if (outside && !inside) steps.vertex_outside[s][v] = true;
    }
  }
}

}  // namespace

void find_inner_faces(Answer& answer, Steps& steps) {
  for (const Side side : {Side::E, Side::F}) {
    const Body& body = answer.scene.body(side);
    const int s = index_of(side);
    steps.vertex_inside[s].assign(body.vertices.size(), false);
    steps.vertex_outside[s].assign(body.vertices.size(), false);
    if (answer.scene.body(other(side)).closed)
      label_against_closed(answer, steps, side);
    else
      label_against_open(answer, steps, side);
    steps.active[s] = steps.intersected[s];
    for (const Index f : answer.active(side).inner) steps.active[s][f] = true;
  }
}

void find_patches(Answer& answer, const Steps& steps) {
  const auto polygon_count = static_cast<Index>(answer.polygons.size());
  std::map<Crossing, Index> polygon_of;
  for (Index i = 0; i < polygon_count; ++i)
    for (const Crossing& crossing : answer.polygons[i].points) polygon_of[crossing] = i;

  const auto vertex_name = [&](const Body& body, Index v) { return polygon_count + body.first_rank + v; };
  Sets sets(polygon_count + answer.scene.rank_count);
  for (const Side side : {Side::E, Side::F}) {
    const Body& body = answer.scene.body(side);
    const std::vector<bool>& inside = steps.vertex_inside[index_of(side)];
    for (const auto& [edge, faces] : body.faces_of_edge) {
      const auto [a, b] = edge;
      std::vector<Index> crossed;
      for (const auto& [crossing, passes] : steps.passages)
        if (crossing.edge_side == side && crossing.edge == edge) crossed.push_back(polygon_of.at(crossing));
      if (crossed.empty() && inside[a] && inside[b]) sets.join(vertex_name(body, a), vertex_name(body, b));
      if (crossed.size() == 1 && inside[a]) sets.join(vertex_name(body, a), crossed[0]);
      if (crossed.size() == 1 && inside[b]) sets.join(vertex_name(body, b), crossed[0]);
      if (crossed.size() == 2 && !inside[a] && !inside[b]) sets.join(crossed[0], crossed[1]);
    }
  }
  std::map<Index, Index> number;
  for (Index i = 0; i < polygon_count; ++i) {
    const auto [it, is_new] = number.emplace(sets.name(i), answer.patches);
    if (is_new) ++answer.patches;
    answer.polygons[i].patch = it->second;
  }
}

}  // namespace pcm::brute_force
