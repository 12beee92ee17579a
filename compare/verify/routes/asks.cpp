// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/asks.h"

#include <array>
#include <bit>
#include <cstddef>

#include "compare/verify/routes/wanted_presets.h"
#include "fast/base/geometry.h"

namespace pcm::compare {
namespace {

/// The finaliser of splitmix64 (Steele, Lea and Flood 2014): every bit of the result depends on every bit of x.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// Seventeen switches from as many bits.
Ask drawn_ask(Route route, std::uint64_t bits) {
  Ask ask{route, {}, {}};
  const auto next = [&bits] {
    const bool bit = (bits & 1) != 0;
    bits >>= 1;
    return bit;
  };
  for (bool* wanted : {&ask.wanted.polygons, &ask.wanted.areas, &ask.wanted.force, &ask.wanted.elements,
                       &ask.wanted.bound, &ask.wanted.statistics})
    *wanted = next();
  for (bool* saving :
       {&ask.savings.broad_phase, &ask.savings.certificates, &ask.savings.first_crossing, &ask.savings.lazy_vertices,
        &ask.savings.one_sided, &ask.savings.velocities, &ask.savings.only_wanted, &ask.savings.filters,
        &ask.savings.known_poses, &ask.savings.coherence})
    *saving = next();
  ask.wanted.tangent = next();
  return ask;
}

}  // namespace

std::string_view name(Route route) {
  constexpr std::array<std::string_view, 9> kNames = {"plain", "bounded",    "force", "touch", "tangent",
                                                      "drawn", "known pose", "scene", "motion"};
  return kNames[static_cast<std::size_t>(route)];
}

std::vector<Ask> asks_at(const Pose& pose, const Velocity& velocity) {
  Wanted with_bound;
  with_bound.bound = true;
  std::vector<Ask> asks = {{Route::plain, {}, {}},
                           {Route::bounded, with_bound, {}},
                           {Route::force, kForceOnly, {}},
                           {Route::touch, kTouchOnly, {}},
                           {Route::tangent, kForceAndTangent, {}}};
  asks.push_back(drawn_ask(Route::drawn, bits_of(pose, velocity, Draw::ask)));
  return asks;
}

std::vector<Ask> known_pose_asks_at(const Pose& pose, const Velocity& velocity) {
  return {{Route::known_pose, {}, {}}, drawn_ask(Route::known_pose, bits_of(pose, velocity, Draw::known_pose_ask))};
}

std::vector<Ask> scene_asks_at(const Pose& pose, const Velocity& velocity) {
  return {{Route::scene, {}, {}}, drawn_ask(Route::scene, bits_of(pose, velocity, Draw::scene_ask))};
}

bool is_pose_for_scenes(const Pose& pose) {
  // Less what the product with a turn rounds.
  constexpr double kSkew = (1 - 0x1p-10) * 1e-10;
  return fast::orthogonality_error(pose.A) <= kSkew;
}

std::uint64_t bits_of(const Pose& pose, const Velocity& velocity, Draw purpose) {
  std::uint64_t hash = 0;
  const auto mix = [&hash](double x) { hash = mixed(hash + 0x9e3779b97f4a7c15 + std::bit_cast<std::uint64_t>(x)); };
  for (int k = 0; k < 9; ++k) mix(pose.A(k / 3, k % 3));
  for (const Eigen::Vector3d* v : {&pose.r, &velocity.v, &velocity.w})
    for (int k = 0; k < 3; ++k) mix((*v)[k]);
  return mixed(hash + static_cast<std::uint64_t>(purpose));
}

}  // namespace pcm::compare
