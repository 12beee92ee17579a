// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pcm/triangle_mesh.h"

/// The generators by name, for the command line.
namespace pcm {

/// A parameter of a shape. A count is a whole number without a unit.
struct ShapeParameter {
  std::string name;
  double default_value = 0;
  std::string unit;  ///< "m", "degrees", "count" or "ratio"
  std::string description;
};

/// A shape that `make` knows.
struct Shape {
  std::string name;
  std::string description;
  std::vector<ShapeParameter> parameters;
};

/// Every shape, in the order in which help should list them.
const std::vector<Shape>& shapes();

/// The surface of that name, parameters not given at their defaults. In names of shapes and parameters '-' stands for
/// '_' as well. The mesh's name is the call, e.g. "make torus --tube_radius 0.1". Throws BadInput for an unknown name
/// or parameter, listing the known ones, and for a value out of range or a count that is not whole, naming the
/// parameter.
TriangleMesh make(std::string_view name, const std::map<std::string, double, std::less<>>& parameters = {});

}  // namespace pcm
