// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <string>
#include <utility>

#include "bindings/python/arrays.h"
#include "bindings/python/bind.h"
#include "pcm/engine.h"
#include "pcm/read_mesh.h"

namespace pcm::python {

namespace {

using fast::Surface;

/// Preparing takes a while for large meshes, in which other Python threads may go on.
Surface prepared(TriangleMesh mesh) {
  const py::gil_scoped_release others_may_run;
  return Surface(std::move(mesh));
}

Surface read(const std::filesystem::path& path) {
  const py::gil_scoped_release others_may_run;
  return Surface(read_mesh(path));
}

py::array_t<double> vertices_of(const Surface& surface) {
  const auto& vertices = surface.mesh().vertices;
  py::array_t<double> array({static_cast<py::ssize_t>(vertices.size()), py::ssize_t{3}});
  double* to = array.mutable_data();
  for (const Eigen::Vector3d& vertex : vertices) to = std::copy_n(vertex.data(), 3, to);
  return array;
}

py::array_t<Index> faces_of(const Surface& surface) {
  const auto& faces = surface.mesh().faces;
  py::array_t<Index> array({static_cast<py::ssize_t>(faces.size()), py::ssize_t{3}});
  Index* to = array.mutable_data();
  for (const Triangle& face : faces) to = std::copy(face.begin(), face.end(), to);
  return array;
}

std::string surface_text(const Surface& surface) {
  return std::string("<pcm.Surface: ") + std::to_string(surface.mesh().vertices.size()) + " vertices, " +
         std::to_string(surface.mesh().faces.size()) + " faces, " + (surface.closed() ? "closed>" : "open>");
}

}  // namespace

void bind_surface(py::module_& module) {
  py::class_<Surface>(module, "Surface", "A surface, checked and prepared for contact. It never changes.")
      .def(py::init([](const py::object& vertices, const py::object& faces) {
             return prepared(mesh_from(vertices, faces));
           }),
           py::arg("vertices"), py::arg("faces"),
           "From vertices, shape (n, 3), m, and triangles, shape (m, 3): vertex numbers from 0, counterclockwise seen\n"
           "from outside the body. Raises BadInput where the surface is unfit for contact; its text counts from 1, as\n"
           "OBJ files do.")
      .def_static("read", &read, py::arg("path"), "From a file, .obj or .off, whose coordinates are metres.")
      .def_property_readonly("vertices", &vertices_of, "A copy of the coordinates, shape (n, 3), m.")
      .def_property_readonly("faces", &faces_of, "A copy of the vertex numbers, shape (m, 3).")
      .def_property_readonly("closed", &Surface::closed, "Whether it has no border.")
      .def("__repr__", &surface_text);
}

}  // namespace pcm::python
