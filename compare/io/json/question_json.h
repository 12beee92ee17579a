// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/io/json/exact_json.h"
#include "pcm/inputs.h"

/// Numbers, law, mode and scheme of a question as JSON that reads back bit for bit: case files, recorded trajectories.
/// Readers throw BadInput for what is none of these, and what the library throws for a key that is missing or of the
/// wrong type.
namespace pcm::compare {

/// As C hexadecimal floating point, e.g. "0x1.8p-3", or "inf".
std::string hexadecimal(double x);
/// A finite number or "inf", in quotes.
double number_from(const Json& json);

/// Three of them, and nine by rows; written as `hexadecimal` writes.
Eigen::Vector3d vector_from(const Json& json);
Json matrix_json(const Eigen::Matrix3d& A);
Eigen::Matrix3d matrix_from(const Json& json);

/// How a file writes its doubles: as JSON numbers, or in quotes as above. Both read back bit for bit, and infinity is
/// "inf" in both.
enum class Notation : std::uint8_t { decimal, hexadecimal };
Json number_json(double x, Notation notation);
Json vector_json(const Eigen::Vector3d& x, Notation notation = Notation::hexadecimal);
/// A number in either notation.
double number_in_either_notation(const Json& json);

Json law_json(const ContactLaw& law, Notation notation = Notation::hexadecimal);
/// Throws BadInput for other keys too. Values may be out of their ranges: whoever asks the question refuses them.
ContactLaw law_from(const Json& json, double (*number)(const Json&) = number_from);

Mode mode_from(const Json& json);
Scheme scheme_from(const Json& json);

}  // namespace pcm::compare
