// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/cli/contact/contact_answers.h"
#include "compare/cli/frame/command_line.h"
#include "compare/contact/coincident_json.h"
#include "compare/contact/contact_vtp.h"
#include "compare/contact/csv_file.h"
#include "compare/contact/full_json.h"
#include "compare/contact/provenance.h"

namespace pcm::compare {

/// What `pcm contact` gives out beyond its line for each pose.
struct ContactOutputOptions {
  bool full = false;                        ///< everything, in the line itself
  std::optional<std::string> csv;           ///< a file with a row a pose
  std::optional<std::string> csv_elements;  ///< and one with a row an element
  std::optional<std::string> vtk;           ///< a folder of files for ParaView

  bool any() const { return full || csv || csv_elements || vtk; }
};

void add_contact_output_options(CLI::App& command, ContactOutputOptions& options);

/// Throws BadInput where a file to write has no name, is a folder, another one of the files to write, or one of
/// `inputs`.
void require_files_of_their_own(const ContactOutputOptions& options, const std::vector<std::string>& inputs);

/// Takes answers one by one, in steps: what can be wrong with a pose is known before anything of it is written, and no
/// file is begun, or emptied, before the first answer is there.
class ContactOutputs {
 public:
  /// Throws BadInput where a surface's file can't be read again.
  ContactOutputs(const ContactOutputOptions& options, const ContactQuestion& question, TriangleMesh mesh_E,
                 TriangleMesh mesh_F, const std::function<Provenance()>& provenance);
  ContactOutputs(const ContactOutputs&) = delete;
  ContactOutputs& operator=(const ContactOutputs&) = delete;

  /// Adds to the answer's line what was asked for. Throws BadInput where a pressure is too large for a double.
  void complete(ContactAnswer& answer, const State& state) const;
  /// Before the first answer is printed: throws BadInput where a file can't be written, as far as can be told without
  /// touching what is there. Pipes and devices, which hold nothing, are begun.
  void prepare();
  /// Writes to the files, which are begun with the first answer. Throws BadInput where one can't be written.
  void write(const ContactAnswer& answer, const State& state);

 private:
  void begin();
  void begin_tables(bool with_a_place_beside);

  ContactOutputOptions options_;
  TriangleMesh E_, F_;
  Json provenance_;
  std::optional<FullJson> full_;
  std::optional<CoincidentJson> coincident_;
  std::optional<CsvFile> csv_, csv_elements_;
  std::optional<ContactVtpFolder> vtk_;
  std::int64_t pose_ = 0;  ///< number of the last one written, from 1
};

}  // namespace pcm::compare
