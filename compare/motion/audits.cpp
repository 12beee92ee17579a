// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/audits.h"

#include <fmt/core.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace pcm::compare {
namespace {

void expect(std::vector<std::string>& misses, const std::string& what, double found, const std::optional<Band>& band,
            double tolerance = 0) {
  if (!band || Band{band->least - tolerance, band->greatest + tolerance}.contains(found)) return;
  misses.push_back(fmt::format("{} {:.6g} out of [{:.6g}, {:.6g}]", what, found, band->least - tolerance,
                               band->greatest + tolerance));
}

}  // namespace

AuditResult run(Audit audit) {
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
  expect(result.misses, "work", result.work.work, audit.work, result.work.error);
  if (result.tangential) expect(result.misses, "tangential force", result.tangential->share(), audit.tangential);
  expect(result.misses, "number of jumps", static_cast<double>(result.jumps), audit.jumps);
  expect(result.misses, "greatest jump", result.greatest_jump, audit.greatest_jump);
  result.audit = std::move(audit);
  return result;
}

std::vector<AuditResult> run_audits(Extent extent, int jobs,
                                    const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<Audit> loops = audits(extent);
  std::vector<AuditResult> results(loops.size());
  std::mutex mutex;
  std::size_t done = 0;
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    oneapi::tbb::parallel_for(std::size_t{0}, loops.size(), [&](std::size_t i) {
      results[i] = run(std::move(loops[i]));
      const std::lock_guard<std::mutex> lock(mutex);
      progress(++done, loops.size());
    });
  });
  return results;
}

}  // namespace pcm::compare
