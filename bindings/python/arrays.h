// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <initializer_list>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

/// Between Python's arrays and the engine's values. What does not fit throws BadInput and names the argument.
namespace pcm::python {

namespace py = pybind11;

/// Any length along an axis.
inline constexpr py::ssize_t kAny = -1;

/// Numbers of this shape as doubles, row by row. Lists of lists are arrays too.
py::array_t<double> doubles(const py::handle& value, const char* name, std::initializer_list<py::ssize_t> shape);

/// From arrays of shapes (n, 3): coordinates, and vertex numbers, which have to be integers.
TriangleMesh mesh_from(const py::handle& vertices, const py::handle& faces);

/// A copy as an array of three numbers.
inline py::array_t<double> array_of(const Eigen::Vector3d& x) {
  return py::array_t<double>(3, x.data());
}

}  // namespace pcm::python
