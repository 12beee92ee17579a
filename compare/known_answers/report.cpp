// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/report.h"

#include <fmt/core.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "compare/io/names.h"
#include "compare/io/tables/table.h"
#include "compare/known_answers/problems.h"

namespace pcm::compare {
namespace {

std::string_view in_words(Sharpness sharpness) {
  return sharpness == Sharpness::bits ? "bit for bit" : sharpness == Sharpness::rounding ? "to rounding" : "exact";
}

std::string optional_number(const std::optional<double>& x, int digits) {
  return x ? fmt::format("{:.{}g}", *x, digits) : "-";
}

/// A band; an end that is infinite is left out.
std::string text(const Band& band) {
  if (!std::isfinite(band.least) && !std::isfinite(band.greatest)) return "-";
  return fmt::format("{:.3g} to {:.3g}", band.least, band.greatest);
}

std::string text(const std::optional<Band>& band) {
  return band ? text(*band) : "-";
}

/// Deviation of the Richardson value, as those of the levels are.
std::optional<double> richardson_deviation(const Series& series, const Convergence& c) {
  if (!c.richardson) return {};
  return static_cast<double>((*c.richardson - series.reference) / series.scale);
}

nlohmann::ordered_json json(const Band& band) {
  const auto end = [](double x) { return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(); };
  return {end(band.least), end(band.greatest)};
}

nlohmann::ordered_json json(const std::optional<double>& x) {
  return x ? nlohmann::ordered_json(*x) : nlohmann::ordered_json();
}

nlohmann::ordered_json json(const Series& series, const SeriesResult& result) {
  nlohmann::ordered_json row;
  row["quantity"] = series.quantity;
  row["mode"] = name(series.mode);
  row["scheme"] = name(series.scheme);
  row["reference"] = static_cast<double>(series.reference);
  row["scale"] = series.scale;
  row["orientations"] = series.orientations;
  row["order"] = json(result.convergence.order);
  row["order_expected"] = series.order ? json(*series.order) : nlohmann::ordered_json();
  row["order_of_values"] = json(result.convergence.order_of_values);
  row["grid_convergence_index"] = json(result.convergence.grid_convergence_index);
  row["richardson"] = json(result.convergence.richardson);
  row["richardson_deviation"] = json(richardson_deviation(series, result.convergence));
  row["expectation"] = series.reason;
  row["levels"] = nlohmann::ordered_json::array();
  for (std::size_t l = 0; l < series.levels.size(); ++l) {
    const Resolution& level = series.levels[l];
    const LevelResult& found = result.levels[l];
    row["levels"].push_back({{"meshes", level.meshes},
                             {"edge", level.edge},
                             {"faces", level.faces},
                             {"edges_across", level.across},
                             {"value", found.value},
                             {"deviation", found.deviation},
                             {"deviation_least", found.least},
                             {"deviation_greatest", found.greatest},
                             {"deviation_rms", found.rms},
                             {"deviation_expected", json(level.deviation)}});
  }
  row["misses"] = result.misses;
  return row;
}

}  // namespace

std::size_t KnownAnswersReport::rows() const {
  std::size_t n = 0;
  for (const KnownAnswerResult& result : problems) n += result.series.size();
  return n;
}

std::size_t KnownAnswersReport::missed_rows() const {
  std::size_t n = 0;
  for (const KnownAnswerResult& result : problems) n += result.missed();
  return n;
}

std::size_t KnownAnswersReport::missed_identities() const {
  return static_cast<std::size_t>(
      std::count_if(identities.begin(), identities.end(), [](const IdentityResult& i) { return !i.passed(); }));
}

KnownAnswersReport run_known_answers(Extent extent, std::uint64_t seed, int jobs, KeptValues& kept,
                                     const std::function<void(const std::string&)>& progress) {
  KnownAnswersReport report;
  oneapi::tbb::task_arena arena(jobs);
  arena.execute([&] {
    for (const KnownAnswerFamily family : known_answer_families())
      for (KnownAnswer& problem : family(extent)) {
        progress(problem.id + ": " + problem.title);
        report.problems.push_back(run(std::move(problem), kept));
      }
    progress("identities");
    report.identities = check_identities(seed, extent);
  });
  // By number, and what has none at the end.
  std::stable_sort(
      report.problems.begin(), report.problems.end(), [](const KnownAnswerResult& a, const KnownAnswerResult& b) {
        const std::string &x = a.problem.id, &y = b.problem.id;
        return x.front() != y.front() ? x.front() < y.front() : x.size() != y.size() ? x.size() < y.size() : x < y;
      });
  return report;
}

std::string problem_markdown(const KnownAnswerResult& result) {
  const KnownAnswer& problem = result.problem;
  std::string page = fmt::format(
      "# {}: {}\n\n{}\n\nReference: {}.\n\n"
      "Deviations are relative to the reference, or to what the quantity says where that is 0; `order`: of the "
      "deviations of the last three levels in edge length; `order of values`, `Richardson` (deviation of the "
      "extrapolated value) and `GCI` (grid convergence index, Roache 1998, safety 1.25): from the last three values "
      "alone, - where they do not converge monotonically.\n\n"
      "| quantity | mode | scheme | reference | finest | deviation | expected | order | expected | order of values | "
      "Richardson | GCI | why | met |\n|---|---|---|--:|--:|--:|---|--:|---|--:|--:|--:|---|---|\n",
      problem.id, problem.title, problem.problem, problem.reference);
  for (std::size_t s = 0; s < problem.series.size(); ++s) {
    const Series& series = problem.series[s];
    const SeriesResult& row = result.series[s];
    page += fmt::format("| {} | {} | {} | {:.9Lg} | {:.9g} | {:.3e} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                        series.quantity, name(series.mode), name(series.scheme), series.reference,
                        row.levels.back().value, row.levels.back().deviation, text(series.levels.back().deviation),
                        optional_number(row.convergence.order, 4), text(series.order),
                        optional_number(row.convergence.order_of_values, 4),
                        optional_number(richardson_deviation(series, row.convergence), 3),
                        optional_number(row.convergence.grid_convergence_index, 3), series.reason,
                        row.misses.empty() ? "yes" : "**no**");
  }
  page +=
      "\n## Levels\n\n`edge`: root mean square edge length or cell, m; `across`: width of the contact in edges; "
      "`least`, `greatest` and `rms` (root mean square): deviations of single orientations.\n\n"
      "| quantity | mode | scheme | meshes | edge | faces | across | value | deviation | least | greatest | rms | "
      "expected |\n|---|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|---|\n";
  for (std::size_t s = 0; s < problem.series.size(); ++s) {
    const Series& series = problem.series[s];
    for (std::size_t l = 0; l < series.levels.size(); ++l) {
      const Resolution& level = series.levels[l];
      const LevelResult& found = result.series[s].levels[l];
      page +=
          fmt::format("| {} | {} | {} | {} | {:.4g} | {} | {} | {:.9g} | {:.3e} | {:.3e} | {:.3e} | {:.3e} | {} |\n",
                      series.quantity, name(series.mode), name(series.scheme), level.meshes, level.edge, level.faces,
                      level.across > 0 ? fmt::format("{:.1f}", level.across) : "-", found.value, found.deviation,
                      found.least, found.greatest, found.rms, text(level.deviation));
    }
  }
  for (std::size_t s = 0; s < problem.series.size(); ++s)
    for (const std::string& miss : result.series[s].misses)
      page += fmt::format("\nMissed: {} ({}, {}): {}\n", problem.series[s].quantity, name(problem.series[s].mode),
                          name(problem.series[s].scheme), miss);
  return page;
}

std::string identities_markdown(const std::vector<IdentityResult>& identities) {
  std::string page =
      "# Identities that need no reference\n\n`worst`: greatest difference in units of what rounding allows.\n\n"
      "| identity | statement | sharpness | checks | violations | worst | held |\n|---|---|---|--:|--:|--:|---|\n";
  for (const IdentityResult& i : identities)
    page += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", i.name, i.statement, in_words(i.sharpness), i.checks,
                        i.violations, i.sharpness == Sharpness::rounding ? fmt::format("{:.2g}", i.worst) : "-",
                        i.passed() ? "yes" : "**no**");
  for (const IdentityResult& i : identities)
    if (!i.first.empty()) page += fmt::format("\n{}: {}\n", i.name, i.first);
  return page;
}

