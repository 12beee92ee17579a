// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "pcm/body_state.h"
#include "pcm/engine.h"
#include "pcm/savings.h"

namespace pcm::fast {

/// What became of the pairings when each was last asked for, since the last `move`.
struct SceneCounters {
  std::int64_t apart_by_boxes = 0;        ///< the bodies' boxes are apart
  std::int64_t apart_by_certificate = 0;  ///< apart by more than they have moved since they were looked at
  std::int64_t evaluated = 0;             ///< by the engine, by the law alone included (work.law_only)
  std::int64_t certificates_sought = 0;   ///< searches for the distance of a pairing found apart
  WorkCounters work;                      ///< of these evaluations and searches
};

/// Bodies that move, and the pairings among them; a pairing that can't be in contact costs nanoseconds. Answers are
/// those of `evaluate` for each pairing's relative pose, bit for bit, whatever is skipped, however many threads, and
/// whatever their floating-point environment.
///
/// For one caller at a time, except where it says otherwise. A number that is no pairing's throws BadInput. A scene
/// that was moved from may be destroyed or assigned to, no more.
class Scene {
 public:
  explicit Scene(Savings savings = {});
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  /// Bodies and pairings are numbered from 0 in the order they are added. A surface may be that of many bodies. Until
  /// the first `move` a body is at rest in the origin, its axes those of W.
  Index add_body(Surface surface);
  /// Throws BadInput where there is no such body, both are the same, or a parameter of the law is out of its range.
  Index add_pairing(Index body_E, Index body_F, ContactLaw law = {}, Mode mode = Mode::E,
                    Scheme scheme = Scheme::barycentric, Wanted wanted = {});

  Index bodies() const;
  Index pairings() const;
  /// The reference lives until the next `add_pairing`.
  const Pairing& pairing(Index index) const;

  /// Puts every body where it is. Throws BadInput, naming the body, where the number of states is not that of bodies, a
  /// pose is no rotation to 1e-10 (so that every relative pose is one to 1e-9), anything is not finite or exceeds
  /// 2^300. All bodies then are where they were.
  void move(const std::vector<BodyState>& states);

  /// Pose and velocity of the marker of the pairing's F relative to that of its E: A = A_E^T A_F, r = A_E^T (r_F -
  /// r_E).
  Pose relative_pose(Index pairing) const;
  Velocity relative_velocity(Index pairing) const;

  /// From now on, until the next call, what is found of a pairing at the relative pose that it has now is kept: there
  /// only the first evaluation is a whole one, further ones apply the law at whatever velocity it then has. For
  /// difference quotients; wherever else bodies go costs what it did. Pairings with a bound, or in the clipped scheme
  /// with a tangent, are always found anew.
  void remember_poses();

  /// Answers one pairing, where its bodies are; the answer lives until the next use of `workspace`, or until the
  /// pairing is asked for again. Throws as `evaluate` does, also for a relative pose of more than 2^300 m where it
  /// is not known before that the bodies are apart. Different
  /// pairings may be asked for by different threads at once, each with its own workspace.
  const Contact& evaluate(Index pairing, Workspace& workspace);

  /// Called with each answer in `evaluate_all`, from the thread that has it. `contact` lives until the call returns.
  using Visit = std::function<void(Index pairing, const Contact& contact)>;
  /// Answers all pairings, `threads` at once (at least 1, else BadInput), and keeps their loads. Those whose last
  /// contact was large come first; where there is one such pairing alone, all threads are at work within it (see
  /// Workspace), but where little would come of it: in the barycentric scheme with few elements or at short steps, at a
  /// pose that is remembered, with a bound. `visit`, where given, sees the answers of those that touch or are nested,
  /// at once and in any order, and in the default floating-point environment. What is thrown for the first pairing that
  /// fails is thrown on, when all threads are done. Throws std::system_error where the system has no thread left. Where
  /// it throws, loads are of no use until an evaluate_all that does not. In a process that was forked from another one,
  /// threads started before are missing: make a new scene there, and do not destroy one that has had threads.
  void evaluate_all(int threads = 1, const Visit& visit = {});

  /// Of the last evaluate_all; until the next one, or until `add_pairing`.
  const PairingLoad& load(Index pairing) const;
  /// Of every body where it was then, summed over its pairings in their order.
  std::vector<BodyLoad> body_loads() const;

  /// Sums over threads. Reset by `move`.
  SceneCounters counters() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace pcm::fast
