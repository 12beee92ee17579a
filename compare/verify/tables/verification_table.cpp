// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/tables/verification_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "compare/io/names.h"
#include "compare/verify/run/run_verdict.h"
#include "compare/verify/tables/overview.h"
#include "compare/verify/tables/verification_widths.h"

namespace pcm::compare {
namespace {

struct Row {
  std::string pair;
  std::string stratum;
  std::string scheme;
  std::string mode;
  Tally tally;
};

const std::string kAll = "**all**";

/// Each cell; each stratum in each scheme and mode; each scheme and each mode, where there are several; and all. What
/// had no pose has no row: those of other parts of a run.
std::vector<Row> rows(const Verification& run) {
  std::vector<Row> table;
  const auto add = [&table](Row row) {
    if (row.tally.poses > 0) table.push_back(std::move(row));
  };
  for (const Cell& cell : run.cells())
    add({run.plan().pairs[cell.pair].name, std::string(name(cell.stratum)), std::string(name(cell.scheme)),
         std::string(name(cell.mode)), cell.tally});
  for (const StratumTally& t : run.by_stratum_scheme_and_mode())
    add({kAll, std::string(name(t.stratum)), std::string(name(t.scheme)), std::string(name(t.mode)), t.tally});
  const bool schemes = run.plan().schemes.size() > 1, modes = run.plan().modes.size() > 1;
  for (const NamedTally& scheme : run.by_scheme())
    if (schemes) add({kAll, kAll, scheme.name, kAll, scheme.tally});
  for (const NamedTally& mode : run.by_mode())
    if (modes) add({kAll, kAll, kAll, mode.name, mode.tally});
  table.push_back({kAll, kAll, kAll, kAll, run.total()});
  return table;
}

std::string plain(const std::string& word) {
  return word == kAll ? "all" : word;
}

/// The kinds that have a column of their own in the Markdown table; the rest share one.
constexpr std::array kShownKinds = {Kind::touching,          Kind::polygon_count, Kind::polygon_cycle,
                                    Kind::intersected_faces, Kind::inner_faces,   Kind::elements};

double exact_fallback_rate(const Tally& tally) {
  return tally.predicates > 0 ? static_cast<double>(tally.exact_predicates) / static_cast<double>(tally.predicates) : 0;
}

std::string error_cell(const Tally& tally, std::size_t k) {
  if (tally.errors[k].count() == 0) return "-";
  std::string text;
  for (const double q : kShownQuantiles) text += fmt::format("{:.1e} / ", tally.error_quantile(k, q));
  return text + fmt::format("{:.1e}", tally.worst[k].value);
}

}  // namespace

std::string verification_markdown(const Verification& run) {
  const std::vector<Row> table = rows(run);
  std::string text =
      "## Agreement with the oracle on the rounded problem\n\n"
      "A row counts the poses of one mode, that of all modes each pose once for each. `disagreements` counts poses; "
      "`touch` to `other kinds` count them by what engine and oracle disagree about. "
      "`touching`, `nested` (one body inside the other without crossing), `ambiguous` (an open surface that does not "
      "tell inside from outside), `flipped` (rounding may have changed a contact element), `unbounded` (the engine "
      "promises nothing about its force), `announced` (it says that a decision may be another one in the exact "
      "problem) and `too deep` (a line of "
      "penetration leaves its own body first) count poses that are so. `fallback`: part of the engine's predicates "
      "that needed exact arithmetic. `rate <`: 95 % upper bound on the rate of disagreeing poses. `backward`: greatest "
      "distance of a rounded vertex of F from the true one, in ulps.\n\n"
      "| pair | stratum | scheme | mode | poses | touching | disagreements | touch | polygon count | polygon cycle | "
      "intersected | "
      "inner | elements | other kinds | nested | ambiguous | flipped | unbounded | announced | too deep | fallback | "
      "rate < | "
      "backward |\n"
      "|---|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Row& row : table) {
    const Tally& t = row.tally;
    std::int64_t others = 0;
    for (const std::int64_t n : t.by_kind) others += n;
    std::string kinds;
    for (const Kind kind : kShownKinds) {
      const std::int64_t n = t.by_kind[static_cast<std::size_t>(kind)];
      others -= n;
      kinds += fmt::format(" {} |", n);
    }
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} |{} {} | {} | {} | {} | {} | {} | {} | {:.1e} | {:.1e} | {:.2f} |\n",
        row.pair, row.stratum, row.scheme, row.mode, t.poses, t.touching, t.disagreeing, kinds, others, t.nested,
        t.ambiguous, t.flipped, t.unbounded, t.announced, t.too_deep, exact_fallback_rate(t),
        t.disagreement_rate_bound(), t.backward_error_ulps.value);
  }
  text +=
      "\n## Rounding error against the oracle on the exact problem\n\n"
      "This is the error of floating point alone: same meshes, same scheme; neither discretisation nor geometry shows. "
      "median / p99 / p99.9 / maximum of the relative errors divided by S/p (S: the greatest coordinate; p: mean "
      "thickness of the contact, twice the volume of the intersection over its surface; where a surface is open, of "
      "the "
      "prisms below the elements, walled along the intersection polygons); quantiles are rounded up by at most "
      "1/64. Area and vector area are relative "
      "to the area, volume to area times p, penetration to itself, force to the sum of the elements' |F|, torque to "
      "the sum of |lever| |F|. Penetration, force and torque without the poses that are `flipped`. "
      "Last the engine's own bounds on the errors of force and torque, where finite.\n\n"
      "| pair | stratum | scheme | mode |";
  for (const char* error : kErrorNames) text += fmt::format(" {} |", error);
  text += "\n|---|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Row& row : table) {
    std::int64_t count = 0;
    for (const Histogram& errors : row.tally.errors) count += errors.count();
    if (count == 0) continue;
    text += fmt::format("| {} | {} | {} | {} |", row.pair, row.stratum, row.scheme, row.mode);
    for (std::size_t k = 0; k < kErrors; ++k) text += fmt::format(" {} |", error_cell(row.tally, k));
    text += "\n";
  }
  text += "\n| stratum | scheme | mode | worst pose by | error | pose |\n|---|---|---|---|--:|---|\n";
  for (const Row& row : table) {
    if (row.pair != kAll) continue;
    for (std::size_t k = 0; k < kErrors; ++k)
      if (!row.tally.worst[k].pose.empty())
        text += fmt::format("| {} | {} | {} | {} | {:.2e} | {} |\n", row.stratum, row.scheme, row.mode, kErrorNames[k],
                            row.tally.worst[k].value, row.tally.worst[k].pose);
  }
  if (const std::string line = without_scene_line(run); !line.empty()) text += "\n" + line + "\n";
  for (const std::string& omission : run.poses().omissions()) text += "\n" + omission + "\n";
  return text;
}

