// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/stability_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "compare/io/names.h"

namespace pcm::compare::stability {
namespace {

constexpr const char* kLegend =
    "Errors are the engine's against the exact problem, all numbers taken as the reals that they are. Condition: how\n"
    "far the exact answer moves as one number of the pose moves by an ulp, the greatest over r's three and A's nine.\n"
    "Bound: the engine's own. All are relative: of forces to the sum of |F_k|, of torques to the sum of |C_k - r| "
    "|F_k|,\n"
    "of areas and penetrations to themselves; their ratios do not depend on that. A pose is flipped where the "
    "engine's\n"
    "bound says that a discrete decision may be another one in the exact problem; the others are settled.\n";

TableCell figure_cell(double x, bool there = true) {
  if (!there || std::isnan(x)) return empty_cell();
  return {fmt::format("{:.1e}", x), std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json()};
}

TableCell short_cell(double x) {
  return std::isnan(x) ? empty_cell() : TableCell(fmt::format("{:.0e}", x), x);
}

TableCell ratio_cell(double x) {
  return std::isnan(x) ? empty_cell() : TableCell(fmt::format("{:.2g}", x), x);
}

const PointFigures& other_scheme(const StabilityReport& report, const PointFigures& figures) {
  return *std::find_if(report.points.begin(), report.points.end(), [&](const PointFigures& other) {
    return other.point.sweep == figures.point.sweep && other.point.step == figures.point.step &&
           other.scheme != figures.scheme;
  });
}

std::vector<std::string> findings(const StabilityReport& report) {
  std::vector<std::string> lines;
  for (const PointFigures& figures : report.points) {
    const std::string where =
        fmt::format("{} {}, {}", name(figures.point.sweep), figures.point.in_words(), compare::name(figures.scheme));
    for (const std::string& outside : figures.outside_bound)
      lines.push_back(fmt::format("outside its bound: {}, {}", where, outside));
    if (figures.unanswered > 0)
      lines.push_back(fmt::format("no finite answer: {}, {} poses", where, figures.unanswered));
  }
  return lines;
}

// Okabe and Ito's colours, told apart by the colour-blind too.
const CurveStyle kError{"#0072b2", Marker::circle, false}, kFlippedError{"#0072b2", Marker::circle, true},
    kOfVertices{"#56b4e9", Marker::square, false}, kCondition{"#222222", Marker::diamond, false},
    kBound{"#d55e00", Marker::triangle, false}, kPublished2003{"#009e73", Marker::square, true},
    kPublished2023{"#cc79a7", Marker::diamond, true}, kForceRatio{"#777777", Marker::circle, false},
    kBarycentricForceRatio{"#777777", Marker::triangle, true}, kTorque{"#e69f00", Marker::triangle, false},
    kArea{"#009e73", Marker::square, false}, kPenetration{"#cc79a7", Marker::diamond, false};

/// What is greater says no more than that nothing is known; it is left out of plots.
constexpr double kNothingKnown = 1e4;

template <class NumberOf>
PlotCurve curve(const StabilityReport& report, Sweep sweep, Scheme scheme, const std::string& name,
                const CurveStyle& style, double greatest, const NumberOf& number_of) {
  PlotCurve points{name, style, {}};
  for (const PointFigures& figures : report.points) {
    if (figures.point.sweep != sweep || figures.scheme != scheme) continue;
    const double y = number_of(figures);
    if (y > 0 && y <= greatest) points.points.push_back({figures.point.parameter(), y});
  }
  std::sort(points.points.begin(), points.points.end());
  return points;
}

void keep_drawn(LogPlot& plot) {
  std::erase_if(plot.curves, [](const PlotCurve& c) { return c.points.empty(); });
}

LogPlot error_plot(const StabilityReport& report, Sweep sweep, Scheme scheme) {
  constexpr auto kForce = static_cast<std::size_t>(Quantity::force);
  const auto add = [&](LogPlot& plot, const std::string& name, const CurveStyle& style, const auto& number_of) {
    plot.curves.push_back(curve(report, sweep, scheme, name, style, kNothingKnown, number_of));
  };
  LogPlot plot;
  plot.title = scheme == Scheme::barycentric ? "Force, barycentric scheme" : "Force, clipped scheme";
  plot.x_title = title(sweep);
  plot.y_title = "relative to the sum of |F_k|, medians";
  add(plot, "the engine's bound", kBound,
      [](const PointFigures& p) { return p.settled.of(Quantity::force).bound.median; });
  add(plot, "condition: an ulp of the pose", kCondition,
      [](const PointFigures& p) { return p.settled.of(Quantity::force).condition.median; });
  add(plot, "the part of rounded vertices", kOfVertices,
      [](const PointFigures& p) { return p.settled.of(Quantity::force).of_vertices.median; });
  add(plot, "error of the engine", kError,
      [](const PointFigures& p) { return p.settled.of(Quantity::force).error.median; });
  add(plot, "error of the engine, flipped poses", kFlippedError,
      [](const PointFigures& p) { return p.flipped.of(Quantity::force).error.median; });
  if (scheme == Scheme::barycentric) {
    add(plot, "algorithm as published in 2003", kPublished2003,
        [](const PointFigures& p) { return p.settled.published[0].error[kForce].median; });
    add(plot, "variant published in 2023", kPublished2023,
        [](const PointFigures& p) { return p.settled.published[1].error[kForce].median; });
  }
  keep_drawn(plot);
  return plot;
}

LogPlot ratio_plot(const StabilityReport& report, Sweep sweep) {
  const auto ratio = [&](LogPlot& plot, Scheme scheme, Quantity quantity, const std::string& name,
                         const CurveStyle& style) {
    plot.curves.push_back(curve(report, sweep, scheme, name, style, HUGE_VAL, [&](const PointFigures& p) {
      return p.settled.of(quantity).error_over_condition.median;
    }));
  };
  LogPlot plot;
  plot.title = "Error over condition";
  plot.x_title = title(sweep);
  plot.y_title = "median, settled poses";
  ratio(plot, Scheme::barycentric, Quantity::force, "over condition: force, barycentric", kBarycentricForceRatio);
  ratio(plot, Scheme::clipped, Quantity::force, "over condition: force, clipped", kForceRatio);
  ratio(plot, Scheme::clipped, Quantity::torque, "over condition: torque, clipped", kTorque);
  ratio(plot, Scheme::clipped, Quantity::area, "over condition: area", kArea);
  ratio(plot, Scheme::clipped, Quantity::penetration, "over condition: penetration, clipped", kPenetration);
  keep_drawn(plot);
  return plot;
}

}  // namespace

Table stability_table(const StabilityReport& report) {
  Table table;
  table.columns = {{"sweep", "sweep", false},
                   {"value", "value", false},
                   {"parameter", "parameter"},
                   {"scheme", "scheme", false},
                   {"poses are", "group", false},
                   {"quantity", "quantity", false},
                   {"poses", "poses"},
                   {"without force", "without_force"},
                   {"no finite answer", "unanswered"},
                   {"outside bound", "outside_bound"},
                   {"infinite bound", "unbounded"}};
  for (const auto& [words, key] : {std::pair{"error", "error"},
                                   {"error of rounded vertices", "vertices_error"},
                                   {"condition", "condition"},
                                   {"bound", "bound"},
                                   {"error / condition", "error_over_condition"},
                                   {"bound / condition", "bound_over_condition"},
                                   {"bound / error", "bound_over_error"},
                                   {"2003: error", "published_2003_error"},
                                   {"2023: error", "published_2023_error"}}) {
    table.columns.push_back({fmt::format("{}, median", words), fmt::format("{}_median", key)});
    table.columns.push_back({fmt::format("{}, greatest", words), fmt::format("{}_greatest", key)});
  }
  for (const int year : {2003, 2023}) {
    table.columns.push_back(
        {fmt::format("{}: other elements", year), fmt::format("published_{}_other_elements", year)});
    table.columns.push_back({fmt::format("{}: no answer", year), fmt::format("published_{}_unanswered", year)});
  }
  for (const PointFigures& figures : report.points)
    for (const bool flipped : {false, true})
      for (std::size_t k = 0; k < kQuantities.size(); ++k) {
        const GroupFigures& group = flipped ? figures.flipped : figures.settled;
        if (!told(figures.scheme, kQuantities[k]) || group.poses == 0) continue;
        const GroupFigures::OfQuantity& of = group.quantities[k];
        std::vector<TableCell> row{std::string(name(figures.point.sweep)),
                                   figures.point.in_words(),
                                   TableCell(fmt::format("{:g}", figures.point.parameter()), figures.point.parameter()),
                                   std::string(compare::name(figures.scheme)),
                                   flipped ? "flipped" : "settled",
                                   std::string(name(kQuantities[k])),
                                   count_cell(group.poses),
                                   count_cell(figures.without_force),
                                   count_cell(figures.unanswered),
                                   count_cell(static_cast<std::int64_t>(figures.outside_bound.size())),
                                   count_cell(figures.unbounded)};
        const auto add = [&](const Spread& spread, bool there) {
          row.push_back(figure_cell(spread.median, there));
          row.push_back(figure_cell(spread.greatest, there));
        };
        const bool bounded = kQuantities[k] != Quantity::area;
        const bool published = figures.scheme == Scheme::barycentric;
        add(of.error, true);
        add(of.of_vertices, true);
        add(of.condition, true);
        add(of.bound, bounded);
        add(of.error_over_condition, true);
        add(of.bound_over_condition, bounded);
        add(of.bound_over_error, bounded);
        for (const GroupFigures::OfPublished& algorithm : group.published) add(algorithm.error[k], published);
        for (const GroupFigures::OfPublished& algorithm : group.published) {
          row.push_back(published ? count_cell(algorithm.other_elements) : empty_cell());
          row.push_back(published ? count_cell(algorithm.unanswered) : empty_cell());
        }
        table.rows.push_back(std::move(row));
      }
  return table;
}

Table flatness_table(const StabilityReport& report) {
  Table table{{{"sweep", "sweep", false},
               {"scheme", "scheme", false},
               {"quantity", "quantity", false},
               {"condition", "condition_least_median"},
               {"to", "condition_greatest_median"},
               {"error/cond.", "error_over_condition_least_median"},
               {"to", "error_over_condition_greatest_median"},
               {"apart", "greatest_over_least"},
               {"of any pose", "greatest_error_over_condition"},
               {"bound/cond.", "bound_over_condition_least_median"},
               {"to", "bound_over_condition_greatest_median"}},
              {}};
  for (const Flatness& flat : flatness(report)) {
    const bool bounded = flat.quantity != Quantity::area;
    table.rows.push_back({std::string(name(flat.sweep)), std::string(compare::name(flat.scheme)),
                          std::string(name(flat.quantity)), short_cell(flat.least_condition),
                          short_cell(flat.greatest_condition), ratio_cell(flat.least), ratio_cell(flat.greatest),
                          ratio_cell(flat.greatest / flat.least), ratio_cell(flat.greatest_of_all),
                          bounded ? ratio_cell(flat.least_bound) : empty_cell(),
                          bounded ? ratio_cell(flat.greatest_bound) : empty_cell()});
  }
  return table;
}

Table force_table(const StabilityReport& report, Sweep sweep) {
  Table table;
  table.columns = {{std::string(name(sweep)), "value"}};
  for (const char* scheme : {"barycentric", "clipped"})
    for (const char* column : {"set", "flip", "error", "cond", "bound", "e/c"})
      table.columns.push_back({column, fmt::format("{}_{}", scheme, column)});
  table.columns.insert(table.columns.end(), {{"2003", "published_2003_error"},
                                             {"other", "published_2003_other_elements"},
                                             {"2023", "published_2023_error"},
                                             {"other", "published_2023_other_elements"}});
  for (const PointFigures& barycentric : report.points) {
    if (barycentric.point.sweep != sweep || barycentric.scheme != Scheme::barycentric) continue;
    std::vector<TableCell> row{barycentric.point.in_words()};
    for (const PointFigures* figures : {&barycentric, &other_scheme(report, barycentric)}) {
      const GroupFigures::OfQuantity& force = figures->settled.of(Quantity::force);
      row.push_back(count_cell(figures->settled.poses));
      row.push_back(count_cell(figures->flipped.poses));
      for (const Spread* spread : {&force.error, &force.condition, &force.bound})
        row.push_back(short_cell(spread->median));
      row.push_back(ratio_cell(force.error_over_condition.median));
    }
    for (const GroupFigures::OfPublished& algorithm : barycentric.settled.published) {
      row.push_back(short_cell(algorithm.error[static_cast<std::size_t>(Quantity::force)].median));
      row.push_back(count_cell(algorithm.other_elements + algorithm.unanswered));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string stability_summary(const StabilityReport& report) {
  std::string screen = kLegend;
  screen += fmt::format(
      "\nForce, medians over the settled poses of {} (seed {}): number of settled and flipped poses, error, "
      "condition,\n"
      "bound, error over condition, in the barycentric scheme, then in the clipped one; then the errors of the "
      "algorithm\n"
      "as published in 2003 and of the variant of 2023, and how often they had other elements or no answer.\n",
      report.poses, report.seed);
  for (const Sweep sweep : kSweeps)
    screen += fmt::format("\n{}:\n{}", title(sweep), on_screen(force_table(report, sweep)));
  screen +=
      "\nError over condition along each sweep: medians of the points with settled poses, least to greatest, how far "
      "apart\n"
      "these are, and the greatest of any pose. The area is the same in both schemes.\n";
  screen += on_screen(flatness_table(report));
  for (const std::string& finding : findings(report)) screen += finding + '\n';
  return screen;
}

std::string stability_markdown(const StabilityReport& report) {
  std::string page = fmt::format(
      "# Stability\n\n{}\nIcospheres of radius 1 m, c_l = 1 N/m^3, elastic, E is the master; {} poses at each point, "
      "seed "
      "{}. error of rounded vertices: the rounded problem's exact answer against the exact problem's; what is left of "
      "the "
      "error is evaluation.\n\n## Error over condition\n\nMedians of the points with settled poses, least to greatest; "
      "apart: greatest over least.\n\n{}",
      kLegend, report.poses, report.seed, markdown(flatness_table(report)));
  for (const Sweep sweep : kSweeps)
    page += fmt::format(
        "\n## {}\n\nMedians of the force's figures, barycentric scheme, then clipped scheme; set, flip: settled and "
        "flipped "
        "poses; cond: condition; e/c: error over condition; 2003, 2023: errors of the published algorithms, other: how "
        "often they had other elements than the exact problem, or no answer. Plot: {}.svg\n\n{}",
        title(sweep), stability_picture(sweep), markdown(force_table(report, sweep)));
  page += "\n## All figures\n\n" + markdown(stability_table(report));
  for (const std::string& finding : findings(report)) page += fmt::format("\n- {}\n", finding);
  return page;
}

std::string stability_picture(Sweep sweep) {
  return fmt::format("stability_{}", name(sweep));
}

Figure stability_figure(const StabilityReport& report, Sweep sweep) {
  Figure figure;
  figure.title = fmt::format("Rounding error and condition over {}", title(sweep));
  for (LogPlot plot : {error_plot(report, sweep, Scheme::barycentric), error_plot(report, sweep, Scheme::clipped),
                       ratio_plot(report, sweep)})
    if (!plot.curves.empty()) figure.plots.push_back(std::move(plot));
  figure.caption = fmt::format(
      "Two polyhedral spheres{} in contact, an elastic foundation between them; medians over {} random poses at each "
      "value. Error: of the engine's force against the exact force, computed without rounding from the same doubles. "
      "Condition: how far the exact force moves as one of the pose's twelve numbers moves by a unit in the last place, "
      "the greatest over the twelve. The part of rounded vertices: error of the exact force between bodies of which "
      "one "
      "has its vertices rounded, as the engine has them; the rest is evaluation. Bound: what the engine itself "
      "promises; "
      "bounds above {:.0f} are not drawn. Error over condition is the engine's own share. Flipped poses, in which a "
      "discrete decision may not be that of the exact problem, are drawn apart.",
      sweep == Sweep::aspect ? ", stretched along one axis," : "", report.poses, kNothingKnown);
  return figure;
}

std::string stability_verdict(const StabilityReport& report) {
  std::int64_t answers = 0, flipped = 0, unanswered = 0;
  std::size_t outside = 0;
  for (const PointFigures& figures : report.points) {
    answers += figures.poses;
    flipped += figures.flipped.poses;
    unanswered += figures.unanswered;
    outside += figures.outside_bound.size();
  }
  return fmt::format(
      "stability {}: {} answers at {} points of {} sweeps, {} flipped, {} outside their bounds, {} not finite",
      report.met() ? "met" : "NOT met", answers, report.points.size() / kSchemes.size(), kSweeps.size(), flipped,
      outside, unanswered);
}

}  // namespace pcm::compare::stability
