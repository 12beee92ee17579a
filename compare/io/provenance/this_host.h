// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace pcm::compare {

/// Within which process numbers mean the same: this start of this machine, and what a container sees of it.
std::string this_host();

}  // namespace pcm::compare
