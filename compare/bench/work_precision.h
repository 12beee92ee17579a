// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/bench/timing.h"
#include "compare/error_budget/bodies.h"
#include "compare/io/pictures/svg_plot.h"
#include "compare/io/tables/table.h"
#include "compare/wrong_answers/tested_engine.h"

/// `pcm bench work-precision`: error of the elastic force over run time, for pairs of smooth bodies (those of the error
/// budget) over mesh resolutions, schemes and engines.
///
/// Two errors, for they answer two questions. Against the smooth bodies' force: whoever may refine the meshes at will
/// pays for the meshes' error G e^2 (e: edge length) in either scheme and for the scheme's, D e^2, in the barycentric
/// one, while time grows as e^-2; so that at equal time the barycentric error over the clipped one tends to the
/// constant (1 + D / G) t_b / t_c, with t the times on one mesh, whatever that time is. It exceeds 1 only where the
/// meshes are better than the scheme, as at equal volume. Against the exact integral over the given meshes: the error
/// of whoever has these bodies and no others. D e^2 in the barycentric scheme, rounding in the clipped one. At equal
/// time the barycentric scheme is on a finer mesh there, and is held against the integral over that one.
namespace pcm::compare {

/// Who evaluates, and on which meshes.
struct Method {
  std::string name;  ///< in the legend
  Engine engine = Engine::fast;
  Scheme scheme = Scheme::barycentric;
  bool equal_volume = false;  ///< meshes that enclose the smooth bodies' volumes
};

const std::vector<Method>& work_precision_methods();

enum class ErrorAgainst : std::uint8_t { smooth, integral };

/// One method on the meshes of one level.
struct WorkPrecisionPoint {
  std::int64_t faces = 0;  ///< of both bodies
  double edge = 0;         ///< root mean square edge length of the master, m
  double median_us = 0;    ///< over the orientations, of the least time
  /// Root mean square over the orientations of |F - F_ref| / |F_ref|. Against the integral over the same meshes the
  /// clipped scheme shows the certified bound on its rounding: what it computes is that integral.
  double smooth_error = 0;
  double integral_error = 0;

  double error(ErrorAgainst reference) const {
    return reference == ErrorAgainst::smooth ? smooth_error : integral_error;
  }
};

/// One method, from coarse to fine meshes.
struct WorkPrecisionCurve {
  Method method;
  std::vector<WorkPrecisionPoint> points;
  std::optional<double> stopped_by_ms;  ///< what an evaluation took on the next finer meshes, where too long

  /// In edge length, by least squares over the last three levels; nothing where there are fewer than two.
  std::optional<double> order(ErrorAgainst reference) const;
};

/// A pair of bodies with its poses and the smooth bodies' force.
struct WorkPrecisionProblem {
  BudgetCase pair;
  std::vector<Pose> poses;                 ///< one an orientation
  std::vector<Eigen::Vector3d> smooth_Me;  ///< force on E at stiffness 1, N
};

struct WorkPrecisionResult {
  std::string id, title, problem, reference;
  std::size_t orientations = 0;
  std::vector<WorkPrecisionCurve> curves;  ///< one a method

  const WorkPrecisionCurve& curve(Scheme scheme, bool equal_volume) const;  ///< of the engine
};

/// Error of one curve over that of another where both take the same time; between the points both are powers of time.
struct EqualTime {
  double from_us = 0, to_us = 0;  ///< the times that both curves cover
  double least = 0, greatest = 0;
};
/// Nothing where no time is covered by both.
std::optional<EqualTime> errors_at_equal_time(const WorkPrecisionCurve& over, const WorkPrecisionCurve& under,
                                              ErrorAgainst reference);

/// Sphere on plane, sphere on sphere, ball in socket, bubble on bubble. The smooth bubbles' force takes some seconds on
/// all cores.
std::vector<WorkPrecisionProblem> work_precision_problems(Extent extent);

/// A method is left out of meshes on which an evaluation takes longer, but never of the coarsest.
inline constexpr double kLongestEvaluation_ms = 100;

/// All levels of the pair, methods taking turns at every pose.
WorkPrecisionResult run_work_precision(const WorkPrecisionProblem& problem,
                                       const std::function<void(const std::string&)>& progress);

Table work_precision_table(const std::vector<WorkPrecisionResult>& results);
/// Orders of convergence, and the barycentric error over the clipped one on the same meshes and at equal time.
Table equal_time_table(const std::vector<WorkPrecisionResult>& results);
std::string work_precision_screen(const std::vector<WorkPrecisionResult>& results, const Machine& machine);
std::string work_precision_markdown(const std::vector<WorkPrecisionResult>& results, const Machine& machine);
/// Both errors side by side.
Figure work_precision_figure(const WorkPrecisionResult& result, const Machine& machine);
/// The name of its file, without the extension; `id`: of the pair.
std::string work_precision_picture(const std::string& id);

}  // namespace pcm::compare
