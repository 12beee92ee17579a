// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/contact/contact_outputs.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/contact/contact_rows.h"

namespace pcm::compare {

void add_contact_output_options(CLI::App& command, ContactOutputOptions& options) {
  const auto add_file = [&command](const std::string& name, std::optional<std::string>& path,
                                   const std::string& description, const std::string& type = "FILE") {
    command.add_option(name, path, description)->type_name(type)->group("Output");
  };
  command
      .add_flag("--full", options.full,
                "Everything in each object: whether features coincide and the areas without and with faces in one "
                "plane, numbers of the active faces, crossing pairs, features and patch of the "
                "polygons, every contact element, statistics, the pose, and where the answer comes from")
      ->group("Output");
  add_file("--csv", options.poses, "Also a CSV file with a row a pose, units in its first line");
  add_file("--elements", options.elements, "Also a CSV file with a row a contact element, units in its first line");
  add_file(
      "--vtk", options.vtk,
      "Also files for ParaView: DIR/contacts.pvd shows surfaces in place, polygons and contact elements, pose by pose",
      "DIR");
}

ContactOutputs::ContactOutputs(const ContactOutputOptions& options, const ContactQuestion& question,
                               TriangleMesh mesh_E, TriangleMesh mesh_F, const std::function<Provenance()>& provenance)
    : E_(std::move(mesh_E)), F_(std::move(mesh_F)) {
  if (options.full) {
    full_.emplace(E_, F_, provenance_json(provenance()));
    coincident_.emplace(E_, F_, question.mode, question.scheme, question.problem);
  }
  if (options.poses) poses_.emplace(*options.poses, pose_row(0, {}, {}, true));
  if (options.elements) elements_.emplace(*options.elements, element_row(0, {}, {}));
  if (options.vtk) vtk_.emplace(*options.vtk);
}

void ContactOutputs::complete(ContactAnswer& answer, const State& state) const {
  if (!full_) return;
  coincident_->add_to(answer.json, state.pose);
  full_->add_to(answer.json, *answer.record, state);
}

void ContactOutputs::write(const ContactAnswer& answer, const State& state) {
  ++pose_;
  if (poses_) poses_->write(pose_row(pose_, state, *answer.record, !answer.json["polygons"].is_null()));
  if (!elements_ && !vtk_) return;
  const PlacedSurfaces placed(E_, F_, state.pose);
  if (elements_)
    for (const fast::Element& e : answer.record->elements)
      elements_->write(element_row(pose_, e, placed.centroid_Me(e.master, e.master_face)));
  if (vtk_) vtk_->write(*answer.record, placed);
}

}  // namespace pcm::compare
