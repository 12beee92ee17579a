// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/recorded_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pcm/bad_input.h"
#include "simulate/record/run_folder.h"

namespace pcm::simulate {

InitialState recorded_state(const std::filesystem::path& folder, double t) {
  const std::filesystem::path file = folder / "states.csv";
  const NumberTable states = read_number_table(file);
  if (states.columns.empty() || states.columns[0] != "t") throw BadInput(file.string() + ": is no table of states");
  if (states.rows.empty()) throw BadInput(file.string() + ": holds no state");
  const std::vector<double>& nearest =
      *std::min_element(states.rows.begin(), states.rows.end(),
                        [t](const auto& a, const auto& b) { return std::abs(a[0] - t) < std::abs(b[0] - t); });
  if (!same_instant(nearest[0], t))
    throw BadInput(fmt::format("{}: has no state at t = {} s; the nearest is at {} s", file.string(), t, nearest[0]));
  return {nearest[0],
          Eigen::VectorXd::Map(nearest.data() + 1, static_cast<Eigen::Index>(nearest.size()) - 1),
          {states.columns.begin() + 1, states.columns.end()}};
}

}  // namespace pcm::simulate
