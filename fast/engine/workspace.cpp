// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/engine/workspace.h"

namespace pcm::fast {

Workspace::Workspace() : data_(std::make_unique<Data>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

Workspace::Data& Workspace::data() {
  if (!data_) data_ = std::make_unique<Data>();
  return *data_;
}

}  // namespace pcm::fast
