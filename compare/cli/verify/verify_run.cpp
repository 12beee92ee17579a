// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <limits>
#include <system_error>
#include <utility>
#include <vector>

#include "compare/cli/frame/launcher.h"
#include "compare/cli/frame/surface_warnings.h"
#include "compare/io/names.h"
#include "compare/verify/run/recorded_scenes.h"
#include "compare/verify/run/trajectory.h"
#include "compare/verify/verdict/question_range.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

/// More than any machine gets through; products of pose numbers and shares stay below 2^63.
constexpr std::uint64_t kMostPoses = 10'000'000'000;

constexpr std::uint64_t kMostParts = 1'000'000;

std::int64_t number_of_poses(const std::string& text) {
  return static_cast<std::int64_t>(whole_number("--poses", text, 1, kMostPoses));
}

HeldPairing::Modes modes_named(const std::string& word) {
  return word == "all" ? HeldPairing::Modes{Mode::E, Mode::F, Mode::both} : HeldPairing::Modes{mode_named(word)};
}

/// With those of the stratum extreme, 2^-960 to 2^960 with an arm, there is room for numbers of a law from 2^-40 to
/// 2^40.
constexpr double kLeastOfExtreme = 0x1p-40, kGreatestOfExtreme = 0x1p40;

/// The option that gives a law's number.
std::string option_of(std::string_view key) {
  std::string option = "--" + std::string(key);
  std::replace(option.begin(), option.end(), '_', '-');
  if (key == "stiffness_E") option += " or --layer-E";
  if (key == "stiffness_F") option += " or --layer-F";
  return option;
}

/// Leaves the stratum extreme out under a law that has no room for it. Throws BadInput where it is asked for by name.
void leave_out_extreme(const ContactLaw& law, VerificationPlan& plan, std::vector<std::string>& notices) {
  const auto extreme = std::find(plan.strata.begin(), plan.strata.end(), Stratum::extreme);
  if (extreme == plan.strata.end()) return;
  for (const LawNumber& number : numbers_of(law)) {
    if (is_zero_infinite_or_between(number.value, kLeastOfExtreme, kGreatestOfExtreme)) continue;
    const std::string why = fmt::format(
        "stratum extreme: with {} of {:g} forces leave the range of doubles; from 2^-40 to 2^40 (9e-13 to 1e12) they "
        "do not",
        option_of(number.key), number.value);
    if (plan.strata_named) throw BadInput(why);
    notices.push_back(why + "; the stratum is left out");
    plan.strata.erase(extreme);
    return;
  }
}

/// Refuses pairs that are unfit for contact, and notes once what is odd about others.
void note_warnings(const std::vector<SurfacePair>& pairs, std::vector<std::string>& notices) {
  for (const SurfacePair& pair : pairs)
    for (const TriangleMesh* mesh : {&pair.E, &pair.F}) {
      const std::string warning = require_fit_or_warn(*mesh);
      if (!warning.empty() && std::find(notices.begin(), notices.end(), warning) == notices.end())
        notices.push_back(warning);
    }
}

/// Those of the command line, or else the built-in ones of these strata.
std::vector<SurfacePair> pairs_of(const VerifyOptions& options, const std::vector<Stratum>& strata,
                                  std::vector<std::string>& notices) {
  std::vector<SurfacePair> pairs = pairs_named(options, notices);
  if (!pairs.empty()) return pairs;
  std::vector<std::string> missing;
  const bool wants_trajectory = std::find(strata.begin(), strata.end(), Stratum::trajectory) != strata.end();
  if (!wants_trajectory || strata.size() > 1) pairs = built_in_pairs(installed_real_surfaces(), missing);
  if (!missing.empty())
    notices.push_back(
        fmt::format("skipped for want of the real surfaces of libcgal-demo: {}", fmt::join(missing, ", ")));
  if (wants_trajectory) std::ranges::move(recorded_pairs(), std::back_inserter(pairs));
  return pairs;
}

}  // namespace

Interruptible::Interruptible(std::int64_t whole, const char* what)
    : whole_(whole), what_(what), terminal_(isatty(STDERR_FILENO) != 0) {}

Interruptible::~Interruptible() {
  if (terminal_) std::cerr << '\n';
}

