// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compare/io/tables/column_units.h"
#include "compare/motion/audits.h"

/// Tables of audits. They hold no times, so that they are the same on every run.
namespace pcm::compare {

bool met(const std::vector<AuditResult>& results);

/// One screen: a line for each row, then every miss.
std::string audits_summary(const std::vector<AuditResult>& results);
/// The last line printed.
std::string audits_verdict(const std::vector<AuditResult>& results);

std::string audits_markdown(const std::vector<AuditResult>& results);
std::string audits_csv(const std::vector<AuditResult>& results);
ColumnUnits audits_units();
nlohmann::ordered_json audits_json(const std::vector<AuditResult>& results);

}  // namespace pcm::compare
