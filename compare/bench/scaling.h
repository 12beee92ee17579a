// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compare/bench/timing.h"
#include "compare/io/tables/table.h"
#include "pcm/triangle_mesh.h"

/// `pcm bench scaling`: how the engine's time, setup time and memory grow, on two spheres (subdivided icosahedra).
namespace pcm::compare {

/// What an evaluation is asked for: whether surfaces touch, which ends at the first crossing; polygons, which cost what
/// the border of the patch is long; and what needs all of its faces.
enum class Asked : std::uint8_t {
  touch,
  polygons,
  force,
  everything,
  clipped_everything,
};
inline constexpr std::size_t kAsked = 5;

/// Setting up two surfaces of one resolution.
struct SetupResult {
  std::int64_t faces = 0;     ///< of each surface
  double setup_ms = 0;        ///< of one surface
  double rest_ms = 0;         ///< of what is left to contacts, were it computed for all faces
  double fcl_ms = 0;          ///< of FCL's tree for the same surface; 0 where the program was built without it
  double bytes_a_face = 0;    ///< what a prepared surface holds; 0 where the allocator doesn't tell
  double peak_megabytes = 0;  ///< greatest resident set of the program so far, two surfaces of this size in it
};

/// Means over the poses of one resolution and depth.
struct ScalingPoint {
  std::int64_t faces = 0;  ///< of each surface
  double depth = 0;        ///< overlap of the spheres in diameters
  double crossings = 0;
  double elements = 0;  ///< barycentric
  double box_tests = 0;
  std::array<double, kAsked> median_us{};
  /// How many times as fast two threads are, medians over the poses: force, and everything in the clipped scheme.
  double force_gain_of_two = 0, clipped_gain_of_two = 0;

  double us(Asked asked) const { return median_us[static_cast<std::size_t>(asked)]; }
  /// Cost of a crossing or an element in nanoseconds, everything asked for.
  double unit_cost_ns() const { return 1e3 * us(Asked::everything) / (crossings + elements); }
};

/// Points along which one thing grows.
struct ScalingSeries {
  std::string name;
  std::string explanation;
  std::string over;  ///< what times are fitted over
  std::vector<ScalingPoint> points;

  /// Exponent of the time over faces, or over crossings and elements in the last series.
  double exponent(Asked asked) const;
};

struct ScalingResult {
  std::vector<SetupResult> setups;
  std::vector<ScalingSeries> series;
};

/// Spheres of levels 2 (320 faces) to `finest` (8: 1,310,720), `poses` random rotations each.
ScalingResult run_scaling(Index finest, std::int64_t poses, const std::function<void(const std::string&)>& progress);

Table setup_table(const ScalingResult& result);
Table scaling_table(const ScalingResult& result);
Table exponents_table(const ScalingResult& result);
std::string scaling_screen(const ScalingResult& result, const Machine& machine);
std::string scaling_markdown(const ScalingResult& result, const Machine& machine);

}  // namespace pcm::compare
