// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace pcm::compare {

/// Objects keep the order in which their keys were set.
using Json = nlohmann::ordered_json;

/// [x, y, z]
Json json_vector(const Eigen::Vector3d& vector);

/// The value on one line, every double as the shortest decimal that reads back bit for bit (the library's own printer
/// is not always the shortest, and prints NaN as null). A double always has a point or an exponent, so that readers
/// keep it a double and -0.0 its sign. Throws BadInput naming the key where a double is not finite: its true value
/// exceeds what a double can hold.
std::string dump_exactly(const Json& value);

}  // namespace pcm::compare