bool Interruptible::interrupted() const {
  return interrupt_.interrupted();
}

void Interruptible::show(std::int64_t done) const {
  if (terminal_ && (done % 16 == 0 || done == whole_))
    std::cerr << fmt::format("\r{} of {} {}", done, whole_, what_) << std::flush;
}

int number_of_jobs(const VerifyOptions& options) {
  if (options.jobs) return static_cast<int>(whole_number("--jobs", *options.jobs, 1, 4096));
  return cores_of(launched_process());
}

std::uint64_t seed_of(const VerifyOptions& options) {
  return whole_number("--seed", options.seed, 0, std::numeric_limits<std::uint64_t>::max());
}

std::vector<SurfacePair> pairs_named(const VerifyOptions& options, std::vector<std::string>& notices) {
  std::vector<SurfacePair> pairs;
  for (const std::vector<std::string>& files : options.pairs)
    pairs.push_back(pair_from_files(files.at(0), files.at(1)));
  note_warnings(pairs, notices);
  tell_apart(pairs);
  return pairs;
}

std::vector<Scheme> schemes_of(const VerifyOptions& options) {
  if (options.scheme && *options.scheme != "both") return {scheme_named(*options.scheme)};
  return {Scheme::barycentric, Scheme::clipped};
}

JobPart part_of(const VerifyOptions& options) {
  if (!options.merge.empty()) return kNoPart;
  if (!options.part) return {};
  const std::string& text = *options.part;
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) throw BadInput("--part: '" + text + "' is not K/N, e.g. 2/5");
  const std::uint64_t of = whole_number("--part", text.substr(slash + 1), 1, kMostParts);
  return {static_cast<std::int64_t>(whole_number("--part", text.substr(0, slash), 1, of)),
          static_cast<std::int64_t>(of)};
}

VerificationPlan plan_from(const VerifyOptions& options, std::vector<std::string>& notices) {
  VerificationPlan plan;
  if (options.poses) plan.poses = number_of_poses(*options.poses);
  plan.seed = seed_of(options);
  plan.modes = modes_named(options.mode.value_or("both"));
  plan.schemes = schemes_of(options);
  plan.schemes_named = options.scheme.has_value();
  plan.strata_named = !options.strata.empty();
  plan.pairs_named = !options.pairs.empty();
  if (options.usual_strata) plan.strata.assign(kUsualStrata.begin(), kUsualStrata.end());
  if (plan.strata_named) plan.strata.clear();
  for (const std::string& word : options.strata) {
    const std::optional<Stratum> stratum = stratum_named(word);
    if (!stratum) throw BadInput("--strata: unknown stratum '" + word + "'; known are " + strata_names());
    if (std::find(plan.strata.begin(), plan.strata.end(), *stratum) == plan.strata.end())
      plan.strata.push_back(*stratum);
  }
  if (options.law.any()) {
    plan.law = law_from(options.law);
    require_in_range(*plan.law, option_of);
    leave_out_extreme(*plan.law, plan, notices);
  }
  plan.pairs = pairs_of(options, plan.strata, notices);
  for (SurfacePair& pair : plan.pairs)
    if (plan.law) pair.law = *plan.law;
  return plan;
}

VerificationPlan plan_from_trajectory(const VerifyOptions& options, std::vector<std::string>& notices) {
  TrajectoryChoice choice;
  if (options.poses) choice.poses = number_of_poses(*options.poses);
  if (options.mode) choice.modes = modes_named(*options.mode);
  if (options.scheme == "both")
    throw BadInput("--scheme both: a recorded pose is asked in one scheme; name barycentric or clipped");
  if (options.scheme) choice.scheme = scheme_named(*options.scheme);
  VerificationPlan plan = read_trajectory(*options.trajectory, choice);
  note_warnings(plan.pairs, notices);
  return plan;
}

std::optional<fs::path> prepared_folder(const VerifyOptions& options) {
  if (!options.out) return std::nullopt;
  const fs::path folder = *options.out;
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error))
    throw BadInput("--out " + *options.out + ": no such folder, and it cannot be made");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw BadInput("--out " + *options.out + ": nothing can be written there; choose another folder");
  return folder;
}

}  // namespace pcm::compare
