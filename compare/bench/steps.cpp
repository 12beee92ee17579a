// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/steps.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>

#include "compare/bench/bodies.h"
#include "compare/io/names.h"
#include "compare/poses/greatest_extent.h"
#include "compare/poses/recorded_motion.h"
#include "compare/random/random.h"
#include "compare/verify/routes/wanted_presets.h"
#include "compare/verify/run/recorded_scenes.h"
#include "fast/base/same_bits.h"
#include "pcm/pairing_memory.h"

namespace pcm::compare {
namespace {

constexpr std::uint64_t kSeed = 51;

/// Poses and velocities of a pairing, one after the other; the first of them prepare for those that are measured.
struct Motion {
  fast::Pairing pairing;
  std::vector<MovingPose> states;
  std::size_t measured_from = 0;
};

/// Motions that are measured together; each starts anew.
struct Scenario {
  std::string bodies, steps, scheme;
  std::vector<Motion> motions;
};

/// A way from a pose: a straight one with a turn about one axis, or difference quotients, or other velocities there.
struct Way {
  enum class Kind : std::uint8_t { straight, differences, velocities };
  std::string name;
  Kind kind;
  double step;  ///< by which points of F move about, m
};

const std::vector<Way>& kinds_of_ways() {
  static const std::vector<Way> all{
      {"another velocity", Way::Kind::velocities, 0},  {"differences by 10 nm", Way::Kind::differences, 1e-8},
      {"steps of 0.01 mm", Way::Kind::straight, 1e-5}, {"steps of 0.1 mm", Way::Kind::straight, 1e-4},
      {"steps of 0.3 mm", Way::Kind::straight, 3e-4},  {"steps of 1 mm", Way::Kind::straight, 1e-3}};
  return all;
}

Pose moved(const Pose& start, const Eigen::Vector3d& move, const Eigen::Vector3d& turn) {
  return {Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) * start.A, start.r + move};
}

/// Of points of a body of this size, m: on straight ways half of a step is due to the move, half to the turn.
Motion motion_along(const Way& way, const fast::Pairing& pairing, const Pose& start, double size, PoseRandom random) {
  constexpr int kFirst = 3, kMeasured = 12;
  const Eigen::Vector3d direction = random.direction(), axis = random.direction();
  Motion motion{pairing, {}, kFirst};
  for (int i = 0; i < kFirst + kMeasured; ++i) {
    MovingPose state{start, bench_velocity()};
    if (way.kind == Way::Kind::velocities) {
      state.velocity.v *= 1 + 0x1p-20 * i;
    } else if (way.kind == Way::Kind::straight) {
      state.pose = moved(start, 0.5 * way.step * i * direction, way.step * i / size * axis);
    } else if (i > 0) {
      // About the start, along each coordinate and back.
      const int coordinate = (i - 1) / 2 % 6;
      const Eigen::Vector3d step = (i % 2 == 0 ? way.step : -way.step) * Eigen::Vector3d::Unit(coordinate % 3);
      const Eigen::Vector3d none = Eigen::Vector3d::Zero();
      state.pose = coordinate < 3 ? moved(start, step, none) : moved(start, none, 2 / size * step);
    }
    motion.states.push_back(state);
  }
  return motion;
}

std::vector<Scenario> seeded_scenarios(std::int64_t number) {
  std::vector<Scenario> scenarios;
  for (const char* const kind : {"bubbles", "spheres"}) {
    const BenchBody body = bench_body(kind);
    const fast::Surface surface(body.mesh);
    surface.prepare_all_faces();  // Or whoever is asked first would pay for both.
    const double size = greatest_extent(body.mesh);
    const std::vector<Pose> starts = bench_poses(body.mesh, Distance::touching, number);
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      const fast::Pairing pairing(surface, surface, bench_law(), Mode::E, scheme);
      for (const Way& way : kinds_of_ways()) {
        Scenario& scenario = scenarios.emplace_back(Scenario{body.name, way.name, std::string(name(scheme)), {}});
        for (std::size_t k = 0; k < starts.size(); ++k)
          scenario.motions.push_back(motion_along(way, pairing, starts[k], size, PoseRandom(kSeed, 1, 0, k)));
      }
    }
  }
  return scenarios;
}

