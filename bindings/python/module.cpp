// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>

#include <exception>
#include <string_view>
#include <utility>

#include "bindings/python/bind.h"
#include "bindings/python/rows.h"
#include "pcm/bad_input.h"
#include "pcm/version.h"

namespace {

/// Sets Python's error. A text may hold a path as the user gave it, in bytes that are no UTF-8: written as \xNN.
void raise_bad_input(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const pcm::BadInput& bad) {
    const std::string_view text = bad.what();
    const auto decoded = pybind11::reinterpret_steal<pybind11::object>(
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace"));
    if (decoded) PyErr_SetObject(pybind11::module_::import("pcm").attr("BadInput").ptr(), decoded.ptr());
  }
}

}  // namespace

PYBIND11_MODULE(pcm, module) {
  module.doc() =
      "Contact between triangle meshes by the Polygonal Contact Model, with exact decisions.\n\n"
      "Define a Pairing of two Surfaces and evaluate it for as many states as wanted. Units are SI. Bodies E and F "
      "carry\n"
      "the markers Me and Mf; what ends in _Me is resolved in Me. Vertices and faces are numbered from 0. Input that "
      "you\n"
      "can mend raises BadInput, a ValueError.";
  module.attr("__version__") = PCM_VERSION;
  pybind11::exception<pcm::BadInput>(module, "BadInput", PyExc_ValueError).doc() =
      "Input that you can mend: the text says what is wrong where.";
  pybind11::register_exception_translator(&raise_bad_input);
  pcm::python::register_rows();
  pcm::python::bind_surface(module);
  pcm::python::bind_contact(module);
  pcm::python::bind_pairing(module);
}
