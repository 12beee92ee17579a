// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

namespace pcm::fast {

/// Scratch memory and the last answer; one for each thread that evaluates. It grows to what the poses need and then
/// allocates no more; with several threads, each of which needs what the faces take that fall to it, that may take some
/// more poses. What it holds never changes an answer, nor does the number of its threads, but for counters of work
/// (WorkCounters). One that was moved from starts anew, with one thread.
class Workspace {
 public:
  Workspace() : Workspace(1) {}
  /// `threads`, at least 1 (else BadInput), take part in an evaluation, the caller's among them: as far as there is
  /// enough for them to do, some 300 us. More than the machine has cores are of no use. The others are started when
  /// they are first needed, and wait in between; an evaluation throws std::system_error where the system has none left.
  /// Each has memory of its own. Sums are taken by one, in the same order, so that answers are the same, bit for bit.
  /// Where a bound is wanted one thread finds crossings and bounds elements; at short steps of a Scene or a
  /// PairingMemory one follows crossings, and penetration lines in the barycentric scheme. A process that is forked
  /// from another one has none of the others: it needs workspaces of its own, and must not destroy those with threads.
  explicit Workspace(int threads);
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;

  struct Data;
  Data& data();

 private:
  std::unique_ptr<Data> data_;
};

}  // namespace pcm::fast
