// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/integrator.h"

namespace pcm::simulate {

std::string_view name(Method method) {
  switch (method) {
    case Method::adams:
      return "CVODE, Adams";
    case Method::bdf:
      return "CVODE, BDF";
    case Method::ida:
      return "IDA";
    case Method::dormand_prince:
      return "ARKODE, Dormand-Prince";
    case Method::rkc:
      return "Runge-Kutta-Chebyshev";
    case Method::runge_kutta_merson:
      return "Simbody, Runge-Kutta-Merson";
    default:
      return "ARKODE, ESDIRK";
  }
}

}  // namespace pcm::simulate
