// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "compare/published/workspace.h"
#include "pcm/engine.h"

/// Whoever answers in floating point and can be held against the oracle: the engine, and the algorithms it follows.
namespace pcm::compare {

enum class Engine : std::uint8_t {
  fast,            ///< fast/, every decision exact
  published_2003,  ///< published/algorithm_2003.h
  published_2023,  ///< published/algorithm_2023.h
};

inline constexpr std::array kEngines = {Engine::fast, Engine::published_2003, Engine::published_2023};

/// The word of --engine: fast, published-2003 or published-2023.
std::string_view name(Engine engine);
/// Throws BadInput for another word.
Engine engine_named(const std::string& word);

/// Scratch memory for any of them; one per thread.
struct TestedEngineWorkspace {
  fast::Workspace fast;
  published::Workspace published;
};

/// An engine with its pairing. Immutable.
class TestedEngine {
 public:
  TestedEngine() = default;
  TestedEngine(const TestedEngine&) = delete;
  TestedEngine& operator=(const TestedEngine&) = delete;
  virtual ~TestedEngine() = default;

  /// The answer lives in `workspace` until its next use. Throws BadInput as fast::evaluate does, and where a bound is
  /// wanted of a published algorithm.
  virtual const fast::Contact& evaluate(const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                                        TestedEngineWorkspace& workspace) const = 0;
};

/// Throws BadInput where a mesh is unfit for contact, a parameter of the law out of its range, or the scheme one that
/// the engine does not know: the published algorithms are barycentric.
std::unique_ptr<const TestedEngine> make_tested_engine(Engine engine, TriangleMesh mesh_E, TriangleMesh mesh_F,
                                                       const ContactLaw& law, Mode mode, Scheme scheme);

}  // namespace pcm::compare