std::string rows_csv(const std::vector<KnownAnswerResult>& problems) {
  std::string table =
      "case,quantity,mode,scheme,reference,meshes,edge,faces,edges_across,value,deviation,deviation_least,"
      "deviation_greatest,deviation_rms,expected_least,expected_greatest,order,order_of_values,richardson,grid_"
      "convergence_index,"
      "met\n";
  const auto number = [](const std::optional<double>& x) { return x.has_value() ? fmt::format("{}", x.value()) : ""; };
  for (const KnownAnswerResult& result : problems)
    for (std::size_t s = 0; s < result.series.size(); ++s) {
      const Series& series = result.problem.series[s];
      const SeriesResult& row = result.series[s];
      for (std::size_t l = 0; l < series.levels.size(); ++l) {
        const Resolution& level = series.levels[l];
        const LevelResult& found = row.levels[l];
        const bool finest = l + 1 == series.levels.size();
        table +=
            fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", result.problem.id, quoted(series.quantity),
                        name(series.mode), name(series.scheme), static_cast<double>(series.reference),
                        quoted(level.meshes), level.edge, level.faces, level.across, found.value, found.deviation,
                        found.least, found.greatest, found.rms, level.deviation.least, level.deviation.greatest);
        const Convergence& c = row.convergence;
        table += finest ? fmt::format(",{},{},{},{}", number(c.order), number(c.order_of_values), number(c.richardson),
                                      number(c.grid_convergence_index))
                        : ",,,,";
        table += row.misses.empty() ? ",yes\n" : ",no\n";
      }
    }
  return table;
}

