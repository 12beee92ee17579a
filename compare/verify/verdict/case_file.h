// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compare/poses/strata.h"
#include "compare/verify/verdict/verdict.h"
#include "pcm/contact.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// One question with all that is needed to put it again, anywhere.
struct Case {
  std::string origin;  ///< where the pose comes from, e.g. "seed 1, bubble-bubble/generic/17"
  TriangleMesh E;
  TriangleMesh F;
  std::filesystem::path file_E;  ///< set: the file refers to the mesh by path and SHA-256 of that file's bytes
  std::filesystem::path file_F;
  Pose pose;
  Velocity velocity;
  ContactLaw law;
  Mode mode = Mode::E;
  Scheme scheme = Scheme::barycentric;
  std::vector<MovingPose> before;  ///< how F came there, of poses that have that
  /// What disagreed: of each its kind, and in words what either side says. A replay does not look at it.
  std::vector<std::array<std::string, 2>> disagreements;
};

std::vector<std::array<std::string, 2>> in_words(const std::vector<Disagreement>& disagreements);

/// What each side decided, for the reader of a case file; a replay does not look at it.
nlohmann::ordered_json decided(const fast::Contact& subj);
nlohmann::ordered_json decided(const reference::Answer& truth);

/// The text of a case file: JSON; pose, velocity and law in hexadecimal floating point, inline meshes in decimals that
/// read back bit for bit.
std::string format_case(const Case& posed, const nlohmann::ordered_json& engine, const nlohmann::ordered_json& oracle);

/// What the case file of a pose is called, by the pose's name.
std::string case_file_name(std::string pose);
/// The case files of a folder by their names. Throws BadInput where it can't be read.
std::vector<std::filesystem::path> case_files_in(const std::filesystem::path& folder);
/// Removes the case files of runs from a folder, not those under other names; says whether there were any. Throws
/// BadInput where one can't be removed.
bool remove_case_files(const std::filesystem::path& folder);

/// Reads a case file. Throws BadInput naming the file and what is wrong with it: not JSON, a key missing or of the
/// wrong type, a number that is none, a mesh file missing (paths are relative to the case file) or changed since.
Case read_case(const std::filesystem::path& path);
/// The same of a file's text; paths are relative to the folder.
Case case_from_text(const std::string& text, const std::filesystem::path& folder);

}  // namespace pcm::compare
