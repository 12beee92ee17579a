// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "compare/stability/exact_contact.h"
#include "compare/wrong_answers/tested_engine.h"

namespace pcm::compare::stability {

/// The published algorithms, beside which the engine is shown.
inline constexpr std::array kPublished = {Engine::published_2003, Engine::published_2023};

/// Asks the engine for force, areas and bound; the answer lives in the workspace.
using AskEngine = std::function<const fast::Contact&(const fast::Pairing&, const Pose&, fast::Workspace&)>;
const fast::Contact& ask_engine(const fast::Pairing& pairing, const Pose& pose, fast::Workspace& workspace);

/// The two bodies of a point as everybody has them; immutable.
struct Contestants {
  Contestants(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F);

  ExactBodies exact;
  std::vector<fast::Pairing> engines;  ///< barycentric, clipped
  /// Empty where an algorithm does not take such surfaces.
  std::array<std::unique_ptr<const TestedEngine>, kPublished.size()> published;

  const fast::Pairing& engine(Scheme scheme) const { return engines[scheme == Scheme::barycentric ? 0 : 1]; }
};

/// What a published algorithm said.
struct PublishedFigures {
  bool answered = false;       ///< with finite numbers
  bool same_elements = false;  ///< as the exact problem has
  Figures error{};             ///< not of the area, which they do not know: 0
};

/// Everything about one pose in one scheme. Errors, bounds and condition are relative to the exact problem's own sizes
/// (exact_contact.h), so ratios of them do not depend on what they are relative to.
struct PoseFigures {
  bool answered = false;       ///< by the engine, with finite numbers
  bool carries_force = false;  ///< in the exact problem; without it nothing below is told but `outside_bound`
  bool flipped = false;        ///< the engine's bound says so: a decision may be another one in the exact problem
  bool unbounded = false;      ///< a bound is infinite
  std::string outside_bound;   ///< what the bound promised and is not so; empty where it holds
  Figures error{};
  Figures of_vertices{};  ///< the part of the error that is not the engine's evaluation: rounded against exact problem
  Figures bound{};        ///< the engine's own; none of the area, of which it knows none: 0
  Figures condition{};
  std::array<PublishedFigures, kPublished.size()> published;  ///< barycentric scheme
};

/// Scratch memory of a thread.
using FiguresWorkspace = TestedEngineWorkspace;

PoseFigures figures_at(const Contestants& contestants, const Pose& pose, Scheme scheme, const AskEngine& ask,
                       FiguresWorkspace& workspace);

}  // namespace pcm::compare::stability
