// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "compare/judge/lines/given_answer.h"
#include "compare/judge/lines/posed_question.h"
#include "compare/poses/surface_features.h"
#include "compare/wrong_answers/tested_engine.h"

namespace pcm::compare {

/// The engines of this project as anybody else's: they are told nothing but what a folder of posed questions says.
class OwnAnswers {
 public:
  /// The surfaces must outlive this.
  OwnAnswers(Engine engine, const std::vector<PosedSurface>& surfaces);

  /// What the engine knows; the published algorithms know no areas and no volume, the variant of 2023 elements, force
  /// and torque alone. Throws BadInput where the engine refuses the question.
  GivenAnswer answer(const PosedQuestion& question);

 private:
  const fast::Contact& evaluate(const PosedQuestion& question);
  const fast::Surface& prepared(std::size_t surface);
  const SurfaceFeatures& features(std::size_t surface);

  Engine engine_;
  const std::vector<PosedSurface>& surfaces_;
  std::map<std::size_t, fast::Surface> prepared_;
  std::map<std::size_t, SurfaceFeatures> features_;
  std::unique_ptr<const TestedEngine> tested_;  ///< the one asked last
  TestedEngineWorkspace workspace_;
};

}  // namespace pcm::compare
