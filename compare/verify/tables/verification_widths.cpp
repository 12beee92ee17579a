// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/tables/verification_widths.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "compare/io/names.h"
#include "compare/verify/run/run_verdict.h"

namespace pcm::compare {
namespace {

struct KindText {
  Kind kind;
  std::string_view unit;  ///< what widths are told in units of
  std::string_view why;   ///< what makes a check wide
};

/// The kinds whose checks have a width; the others hold discrete facts, or doubles bit for bit.
constexpr KindText kTexts[] = {
    {Kind::elements, "the element's area",
     "clipped scheme: a sliver, as narrow as projected edges are uncertain, may come or go"},
    {Kind::crossing_position, "the greatest coordinate", "an edge nearly in the plane of the face it passes through"},
    {Kind::area, "the area, with all of what lies in one plane with the other body's faces",
     "a patch no larger than its crossings are uncertain"},
    {Kind::vector_area, "the same", "as the area; slivers, whose normals are uncertain"},
    {Kind::volume, "the volume", "as the area, over a body hardly thicker than the roundings of its vertices"},
    {Kind::element_area, "the area", "clipped scheme: a narrow part of a face, or a needle"},
    {Kind::element_penetration, "the penetration",
     "a penetration no greater than roundings of coordinates; a slave face nearly parallel to the line"},
    {Kind::element_position, "the greatest coordinate", "clipped scheme: the centre of pressure of a sliver"},
    {Kind::element_normal, "1", "a needle, whose normal is uncertain"},
    {Kind::element_velocity, "the element's speed", "what is said of normal and position"},
    {Kind::element_force, "the element's force", "what is said of area, penetration and normal; friction near rest"},
    {Kind::penetration, "the greatest penetration",
     "as an element's; clipped scheme: held by the engine's own two bounds (below), or by slivers alone (`any`)"},
    {Kind::force, "the sum of the elements' forces", "what is said of elements, in the mean over all of them"},
    {Kind::torque, "the sum of lever times force", "the same"},
    {Kind::tangent, "the greatest entry of its three by three",
     "entries that cancel; a slave face nearly parallel to the line; a kink of the law, where it may be either side's"},
    {Kind::sums, "the sum of the terms' sizes", "n roundings of n terms"},
    {Kind::statistics, "the value", "a mean pressure or centre of pressure in which tension cancels pressure"},
    {Kind::bound, "the sum of the elements' forces, or of lever times force",
     "the engine's own bound: where a decision may be another one in the exact problem it holds all answers"},
    {Kind::penetration_bound, "the greatest penetration",
     "the engine's own two bounds, how far apart they are: as above, or where a gap as narrow as roundings shows what "
     "lies deepest"},
};

const Widths& widths_of(const Tally& tally, Kind kind) {
  return tally.widths[static_cast<std::size_t>(kind)];
}

/// The poses of a stratum in one scheme, over all modes.
struct Group {
  std::string stratum;
  Scheme scheme;
  Tally tally;
};

/// What the generic poses of pairs that are not made to hurt are called.
constexpr std::string_view kMeasured = "measured";

/// Strata in each scheme, and of the generic ones once more those that the measure is demanded of. Recorded poses are
/// not generic.
std::vector<Group> groups_of(const Verification& run) {
  std::vector<Group> groups;
  for (const StratumTally& t : run.by_stratum_scheme_and_mode()) {
    if (groups.empty() || groups.back().stratum != name(t.stratum) || groups.back().scheme != t.scheme)
      groups.push_back({std::string(name(t.stratum)), t.scheme, t.tally});
    else
      groups.back().tally.merge(t.tally);
  }
  if (!run.plan().recorded.empty()) return groups;
  for (const Scheme scheme : run.plan().schemes)
    groups.push_back({std::string(kMeasured), scheme, measured_poses(run, scheme)});
  return groups;
}

std::string number(double width) {
  return width == 0 ? "exact" : std::isinf(width) ? "any" : fmt::format("{:.1e}", width);
}

template <class Visit>
void for_each_width(const Verification& run, const Visit& visit) {
  for (const Group& group : groups_of(run))
    for (int k = 1; k < kKinds; ++k)
      if (const Widths& widths = widths_of(group.tally, static_cast<Kind>(k)); widths.count() > 0)
        visit(group, static_cast<Kind>(k), widths);
}

}  // namespace

std::string widths_markdown(const Verification& run) {
  std::string text =
      "## How wide the checks were\n\n"
      "A check holds a value of the engine to within a derived bound of the oracle's. Its width is that bound in units "
      "of what it holds; `exact` checks let nothing else pass. `measured`: the generic poses of pairs that are not "
      "made to hurt. `any`: checks that let anything pass; `wider`: finite, "
      "but wider than what they held; `of 0`: held 0 to within a bound that is not, so that they have no width.\n\n"
      "| stratum | scheme | check | checks | median | p99 | p99.9 | any | wider | of 0 |\n"
      "|---|---|---|--:|--:|--:|--:|--:|--:|--:|\n";
  for_each_width(run, [&text](const Group& group, Kind kind, const Widths& widths) {
    text += fmt::format("| {} | {} | {} | {} |", group.stratum, name(group.scheme), name(kind), widths.count());
    for (const double q : kShownQuantiles)
      text += fmt::format(" {} |", widths.has_quantiles() ? number(widths.quantile(q)) : "-");
    text += fmt::format(" {} | {} | {} |\n", widths.infinite, widths.wider, widths.of_zero);
  });
  text += "\n| check | in units of | wide where |\n|---|---|---|\n";
  for (const KindText& of_kind : kTexts)
    text += fmt::format("| {} | {} | {} |\n", name(of_kind.kind), of_kind.unit, of_kind.why);
  return text;
}

std::string widths_csv(const Verification& run) {
  std::string text = "stratum,scheme,check,checks,median,p99,p99.9,any,wider,of 0\n";
  for_each_width(run, [&text](const Group& group, Kind kind, const Widths& widths) {
    text += fmt::format("{},{},{},{}", group.stratum, name(group.scheme), name(kind), widths.count());
    for (const double q : kShownQuantiles)
      text += widths.has_quantiles() ? fmt::format(",{}", widths.quantile(q)) : ",";
    text += fmt::format(",{},{},{}\n", widths.infinite, widths.wider, widths.of_zero);
  });
  return text;
}

nlohmann::ordered_json widths_json(const Verification& run) {
  auto json = nlohmann::ordered_json::array();
  // JSON has no infinity: null stands for it. What has no quantiles has no entries for them.
  const auto finite = [](double x) { return std::isinf(x) ? nlohmann::ordered_json() : nlohmann::ordered_json(x); };
  for_each_width(run, [&](const Group& group, Kind kind, const Widths& widths) {
    nlohmann::ordered_json entry = {{"stratum", group.stratum},
                                    {"scheme", std::string(name(group.scheme))},
                                    {"check", std::string(name(kind))},
                                    {"checks", widths.count()}};
    if (widths.has_quantiles()) {
      entry["median"] = finite(widths.quantile(0.5));
      entry["p99"] = finite(widths.quantile(0.99));
      entry["p99.9"] = finite(widths.quantile(0.999));
    }
    entry["any"] = widths.infinite;
    entry["wider"] = widths.wider;
    entry["of 0"] = widths.of_zero;
    json.push_back(std::move(entry));
  });
  return json;
}

std::string widths_summary(const Verification& run) {
  const std::vector<Group> groups = groups_of(run);
  std::vector<std::string> columns;
  for (const Group& group : groups)
    if (std::find(columns.begin(), columns.end(), group.stratum) == columns.end()) columns.push_back(group.stratum);
  std::string text =
      "\nHow wide the checks were: medians of their bounds in units of what they hold; `any`: let anything pass; "
      "`wider`:\nthan what they held; `of 0`: held 0 to within a bound, so in no units";
  text += run.plan().recorded.empty() ? "; `measured`: as above, part of generic\n" : "\n";
  text += fmt::format("{:<20}{:<12}{:>12}", "check", "scheme", "checks");
  for (const std::string& column : columns) text += fmt::format("{:>17}", column);
  text += fmt::format("{:>10}{:>10}{:>10}\n", "any", "wider", "of 0");
  for (const KindText& of_kind : kTexts)
    for (const Scheme scheme : run.plan().schemes) {
      Widths all;
      std::string medians;
      for (const std::string& column : columns) {
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const Group& g) { return g.scheme == scheme && g.stratum == column; });
        const Widths widths = group == groups.end() ? Widths{} : widths_of(group->tally, of_kind.kind);
        if (column != kMeasured) all.merge(widths);
        medians += fmt::format("{:>17}", widths.has_quantiles() ? number(widths.quantile(0.5)) : "-");
      }
      if (all.count() == 0) continue;
      text += fmt::format("{:<20}{:<12}{:>12}{}{:>10}{:>10}{:>10}\n", name(of_kind.kind), name(scheme), all.count(),
                          medians, all.infinite, all.wider, all.of_zero);
    }
  return text;
}

ColumnUnits widths_units() {
  const std::string unit = "of each check its own, named in verification.md";
  return {{"median", unit}, {"p99", unit}, {"p99.9", unit}};
}

}  // namespace pcm::compare
