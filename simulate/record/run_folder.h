// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "simulate/record/folder_lock.h"
#include "simulate/run/simulation.h"
#include "simulate/scenes/scene.h"

namespace pcm::simulate {

/// What a run has cost so far. Seconds differ from run to run; all else is the same bits.
struct RunCost {
  Work work;
  std::int64_t law_only = 0;          ///< of the evaluations, see Simulation::law_only
  std::int64_t elements_changed = 0;  ///< steps in which an element came or went
  std::int64_t too_deep = 0;          ///< steps that end with faces without a force
  double integration_seconds = 0;     ///< processor time of the steps
  double seconds = 0;                 ///< of all, recording included
};

/// What its tables are reported as, with what made them: run.provenance.json (compare::ReportFolder).
inline constexpr const char* kRunReport = "run";

/// Where a run stands that was kept.
struct KeptRun {
  Simulation::Checkpoint checkpoint;
  RunCost cost;
  bool finished = false;
};

/// The folder of a run:
///
///   scene.json              the scene as it was given
///   steps.csv               a line an accepted step
///   series.csv              a line an accepted step: energies, loads and statistics of the pairings
///   states.csv              coordinates and speeds at the start and at multiples of the output's interval
///   spectrum.csv            a line a spectrum that was asked for
///   trajectory/             surfaces and poses of the pairings, for `pcm verify --trajectory`
///   checkpoint.json         where the run goes on from
///   .pcm-simulate.lock      keeps other runs out (FolderLock)
///
/// and, of the caller, tables.md, tables.tex and run.provenance.json (compare::ReportFolder), page.html, stills and
/// paraview/.
///
/// Tables grow line by line. A checkpoint holds their lengths: what was written after it is cut off when a run goes on,
/// so that a run that was killed ends with the same bytes as one that was not; files it was killed at writing are
/// removed. Numbers in tables are the shortest that
/// read back to the same bits.
class RunFolder {
 public:
  /// Creates the folder where it is missing. `scene_text`, the scene's surfaces, what the command line changed and the
  /// program are what a kept run is known by. Throws BadInput where the folder can't be written to, or another run is
  /// at it.
  RunFolder(std::filesystem::path folder, std::string scene_text, const Scene& scene);

  /// The run that is kept there, ready to go on; none where there is none, or an unfinished one of another build of the
  /// program (`notice` then says so). Throws BadInput where it is of another scene, of another build and finished, or
  /// damaged: that may be worth keeping.
  std::optional<KeptRun> open(std::string& notice);
  /// Begins anew, with states of these components; whatever run was there is gone.
  void begin(const std::vector<StateColumn>& columns);

  void add_step(const SimulatedStep& step);
  /// A state at the output's interval.
  void add_state(double t, const Eigen::VectorXd& y);
  /// The tables are whole up to what was added last. Throws BadInput where they can't be written.
  void flush();
  /// All that was added is handed to the system, which keeps it though this program be killed (not through a loss of
  /// power), and the run goes on from here.
  void keep(const KeptRun& run);

 private:
  /// Throws BadInput naming one, where no run was begun here yet.
  void refuse_others_files() const;
  void open_tables(bool append);
  /// What was said of the tables, which are about to change.
  void remove_report() const;
  std::vector<std::filesystem::path> tables() const;
  /// What is written at once, not line by line.
  std::vector<std::filesystem::path> whole_files() const;
  /// In the order of `tables`.
  std::vector<std::ofstream*> streams();
  void write_surfaces() const;
  /// The scene's text and the trajectory's index, where they are missing or empty.
  void write_texts_that_are_missing() const;
  std::string trajectory_index() const;

  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
  std::string scene_text_;
  const Scene& scene_;
  std::string scene_hash_;
  std::ofstream steps_, series_, states_, spectrum_;
  std::vector<std::ofstream> poses_;  ///< by pairing
};

/// Reads a table back: names of its columns, and its lines.
struct NumberTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  /// Throws BadInput where there is no such column.
  std::vector<double> column(const std::string& name) const;
};
NumberTable read_number_table(const std::filesystem::path& file);

}  // namespace pcm::simulate
