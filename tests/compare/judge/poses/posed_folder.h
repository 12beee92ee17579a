// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/judge/engines/own_answers.h"
#include "compare/judge/poses/poses_folder.h"
#include "compare/judge/poses/write_poses.h"
#include "tests/compare/small_pair.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {

/// Poses of a small pair in a folder of their own, and the engine's answers to them.
struct PosedFolder {
  explicit PosedFolder(std::int64_t poses, std::vector<Scheme> schemes = {Scheme::barycentric},
                       Notation notation = Notation::decimal) {
    VerificationPlan plan;
    plan.poses = poses;
    plan.strata.assign(kUsualStrata.begin(), kUsualStrata.end());
    plan.schemes = std::move(schemes);
    plan.pairs = {small_pair()};
    write_poses(
        path(), PlannedPoses(std::move(plan)), PosedLaw::drawn, notation, 2, [] { return false; }, [](std::int64_t) {});
    posed = read_poses_folder(path());
    OwnAnswers own(Engine::fast, posed.surfaces);
    for (const PosedQuestion& question : posed.questions) answers.push_back(own.answer(question));
  }

  std::string path() const { return folder.path("poses"); }

  TemporaryFolder folder;
  PosedQuestions posed;
  std::vector<GivenAnswer> answers;  ///< by question
};

}  // namespace pcm::compare
