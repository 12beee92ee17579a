// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/io/tables/kept_values.h"
#include "pcm/engine.h"
#include "pcm/inputs.h"

/// Known answers: problems whose force is known in closed form, and how far the engine is from it over a sequence of
/// resolutions. What each row must show is data beside the problem, with its derivation.
namespace pcm::compare {

/// How much of the problems is run.
enum class Extent : std::uint8_t {
  full,   ///< up to 327,680 triangles a body, 20 orientations
  quick,  ///< coarser meshes and fewer orientations, for a test
};

/// A closed range; by default everything.
struct Band {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();

  bool contains(double x) const { return least <= x && x <= greatest; }
};

inline Band within(double x) {
  return {-x, x};
}

/// Everything between `low` and `high` times x, whatever the sign of x.
inline Band between(double low, double high, double x) {
  return x < 0 ? Band{high * x, low * x} : Band{low * x, high * x};
}

/// The meshes of one level of refinement.
struct Resolution {
  std::string meshes;  ///< in words
  double edge = 1;     ///< root mean square edge length of the body whose curvature is approximated, or a cell's, m
  std::int64_t faces = 0;
  double across = 0;    ///< width of the contact in edges; 0 where it means nothing
  Band deviation = {};  ///< what the deviation must lie in
};

/// One quantity of a problem in one mode and scheme, over levels of refinement from coarse to fine.
struct Series {
  std::string quantity;
  Mode mode = Mode::E;
  Scheme scheme = Scheme::barycentric;
  long double reference = 0;
  double scale = 1;  ///< what deviations are relative to: |reference| unless that is 0
  std::vector<Resolution> levels;
  int orientations = 1;  ///< over which the mean is taken
  /// The engine's value. Called from any thread.
  std::function<double(std::size_t level, int orientation, fast::Workspace& workspace)> measure;
  std::optional<Band> order;  ///< what the observed order must lie in
  std::string reason;         ///< why the bands are what they are, in a few words
};

/// A problem.
struct KnownAnswer {
  std::string id;         ///< e.g. "A2"
  std::string title;      ///< in a few words
  std::string problem;    ///< bodies, pose, law
  std::string reference;  ///< the formula and where it comes from
  std::vector<Series> series;
};

/// The mean over the orientations at one level.
struct LevelResult {
  double value = 0;
  double deviation = 0;  ///< (mean - reference) / scale
  double least = 0;      ///< deviation of the orientations apart
  double greatest = 0;
  double rms = 0;  ///< root of their mean square
};

/// What the levels of a series say together.
struct Convergence {
  /// log(e1 / e3) / log(h1 / h3) of the deviations e of the last three levels.
  std::optional<double> order;
  /// Without the reference (Roache 1998): p = log((f3 - f2) / (f2 - f1)) / log(h2 / h1) for the mean ratio of edge
  /// lengths, none unless the last three values converge monotonically with 0.5 <= p <= 4.
  std::optional<double> order_of_values;
  std::optional<double> richardson;              ///< f1 + (f1 - f2) / (ratio^p - 1), f1 the finest
  std::optional<double> grid_convergence_index;  ///< 1.25 |f1 - f2| / (ratio^p - 1), relative to the scale
};

struct SeriesResult {
  std::vector<LevelResult> levels;
  Convergence convergence;
  std::vector<std::string> misses;  ///< what is out of bounds; empty where the row is met
};

struct KnownAnswerResult {
  KnownAnswer problem;
  std::vector<SeriesResult> series;  ///< in the order of problem.series

  std::size_t missed() const;
};

/// Statistics of the last three levels; fewer have none.
Convergence convergence(const std::vector<Resolution>& levels, const std::vector<LevelResult>& results, double scale);

/// Runs all series of a problem on the threads of the current TBB arena. The same bits whatever their number. Values
/// that are kept, under the problem's title, are not worked out again.
KnownAnswerResult run(KnownAnswer problem, KeptValues& kept);
inline KnownAnswerResult run(KnownAnswer problem) {
  KeptValues none;
  return run(std::move(problem), none);
}

}  // namespace pcm::compare
