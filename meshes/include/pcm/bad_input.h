// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace pcm {

/// Input that the user can mend: the message names the file, line or element and says what to do.
/// The program prints it and exits with status 2; our own bugs are assertions instead.
class BadInput : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace pcm
