// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bench/skip.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "compare/bench/bodies.h"
#include "compare/bench/moving_bubbles.h"
#include "compare/random/random.h"
#include "compare/verify/routes/wanted_presets.h"
#include "fast/base/same_bits.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

using fast::Savings;
using fast::SceneCounters;

constexpr std::uint64_t kSeed = 50;
constexpr double kStep = 1e-3;  // s

struct Setting {
  std::string name;
  Savings savings;
};

Savings without(bool Savings::*saving) {
  Savings savings;
  savings.*saving = false;
  return savings;
}

std::vector<Setting> settings() {
  return {{"everything skipped", {}},
          {"no broad phase", without(&Savings::broad_phase)},
          {"no certificates", without(&Savings::certificates)},
          {"all vertices transformed", without(&Savings::lazy_vertices)},
          {"elements on both sides", without(&Savings::one_sided)},
          {"all answers, asked for or not", without(&Savings::only_wanted)},
          {"no filters", without(&Savings::filters)},
          {"no coherence", without(&Savings::coherence)},
          {"nothing skipped", Savings::none()}};
}

bool same_bits(const fast::PairingLoad& a, const fast::PairingLoad& b) {
  return a.touching == b.touching && a.nested == b.nested && fast::same_bits(a.force_Me, b.force_Me) &&
         fast::same_bits(a.torque_Me, b.torque_Me);
}

void run_scenes(std::int64_t steps, SkipResult& result, const std::function<void(const std::string&)>& progress) {
  const MovingBubbles bubbles(result.bubbles, kSeed);
  const std::vector<Setting> all = settings();
  std::vector<fast::Scene> scenes;
  for (const Setting& setting : all) scenes.push_back(bubbles.scene(setting.savings));
  result.pairings = scenes.front().pairings();
  result.steps = steps;
  result.step_s = kStep;
  std::vector<std::vector<double>> times(all.size());
  std::vector<SceneCounters> sums(all.size());
  // The first step is not measured: memory grows, certificates are sought.
  for (std::int64_t step = 0; step <= steps; ++step) {
    progress(fmt::format("bubbles, step {} of {}", step, steps));
    const std::vector<fast::BodyState> states = bubbles.states(static_cast<double>(step) * kStep);
    for (std::size_t s = 0; s < all.size(); ++s) {
      const double us = time_us([&] {
        scenes[s].move(states);
        scenes[s].evaluate_all();
      });
      if (step == 0) continue;
      times[s].push_back(us);
      const SceneCounters counters = scenes[s].counters();
      sums[s].apart_by_boxes += counters.apart_by_boxes;
      sums[s].apart_by_certificate += counters.apart_by_certificate;
      sums[s].evaluated += counters.evaluated;
      sums[s].certificates_sought += counters.certificates_sought;
      sums[s].work.predicates += counters.work.predicates;
      sums[s].work.exact_predicates += counters.work.exact_predicates;
      sums[s].work.vertices_transformed += counters.work.vertices_transformed;
    }
    for (Index i = 0; i < scenes.front().pairings(); ++i) {
      const fast::PairingLoad& load = scenes.front().load(i);
      if (step > 0) result.touching += load.touching;
      for (std::size_t s = 1; s < all.size(); ++s) {
        ++result.answers_compared;
        result.answers_different += !same_bits(load, scenes[s].load(i));
      }
    }
  }
  const auto number = static_cast<double>(steps);
  result.touching /= number;
  for (std::size_t s = 0; s < all.size(); ++s) {
    double sum = 0;
    for (const double us : times[s]) sum += us;
    const auto a_step = [&](std::int64_t count) { return static_cast<double>(count) / number; };
    result.scenes.push_back({all[s].name, quantile(times[s], 0.5), sum / number, a_step(sums[s].apart_by_boxes),
                             a_step(sums[s].apart_by_certificate), a_step(sums[s].evaluated),
                             a_step(sums[s].certificates_sought), a_step(sums[s].work.predicates),
                             a_step(sums[s].work.exact_predicates), a_step(sums[s].work.vertices_transformed)});
  }
}

