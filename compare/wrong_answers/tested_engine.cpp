// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/wrong_answers/tested_engine.h"

#include <utility>

#include "compare/published/algorithm_2003.h"
#include "compare/published/algorithm_2023.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"

namespace pcm::compare {
namespace {

class FastEngine final : public TestedEngine {
 public:
  FastEngine(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode, Scheme scheme)
      : pairing_(fast::Surface(std::move(mesh_E)), fast::Surface(std::move(mesh_F)), law, mode, scheme) {}

  const fast::Contact& evaluate(const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                                TestedEngineWorkspace& workspace) const override {
    return fast::evaluate(pairing_, pose, velocity, wanted, workspace.fast);
  }

 private:
  fast::Pairing pairing_;
};

template <class Algorithm>
class PublishedEngine final : public TestedEngine {
 public:
  PublishedEngine(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode)
      : algorithm_(std::move(mesh_E), std::move(mesh_F), law, mode) {}

  const fast::Contact& evaluate(const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                                TestedEngineWorkspace& workspace) const override {
    return algorithm_.evaluate(pose, velocity, wanted, workspace.published);
  }

 private:
  Algorithm algorithm_;
};

}  // namespace

std::string_view name(Engine engine) {
  constexpr std::array<std::string_view, kEngines.size()> kNames = {"fast", "published-2003", "published-2023"};
  return kNames[static_cast<std::size_t>(engine)];
}

Engine engine_named(const std::string& word) {
  for (const Engine engine : kEngines)
    if (name(engine) == word) return engine;
  throw BadInput("--engine: unknown '" + word + "'; known are fast, published-2003, published-2023");
}

std::unique_ptr<const TestedEngine> make_tested_engine(Engine engine, TriangleMesh mesh_E, TriangleMesh mesh_F,
                                                       const ContactLaw& law, Mode mode, Scheme scheme) {
  if (engine == Engine::fast)
    return std::make_unique<FastEngine>(std::move(mesh_E), std::move(mesh_F), law, mode, scheme);
  if (scheme != Scheme::barycentric)
    throw BadInput("--engine " + std::string(name(engine)) +
                   " knows the barycentric scheme only; ask it about poses in that scheme");
  require_fit(mesh_E);
  require_fit(mesh_F);
  if (engine == Engine::published_2003)
    return std::make_unique<PublishedEngine<published::Algorithm2003>>(std::move(mesh_E), std::move(mesh_F), law, mode);
  return std::make_unique<PublishedEngine<published::Algorithm2023>>(std::move(mesh_E), std::move(mesh_F), law, mode);
}

}  // namespace pcm::compare
