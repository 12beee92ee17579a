// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/engine/workspace.h"

#include <string>

#include "pcm/bad_input.h"

namespace pcm::fast {

namespace {

std::size_t checked(int threads) {
  if (threads < 1) throw BadInput("workspace: needs at least 1 thread, not " + std::to_string(threads));
  return static_cast<std::size_t>(threads);
}

}  // namespace

Workspace::Workspace(int threads) : data_(std::make_unique<Data>(checked(threads))) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

Workspace::Data& Workspace::data() {
  if (!data_) data_ = std::make_unique<Data>(1);
  return *data_;
}

}  // namespace pcm::fast