/// A question asked with a saving on and off.
struct Question {
  std::string saving;
  std::string scene;
  TriangleMesh E, F;
  double overlap;   ///< of the spheres or bubbles along the axis between them, m
  double touching;  ///< distance of their centres where they would just touch, m
  ContactLaw law;
  Wanted wanted;
  bool Savings::*off;
  std::string counted;
  std::int64_t fast::WorkCounters::*counter;
};

std::vector<Question> questions() {
  const TriangleMesh sphere = generate::icosphere(1, 5), coarse = generate::icosphere(1, 2);
  const TriangleMesh bubble = generate::bubble();
  ContactLaw elastic;
  return {{"first crossing", "do two spheres of 20,480 faces touch, 5 % deep", sphere, sphere, 0.1, 2, bench_law(),
           kTouchOnly, &Savings::first_crossing, "candidate pairs", &fast::WorkCounters::candidate_pairs},
          {"lazy vertices", "force on two spheres of 20,480 faces, 0.02 % deep", sphere, sphere, 4e-4, 2, bench_law(),
           kForceOnly, &Savings::lazy_vertices, "vertices transformed", &fast::WorkCounters::vertices_transformed},
          {"one-sided mode", "force on a sphere of 320 faces by one of 20,480, 10 % deep", coarse, sphere, 0.2, 2,
           bench_law(), kForceOnly, &Savings::one_sided, "elements formed", &fast::WorkCounters::elements},
          {"velocities", "elastic force on two spheres of 20,480 faces, 10 % deep", sphere, sphere, 0.2, 2, elastic,
           kForceOnly, &Savings::velocities, "elements with velocities", &fast::WorkCounters::velocities},
          {"only what is wanted", "do two bubbles touch, 5 % deep", bubble, bubble, 0.02, 0.4, bench_law(), kTouchOnly,
           &Savings::only_wanted, "elements formed", &fast::WorkCounters::elements},
          {"filters", "force on two bubbles, 5 % deep", bubble, bubble, 0.02, 0.4, bench_law(), kForceOnly,
           &Savings::filters, "exact signs", &fast::WorkCounters::exact_predicates}};
}

/// Turned about the axis that joins the two: bubbles meet pole to pole.
Pose drawn_pose(double touching, double overlap, std::int64_t number) {
  PoseRandom random(kSeed, 1, 0, static_cast<std::uint64_t>(number));
  Pose pose;
  const double angle = random.uniform(0, 6);
  pose.A << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  const double x = 0.01 * touching * random.uniform(-1, 1), y = 0.01 * touching * random.uniform(-1, 1);
  pose.r = {x, y, touching - overlap};
  return pose;
}

SavingResult measure(const Question& question, std::int64_t poses) {
  const fast::Pairing pairing{fast::Surface(question.E), fast::Surface(question.F), question.law, Mode::E,
                              Scheme::barycentric};
  fast::Workspace workspace;
  SavingResult result{question.saving, question.scene, 0, 0, question.counted, 0, 0};
  std::vector<double> on, off;
  for (std::int64_t p = 0; p < poses; ++p) {
    const Pose pose = drawn_pose(question.touching, question.overlap, p);
    const auto ask = [&](const Savings& savings) -> const fast::Contact& {
      return fast::evaluate(pairing, pose, bench_velocity(), question.wanted, workspace, savings);
    };
    on.push_back(least_time([] {}, [&] { ask({}); }).query_us);
    result.work_on += ask({}).work.*question.counter;
    off.push_back(least_time([] {}, [&] { ask(without(question.off)); }).query_us);
    result.work_off += ask(without(question.off)).work.*question.counter;
  }
  result.on_us = quantile(on, 0.5);
  result.off_us = quantile(off, 0.5);
  return result;
}

