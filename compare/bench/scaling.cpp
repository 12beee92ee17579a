// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/scaling.h"

#include <fmt/core.h>
#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/bench/peer.h"
#include "compare/random/random.h"
#include "compare/verify/routes/wanted_presets.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"

namespace pcm::compare {
namespace {

constexpr std::uint64_t kSeed = 20032;
constexpr Index kCoarsest = 2;
/// Overlap in diameters where the patch is the same over all meshes.
constexpr double kDepth = 0.05;

double heap_bytes() {
#ifdef __GLIBC__
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
#else
  return 0;
#endif
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
}

/// Two spheres of radius 1, prepared apart from one another, in both schemes.
struct Spheres {
  Spheres(const fast::Surface& E, const fast::Surface& F)
      : barycentric(E, F, bench_law(), Mode::E, Scheme::barycentric),
        clipped(E, F, bench_law(), Mode::E, Scheme::clipped) {}

  std::int64_t faces() const { return static_cast<std::int64_t>(barycentric.surface_E().mesh().faces.size()); }

  fast::Pairing barycentric, clipped;
  fast::Workspace workspace, workspace_of_two{2};
};

fast::Surface prepared_sphere(Index level, SetupResult& setup) {
  TriangleMesh mesh = generate::icosphere(1, level);
  setup.faces = static_cast<std::int64_t>(mesh.faces.size());
  const double mesh_bytes = static_cast<double>(mesh.vertices.capacity() * sizeof(mesh.vertices[0]) +
                                                mesh.faces.capacity() * sizeof(mesh.faces[0]));
  const double heap_before = heap_bytes() - mesh_bytes;
  std::optional<fast::Surface> surface;
  setup.setup_ms = 1e-3 * time_us([&] { surface.emplace(std::move(mesh)); });
  setup.bytes_a_face = std::max(0.0, heap_bytes() - heap_before) / static_cast<double>(setup.faces);
  setup.rest_ms = 1e-3 * time_us([&] { surface->prepare_all_faces(); });
  return *surface;
}

/// Milliseconds that FCL takes to build its tree for one surface; 0 where it is not there.
double time_of_fcl_ms(const TriangleMesh& mesh) {
  const std::vector<PeerEntry> all = all_peers();
  const auto fcl = std::find_if(all.begin(), all.end(), [](const PeerEntry& entry) {
    return entry.make && entry.debian_package == "libfcl-dev";
  });
  if (fcl == all.end()) return 0;
  // It sets two up.
  return 0.5 * 1e-3 * time_us([&] { fcl->make(mesh, mesh); });
}

Pose pose_at(double depth, std::uint64_t number) {
  PoseRandom random(kSeed, 0, 0, number);
  Pose pose;
  pose.A = random.rotation();
  pose.r = random.direction() * (2 - 2 * depth);
  return pose;
}

struct Question {
  Asked asked;
  bool clipped;
  Wanted wanted;
};
constexpr std::array<Question, kAsked> kQuestions{{
    {Asked::touch, false, kTouchOnly},
    {Asked::polygons, false, kPolygonsOnly},
    {Asked::force, false, kForceOnly},
    {Asked::everything, false, {}},
    {Asked::clipped_everything, true, {}},
}};

/// Median over the poses.
double gain_of_two_threads(Spheres& spheres, const fast::Pairing& pairing, const Wanted& wanted, double depth,
                           std::int64_t poses) {
  const OnAnyCore both_threads;
  std::vector<double> gains;
  for (std::int64_t p = 0; p < poses; ++p) {
    const Pose pose = pose_at(depth, static_cast<std::uint64_t>(p));
    const auto ask = [&](fast::Workspace& workspace) {
      fast::evaluate(pairing, pose, bench_velocity(), wanted, workspace);
    };
    gains.push_back(times_as_fast([&] { ask(spheres.workspace); }, [&] { ask(spheres.workspace_of_two); }));
  }
  return quantile(gains, 0.5);
}

ScalingPoint measure(Spheres& spheres, double depth, std::int64_t poses) {
  ScalingPoint point;
  point.faces = spheres.faces();
  point.depth = depth;
  std::array<std::vector<double>, kAsked> times;
  for (std::int64_t p = 0; p < poses; ++p) {
    const Pose pose = pose_at(depth, static_cast<std::uint64_t>(p));
    for (const Question& question : kQuestions) {
      const fast::Pairing& pairing = question.clipped ? spheres.clipped : spheres.barycentric;
      const auto ask = [&]() -> const fast::Contact& {
        return fast::evaluate(pairing, pose, bench_velocity(), question.wanted, spheres.workspace);
      };
      times[static_cast<std::size_t>(question.asked)].push_back(least_time([] {}, ask).query_us);
      if (question.asked != Asked::everything) continue;
      const fast::Contact& contact = ask();
      const auto number = static_cast<double>(poses);
      point.crossings += static_cast<double>(contact.crossings.size()) / number;
      point.elements += static_cast<double>(contact.element_count) / number;
      point.box_tests += static_cast<double>(contact.work.box_tests) / number;
    }
  }
  for (std::size_t a = 0; a < kAsked; ++a) point.median_us[a] = quantile(times[a], 0.5);
  point.force_gain_of_two = gain_of_two_threads(spheres, spheres.barycentric, kForceOnly, depth, poses);
  point.clipped_gain_of_two = gain_of_two_threads(spheres, spheres.clipped, {}, depth, poses);
  return point;
}

std::int64_t faces_of_level(Index level) {
  return 20 * (std::int64_t{1} << (2 * level));
}

}  // namespace

double ScalingSeries::exponent(Asked asked) const {
  std::vector<double> x, y;
  for (const ScalingPoint& point : points) {
    x.push_back(over == "faces" ? static_cast<double>(point.faces) : point.crossings + point.elements);
    y.push_back(point.us(asked));
  }
  return fitted_exponent(x, y);
}

ScalingResult run_scaling(Index finest, std::int64_t poses, const std::function<void(const std::string&)>& progress) {
  // The patch over which all depths are compared lies on the finest mesh but two.
  const Index patch_level = std::max(kCoarsest, finest - 2);
  ScalingSeries geometry{"mesh size, same patch",
                         fmt::format("spheres overlap by {:g} % of the diameter: crossings grow as the square root of "
                                     "the faces, elements as the faces",
                                     100 * kDepth),
                         "faces",
                         {}};
  ScalingSeries resolution{"mesh size, same number of faces in the patch",
                           "overlap as the square of the edge length: only the mesh around the patch grows",
                           "faces",
                           {}};
  ScalingSeries patch{
      "patch size",
      fmt::format("one mesh of {} faces, overlap from 0.01 to 30 % of the diameter", faces_of_level(patch_level)),
      "crossings and elements",
      {}};
  ScalingResult result;
  for (Index level = kCoarsest; level <= finest; ++level) {
    progress(fmt::format("{} faces", faces_of_level(level)));
    SetupResult setup;
    const fast::Surface E = prepared_sphere(level, setup), F = prepared_sphere(level, setup);
    Spheres spheres(E, F);
    geometry.points.push_back(measure(spheres, kDepth, poses));
    resolution.points.push_back(measure(spheres, kDepth / std::pow(4.0, level - kCoarsest), poses));
    if (level == patch_level)
      for (const double depth : {1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3})
        patch.points.push_back(measure(spheres, depth, poses));
    setup.peak_megabytes = peak_megabytes();
    setup.fcl_ms = time_of_fcl_ms(E.mesh());
    result.setups.push_back(setup);
  }
  // A pose in which nothing touches has no place on a logarithmic scale.
  for (ScalingSeries* series : {&geometry, &resolution, &patch}) {
    std::erase_if(series->points, [](const ScalingPoint& point) { return point.crossings + point.elements == 0; });
    result.series.push_back(std::move(*series));
  }
  return result;
}

}  // namespace pcm::compare
