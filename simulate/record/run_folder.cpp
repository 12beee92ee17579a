// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/run_folder.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <utility>

#include "compare/io/create_folder.h"
#include "compare/io/json/question_json.h"
#include "compare/io/names.h"
#include "compare/io/provenance/program_hash.h"
#include "compare/io/provenance/sha256.h"
#include "compare/io/tables/report_folder.h"
#include "meshes/files/parse_number.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/write_obj.h"
#include "simulate/integrators/make_integrator.h"
#include "simulate/record/run_provenance.h"
#include "simulate/scenes/still_instants.h"

namespace pcm::simulate {
namespace {

constexpr const char* kTrajectoryIndex = "trajectory/trajectory.json";

using Json = nlohmann::ordered_json;

/// A hash of all but itself.
std::string checksum(Json checkpoint) {
  checkpoint.erase("checksum");
  return compare::sha256(checkpoint.dump());
}

Json to_json(const Eigen::VectorXd& y) {
  Json json = Json::array();
  for (const double value : y) json.push_back(compare::hexadecimal(value));
  return json;
}

/// A hash of the scene's text, of what the command line changed, and of the surfaces, whose files may have changed.
std::string scene_hash(const std::string& scene_text, const Scene& scene) {
  std::string all = scene_text + settings_of(scene).dump();
  for (const SceneSurface& surface : scene.surfaces) all += compare::sha256(surface.surface.mesh());
  return compare::sha256(all);
}

/// A hash of the program and of its shared library, the integrators. The system's libraries are not part of it.
std::string build_hash() {
  Dl_info library{};
  if (dladdr(reinterpret_cast<void*>(&make_integrator), &library) == 0) return compare::program_hash();
  static const std::string hash =
      compare::sha256(compare::program_hash() + compare::program_hash_of(library.dli_fname));
  return hash;
}

Json to_json(const EnergyFlow& flow) {
  return {{"damping", compare::hexadecimal(flow.damping)},
          {"friction", compare::hexadecimal(flow.friction)},
          {"joints", compare::hexadecimal(flow.joints)},
          {"motions", compare::hexadecimal(flow.motions)}};
}

Json to_json(const RunCost& cost) {
  const Failures& failures = cost.work.failures;
  return {{"steps", cost.work.steps},
          {"derivatives", cost.work.derivatives},
          {"derivatives_for_jacobians", cost.work.derivatives_for_jacobians},
          {"linear_derivatives", cost.work.linear_derivatives},
          {"jacobians", cost.work.jacobians},
          {"nonlinear_iterations", cost.work.nonlinear_iterations},
          {"error_test", failures.error_test},
          {"nonlinear", failures.nonlinear},
          {"not_here", failures.not_here},
          {"not_finite", failures.not_finite},
          {"law_only", cost.law_only},
          {"elements_changed", cost.elements_changed},
          {"too_deep", cost.too_deep},
          {"integration_seconds", cost.integration_seconds},
          {"seconds", cost.seconds}};
}

EnergyFlow flow_from(const Json& json) {
  return {compare::number_from(json.at("damping")), compare::number_from(json.at("friction")),
          compare::number_from(json.at("joints")), compare::number_from(json.at("motions"))};
}

RunCost cost_from(const Json& json) {
  RunCost cost;
  cost.work.steps = json.at("steps");
  cost.work.derivatives = json.at("derivatives");
  cost.work.derivatives_for_jacobians = json.at("derivatives_for_jacobians");
  cost.work.linear_derivatives = json.at("linear_derivatives");
  cost.work.jacobians = json.at("jacobians");
  cost.work.nonlinear_iterations = json.at("nonlinear_iterations");
  cost.work.failures.error_test = json.at("error_test");
  cost.work.failures.nonlinear = json.at("nonlinear");
  cost.work.failures.not_here = json.at("not_here");
  cost.work.failures.not_finite = json.at("not_finite");
  cost.law_only = json.at("law_only");
  cost.elements_changed = json.at("elements_changed");
  cost.too_deep = json.at("too_deep");
  cost.integration_seconds = json.at("integration_seconds");
  cost.seconds = json.at("seconds");
  return cost;
}

std::string series_header(const Scene& scene) {
  std::string header =
      "t,kinetic,gravity,elastic,bumpers,lost_to_damping,lost_to_friction,lost_to_joints,brought_by_motions";
  for (std::size_t p = 0; p < scene.pairings.size(); ++p)
    header += fmt::format(",elements_{0},depth_{0},area_{0},normal_force_{0},tangential_force_{0}", p);
  return header + "\n";
}

std::string states_header(const std::vector<StateColumn>& columns) {
  std::string header = "t";
  for (const StateColumn& column : columns) header += "," + column.name;
  return header + "\n";
}

std::string pose_line(const PairingObservation& pairing) {
  std::string line;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) line += compare::hexadecimal(pairing.pose.A(i, j)) + " ";
  for (const Eigen::Vector3d& v : {pairing.pose.r, pairing.velocity.v, pairing.velocity.w})
    for (int i = 0; i < 3; ++i) line += compare::hexadecimal(v[i]) + (i < 2 ? " " : "  ");
  line += "\n";
  return line;
}

std::string surface_file(std::size_t surface) {
  return fmt::format("surface_{}.obj", surface);
}

/// Be it a link to nowhere.
bool is_there(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(std::filesystem::symlink_status(file, error));
}

[[noreturn]] void refuse_damaged(const std::filesystem::path& file) {
  throw BadInput(file.string() + ": is damaged; remove the folder to begin anew");
}

}  // namespace