/// The oracle looks exactly at pairs of faces whose boxes meet, or at all.
SavingResult measure_candidate_region(std::int64_t poses) {
  using reference::CandidateRegion;
  const TriangleMesh sphere = generate::icosphere(1, 2);
  const auto oracle = [&](CandidateRegion region) {
    return reference::Oracle(sphere, sphere, bench_law(), Mode::E, Scheme::barycentric, region);
  };
  const reference::Oracle near = oracle(CandidateRegion::near), everywhere = oracle(CandidateRegion::everywhere);
  SavingResult result{"oracle's candidate region",
                      "all of two spheres of 320 faces, 10 % deep, exactly",
                      0,
                      0,
                      "face pairs looked at",
                      0,
                      0};
  std::vector<double> on, off;
  for (std::int64_t p = 0; p < poses; ++p) {
    PoseRandom random(kSeed, 2, 0, static_cast<std::uint64_t>(p));
    Pose pose;
    pose.A = random.rotation();
    pose.r = 1.8 * random.direction();
    const auto ask = [&](const reference::Oracle& asked, std::vector<double>& times, std::int64_t& work) {
      reference::Inquiry inquiry(asked, pose, bench_velocity());
      times.push_back(time_us([&] { inquiry.answer(reference::Problem::exact); }));
      work += static_cast<std::int64_t>(inquiry.candidate_pairs(reference::Problem::exact));
    };
    ask(near, on, result.work_on);
    ask(everywhere, off, result.work_off);
  }
  result.on_us = quantile(on, 0.5);
  result.off_us = quantile(off, 0.5);
  return result;
}

/// Many bubbles, each paired with one and the same body and touching nothing.
struct Apart {
  static constexpr Index kBodies = 1000;
  fast::Scene scene;

  /// `distance`: of neighbours on a line; with 0 all hang in an open container whose box holds them.
  Apart(const Savings& savings, double distance) : scene(savings) {
    const fast::Surface bubble(generate::bubble());
    scene.add_body(distance > 0 ? bubble : fast::Surface(generate::pyramid(8, 8)));
    std::vector<fast::BodyState> states(1);
    for (Index b = 1; b < kBodies; ++b) {
      scene.add_body(bubble);
      scene.add_pairing(0, b, bench_law(), Mode::F, Scheme::barycentric, kForceOnly);
      fast::BodyState state;
      state.pose.r = distance > 0 ? Eigen::Vector3d(b * distance, 0, 0) : Eigen::Vector3d(0.001 * b, 0, 6);
      states.push_back(state);
    }
    scene.move(states);
    scene.evaluate_all();
  }
  /// Of one pairing, us.
  double time() {
    return least_time([] {}, [&] { scene.evaluate_all(); }).query_us / (kBodies - 1);
  }
};

/// The two things a scene skips whole pairings by.
void measure_pairings_apart(std::int64_t repetitions, SkipResult& result) {
  Savings certificates_only = without(&Savings::broad_phase), boxes_only = without(&Savings::certificates);
  Savings neither = boxes_only;
  neither.broad_phase = false;
  Apart boxes(boxes_only, 1), no_boxes(neither, 1), certificates(certificates_only, 0), no_certificates(neither, 0);
  std::array<std::vector<double>, 4> us;
  const std::array<Apart*, 4> all{&boxes, &no_boxes, &certificates, &no_certificates};
  for (std::int64_t k = 0; k < repetitions; ++k)
    for (std::size_t a = 0; a < all.size(); ++a) us[a].push_back(all[a]->time());
  const auto median = [&](std::size_t a) { return quantile(us[a], 0.5); };
  result.boxes_ns = 1e3 * median(0);
  result.certificate_ns = 1e3 * median(2);
  const auto evaluated = [](const Apart& apart) { return apart.scene.counters().evaluated; };
  result.savings.push_back({"broad phase", "a bubble and one of 999 in a row, 1 m apart", median(0), median(1),
                            "pairings evaluated of 999", evaluated(boxes), evaluated(no_boxes)});
  result.savings.push_back({"certificates", "a bubble in an open container it does not touch", median(2), median(3),
                            "pairings evaluated of 999", evaluated(certificates), evaluated(no_certificates)});
}

}  // namespace

SkipResult run_skip(int bubbles, std::int64_t steps, std::int64_t poses,
                    const std::function<void(const std::string&)>& progress) {
  SkipResult result;
  result.bubbles = bubbles;
  run_scenes(steps, result, progress);
  progress("pairings apart");
  measure_pairings_apart(poses, result);
  for (const Question& question : questions()) {
    progress(question.saving);
    result.savings.push_back(measure(question, poses));
  }
  progress("oracle's candidate region");
  result.savings.push_back(measure_candidate_region(poses));
  return result;
}

}  // namespace pcm::compare
