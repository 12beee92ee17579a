// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/brute_force/brute_force.h"

#include "tests/reference/brute_force/steps.h"

namespace pcm::brute_force {
namespace {

/// Sum of the faces' areas, each taken to the share given.
template <typename ShareOf>
double summed_area(const Scene& scene, const Body& body, const ActiveArea& active, const ShareOf& share_of) {
  std::vector<Root> terms;
  for (Index f = 0; f < std::ssize(body.faces); ++f)
    terms.push_back(
        {Rational(share_of(active.shares[f]) * scene.unit * scene.unit / 2), dot(body.normals[f], body.normals[f])});
  return rounded(terms);
}

template <typename ShareOf>
Vector summed_vector_area(const Body& body, const ActiveArea& active, const ShareOf& share_of) {
  Vector sum{};
  for (Index f = 0; f < std::ssize(body.faces); ++f)
    sum = sum + Rational(share_of(active.shares[f]) / 2) * body.normals[f];
  return sum;
}

/// One third of the flux of x through the faces, each taken to the share given: x . N is constant on a face.
template <typename ShareOf>
Rational summed_volume(const Body& body, const ActiveArea& active, const ShareOf& share_of) {
  Rational sum = 0;
  for (Index f = 0; f < std::ssize(body.faces); ++f)
    sum += share_of(active.shares[f]) * dot(body.corner(f, 0), body.normals[f]) / 6;
  return sum;
}

std::array<double, 3> rounded_vector(const Vector& x, const Rational& unit) {
  return {rounded(Rational(x[0] * unit)), rounded(Rational(x[1] * unit)), rounded(Rational(x[2] * unit))};
}

}  // namespace

void sum_areas(Answer& answer) {
  const Scene& scene = answer.scene;
  const Rational square = scene.unit * scene.unit;
  const Rational cube = square * scene.unit;
  const auto perturbed = [](const Share& share) -> Rational { return share.perturbed; };
  Rational volume = 0;
  Rational perturbed_volume = 0;
  for (const Side side : {Side::E, Side::F}) {
    const Body& body = scene.body(side);
    ActiveArea& active = side == Side::E ? answer.E : answer.F;
    if (!scene.body(other(side)).closed)
      for (Share& share : active.shares) share.below = share.perturbed;
    const auto counted = [side](const Share& share) -> Rational {
      return side == Side::E ? share.below : Rational(share.below - share.equal);
    };
    const auto open = [](const Share& share) -> Rational { return share.below - share.equal; };
    const auto closed = [](const Share& share) -> Rational { return share.below + share.opposite; };
    active.open = summed_area(scene, body, active, open);
    active.closed = summed_area(scene, body, active, closed);
    active.area = summed_area(scene, body, active, counted);
    active.perturbed_area = summed_area(scene, body, active, perturbed);
    active.exact_vector_area = summed_vector_area(body, active, counted);
    active.vector_area = rounded_vector(active.exact_vector_area, square);
    active.perturbed_vector_area = rounded_vector(summed_vector_area(body, active, perturbed), square);
    volume += summed_volume(body, active, counted);
    perturbed_volume += summed_volume(body, active, perturbed);
    for (Index f = 0; f < std::ssize(body.faces); ++f) {
      const Share& share = active.shares[f];
      const Vector moment = side == Side::E ? share.moment : share.moment - share.equal_moment;
      for (int i = 0; i < 3; ++i) answer.fluxes[i] += moment[i] * body.normals[f][i] / 2;
    }
  }
  if (!scene.E.closed || !scene.F.closed) return;
  answer.volume = rounded(Rational(volume * cube));
  answer.perturbed_volume = rounded(Rational(perturbed_volume * cube));
}

Answer answer(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Pose& pose, reference::Problem problem,
              Mode mode, Scheme scheme, double max_penetration) {
  Answer answer;
  Steps steps;
  answer.scene = scene_of(mesh_E, mesh_F, pose, problem);
  find_crossings(answer, steps);
  chain_polygons(answer, steps);
  find_inner_faces(answer, steps);
  find_patches(answer, steps);
  clip_by_prisms(answer);
  sweep_perturbed_areas(answer, steps);
  sum_areas(answer);
  find_elements(answer, steps, mode);
  if (scheme == Scheme::clipped) find_clipped_elements(answer, mode, max_penetration);
  return answer;
}

}  // namespace pcm::brute_force