ColumnUnits rows_units() {
  return {{"reference", "that of the quantity, SI"},
          {"value", "that of the quantity, SI"},
          {"richardson", "that of the quantity, SI"},
          {"edge", "m"}};
}

std::string identities_csv(const std::vector<IdentityResult>& identities) {
  std::string table = "identity,statement,sharpness,checks,violations,worst,held\n";
  for (const IdentityResult& i : identities)
    table += fmt::format("{},{},{},{},{},{},{}\n", quoted(i.name), quoted(i.statement), in_words(i.sharpness), i.checks,
                         i.violations, i.worst, i.passed() ? "yes" : "no");
  return table;
}

nlohmann::ordered_json cases_json(const std::vector<KnownAnswerResult>& problems) {
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  for (const KnownAnswerResult& result : problems) {
    nlohmann::ordered_json page;
    page["id"] = result.problem.id;
    page["title"] = result.problem.title;
    page["problem"] = result.problem.problem;
    page["reference"] = result.problem.reference;
    page["rows"] = nlohmann::ordered_json::array();
    for (std::size_t s = 0; s < result.series.size(); ++s)
      page["rows"].push_back(json(result.problem.series[s], result.series[s]));
    cases.push_back(std::move(page));
  }
  return cases;
}

nlohmann::ordered_json known_answers_json(const KnownAnswersReport& report) {
  nlohmann::ordered_json whole;
  whole["verdict"] = {{"met", report.met()},
                      {"rows", report.rows()},
                      {"missed_rows", report.missed_rows()},
                      {"identities", report.identities.size()},
                      {"missed_identities", report.missed_identities()}};
  whole["cases"] = cases_json(report.problems);
  whole["identities"] = nlohmann::ordered_json::array();
  for (const IdentityResult& i : report.identities)
    whole["identities"].push_back({{"name", i.name},
                                   {"statement", i.statement},
                                   {"sharpness", in_words(i.sharpness)},
                                   {"checks", i.checks},
                                   {"violations", i.violations},
                                   {"worst", i.worst},
                                   {"first", i.first}});
  return whole;
}