std::string verification_csv(const Verification& run) {
  std::string text = "pair,stratum,scheme,mode,poses,touching,disagreements";
  for (int k = 0; k < kKinds; ++k) text += fmt::format(",{} disagreements", name(static_cast<Kind>(k)));
  text +=
      ",nested,ambiguous,flipped,unbounded,announced,too_deep,exact_fallback_rate,rate_bound_95,backward_error_ulps,"
      "backward_"
      "error_pose";
  for (const char* error : kErrorNames)
    text += fmt::format(",{0} count,{0} median,{0} p99,{0} p99.9,{0} max,{0} max pose", error);
  text += "\n";
  for (const Row& row : rows(run)) {
    const Tally& t = row.tally;
    text += fmt::format("{},{},{},{},{},{},{}", plain(row.pair), plain(row.stratum), plain(row.scheme), plain(row.mode),
                        t.poses, t.touching, t.disagreeing);
    for (const std::int64_t n : t.by_kind) text += fmt::format(",{}", n);
    text += fmt::format(",{},{},{},{},{},{},{},{},{},{}", t.nested, t.ambiguous, t.flipped, t.unbounded, t.announced,
                        t.too_deep, exact_fallback_rate(t), t.disagreement_rate_bound(), t.backward_error_ulps.value,
                        t.backward_error_ulps.pose);
    for (std::size_t k = 0; k < kErrors; ++k) {
      text += fmt::format(",{}", t.errors[k].count());
      for (const double q : kShownQuantiles) text += fmt::format(",{}", t.error_quantile(k, q));
      text += fmt::format(",{},{}", t.worst[k].value, t.worst[k].pose);
    }
    text += "\n";
  }
  return text;
}

