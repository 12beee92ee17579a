// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/make.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "meshes/base/floating_point_environment.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/car.h"
#include "meshes/generate/generator_support.h"
#include "meshes/generate/human.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"
#include "pcm/bad_input.h"

namespace pcm {
namespace {

/// The values of one call, every parameter of the shape among them.
class Values {
 public:
  explicit Values(std::map<std::string, double, std::less<>> values) : values_(std::move(values)) {}

  double number(std::string_view name) const { return values_.find(name)->second; }

  Index count(std::string_view name) const {
    const double value = number(name);
    if (std::floor(value) == value && std::fabs(value) <= std::numeric_limits<Index>::max()) {
      return static_cast<Index>(value);
    }
    throw BadInput(std::string(name) + " is " + generate::shortest_decimal(value) + ": give a whole number");
  }

 private:
  std::map<std::string, double, std::less<>> values_;
};

struct Entry {
  Shape shape;
  std::function<TriangleMesh(const Values&)> generator;
};

ShapeParameter length(std::string name, double default_value, std::string description) {
  return {std::move(name), default_value, "m", std::move(description)};
}

ShapeParameter count(std::string name, Index default_value, std::string description) {
  return {std::move(name), static_cast<double>(default_value), "count", std::move(description)};
}

std::vector<Entry> flat_shapes() {
  return {
      {{"box",
        "closed box about the origin, 12 faces",
        {length("extent_x", 1, "along x"), length("extent_y", 1, "along y"), length("extent_z", 1, "along z")}},
       [](const Values& v) {
         return generate::box({v.number("extent_x"), v.number("extent_y"), v.number("extent_z")});
       }},
      {{"gridded_box",
        "closed box about the origin with a grid on each side",
        {length("extent_x", 1, "along x"), length("extent_y", 1, "along y"), length("extent_z", 1, "along z"),
         count("subdivisions_x", 4, "cells along x"), count("subdivisions_y", 4, "cells along y"),
         count("subdivisions_z", 4, "cells along z")}},
       [](const Values& v) {
         return generate::gridded_box(
             {v.number("extent_x"), v.number("extent_y"), v.number("extent_z")},
             std::array{v.count("subdivisions_x"), v.count("subdivisions_y"), v.count("subdivisions_z")});
       }},
      {{"plate",
        "closed thin box, its top a grid in the plane z = 0",
        {length("extent_x", 1, "along x"), length("extent_y", 1, "along y"), length("thickness", 0.1, "along z"),
         count("subdivisions_x", 8, "cells along x"), count("subdivisions_y", 8, "cells along y")}},
       [](const Values& v) {
         return generate::plate(v.number("extent_x"), v.number("extent_y"), v.number("thickness"),
                                v.count("subdivisions_x"), v.count("subdivisions_y"));
       }},
      {{"rectangle",
        "open gridded rectangle in the plane z = 0, normal along +z",
        {length("extent_x", 1, "along x"), length("extent_y", 1, "along y"),
         count("subdivisions_x", 8, "cells along x"), count("subdivisions_y", 8, "cells along y")}},
       [](const Values& v) {
         return generate::rectangle(v.number("extent_x"), v.number("extent_y"), v.count("subdivisions_x"),
                                    v.count("subdivisions_y"));
       }},
      {{"wedge",
        "closed prism whose two perpendicular lower faces meet in an edge on the y axis",
        {ShapeParameter{"tilt_degrees", 30, "degrees", "of the face that rises towards -x from the plane z = 0"},
         length("height", 1, "of the flat top above the edge"), length("width", 1, "along y"),
         count("subdivisions", 4, "cells along each edge")}},
       [](const Values& v) {
         return generate::wedge(v.number("tilt_degrees"), v.number("height"), v.number("width"),
                                v.count("subdivisions"));
       }},
      {{"pyramid",
        "open container of four triangles, apex down at the origin, normals into the cavity",
        {length("width", 2, "of the square rim"), length("depth", 0.6, "of the apex below the rim")}},
       [](const Values& v) { return generate::pyramid(v.number("width"), v.number("depth")); }},
  };
}

std::vector<Entry> round_shapes() {
  return {
      {{"icosphere",
        "sphere refined from an icosahedron, 20 * 4^level faces",
        {length("radius", 1, "of the sphere through the vertices"), count("level", 3, "how often faces are split")}},
       [](const Values& v) { return generate::icosphere(v.number("radius"), v.count("level")); }},
      {{"uv_sphere",
        "sphere of meridians and parallels",
        {length("radius", 1, "of the sphere through the vertices"), count("segments", 32, "around the axis"),
         count("bands", 16, "from pole to pole")}},
       [](const Values& v) { return generate::uv_sphere(v.number("radius"), v.count("segments"), v.count("bands")); }},
      {{"cylinder",
        "closed cylinder about the z axis and the origin",
        {length("radius", 0.5, "of the circle through the vertices"), length("length", 1, "along z"),
         count("segments", 32, "around the axis"), count("bands", 8, "along the axis"),
         count("cap_rings", 4, "on each cap")}},
       [](const Values& v) {
         return generate::cylinder(v.number("radius"), v.number("length"), v.count("segments"), v.count("bands"),
                                   v.count("cap_rings"));
       }},
      {{"cone",
        "closed cone, base in the plane z = 0",
        {length("radius", 0.5, "of the base"), length("height", 1, "of the apex"),
         count("segments", 32, "around the axis"), count("bands", 8, "from base to apex"),
         count("cap_rings", 4, "on the base")}},
       [](const Values& v) {
         return generate::cone(v.number("radius"), v.number("height"), v.count("segments"), v.count("bands"),
                               v.count("cap_rings"));
       }},
      {{"tube",
        "tube about the z axis and the origin, a bore in a coaxial cylinder",
        {length("inner_radius", 0.5, "of the bore"), length("outer_radius", 1, "of the outside"),
         length("length", 1, "along z"), count("segments", 32, "around the axis"),
         count("bands", 4, "along the axis")}},
       [](const Values& v) {
         return generate::tube(v.number("inner_radius"), v.number("outer_radius"), v.number("length"),
                               v.count("segments"), v.count("bands"));
       }},
      {{"torus",
        "torus about the z axis",
        {length("ring_radius", 1, "of the tube's centre line"), length("tube_radius", 0.25, "of the tube"),
         count("segments", 48, "around the axis"), count("tube_segments", 16, "around the tube")}},
       [](const Values& v) {
         return generate::torus(v.number("ring_radius"), v.number("tube_radius"), v.count("segments"),
                                v.count("tube_segments"));
       }},
      {{"bubble",
        "rotationally symmetric bubble with a concave waist, 950 faces",
        {length("length", 0.4, "along the z axis")}},
       [](const Values& v) { return generate::bubble(v.number("length")); }},
  };
}

std::vector<Entry> part_shapes() {
  return {
      {{"socket",
        "round block with a hemispherical hollow about the origin in its top",
        {length("radius", 1, "of the hollow"), length("wall", 0.5, "beside and below the hollow"),
         count("segments", 48, "around the axis"), count("bands", 12, "from rim to lowest point")}},
       [](const Values& v) {
         return generate::socket(v.number("radius"), v.number("wall"), v.count("segments"), v.count("bands"));
       }},
      {{"bumpy_sphere",
        "sphere with waves, not convex; 20,000 faces by default",
        {length("radius", 1, "of the sphere without waves"),
         ShapeParameter{"amplitude", 0.1, "ratio", "of the waves to the radius"},
         count("bumps", 6, "waves around the axis"), count("segments", 125, "around the axis"),
         count("bands", 81, "from pole to pole")}},
       [](const Values& v) {
         return generate::bumpy_sphere(v.number("radius"), v.number("amplitude"), v.count("bumps"), v.count("segments"),
                                       v.count("bands"));
       }},
      {{"knotted_tube",
        "tube along a trefoil knot",
        {length("ring_radius", 1, "of the torus that carries the knot"), length("tube_radius", 0.2, "of the tube"),
         count("segments", 128, "along the knot"), count("tube_segments", 12, "around the tube")}},
       [](const Values& v) {
         return generate::knotted_tube(v.number("ring_radius"), v.number("tube_radius"), v.count("segments"),
                                       v.count("tube_segments"));
       }},
      {{"spur_gear",
        "gear with involute flanks about the z axis",
        {count("teeth", 20, "number of teeth"), length("module", 0.01, "pitch diameter over teeth"),
         length("width", 0.05, "along z"), count("flank_points", 4, "on each flank"), count("bands", 1, "along z")}},
       [](const Values& v) {
         return generate::spur_gear(v.count("teeth"), v.number("module"), v.number("width"), v.count("flank_points"),
                                    v.count("bands"));
       }},
  };
}

/// The surfaces of the pedestrian crash; they have no parameters.
std::vector<Entry> crash_shapes() {
  std::vector<Entry> list{{{"car", "body of a saloon car 4.4 m long, front at x = 0, road at z = 0, 1,240 faces", {}},
                           [](const Values&) { return generate::car(); }}};
  for (const generate::HumanSegment& segment : generate::human_segments()) {
    list.push_back(
        {{"human_" + segment.name, "segment of the man of 1.75 m, the joint that carries it at the origin", {}},
         [name = segment.name](const Values&) { return generate::human_segment(name); }});
  }
  return list;
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> list = flat_shapes();
    for (const auto& more : {round_shapes(), part_shapes(), crash_shapes()})
      list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

std::string with_underscores(std::string_view name) {
  std::string result(name);
  std::replace(result.begin(), result.end(), '-', '_');
  return result;
}

/// "a, b, c" of the names of the items.
template <typename Items>
std::string listed(const Items& items) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : ", ") + item.name;
  return text;
}

}  // namespace

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = [] {
    std::vector<Shape> list;
    for (const Entry& entry : entries()) list.push_back(entry.shape);
    return list;
  }();
  return all;
}

