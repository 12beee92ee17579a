// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/python/arrays.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "pcm/bad_input.h"

namespace pcm::python {

namespace {

/// As Python writes it: (n, 3).
std::string shape_text(const std::vector<py::ssize_t>& shape) {
  std::string text = "(";
  for (const py::ssize_t length : shape) text += (length == kAny ? "n" : std::to_string(length)) + ", ";
  if (shape.size() > 1) text.resize(text.size() - 2);
  if (shape.size() == 1) text.resize(text.size() - 1);
  return text + ")";
}

bool fits(const std::vector<py::ssize_t>& actual, const std::vector<py::ssize_t>& wanted) {
  if (actual.size() != wanted.size()) return false;
  for (std::size_t axis = 0; axis < wanted.size(); ++axis)
    if (wanted[axis] != kAny && actual[axis] != wanted[axis]) return false;
  return true;
}

/// Whether it is one of NumPy's masked arrays, which hide numbers that may be anything.
bool is_masked_array(const py::handle& value) {
  const bool is_plain = Py_TYPE(value.ptr()) == py::detail::npy_api::get().PyArray_Type_;
  return !is_plain && py::isinstance<py::array>(value) &&
         py::isinstance(value, py::module_::import("numpy.ma").attr("MaskedArray"));
}

/// Itself, or one in the list or tuple that it is.
bool holds_masked_array(const py::handle& value) {
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) return is_masked_array(value);
  const auto items = py::reinterpret_borrow<py::sequence>(value);
  return std::any_of(items.begin(), items.end(), [](const py::handle& item) { return is_masked_array(item); });
}

/// An array whose numbers are of one of these kinds (NumPy's dtype.kind) and which has this shape.
py::array numbers(const py::handle& value, const char* name, std::string_view kinds, const char* kinds_text,
                  const std::vector<py::ssize_t>& shape) {
  const py::array array = py::array::ensure(value);
  if (!array || kinds.find(array.dtype().kind()) == std::string_view::npos)
    throw BadInput(std::string(name) + ": an array of " + kinds_text + " is wanted");
  if (holds_masked_array(value))
    throw BadInput(std::string(name) + ": a masked array; give it filled (numpy.ma.filled)");
  const std::vector<py::ssize_t> actual(array.shape(), array.shape() + array.ndim());
  if (!fits(actual, shape))
    throw BadInput(std::string(name) + ": an array of shape " + shape_text(shape) + " is wanted, not " +
                   shape_text(actual));
  return array;
}

Index index_from(std::int64_t number) {
  if (number < std::numeric_limits<Index>::min() || number > std::numeric_limits<Index>::max())
    throw BadInput(std::string("faces: ") + std::to_string(number) + " is no vertex number");
  return static_cast<Index>(number);
}

}  // namespace

py::array_t<double> doubles(const py::handle& value, const char* name, std::initializer_list<py::ssize_t> shape) {
  return py::array_t<double, py::array::c_style | py::array::forcecast>(numbers(value, name, "fiu", "numbers", shape));
}

TriangleMesh mesh_from(const py::handle& vertices, const py::handle& faces) {
  const py::array_t<double> coordinates = doubles(vertices, "vertices", {kAny, 3});
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> numbers_of_vertices(
      numbers(faces, "faces", "iu", "integers", {kAny, 3}));
  TriangleMesh mesh;
  mesh.name = "surface";
  for (py::ssize_t i = 0; i < coordinates.shape(0); ++i) mesh.vertices.emplace_back(coordinates.data(i, 0));
  for (py::ssize_t i = 0; i < numbers_of_vertices.shape(0); ++i) {
    const std::int64_t* face = numbers_of_vertices.data(i, 0);
    mesh.faces.push_back({index_from(face[0]), index_from(face[1]), index_from(face[2])});
  }
  return mesh;
}

}  // namespace pcm::python
