// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/identity_constructions.h"

#include <fmt/core.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <nlohmann/json.hpp>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/poses/pairs.h"
#include "compare/verify/run/run_chunks.h"
#include "compare/verify/run/verify.h"
#include "compare/verify/tables/verification_table.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"

namespace pcm::compare {
namespace {

IdentityResult result(std::string name, std::string statement, const Findings& findings) {
  return {std::move(name),     std::move(statement), Sharpness::bits, findings.checks,
          findings.violations, findings.worst,       findings.first};
}

std::string unless(bool holds, const std::string& what) {
  return holds ? "" : what;
}

}  // namespace

IdentityResult flush_flanks(int orders) {
  const TriangleMesh lower = generate::box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 2));
  const TriangleMesh upper = generate::box(Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(2, 2, 3));
  Findings findings("boxes [0,2]^3 and [0,2]^2 x [1,3]");
  for (int i = 0; i < orders; ++i) {
    PoseRandom random(1, 0, 0, static_cast<std::uint64_t>(i));
    Posed posed;
    posed.law = stiffness(1);
    posed.E = i == 0 ? lower : reordered(lower, random);
    posed.F = i == 0 ? upper : reordered(upper, random);
    Posed other = posed;
    std::swap(other.E, other.F);
    for (const Scheme scheme : kSchemes) {
      const Eigen::Vector3d on_lower = answer(posed, Mode::E, scheme).force_Me;
      const Eigen::Vector3d on_upper = answer(other, Mode::F, scheme).force_Me;
      findings.same(unless(on_lower == Eigen::Vector3d(0, 0, -4), fmt::format("order {}, lower box first", i)));
      findings.same(unless(on_upper == Eigen::Vector3d(0, 0, 4), fmt::format("order {}, upper box first", i)));
    }
  }
  return result("flush flanks", "(0, 0, -4) whatever the tie rule and the order of the bodies", findings);
}

IdentityResult plate_with_pin() {
  Posed posed;
  posed.law = stiffness(1);
  posed.F = generate::box(Eigen::Vector3d(-8, -8, -4), Eigen::Vector3d(8, 8, 0));
  Findings findings("plate sunk by 1/8, pin beside it");
  // Dyadic numbers: every force is exact.
  constexpr double kPlate = 0.125 * 4, kPinArea = 0.25;
  for (const double depth : {-0.25, -0x1p-50, 0.0, 0x1p-50, 0x1p-30, 0.0625}) {
    posed.E = degenerate::joined(generate::box(Eigen::Vector3d(-1, -1, -0.125), Eigen::Vector3d(1, 1, 1)),
                                 generate::box(Eigen::Vector3d(2, 0, -depth), Eigen::Vector3d(2.5, 0.5, 1)));
    const double expected = kPlate + (depth > 0 ? depth * kPinArea : 0);
    for (const Scheme scheme : kSchemes)
      findings.same(unless(answer(posed, Mode::E, scheme).force_Me == Eigen::Vector3d(0, 0, expected),
                           fmt::format("pin at depth {}", depth)));
  }
  return result("plate under a large face with a pin beside", "the plate's force stays when the pin begins to touch",
                findings);
}

IdentityResult threads_and_workspaces(const std::vector<Posed>& poses) {
  std::vector<fast::Pairing> pairings;
  std::vector<fast::Contact> alone;
  for (const Scheme scheme : kSchemes)
    for (const Posed& posed : poses) {
      pairings.emplace_back(fast::Surface(posed.E), fast::Surface(posed.F), posed.law, Mode::both, scheme);
      fast::Workspace fresh;
      alone.push_back(fast::evaluate(pairings.back(), posed.pose, posed.velocity, {}, fresh));
    }
  Findings findings("poses of all pairs");
  std::vector<std::string> differences(pairings.size());
  oneapi::tbb::enumerable_thread_specific<fast::Workspace> workspaces;
  oneapi::tbb::parallel_for(std::size_t{0}, pairings.size(), [&](std::size_t i) {
    const Posed& posed = poses[i % poses.size()];
    differences[i] =
        difference(alone[i], fast::evaluate(pairings[i], posed.pose, posed.velocity, {}, workspaces.local()));
  });
  for (const std::string& one : differences) findings.same(one);
  return result("threads and used workspaces", "the same bits", findings);
}

IdentityResult jobs_of_verify(std::uint64_t seed, std::int64_t poses) {
  const auto tables = [&](int jobs) {
    VerificationPlan plan;
    plan.poses = poses;
    plan.seed = seed;
    std::vector<std::string> missing;
    for (SurfacePair& pair : built_in_pairs({}, missing))
      if (pair.faces() < 1000) plan.pairs.push_back(std::move(pair));
    Verification run(std::move(plan));
    run_all(
        run, jobs, [] { return false; }, [](std::int64_t) {});
    return std::vector{verification_markdown(run), verification_csv(run), verification_json(run).dump()};
  };
  Findings findings(fmt::format("{} poses, seed {}", poses, seed));
  const std::vector<std::string> one = tables(1), two = tables(2);
  for (std::size_t i = 0; i < one.size(); ++i) findings.same(unless(one[i] == two[i], "a table differs"));
  return result("jobs of pcm verify", "--jobs 1 and --jobs 2 print the same tables", findings);
}

}  // namespace pcm::compare
