// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/contact/contact_outputs.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "compare/cli/frame/output_files.h"
#include "compare/contact/contact_rows.h"
#include "compare/io/create_folder.h"
#include "compare/io/json/json_file.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// Beside a table, which has no place for it.
std::string provenance_file(const std::string& table) {
  return table + ".provenance.json";
}

/// Beside all that is to be written.
std::vector<std::string> provenance_files(const ContactOutputOptions& options) {
  std::vector<std::string> files;
  for (const std::optional<std::string>& table : {options.csv, options.csv_elements})
    if (table) files.push_back(provenance_file(*table));
  if (options.vtk) files.push_back((std::filesystem::path(*options.vtk) / "provenance.json").string());
  return files;
}

/// Whether it is a file that says where tables come from, not somebody's own.
bool is_provenance(const std::string& file) {
  const Json json = json_or_discarded(file);
  return json.is_object() && json.contains("version") && json.contains("command_line") && json.contains("engine");
}

/// Throws BadInput naming a file of the folder that would be replaced where none says that it is of earlier
/// contacts.
void refuse_pictures_of_others(const std::filesystem::path& folder) {
  if (is_provenance((folder / "provenance.json").string())) return;
  std::error_code none_there;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none_there))
    if (is_name_in_vtp_folder(entry.path().filename().string()))
      throw BadInput(entry.path().string() +
                     " is there, and no provenance.json beside it says that 'pcm contact' has written it; name another "
                     "folder for --vtk");
}

/// Not a pipe, a device, or a link, as /dev/stdout is one.
bool has_a_place_beside(const std::string& table) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::symlink_status(table, error);
  return !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
}

}  // namespace

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
  add_file("--csv", options.csv,
           "Also a CSV file with a row a pose, units in its first line; FILE.provenance.json says where it comes from");
  add_file("--elements", options.csv_elements, "The same with a row a contact element");
  add_file(
      "--vtk", options.vtk,
      "Also files for ParaView: DIR/contacts.pvd shows surfaces in place, polygons and contact elements, pose by pose",
      "DIR");
}

void require_files_of_their_own(const ContactOutputOptions& options, const std::vector<std::string>& inputs) {
  const std::vector<std::string> taken =
      require_files_of_their_own({{"--csv", options.csv}, {"--elements", options.csv_elements}}, inputs);
  require_no_standard_output({{"--csv", options.csv}, {"--elements", options.csv_elements}});
  if (options.vtk && options.vtk->empty()) throw BadInput("--vtk: name a folder");
  if (options.vtk)
    for (const std::string& other : taken) {
      const std::filesystem::path name = std::filesystem::path(other).filename();
      if (is_name_in_vtp_folder(name.string()) && is_taken_as(std::filesystem::path(*options.vtk) / name, other))
        throw BadInput(other + ": is read or written already; name another folder for --vtk");
    }
  if (options.vtk) refuse_pictures_of_others(*options.vtk);
  for (const std::string& file : provenance_files(options)) {
    for (const std::string& other : taken)
      if (is_taken_as(file, other))
        throw BadInput(other + ": would be overwritten with where the tables come from; name another file");
    if (std::error_code error; std::filesystem::exists(file, error) && !is_provenance(file))
      throw BadInput(file +
                     ": would be overwritten with where the tables come from, and 'pcm contact' has not written it");
  }
}

ContactOutputs::ContactOutputs(const ContactOutputOptions& options, const ContactQuestion& question,
                               TriangleMesh mesh_E, TriangleMesh mesh_F, const std::function<Provenance()>& provenance)
    : options_(options),
      E_(std::move(mesh_E)),
      F_(std::move(mesh_F)),
      provenance_(options.any() ? provenance_json(provenance()) : Json()) {
  if (options.full) {
    full_.emplace(E_, F_, provenance_);
    coincident_.emplace(E_, F_, question.mode, question.scheme, question.problem);
  }
}

void ContactOutputs::prepare() {
  if (pose_ > 0) return;
  for (const std::optional<std::string>& table : {options_.csv, options_.csv_elements}) {
    if (!table || !has_a_place_beside(*table)) continue;
    require_writable(*table);
    // It is written into, not replaced.
    if (access(table->c_str(), F_OK) == 0 && access(table->c_str(), W_OK) != 0)
      throw BadInput(*table + ": you may not write to it");
  }
  if (options_.vtk) {
    create_folder(*options_.vtk);
    require_writable(std::filesystem::path(*options_.vtk) / "provenance.json");
  }
  begin_tables(false);
}

void ContactOutputs::begin() {
  const std::string text = json_file_text(provenance_);
  for (const std::optional<std::string>& table : {options_.csv, options_.csv_elements})
    if (table && has_a_place_beside(*table)) write_text_file(provenance_file(*table), text);
  begin_tables(true);
  if (options_.vtk) {
    vtk_.emplace(*options_.vtk);
    write_text_file(std::filesystem::path(*options_.vtk) / "provenance.json", text);
  }
}

void ContactOutputs::begin_tables(bool with_a_place_beside) {
  const auto is_next = [&](const std::optional<std::string>& table) {
    return table && has_a_place_beside(*table) == with_a_place_beside;
  };
  if (is_next(options_.csv)) csv_.emplace(*options_.csv, pose_row(0, {}, {}, true));
  if (is_next(options_.csv_elements)) csv_elements_.emplace(*options_.csv_elements, element_row(0, {}, {}));
}

void ContactOutputs::complete(ContactAnswer& answer, const State& state) const {
  for (const fast::Element& e : answer.record->elements)
    if (!std::isfinite(pressure(e))) throw BadInput("the pressure of a contact element is too large for a double");
  if (!full_) return;
  coincident_->add_to(answer.json, state.pose);
  full_->add_to(answer.json, *answer.record, state);
}

void ContactOutputs::write(const ContactAnswer& answer, const State& state) {
  if (pose_ == 0) begin();
  ++pose_;
  const bool with_polygons = !answer.json["polygons"].is_null();
  if (csv_) csv_->write(pose_row(pose_, state, *answer.record, with_polygons));
  if (!csv_elements_ && !vtk_) return;
  const PlacedSurfaces placed(E_, F_, state.pose);
  if (csv_elements_)
    for (const fast::Element& e : answer.record->elements)
      csv_elements_->write(element_row(pose_, e, placed.centroid_Me(e.master, e.master_face)));
  if (vtk_) vtk_->write(*answer.record, placed, with_polygons);
}

}  // namespace pcm::compare
