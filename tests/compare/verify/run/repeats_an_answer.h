// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "compare/verify/routes/engine_seam.h"

namespace pcm::compare {

/// A scene that goes on well for some questions and then repeats an answer: no route but `motion` asks one so often.
class RepeatsAnAnswer final : public EngineSeam {
 public:
  const fast::Contact& evaluate_in(fast::Scene& scene, fast::Workspace& workspace) const override {
    constexpr int kWell = 8;
    int& asked = asked_[&scene];
    const fast::Contact& answer = EngineSeam::evaluate_in(scene, workspace);
    if (asked++ < kWell) answers_[&scene] = answer;
    if (asked <= kWell) return answer;
    altered_ = answers_[&scene];
    altered_.work = answer.work;
    return altered_;
  }

 private:
  mutable std::map<const fast::Scene*, int> asked_;
  mutable std::map<const fast::Scene*, fast::Contact> answers_;
  mutable fast::Contact altered_;
};

}  // namespace pcm::compare
