// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/io/table.h"
#include "compare/opponents/contest.h"

namespace pcm::compare {

/// Wrong answers by stratum, the engines side by side.
Table contest_table(const ContestResult& result);

/// What the table's columns are, in words for people.
std::string contest_legend();

/// How often force and torque of shallow generic poses are right, a line an engine. Empty without such poses.
std::string contest_shallow(const ContestResult& result);

/// The verdict in a line.
std::string contest_verdict(const ContestResult& result);

}  // namespace pcm::compare