RunFolder::RunFolder(std::filesystem::path folder, std::string scene_text, const Scene& scene)
    : folder_(std::move(folder)),
      scene_text_(std::move(scene_text)),
      scene_(scene),
      scene_hash_(scene_hash(scene_text_, scene)),
      poses_(scene.pairings.size()) {
  compare::create_folder(folder_);
  refuse_others_files();
  lock_.emplace(folder_);
  compare::create_folder(folder_ / "trajectory");
  for (const std::filesystem::path& file : whole_files()) remove_unfinished(folder_ / file);
}

void RunFolder::refuse_others_files() const {
  if (is_there(folder_ / "checkpoint.json")) return;
  std::vector<std::filesystem::path> files = whole_files();
  for (const std::filesystem::path& table : tables()) files.push_back(table);
  for (const double t : scene_.output.stills) files.emplace_back(still_name(t));
  files.emplace_back("paraview/frames.pvd");
  // The lock is looked for last: a run that is beginning at this moment makes it before its other files.
  for (const std::filesystem::path& file : files)
    if (is_there(folder_ / file) && !is_there(folder_ / kFolderLock))
      throw BadInput((folder_ / file).string() +
                     ": is there, and no run's, and a run would replace it; move it away, or choose another folder");
}

std::vector<std::filesystem::path> RunFolder::whole_files() const {
  std::vector<std::filesystem::path> files{
      "scene.json", "checkpoint.json", "trajectory/trajectory.json",        "tables.md",
      "tables.tex", "page.html",       compare::provenance_file(kRunReport)};
  for (std::size_t s = 0; s < scene_.surfaces.size(); ++s) files.push_back("trajectory/" + surface_file(s));
  return files;
}

std::vector<std::filesystem::path> RunFolder::tables() const {
  std::vector<std::filesystem::path> files{"steps.csv", "series.csv", "states.csv", "spectrum.csv"};
  for (std::size_t p = 0; p < poses_.size(); ++p) files.push_back(fmt::format("trajectory/{}.poses", p));
  return files;
}

std::vector<std::ofstream*> RunFolder::streams() {
  std::vector<std::ofstream*> all{&steps_, &series_, &states_, &spectrum_};
  for (std::ofstream& out : poses_) all.push_back(&out);
  return all;
}

void RunFolder::remove_report() const {
  std::error_code none_there;
  std::filesystem::remove(folder_ / compare::provenance_file(kRunReport), none_there);
}

