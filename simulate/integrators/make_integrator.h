// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "simulate/integrators/integrator.h"

namespace pcm::simulate {

/// By this method. Throws BadInput where the equation or the control is none.
std::unique_ptr<Integrator> make_integrator(Method method, DifferentialEquation equation, StepControl control);

}  // namespace pcm::simulate