TriangleMesh make(std::string_view name, const std::map<std::string, double, std::less<>>& parameters) {
  const DefaultFloatingPoint environment;
  const std::string shape_name = with_underscores(name);
  const auto entry = std::find_if(entries().begin(), entries().end(),
                                  [&](const Entry& candidate) { return candidate.shape.name == shape_name; });
  if (entry == entries().end()) {
    throw BadInput("there is no shape '" + std::string(name) + "'; the shapes are " + listed(shapes()));
  }

  std::map<std::string, double, std::less<>> values;
  for (const ShapeParameter& parameter : entry->shape.parameters) values[parameter.name] = parameter.default_value;
  std::string call = "make " + shape_name;
  for (const auto& [given_name, value] : parameters) {
    const auto known = values.find(with_underscores(given_name));
    if (known == values.end()) {
      throw BadInput(shape_name + " has no parameter '" + given_name + "'; its parameters are " +
                     listed(entry->shape.parameters));
    }
    known->second = value;
    call += " --" + known->first + " " + generate::shortest_decimal(value);
  }
  TriangleMesh mesh;
  try {
    mesh = entry->generator(Values(std::move(values)));
  } catch (const BadInput& error) {
    throw BadInput(shape_name + ": " + error.what());
  }
  mesh.name = call;
  return mesh;
}

}  // namespace pcm
