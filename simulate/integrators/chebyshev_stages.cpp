// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/chebyshev_stages.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pcm::simulate {

namespace {

/// T_j(x), with its first and second derivative.
struct Chebyshev {
  double value, first, second;
};

/// T_0 to T_n at x, by T_j = 2 x T_{j-1} - T_{j-2}.
std::vector<Chebyshev> chebyshev_polynomials(int n, double x) {
  std::vector<Chebyshev> T{{1, 0, 0}, {x, 1, 0}};
  for (auto j = T.size(); j <= static_cast<std::size_t>(n); ++j) {
    const Chebyshev &a = T[j - 1], &b = T[j - 2];
    T.push_back({2 * x * a.value - b.value, 2 * a.value + 2 * x * a.first - b.first,
                 4 * a.first + 2 * x * a.second - b.second});
  }
  return T;
}

constexpr double kLimit = 0.65;

}  // namespace

std::vector<ChebyshevStage> chebyshev_stages(int number) {
  assert(number >= 2);
  const auto s = static_cast<std::size_t>(number);
  constexpr double kDamping = 2.0 / 13;
  const double w_0 = 1 + kDamping / (static_cast<double>(number) * number);
  const std::vector<Chebyshev> T = chebyshev_polynomials(number, w_0);
  const double w_1 = T[s].first / T[s].second;
  // The first two b are free; those of the second stage keep all internal ones stable.
  const auto b = [&T](std::size_t j) {
    const Chebyshev& of = T[std::max<std::size_t>(j, 2)];
    return of.second / (of.first * of.first);
  };
  const auto a = [&](std::size_t j) { return 1 - b(j) * T[j].value; };

  std::vector<ChebyshevStage> stages(s);
  stages[0].c = b(1) * w_1;
  for (std::size_t j = 2; j <= s; ++j) {
    ChebyshevStage& stage = stages[j - 1];
    stage.mu = 2 * w_0 * b(j) / b(j - 1);
    stage.nu = -b(j) / b(j - 2);
    stage.mu_slope = 2 * w_1 * b(j) / b(j - 1);
    stage.gamma_slope = -a(j - 1) * stage.mu_slope;
    stage.c = w_1 * T[j].second / T[j].first;
  }
  stages.back().c = 1;  // but for rounding
  return stages;
}

double chebyshev_limit(int stages) {
  return kLimit * (static_cast<double>(stages) * stages - 1);
}

int chebyshev_stages_for(double h_lambda) {
  return std::max(2, static_cast<int>(std::ceil(std::sqrt(1 + h_lambda / kLimit))));
}

}  // namespace pcm::simulate
