// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace pcm::simulate {

/// Stage j >= 2 of a Runge-Kutta-Chebyshev step of size h from y_0, at t_0 + c h:
///
///   y_j = (1 - mu - nu) y_0 + mu y_{j-1} + nu y_{j-2} + h (mu_slope f_{j-1} + gamma_slope f_0),
///
/// with f_j = f(t_0 + c_j h, y_j) and y_1 = y_0 + c_1 h f_0.
struct ChebyshevStage {
  double mu = 0, nu = 0, mu_slope = 0, gamma_slope = 0, c = 0;
};

/// All stages of the method of second order, number j - 1 in place j: the first has its c alone, the last has c = 1.
/// At least two.
///
/// B. P. Sommeijer, L. F. Shampine, J. G. Verwer, RKC: an explicit solver for parabolic PDEs, J. Comput. Appl. Math. 88
/// (1998), section 2. For y' = lambda y each y_j is y_0 times a_j + b_j T_j(w_0 + w_1 h lambda), T_j Chebyshev's
/// polynomial of the first kind, which is at most 1 over an interval that grows with the square of the stages' number.
std::vector<ChebyshevStage> chebyshev_stages(int number);

/// Up to which h |lambda|, lambda real and negative, a step of so many stages is stable: 0.65 (s^2 - 1). In the paper
/// 2/3 (s^2 - 1) (1 - 2/15 * 2/13) for many stages, 0.653 (s^2 - 1); a test holds the polynomials themselves to it.
double chebyshev_limit(int stages);
/// The fewest that are stable there.
int chebyshev_stages_for(double h_lambda);

}  // namespace pcm::simulate