void RunFolder::open_tables(bool append) {
  const std::vector<std::filesystem::path> files = tables();
  const std::vector<std::ofstream*> outs = streams();
  for (std::size_t i = 0; i < files.size(); ++i) {
    *outs[i] = std::ofstream(folder_ / files[i], std::ios::binary | (append ? std::ios::app : std::ios::trunc));
    if (!*outs[i]) throw BadInput((folder_ / files[i]).string() + ": can't be written");
  }
}

std::optional<KeptRun> RunFolder::open(std::string& notice) {
  const std::filesystem::path file = folder_ / "checkpoint.json";
  if (!std::filesystem::exists(file)) return std::nullopt;
  KeptRun run;
  try {
    std::ifstream in(file);
    const Json json = Json::parse(in);
    if (json.at("scene") != scene_hash_)
      throw BadInput(folder_.string() +
                     ": holds the run of another scene, or of other surfaces or options; choose another folder, or "
                     "remove it");
    if (json.at("program") != build_hash()) {
      if (json.at("finished").get<bool>())
        throw BadInput(folder_.string() +
                       ": holds a finished run of another build of this program, which is kept; choose another folder, "
                       "or remove it");
      notice = folder_.string() + ": holds an unfinished run of another build of this program; it is begun anew";
      return std::nullopt;
    }
    if (json.at("checksum") != checksum(json)) refuse_damaged(file);
    run.checkpoint.t = compare::number_from(json.at("t"));
    run.checkpoint.y.resize(static_cast<Eigen::Index>(json.at("y").size()));
    for (Eigen::Index i = 0; i < run.checkpoint.y.size(); ++i)
      run.checkpoint.y[i] = compare::number_from(json.at("y")[static_cast<std::size_t>(i)]);
    run.checkpoint.flow = flow_from(json.at("energy_flow"));
    run.checkpoint.energy_at_start = compare::number_from(json.at("energy_at_start"));
    run.cost = cost_from(json.at("cost"));
    run.finished = json.at("finished");
    const Json& lengths = json.at("lengths");
    for (const std::filesystem::path& table : tables())
      if (std::filesystem::file_size(folder_ / table) < lengths.at(table.string()).get<std::uintmax_t>())
        throw BadInput((folder_ / table).string() + ": is shorter than it was; remove the folder to begin anew");
    remove_report();
    for (const std::filesystem::path& table : tables())
      std::filesystem::resize_file(folder_ / table, lengths.at(table.string()).get<std::uintmax_t>());
  } catch (const Json::exception&) {
    refuse_damaged(file);
  } catch (const std::filesystem::filesystem_error& error) {
    throw BadInput(folder_.string() + ": " + error.code().message() + ": " + error.path1().string());
  }
  write_texts_that_are_missing();
  open_tables(true);
  return run;
}

void RunFolder::begin(const std::vector<StateColumn>& columns) {
  std::error_code ignored;
  std::filesystem::remove(folder_ / "checkpoint.json", ignored);
  remove_report();
  open_tables(false);
  write_surfaces();
  write_text_file(folder_ / "scene.json", scene_text_);
  write_text_file(folder_ / kTrajectoryIndex, trajectory_index());
  steps_ << "t,size,order,error_test_failures,nonlinear_failures,not_here,not_finite,elements,entered,left,too_deep\n";
  series_ << series_header(scene_);
  states_ << states_header(columns);
  spectrum_ << "t,size,least_real,greatest_imaginary,radius\n";
}

void RunFolder::write_surfaces() const {
  for (std::size_t s = 0; s < scene_.surfaces.size(); ++s)
    write_obj(scene_.surfaces[s].surface.mesh(), folder_ / "trajectory" / surface_file(s));
}

void RunFolder::write_texts_that_are_missing() const {
  const auto write = [this](const std::filesystem::path& file, const std::string& text) {
    std::error_code none_there;
    const std::uintmax_t size = std::filesystem::file_size(folder_ / file, none_there);
    if (none_there || size == 0) write_text_file(folder_ / file, text);
  };
  write("scene.json", scene_text_);
  write(kTrajectoryIndex, trajectory_index());
}