/// The recorded steps of all pairings, as they came.
Scenario recorded_scenario() {
  Scenario scenario{"scenes of pcm simulate", "as recorded", std::string(name(Scheme::barycentric)), {}};
  for (const SurfacePair& pair : recorded_pairs()) {
    const fast::Surface E(pair.E), F(pair.F);
    for (const fast::Surface& surface : {E, F}) surface.prepare_all_faces();
    const fast::Pairing pairing(E, F, pair.law);
    for (const RecordedStretch& stretch : pair.motion) {
      Motion& motion = scenario.motions.emplace_back(Motion{pairing, {}, 1});
      for (const RecordedStep& step : stretch) motion.states.push_back(state_of(step));
    }
  }
  return scenario;
}

/// What one of the two has answered, by step.
struct Asked {
  std::vector<std::vector<double>> us;  ///< by step, of each pass
  std::vector<std::array<Eigen::Vector3d, 2>> loads;
  fast::WorkCounters work;
};

/// Asks for all motions once.
template <class Start>
void ask(const Scenario& scenario, bool counted, Asked& asked, const Start& start) {
  std::size_t number = 0;
  for (const Motion& motion : scenario.motions) {
    const auto evaluate = start(motion.pairing);
    for (std::size_t i = 0; i < motion.states.size(); ++i) {
      const fast::Contact* answer = nullptr;
      const double us = time_us([&] { answer = &evaluate(motion.states[i]); });
      if (i < motion.measured_from) continue;
      if (number == asked.us.size()) {
        asked.us.emplace_back();
        asked.loads.push_back({answer->force_Me, answer->torque_Me});
        asked.work += answer->work;
      }
      if (counted) asked.us[number].push_back(us);
      ++number;
    }
  }
}

StepsResult measure(const Scenario& scenario, int passes) {
  Asked following, isolated;
  fast::Workspace one, other;
  std::optional<fast::PairingMemory> memory;
  const auto follow = [&](const fast::Pairing& pairing) {
    memory.emplace(pairing);
    return [&](const MovingPose& state) -> const fast::Contact& {
      return memory->evaluate(state.pose, state.velocity, kForceOnly, one);
    };
  };
  const auto find_anew = [&](const fast::Pairing& pairing) {
    return [&](const MovingPose& state) -> const fast::Contact& {
      return fast::evaluate(pairing, state.pose, state.velocity, kForceOnly, other);
    };
  };
  // In turn, so that neither finds in the caches what the other left there. The first pass is not measured.
  for (int pass = 0; pass <= passes; ++pass) {
    ask(scenario, pass > 0, following, follow);
    ask(scenario, pass > 0, isolated, find_anew);
  }
  StepsResult result;
  result.bodies = scenario.bodies;
  result.steps = scenario.steps;
  result.scheme = scenario.scheme;
  result.evaluations = static_cast<std::int64_t>(following.us.size());
  const auto medians = [](const Asked& asked) {
    std::vector<double> us;
    for (const std::vector<double>& of_step : asked.us) us.push_back(quantile(of_step, 0.5));
    return us;
  };
  const std::vector<double> on = medians(following), off = medians(isolated);
  double sum_on = 0, sum_off = 0;
  for (std::size_t k = 0; k < on.size(); ++k) {
    sum_on += on[k];
    sum_off += off[k];
    result.different += !(fast::same_bits(following.loads[k][0], isolated.loads[k][0]) &&
                          fast::same_bits(following.loads[k][1], isolated.loads[k][1]));
  }
  result.following_us = quantile(on, 0.5);
  result.isolated_us = quantile(off, 0.5);
  result.whole_ratio = sum_on / sum_off;
  result.following = following.work;
  result.isolated = isolated.work;
  return result;
}

}  // namespace

std::vector<StepsResult> run_steps(std::int64_t ways, int passes,
                                   const std::function<void(const std::string&)>& progress) {
  std::vector<StepsResult> results;
  std::vector<Scenario> scenarios = seeded_scenarios(ways);
  scenarios.push_back(recorded_scenario());
  for (const Scenario& scenario : scenarios) {
    progress(fmt::format("{}, {}, {}", scenario.bodies, scenario.steps, scenario.scheme));
    results.push_back(measure(scenario, passes));
  }
  return results;
}

}  // namespace pcm::compare
