// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

/// What the module is made of; each adds its classes.
namespace pcm::python {

void bind_surface(pybind11::module_& module);
void bind_contact(pybind11::module_& module);
void bind_pairing(pybind11::module_& module);

}  // namespace pcm::python
