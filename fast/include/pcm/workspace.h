// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

namespace pcm::fast {

/// Scratch memory and the last answer; one for each thread that evaluates. It grows to what the poses need and then
/// allocates no more. What it holds never changes an answer, nor does the number of its threads. One that was moved
/// from starts anew, with one thread.
class Workspace {
 public:
  Workspace() : Workspace(1) {}
  /// `threads`, at least 1 (else BadInput), take part in an evaluation, the caller's among them: as far as there is
  /// enough for them to do, some 300 us. The others are started when they are first needed, and wait in between; each
  /// has memory of its own. Sums are taken by one, in the same order, so that answers are the same, bit for bit. Where
  /// a bound is wanted one thread finds crossings and forms elements, and at short steps of a Scene one follows
  /// penetration lines.
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
