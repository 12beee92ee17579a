// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/audits.h"

#include <fmt/core.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "compare/io/json/exact_json.h"
#include "compare/io/names.h"

namespace pcm::compare {
namespace {

void expect(std::vector<std::string>& misses, const std::string& what, double found, const std::optional<Band>& band,
            double tolerance = 0) {
  if (!band || Band{band->least - tolerance, band->greatest + tolerance}.contains(found)) return;
  misses.push_back(fmt::format("{} {:.6g} out of [{:.6g}, {:.6g}]", what, found, band->least - tolerance,
                               band->greatest + tolerance));
}

/// The trapezoidal rule is off by an eighth of its step squared times the total change of the force's slope, at most.
/// We allow for slopes that change by 16 times the greatest force over a segment's length: smooth but for a few bends.
/// A force that is rough from step to step is off by more, and widens no band.
double greatest_error_of_work(const PathWork& work, std::int64_t steps) {
  const auto n = static_cast<double>(steps);
  return 2 * work.greatest / (n * n);
}

/// The figures alone.
AuditResult walk_along(const Audit& audit) {
  const PosePath path(audit.poses);
  JumpSearch search;
  search.steps = audit.steps;
  const PathWalk found = walk(*audit.pairing, path, search);
  AuditResult result;
  result.work = path_work(path, found);
  if (audit.normal_Me) result.tangential = tangential_force(found, *audit.normal_Me);
  result.jumps = found.jumps.size();
  for (const ForceJump& jump : found.jumps) {
    result.sum_of_jumps += jump.size();
    result.greatest_jump = std::max(result.greatest_jump, jump.size());
  }
  return result;
}

Json kept_point(const PathPoint& point) {
  return Json::array({point.segment, point.tick});
}

PathPoint point_from(const Json& kept) {
  return {kept.at(0).get<std::size_t>(), kept.at(1).get<std::int64_t>()};
}

Json kept_figures(const AuditResult& result) {
  const PathWork& work = result.work;
  Json kept{{"work", Json::array()}, {"at", kept_point(work.greatest_force_at)}, {"jumps", result.jumps}};
  for (const double x : {work.work, work.error, work.greatest, work.greatest_force, work.greatest_torque})
    kept["work"].push_back(kept_number(x));
  kept["sizes"] = {kept_number(result.sum_of_jumps), kept_number(result.greatest_jump)};
  if (const auto& t = result.tangential)
    kept["tangential"] = {kept_number(t->greatest), kept_number(t->normal_there), kept_point(t->at),
                          kept_number(t->greatest_normal)};
  return kept;
}

AuditResult figures_from(const Json& kept) {
  AuditResult result;
  const Json& work = kept.at("work");
  result.work = {number_from_kept(work.at(0)), number_from_kept(work.at(1)), number_from_kept(work.at(2)),
                 number_from_kept(work.at(3)), number_from_kept(work.at(4)), point_from(kept.at("at"))};
  result.jumps = kept.at("jumps").get<std::size_t>();
  result.sum_of_jumps = number_from_kept(kept.at("sizes").at(0));
  result.greatest_jump = number_from_kept(kept.at("sizes").at(1));
  if (kept.contains("tangential")) {
    const Json& t = kept["tangential"];
    result.tangential = TangentialForce{number_from_kept(t.at(0)), number_from_kept(t.at(1)), point_from(t.at(2)),
                                        number_from_kept(t.at(3))};
  }
  return result;
}

}  // namespace

AuditResult run(Audit audit, KeptValues& kept) {
  const std::string name = fmt::format("{}, {}, {}, mode {}, {}", audit.id, audit.bodies, audit.loop,
                                       compare::name(audit.pairing->mode()), compare::name(audit.pairing->scheme()));
  AuditResult result = figures_from(kept.get(name, [&] { return kept_figures(walk_along(audit)); }));
  const double allowed = greatest_error_of_work(result.work, audit.steps);
  expect(result.misses, "work", result.work.work, audit.work, std::min(result.work.error, allowed));
  if (audit.work) expect(result.misses, "error of the work", result.work.error, Band{0, allowed});
  if (result.tangential) expect(result.misses, "tangential force", result.tangential->share(), audit.tangential);
  expect(result.misses, "number of jumps", static_cast<double>(result.jumps), audit.jumps);
  expect(result.misses, "greatest jump", result.greatest_jump, audit.greatest_jump);
  result.audit = std::move(audit);
  return result;
}

std::vector<AuditResult> run_audits(Extent extent, int jobs, KeptValues& kept,
                                    const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<Audit> loops = audits(extent);
  std::vector<AuditResult> results(loops.size());
  std::mutex mutex;
  std::size_t done = 0;
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    oneapi::tbb::parallel_for(std::size_t{0}, loops.size(), [&](std::size_t i) {
      results[i] = run(std::move(loops[i]), kept);
      const std::lock_guard<std::mutex> lock(mutex);
      progress(++done, loops.size());
    });
  });
  return results;
}

}  // namespace pcm::compare
