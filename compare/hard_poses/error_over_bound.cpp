// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/error_over_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/verify/routes/wanted_presets.h"

namespace pcm::compare {

ErrorOverBound error_over_bound(const HeldPairing& held, const Pose& pose, fast::Workspace& workspace) {
  Wanted wanted = kForceOnly;
  wanted.bound = true;
  const fast::Contact& subj = fast::evaluate(held.engine(), pose, {}, wanted, workspace);
  reference::Inquiry inquiry(held.oracle(), pose, {}, kForceOnly);
  const Eigen::Vector3d true_force_Me = inquiry.answer(reference::Problem::exact).force_Me;
  ErrorOverBound found{0, subj.bound->flipped};
  for (int j = 0; j < 3; ++j) {
    const double error = std::abs(subj.force_Me[j] - true_force_Me[j]);
    const double ratio = error == 0 ? 0 : error / subj.bound->force_Me[j];
    found.ratio = std::isnan(ratio) ? std::numeric_limits<double>::infinity() : std::max(found.ratio, ratio);
  }
  return found;
}

}  // namespace pcm::compare
