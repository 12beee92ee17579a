// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bindings/python/arrays.h"
#include "bindings/python/bind.h"
#include "bindings/python/evaluate_many.h"
#include "pcm/bad_input.h"
#include "pcm/engine.h"

namespace pcm::python {

namespace {

/// A word for each value of an enumeration.
template <class Value, std::size_t n>
Value named(const char* what, const std::string& word, const std::pair<const char*, Value> (&values)[n]) {
  std::string words;
  for (const auto& [name, value] : values) {
    if (word == name) return value;
    words += (words.empty() ? "'" : ", '") + std::string(name) + "'";
  }
  throw BadInput(std::string(what) + " is '" + word + "'; it must be one of " + words);
}

constexpr std::pair<const char*, Mode> kModes[] = {{"E", Mode::E}, {"F", Mode::F}, {"both", Mode::both}};
constexpr std::pair<const char*, Scheme> kSchemes[] = {{"barycentric", Scheme::barycentric},
                                                       {"clipped", Scheme::clipped}};
constexpr std::pair<const char*, DampingMode> kDampingModes[] = {{"no_tension", DampingMode::no_tension},
                                                                 {"no-tension", DampingMode::no_tension},
                                                                 {"full", DampingMode::full},
                                                                 {"compression", DampingMode::compression}};

ContactLaw law_from(double stiffness, const std::optional<std::pair<double, double>>& layers, double damping,
                    double transition_depth, double friction, double slip_velocity, double max_penetration,
                    const std::string& damping_mode) {
  ContactLaw law;
  law.stiffness = stiffness;
  if (layers) law.layers = LayerStiffness{layers->first, layers->second};
  law.damping = damping;
  law.transition_depth = transition_depth;
  law.friction = friction;
  law.slip_velocity = slip_velocity;
  law.max_penetration = max_penetration;
  law.damping_mode = named("damping_mode", damping_mode, kDampingModes);
  return law;
}

/// A pairing, and memory to evaluate it in.
struct PooledPairing {
  fast::Pairing pairing;
  WorkspacePool workspaces;
};

std::unique_ptr<PooledPairing> pairing_from(const fast::Surface& E, const fast::Surface& F, const ContactLaw& law,
                                            const std::string& mode, const std::string& scheme) {
  return std::unique_ptr<PooledPairing>(
      new PooledPairing{{E, F, law, named("mode", mode, kModes), named("scheme", scheme, kSchemes)}, {}});
}

const double* data_or_null(const std::optional<py::array_t<double>>& array) {
  return array ? array->data() : nullptr;
}

std::optional<py::array_t<double>> optional_doubles(const py::object& value, const char* name,
                                                    std::initializer_list<py::ssize_t> shape) {
  if (value.is_none()) return std::nullopt;
  return doubles(value, name, shape);
}

fast::Contact evaluate(PooledPairing& self, const py::object& A, const py::object& r, const py::object& v,
                       const py::object& w, bool polygons, bool areas, bool force, bool elements, bool bound,
                       bool statistics, bool tangent) {
  const py::array_t<double> A_array = doubles(A, "A", {3, 3}), r_array = doubles(r, "r", {3});
  const auto v_array = optional_doubles(v, "v", {3}), w_array = optional_doubles(w, "w", {3});
  const States state{1, A_array.data(), r_array.data(), data_or_null(v_array), data_or_null(w_array)};
  const Wanted wanted{polygons, areas, force, elements, bound, statistics, tangent};
  const py::gil_scoped_release others_may_run;
  std::unique_ptr<fast::Workspace> workspace = self.workspaces.take();
  fast::Contact contact = fast::evaluate(self.pairing, state.pose(0), state.velocity(0), wanted, *workspace);
  self.workspaces.give_back(std::move(workspace));
  return contact;
}

py::array_t<AnswerRow> evaluate_many_states(PooledPairing& self, const py::object& A, const py::object& r,
                                            const py::object& v, const py::object& w, bool polygons, bool areas,
                                            bool force, bool bound, bool statistics, int threads) {
  const py::array_t<double> A_array = doubles(A, "A", {kAny, 3, 3});
  const py::ssize_t count = A_array.shape(0);
  const py::array_t<double> r_array = doubles(r, "r", {count, 3});
  const auto v_array = optional_doubles(v, "v", {count, 3}), w_array = optional_doubles(w, "w", {count, 3});
  const States states{static_cast<std::size_t>(count), A_array.data(), r_array.data(), data_or_null(v_array),
                      data_or_null(w_array)};
  const Wanted wanted{polygons, areas, force, false, bound, statistics, false};
  py::array_t<AnswerRow> rows(count);
  AnswerRow* to = rows.mutable_data();
  const py::gil_scoped_release others_may_run;
  evaluate_many(self.pairing, states, wanted, threads, self.workspaces, to);
  return rows;
}

void bind_law(py::module_& module) {
  const ContactLaw defaults;
  py::class_<ContactLaw>(module, "ContactLaw", "Parameters of the force law; all finite and not negative unless said.")
      .def(py::init(&law_from), py::kw_only(), py::arg("stiffness") = defaults.stiffness,
           py::arg("layer_stiffness") = py::none(), py::arg("damping") = defaults.damping,
           py::arg("transition_depth") = defaults.transition_depth, py::arg("friction") = defaults.friction,
           py::arg("slip_velocity") = defaults.slip_velocity, py::arg("max_penetration") = defaults.max_penetration,
           py::arg("damping_mode") = "no_tension",
           "stiffness: c_l, N/m^3, > 0.\n"
           "layer_stiffness: (c_E, c_F), N/m^3, infinite for a rigid body but not for both; in place of stiffness.\n"
           "damping: d_l, N s/m^3. transition_depth: u_d, m, up to which damping fades in.\n"
           "friction: mu. slip_velocity: v_eps, m/s, below which friction is regularised.\n"
           "max_penetration: m, may be infinite; deeper is clamped and flagged.\n"
           "damping_mode: 'no_tension', 'full' or 'compression'.");
}

}  // namespace

void bind_pairing(py::module_& module) {
  bind_law(module);
  py::class_<PooledPairing>(module, "Pairing",
                            "Two surfaces with the law between them. Any number of threads may evaluate it at once.")
      .def(py::init(&pairing_from), py::arg("E"), py::arg("F"), py::arg("law"), py::arg("mode") = "E",
           py::arg("scheme") = "barycentric",
           "mode: whose faces carry the contact elements, 'E', 'F' or 'both'.\n"
           "scheme: 'barycentric', as in the paper, or 'clipped', the integral over the faces.")
      .def(
          "evaluate", &evaluate, py::arg("A"), py::arg("r"), py::arg("v") = py::none(), py::arg("w") = py::none(),
          py::kw_only(), py::arg("polygons") = true, py::arg("areas") = true, py::arg("force") = true,
          py::arg("elements") = true, py::arg("bound") = false, py::arg("statistics") = false,
          py::arg("tangent") = false,
          "The Contact at one state. F's points lie at x_E = A x_F + r: A, shape (3, 3), is a rotation to 1e-9 and is\n"
          "used as given; r, shape (3,), m. v = dr/dt seen in Me, m/s, and w, the angular velocity of F relative to "
          "E,\n"
          "rad/s, are resolved in Me; None is 0. The rest says what is wanted; nothing else is computed. `elements`\n"
          "and `statistics` need the force and have it computed, so do `bound` and `tangent`.")
      .def("evaluate_many", &evaluate_many_states, py::arg("A"), py::arg("r"), py::arg("v") = py::none(),
           py::arg("w") = py::none(), py::kw_only(), py::arg("polygons") = false, py::arg("areas") = true,
           py::arg("force") = true, py::arg("bound") = false, py::arg("statistics") = false, py::arg("threads") = 1,
           "The answers at n states as a structured array of n rows: Contact's numbers and flags by their names; of\n"
           "E and F `area_E`, `vector_area_E_Me` and so on; of the bound `force_bound_Me`, `torque_bound_Me`,\n"
           "`flipped`, `penetration_at_least`, `penetration_at_most`; Statistics by its names. No lists, numbers of\n"
           "active faces or tangents. What is not wanted is 0, `patches` where `polygons` are not. A has shape\n"
           "(n, 3, 3), r, v and w (n, 3). Each row has the bits that `evaluate` gives, whatever the number of\n"
           "threads. Raises BadInput for the first state that is bad, with its number.");
}

}  // namespace pcm::python