// Errors are relative, and divided by S/p.
ColumnUnits verification_units() {
  return {{"backward_error_ulps", "ulp"}, {"median", "S/p"}, {"p99", "S/p"}, {"p99.9", "S/p"}, {"max", "S/p"}};
}

nlohmann::ordered_json verification_json(const Verification& run) {
  nlohmann::ordered_json json;
  json["verdict"] = {{"complete", run.finished()},
                     {"poses", run.poses_done()},
                     {"modes", run.poses().modes_per_pose()},
                     {"touching", touching_poses(run)},
                     {"disagreements", run.total().disagreeing},
                     {"verified", is_verified(run)}};
  if (run.plan().recorded.empty()) json["seed"] = run.plan().seed;
  json["rows"] = nlohmann::ordered_json::array();
  for (const Row& row : rows(run)) {
    const Tally& t = row.tally;
    nlohmann::ordered_json entry;
    entry["pair"] = plain(row.pair);
    entry["stratum"] = plain(row.stratum);
    entry["scheme"] = plain(row.scheme);
    entry["mode"] = plain(row.mode);
    entry["poses"] = t.poses;
    entry["touching"] = t.touching;
    entry["disagreements"] = t.disagreeing;
    for (int k = 0; k < kKinds; ++k)
      entry["by_kind"][std::string(name(static_cast<Kind>(k)))] = t.by_kind[static_cast<std::size_t>(k)];
    entry["nested"] = t.nested;
    entry["ambiguous"] = t.ambiguous;
    entry["flipped"] = t.flipped;
    entry["unbounded"] = t.unbounded;
    entry["announced"] = t.announced;
    entry["too_deep"] = t.too_deep;
    entry["exact_fallback_rate"] = exact_fallback_rate(t);
    entry["rate_bound_95"] = t.disagreement_rate_bound();
    entry["backward_error_ulps"] = {{"max", t.backward_error_ulps.value}, {"pose", t.backward_error_ulps.pose}};
    for (std::size_t k = 0; k < kErrors; ++k)
      entry["errors"][kErrorNames[k]] = {{"count", t.errors[k].count()},     {"median", t.error_quantile(k, 0.5)},
                                         {"p99", t.error_quantile(k, 0.99)}, {"p99.9", t.error_quantile(k, 0.999)},
                                         {"max", t.worst[k].value},          {"pose", t.worst[k].pose}};
    json["rows"].push_back(std::move(entry));
  }
  json["overview"] = compare::json(overview_table(run));
  json["widths"] = widths_json(run);
  json["without_scene"] = nlohmann::ordered_json::object();
  for (const auto& [stratum, poses] : poses_without_scene(run))
    json["without_scene"][std::string(name(stratum))] = poses;
  json["omissions"] = run.poses().omissions();
  return json;
}

std::string times_markdown(const Verification& run) {
  std::string text =
      "## Times\n\nMedian and p99 a pose; all answers asked for. Where there are several modes, the oracle works out "
      "what they share in the first one, and the engine finds the later ones' data in the cache. These vary from run "
      "to "
      "run.\n\n"
      "| pair | stratum | scheme | mode | engine (us) | oracle, rounded (ms) | exact as well (ms) "
      "|\n|---|---|---|---|--:|--:|--:|\n";
  for (const Row& row : rows(run)) {
    const Tally& t = row.tally;
    text += fmt::format("| {} | {} | {} | {} | {:.2f} / {:.2f} | {:.2f} / {:.2f} | {:.2f} / {:.2f} |\n", row.pair,
                        row.stratum, row.scheme, row.mode, 1e6 * t.engine_seconds.quantile(0.5),
                        1e6 * t.engine_seconds.quantile(0.99), 1e3 * t.oracle_seconds.quantile(0.5),
                        1e3 * t.oracle_seconds.quantile(0.99), 1e3 * t.oracle_exact_seconds.quantile(0.5),
                        1e3 * t.oracle_exact_seconds.quantile(0.99));
  }
  return text;
}

}  // namespace pcm::compare
