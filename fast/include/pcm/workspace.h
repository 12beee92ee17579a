// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

namespace pcm::fast {

/// Scratch memory and the last answer; one per thread. It grows to what the poses need and then allocates no more.
/// What it holds never changes an answer. One that was moved from starts anew.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;

  struct Data;
  Data& data();

 private:
  std::unique_ptr<Data> data_;
};

}  // namespace pcm::fast