std::string RunFolder::trajectory_index() const {
  Json json;
  json["pcm_trajectory"] = 1;
  Json& surfaces = json["surfaces"] = Json::array();
  for (std::size_t s = 0; s < scene_.surfaces.size(); ++s)
    surfaces.push_back({{"name", scene_.surfaces[s].name}, {"file", surface_file(s)}});
  Json& pairings = json["pairings"] = Json::array();
  for (std::size_t p = 0; p < scene_.pairings.size(); ++p) {
    Json& pairing = pairings.emplace_back(pairing_json(scene_.pairings[p]));
    pairing["poses"] = fmt::format("{}.poses", p);
  }
  return json.dump(1) + "\n";
}

void RunFolder::add_step(const SimulatedStep& step) {
  const Failures& failures = step.step.failures;
  steps_ << fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", step.step.t, step.step.size, step.step.order,
                        failures.error_test, failures.nonlinear, failures.not_here, failures.not_finite, step.elements,
                        step.entered, step.left, step.too_deep);
  const Energies& e = step.observation.energies;
  series_ << fmt::format("{},{},{},{},{},{},{},{},{}", step.step.t, e.kinetic, e.gravity, e.elastic, e.bumpers,
                         step.flow.damping, step.flow.friction, step.flow.joints, step.flow.motions);
  for (std::size_t p = 0; p < poses_.size(); ++p) {
    const PairingObservation& pairing = step.observation.pairings[p];
    series_ << fmt::format(",{},{},{},{},{}", pairing.elements, pairing.max_penetration, pairing.patch_area,
                           pairing.normal_force, pairing.tangential_force);
    if (pairing.touching) poses_[p] << pose_line(pairing);
  }
  series_ << '\n';
  if (step.spectrum) {
    spectrum_ << fmt::format("{},{},{},{},{}\n", step.step.t, step.step.size, step.spectrum->least_real,
                             step.spectrum->greatest_imaginary, step.spectrum->radius);
  }
}

void RunFolder::add_state(double t, const Eigen::VectorXd& y) {
  states_ << fmt::format("{}", t);
  for (const double value : y) states_ << fmt::format(",{}", value);
  states_ << '\n';
}

void RunFolder::flush() {
  for (std::ofstream* out : streams())
    if (!out->flush()) throw BadInput(folder_.string() + ": can't be written to; is the disk full?");
}

void RunFolder::keep(const KeptRun& run) {
  Json json;
  json["scene"] = scene_hash_;
  json["settings"] = settings_of(scene_);
  json["program"] = build_hash();
  json["t"] = compare::hexadecimal(run.checkpoint.t);
  json["y"] = to_json(run.checkpoint.y);
  json["energy_flow"] = to_json(run.checkpoint.flow);
  json["energy_at_start"] = compare::hexadecimal(run.checkpoint.energy_at_start);
  json["cost"] = to_json(run.cost);
  json["finished"] = run.finished;
  flush();
  for (const std::filesystem::path& table : tables())
    json["lengths"][table.string()] = std::filesystem::file_size(folder_ / table);
  json["checksum"] = checksum(json);
  write_text_file(folder_ / "checkpoint.json", json.dump(1) + "\n");
}

std::vector<double> NumberTable::column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) throw BadInput("the table has no column '" + name + "'");
  const auto index = static_cast<std::size_t>(found - columns.begin());
  std::vector<double> values;
  for (const std::vector<double>& row : rows) values.push_back(row[index]);
  return values;
}

NumberTable read_number_table(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw BadInput(file.string() + ": can't be read");
  NumberTable table;
  std::string line, word;
  std::getline(in, line);
  for (std::istringstream words(line); std::getline(words, word, ',');) table.columns.push_back(word);
  // A last line without an end was being written when the run was killed.
  for (int number = 2; std::getline(in, line) && !in.eof(); ++number) {
    std::vector<double> row;
    for (std::istringstream words(line); std::getline(words, word, ',');) {
      const std::optional<double> value = parse_number(word);
      if (!value) throw BadInput(fmt::format("{}:{}: '{}' is no number", file.string(), number, word));
      row.push_back(*value);
    }
    if (row.size() != table.columns.size())
      throw BadInput(fmt::format("{}:{}: {} numbers, where the table has {} columns", file.string(), number, row.size(),
                                 table.columns.size()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace pcm::simulate
