// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/contact.h"

#include <pybind11/stl.h>

#include <string>

#include "bindings/python/arrays.h"
#include "bindings/python/bind.h"
#include "bindings/python/rows.h"

namespace pcm::python {

namespace {

using fast::ActiveArea;
using fast::Contact;
using fast::ForceBound;
using fast::Statistics;

/// A property that is a vector, as an array of three numbers.
template <class T>
auto vector(Eigen::Vector3d T::*member) {
  return [member](const T& object) { return array_of(object.*member); };
}

/// A property that is a list, as an array.
template <class T, class List>
auto rows(List T::*member) {
  return [member](const T& object) { return array_of_rows(object.*member); };
}

py::object tangent_of(const Contact& contact) {
  if (!contact.tangent) return py::none();
  py::array_t<double> array({6, 12});
  Eigen::Map<Eigen::Matrix<double, 6, 12, Eigen::RowMajor>>(array.mutable_data()) = *contact.tangent;
  return array;
}

std::string text_of(const Contact& contact) {
  return std::string("<pcm.Contact: ") + (contact.touching ? "touching, " : "not touching, ") +
         std::to_string(contact.element_count) + " elements>";
}

void bind_active_area(py::module_& module) {
  py::class_<ActiveArea>(module, "ActiveArea", "What the contact is on one of the surfaces.")
      .def_property_readonly("intersected", rows(&ActiveArea::intersected), "Faces that the other surface crosses.")
      .def_property_readonly("inner", rows(&ActiveArea::inner), "Uncrossed faces inside the other body.")
      .def_readonly("area", &ActiveArea::area, "Of its part inside the other body, m^2.")
      .def_property_readonly("vector_area_Me", vector(&ActiveArea::vector_area_Me),
                             "Integral of the outward normal over that part, m^2.");
}

void bind_bound(py::module_& module) {
  py::class_<ForceBound>(
      module, "ForceBound",
      "Rigorous bounds on |computed - true|, component by component, rounding of F's vertices included.")
      .def_property_readonly("force_Me", vector(&ForceBound::force_Me), "N.")
      .def_property_readonly("torque_Me", vector(&ForceBound::torque_Me), "N m.")
      .def_readonly("flipped", &ForceBound::flipped,
                    "A discrete decision may be another one, so that the bound is great.")
      .def_readonly("penetration_at_least", &ForceBound::penetration_at_least,
                    "The true greatest penetration is no less, m.")
      .def_readonly("penetration_at_most", &ForceBound::penetration_at_most,
                    "The true greatest penetration is no more, m.");
}

void bind_statistics(py::module_& module) {
  py::class_<Statistics>(module, "Statistics", "Summary over the elements; all zero where there is none.")
      .def_readonly("patch_area", &Statistics::patch_area, "Sum of the elements' areas, m^2.")
      .def_readonly("mean_penetration", &Statistics::mean_penetration, "Area-weighted, m.")
      .def_readonly("max_pressure", &Statistics::max_pressure, "Pa.")
      .def_readonly("mean_pressure", &Statistics::mean_pressure, "Area-weighted, Pa.")
      .def_readonly("max_normal_velocity", &Statistics::max_normal_velocity, "Greatest |v_n|, m/s.")
      .def_readonly("max_tangential_velocity", &Statistics::max_tangential_velocity, "Greatest v_t, m/s.")
      .def_property_readonly("centre_of_pressure_Me", vector(&Statistics::centre_of_pressure_Me),
                             "Positions weighted by normal forces, m.");
}

}  // namespace

void bind_contact(py::module_& module) {
  bind_active_area(module);
  bind_bound(module);
  bind_statistics(module);
  py::class_<Contact>(module, "Contact", "The answer at one state. What was not wanted is zero, empty or None.")
      .def_readonly("touching", &Contact::touching, "The surfaces cross.")
      .def_readonly("nested", &Contact::nested,
                    "A part of one lies in the other without crossing: no force, unless open or about a cavity.")
      .def_readonly("ambiguous", &Contact::ambiguous, "An open surface labels faces both ways.")
      .def_readonly("E", &Contact::E, "ActiveArea of E's surface.")
      .def_readonly("F", &Contact::F, "ActiveArea of F's surface.")
      .def_readonly("undefined_areas", &Contact::undefined_areas,
                    "Number of faces whose area counts as 0, for a border of the other surface ends there.")
      .def_readonly("has_volume", &Contact::has_volume, "False where a surface is open or the answer is ambiguous.")
      .def_readonly("volume", &Contact::volume, "Of the intersection, m^3.")
      .def_readonly("patches", &Contact::patches,
                    "Number of contacts; borders that only the inside of a face joins count apart.")
      .def_property_readonly("polygons", rows(&Contact::polygons),
                             "Intersection polygons: closed, first and count in `crossings`, patch.")
      .def_property_readonly("crossings", rows(&Contact::crossings),
                             "Points of the polygons: edge_side (0: E, 1: F) and edge pass through face of the other\n"
                             "surface at position_Me.")
      .def_readonly("element_count", &Contact::element_count, "Number of contact elements, kept or not.")
      .def_property_readonly(
          "elements", rows(&Contact::elements),
          "Contact elements as a structured array: master (0: E, 1: F), master_face, slave_face, area,\n"
          "penetration, normal_velocity, tangential_velocity, normal_force, tangential_force,\n"
          "normal_Me, position_Me, and force_Me on body E.")
      .def_readonly("too_deep", &Contact::too_deep,
                    "Number of faces without a force: the body is thinner there than the penetration.")
      .def_readonly("max_penetration", &Contact::max_penetration, "Greatest penetration, before clamping, m.")
      .def_readonly("penetration_exceeded", &Contact::penetration_exceeded, "Deeper than the law's max_penetration.")
      .def_property_readonly("force_Me", vector(&Contact::force_Me), "On body E, N.")
      .def_property_readonly("torque_Me", vector(&Contact::torque_Me), "On body E about the origin of Mf, N m.")
      .def_readonly("bound", &Contact::bound, "ForceBound, or None.")
      .def_property_readonly(
          "tangent", &tangent_of,
          "Derivatives of force_Me and torque_Me, the six rows, by r, by a turn of F about Mf, by v\n"
          "and by w, three columns each, or None. Discrete facts stay as they are.")
      .def_readonly("statistics", &Contact::statistics, "Statistics over the elements.")
      .def("__repr__", &text_of);
}

}  // namespace pcm::python
