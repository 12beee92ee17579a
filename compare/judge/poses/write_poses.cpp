// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/poses/write_poses.h"

#include <fmt/core.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>

#include "compare/judge/poses/poses_folder.h"
#include "compare/judge/poses/poses_writer.h"
#include "compare/verify/routes/state_draw.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

namespace fs = std::filesystem;

/// Lines that are worked out together.
constexpr std::int64_t kBatch = 1024;

/// The numbers of both surfaces, by where they are held.
using Numbers = std::map<const HeldPairing*, std::pair<std::size_t, std::size_t>>;

/// What is asked at a pose, under that law. Throws DrawFailure where the engine breaks down while a law is drawn.
HeldPairing::State asked(const PlannedPoses& poses, const PlannedCell& cell, std::int64_t pose, PosedLaw law) {
  if (law == PosedLaw::drawn) return poses.asked(cell, pose);
  const DrawnPose drawn = poses.draw(cell, pose);
  if (law == PosedLaw::of_pair) return {drawn.pose, drawn.velocity, poses.held_pairing(cell, pose).law(), cell.scheme};
  ContactLaw elastic;
  elastic.stiffness = 1e6;  // says nothing: forces are proportional to it
  return {drawn.pose, {}, elastic, cell.scheme};
}

PosedQuestion question_of(const PlannedPoses& poses, const PlannedCell& cell, std::int64_t pose, PosedLaw law,
                          const Numbers& numbers) {
  PosedQuestion question;
  question.id = poses.pose_name(cell, pose);
  question.pair = poses.plan().pairs[cell.pair].name;
  question.stratum = std::string(name(cell.stratum));
  std::tie(question.E, question.F) = numbers.at(&poses.held_pairing(cell, pose));
  const HeldPairing::State state = [&] {
    try {
      return asked(poses, cell, pose, law);
    } catch (const DrawFailure& failure) {
      throw BadInput(question.id + " can't be drawn: " + failure.what());
    }
  }();
  question.pose = state.pose;
  question.velocity = state.velocity;
  question.law = state.law;
  question.mode = cell.mode;
  question.scheme = state.scheme;
  return question;
}

}  // namespace

PosedLaw posed_law_named(const std::string& word) {
  for (const PosedLaw law : kPosedLaws)
    if (name(law) == word) return law;
  throw BadInput("--law: unknown " + in_quotes(word) + "; known are drawn, pair, elastic");
}

std::string_view name(PosedLaw law) {
  constexpr std::array<std::string_view, kPosedLaws.size()> kNames = {"drawn", "pair", "elastic"};
  return kNames[static_cast<std::size_t>(law)];
}

bool write_poses(const fs::path& folder, const PlannedPoses& poses, PosedLaw law, Notation notation, int jobs,
                 const std::function<bool()>& stop, const std::function<void(std::int64_t)>& progress) {
  PosedSurfaces known;
  Numbers numbers;
  std::int64_t all = 0;
  for (const PlannedCell& cell : poses.cells()) {
    all += cell.poses;
    for (std::int64_t k = 0; k < cell.poses; ++k)
      if (const HeldPairing& held = poses.held_pairing(cell, cell.first + k); !numbers.contains(&held))
        numbers[&held] = {known.number_of(held.features().E.mesh), known.number_of(held.features().F.mesh)};
  }
  const std::string origin = poses.plan().recorded.empty()
                                 ? fmt::format("pcm poses --seed {}{}", poses.plan().seed,
                                               law == PosedLaw::drawn ? "" : fmt::format(" --law {}", name(law)))
                                 : "recorded by pcm simulate";
  PosesWriter writer(folder, known, all, origin);
  oneapi::tbb::task_arena arena(jobs);
  std::int64_t written = 0;
  for (const PlannedCell& cell : poses.cells()) {
    for (std::int64_t begin = 0; begin < cell.poses; begin += kBatch) {
      std::vector<std::string> lines(static_cast<std::size_t>(std::min(kBatch, cell.poses - begin)));
      arena.execute([&] {
        oneapi::tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t k) {
          if (stop()) return;
          const std::int64_t pose = cell.first + begin + static_cast<std::int64_t>(k);
          lines[k] = dump_exactly(pose_json(question_of(poses, cell, pose, law, numbers), known.surfaces(), notation));
        });
      });
      if (stop()) return false;
      for (const std::string& line : lines) writer.add(line);
      progress(written += std::ssize(lines));
    }
  }
  writer.finish();
  return true;
}

}  // namespace pcm::compare