namespace {

/// Of the rows of a case in one scheme.
struct SchemeFindings {
  double greatest_deviation = 0;                                      ///< on the finest meshes
  std::optional<std::pair<double, double>> least_and_greatest_order;  ///< of those that have one
};

/// None where the case has no row in the scheme.
std::optional<SchemeFindings> findings_of(const KnownAnswerResult& result, Scheme scheme) {
  std::optional<SchemeFindings> found;
  for (std::size_t s = 0; s < result.series.size(); ++s) {
    const Series& series = result.problem.series[s];
    if (series.scheme != scheme) continue;
    if (!found) found.emplace();
    found->greatest_deviation = std::max(found->greatest_deviation, std::abs(result.series[s].levels.back().deviation));
    const std::optional<double>& order = result.series[s].convergence.order;
    if (!order || !series.order) continue;
    auto& orders = found->least_and_greatest_order;
    orders = orders ? std::pair(std::min(orders->first, *order), std::max(orders->second, *order))
                    : std::pair(*order, *order);
  }
  return found;
}

}  // namespace

Table cases_table(const KnownAnswersReport& report) {
  Table table{{{"case", "case", false}, {"title", "title", false}, {"rows", "rows"}, {"missed", "missed"}}, {}};
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const std::string of(name(scheme));
    table.columns.push_back({"deviation, " + of, of + " deviation"});
    table.columns.push_back({"order, " + of, of + " order", false});
  }
  for (const KnownAnswerResult& result : report.problems) {
    std::vector<TableCell> row{result.problem.id, result.problem.title,
                               count_cell(static_cast<std::int64_t>(result.series.size())),
                               count_cell(static_cast<std::int64_t>(result.missed()))};
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      const std::optional<SchemeFindings> found = findings_of(result, scheme);
      row.push_back(found ? TableCell(fmt::format("{:.1e}", found->greatest_deviation), found->greatest_deviation)
                          : empty_cell());
      row.push_back(found && found->least_and_greatest_order
                        ? TableCell(fmt::format("{:.2f} to {:.2f}", found->least_and_greatest_order->first,
                                                found->least_and_greatest_order->second))
                        : empty_cell());
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string known_answers_markdown(const KnownAnswersReport& report) {
  return fmt::format(
      "# Known answers at a glance\n\nEach case has a page of its own. `rows`: quantities, modes and schemes that are "
      "held; `missed`: those beyond what is derived for them. Then, by scheme, the greatest relative deviation on the "
      "finest meshes, and the orders at which deviations fall with the meshes' edges, where an order is asked for.\n\n"
      "{}\n{}\n",
      markdown(cases_table(report)), known_answers_verdict(report));
}

std::string known_answers_summary(const KnownAnswersReport& report) {
  std::string screen =
      "Greatest deviations on the finest meshes, and observed orders.\n" + on_screen(cases_table(report));
  screen += fmt::format("\n{:<50}{:>12}{:>9}{:>12}{:>8}\n", "identity", "sharpness", "checks", "violations", "worst");
  for (const IdentityResult& i : report.identities)
    screen += fmt::format("{:<50}{:>12}{:>9}{:>12}{:>8}\n", i.name, in_words(i.sharpness), i.checks, i.violations,
                          i.sharpness == Sharpness::rounding ? fmt::format("{:.2g}", i.worst) : "-");
  for (const KnownAnswerResult& result : report.problems)
    for (std::size_t s = 0; s < result.series.size(); ++s)
      for (const std::string& miss : result.series[s].misses)
        screen += fmt::format("missed: {}, {}, mode {}, {}: {}\n", result.problem.id, result.problem.series[s].quantity,
                              name(result.problem.series[s].mode), name(result.problem.series[s].scheme), miss);
  for (const IdentityResult& i : report.identities)
    if (!i.passed())
      screen += fmt::format("violated: {}: {}\n", i.name, i.first.empty() ? "nothing was checked" : i.first);
  return screen;
}

std::string known_answers_verdict(const KnownAnswersReport& report) {
  return fmt::format("known answers {}: {} cases, {} rows, {} missed; {} identities, {} violated",
                     report.met() ? "met" : "NOT met", report.problems.size(), report.rows(), report.missed_rows(),
                     report.identities.size(), report.missed_identities());
}

}  // namespace pcm::compare
