// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/audits_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "compare/io/names.h"

namespace pcm::compare {
namespace {

/// A band over a unit; one number where both ends are alike to the digits shown.
std::string text(const std::optional<Band>& band, double unit) {
  if (!band) return "-";
  const std::string least = fmt::format("{:.3g}", band->least / unit);
  const std::string greatest = fmt::format("{:.3g}", band->greatest / unit);
  return least == greatest ? least : least + " to " + greatest;
}

nlohmann::ordered_json json(const std::optional<Band>& band) {
  return band ? nlohmann::ordered_json{band->least, band->greatest} : nlohmann::ordered_json();
}

std::string tangential(const AuditResult& result) {
  return result.tangential ? fmt::format("{:.2g}", result.tangential->share()) : "-";
}

std::size_t missed(const std::vector<AuditResult>& results) {
  return static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(), [](const AuditResult& r) { return !r.misses.empty(); }));
}

std::string misses_of(const std::vector<AuditResult>& results) {
  std::string lines;
  for (const AuditResult& result : results)
    for (const std::string& miss : result.misses)
      lines += fmt::format("missed: {}, mode {}, {}: {}\n", result.audit.id, name(result.audit.pairing->mode()),
                           name(result.audit.pairing->scheme()), miss);
  return lines;
}

}  // namespace

bool met(const std::vector<AuditResult>& results) {
  return missed(results) == 0;
}

std::string audits_summary(const std::vector<AuditResult>& results) {
  std::string lines =
      "work left over after a loop, in greatest force times way; force within the plane of sliding at mu = 0, in\n"
      "normal force; jumps, the greatest in greatest force; * where mathematics says what it must be\n\n";
  lines += fmt::format("{:<24} {:<5} {:<11} {:>11} {:>12} {:>7} {:>12}\n", "loop", "mode", "scheme", "work",
                       "tangential", "jumps", "greatest");
  for (const AuditResult& result : results) {
    const Audit& audit = result.audit;
    lines += fmt::format("{:<24} {:<5} {:<11} {:>10.2g}{} {:>11}{} {:>6}{} {:>11.2g}{}{}\n", audit.id,
                         name(audit.pairing->mode()), name(audit.pairing->scheme()), result.work.share(),
                         audit.work ? '*' : ' ', tangential(result), audit.tangential ? '*' : ' ', result.jumps,
                         audit.jumps ? '*' : ' ', result.relative_jump(), audit.greatest_jump ? '*' : ' ',
                         result.misses.empty() ? "" : " MISSED");
  }
  return lines + '\n' + misses_of(results);
}

std::string audits_verdict(const std::vector<AuditResult>& results) {
  std::size_t expectations = 0;
  for (const AuditResult& result : results)
    for (const bool expected : {result.audit.work.has_value(), result.audit.tangential.has_value(),
                                result.audit.jumps.has_value(), result.audit.greatest_jump.has_value()})
      expectations += expected ? 1 : 0;
  return fmt::format("audits {}: {} loops, {} expectations, {} rows missed", met(results) ? "met" : "NOT met",
                     results.size(), expectations, missed(results));
}

std::string audits_markdown(const std::vector<AuditResult>& results) {
  std::string page =
      "# Audits of closed loops\n\n"
      "Elastic force, no damping, no friction. `work`: of the contact on F over the loop, by the trapezoidal rule with "
      "jumps resolved, in units of greatest force times way (plus greatest torque times turn); `rule`: estimate of the "
      "rule's error, alike; `tangential`: greatest force within the plane of sliding, in units of the greatest normal "
      "force; `greatest`: greatest jump in units of the greatest force.\n\n"
      "| case | loop | mode | scheme | work | rule | expected | tangential | expected | jumps | expected | greatest | "
      "expected | why | met |\n|---|---|---|---|--:|--:|---|--:|---|--:|---|--:|---|---|---|\n";
  for (const AuditResult& result : results) {
    const Audit& audit = result.audit;
    const double unit = result.work.greatest, force = result.work.greatest_force;
    page +=
        fmt::format("| {}: {} | {} | {} | {} | {:.3e} | {:.0e} | {} | {} | {} | {} | {} | {:.3g} | {} | {} | {} |\n",
                    audit.id, audit.bodies, audit.loop, name(audit.pairing->mode()), name(audit.pairing->scheme()),
                    result.work.share(), result.work.error / unit, text(audit.work, unit), tangential(result),
                    text(audit.tangential, 1), result.jumps, text(audit.jumps, 1), result.relative_jump(),
                    text(audit.greatest_jump, force), audit.reason, result.misses.empty() ? "yes" : "**no**");
  }
  const std::string misses = misses_of(results);
  return misses.empty() ? page : page + '\n' + misses;
}

std::string audits_csv(const std::vector<AuditResult>& results) {
  std::string table =
      "case,bodies,loop,mode,scheme,way,turn,greatest_force,work,work_error,work_share,tangential_share,jumps,"
      "sum_of_jumps,greatest_jump,met\n";
  for (const AuditResult& result : results) {
    const Audit& audit = result.audit;
    const PosePath path(audit.poses);
    table += fmt::format("\"{}\",\"{}\",\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{}\n", audit.id, audit.bodies,
                         audit.loop, name(audit.pairing->mode()), name(audit.pairing->scheme()), path.length(),
                         path.turn(), result.work.greatest_force, result.work.work, result.work.error,
                         result.work.share(), result.tangential ? fmt::format("{}", result.tangential->share()) : "",
                         result.jumps, result.sum_of_jumps, result.greatest_jump, result.misses.empty());
  }
  return table;
}

ColumnUnits audits_units() {
  return {{"way", "m"},        {"turn", "rad"},       {"greatest_force", "N"}, {"work", "J"},
          {"work_error", "J"}, {"sum_of_jumps", "N"}, {"greatest_jump", "N"}};
}

nlohmann::ordered_json audits_json(const std::vector<AuditResult>& results) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const AuditResult& result : results) {
    const Audit& audit = result.audit;
    nlohmann::ordered_json row;
    row["case"] = audit.id;
    row["bodies"] = audit.bodies;
    row["loop"] = audit.loop;
    row["mode"] = name(audit.pairing->mode());
    row["scheme"] = name(audit.pairing->scheme());
    row["greatest_force"] = result.work.greatest_force;
    row["greatest_work"] = result.work.greatest;
    row["work"] = result.work.work;
    row["work_error"] = result.work.error;
    row["work_expected"] = json(audit.work);
    row["tangential_share"] =
        result.tangential ? nlohmann::ordered_json(result.tangential->share()) : nlohmann::ordered_json();
    row["tangential_expected"] = json(audit.tangential);
    row["jumps"] = result.jumps;
    row["jumps_expected"] = json(audit.jumps);
    row["sum_of_jumps"] = result.sum_of_jumps;
    row["greatest_jump"] = result.greatest_jump;
    row["greatest_jump_expected"] = json(audit.greatest_jump);
    row["expectation"] = audit.reason;
    row["misses"] = result.misses;
    rows.push_back(std::move(row));
  }
  return {{"verdict", {{"met", met(results)}, {"rows", results.size()}, {"missed_rows", missed(results)}}},
          {"rows", std::move(rows)}};
}

}  // namespace pcm::compare
